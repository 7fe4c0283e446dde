// What of a scene a picture is of: not the ground that goes on to a horizon, nor what strayed far from all the rest.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace gnomon {

struct Subject {
  Box box;                  // of what the picture has to hold; empty for a scene without triangles
  bool cropped = false;     // something of the scene lies outside
  std::vector<bool> stray;  // by object: has triangles that reach far beyond all the rest
  float usual_m = 0.0f;     // how far the rest reaches from its middle
  vec3 middle = vec3(0.0f);
};

// Found from triangles, not from objects or vertices: one mesh may hold the ground and what stands on it.
Subject find_subject(const Scene& scene);

// What shadow maps have to reach: all but the strays that cast nothing.
Box shadowed_bounds(const Scene& scene);

}  // namespace gnomon
