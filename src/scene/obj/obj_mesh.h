// From the faces of an OBJ file to triangles with one index per vertex.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace gnomon {

inline constexpr int32_t k_absent = -1;

// Indices into ObjVertices, from 0; a position is always there.
struct ObjCorner {
  int32_t position = k_absent, uv = k_absent, normal = k_absent;
  bool operator==(const ObjCorner&) const = default;
};

struct ObjVertices {
  std::vector<vec3> positions, normals;
  std::vector<vec2> uvs;
  std::vector<vec4> colours;  // empty, or up to the last vertex that has one
};

// Triangles of one group and material, three corners each. Faces without normals are kept apart: theirs are made; and faces
// without texture coordinates: they have no picture.
struct ObjFaces {
  int material = 0;
  bool has_normals = false, has_uvs = false;
  std::vector<ObjCorner> corners;
};

// Vertices are the distinct corners; the part is finished (scene/finish_part.h).
MeshPart build_obj_part(const ObjVertices& vertices, const ObjFaces& faces);

}  // namespace gnomon
