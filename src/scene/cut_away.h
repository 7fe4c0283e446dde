// Alpha-tested materials of which nothing is left.
#pragma once

#include "scene/scene.h"

namespace gnomon {

// One warning names the materials of which no texel passes the test: what has them is neither seen nor casts.
void warn_of_cut_away(const Scene& scene);

}  // namespace gnomon
