// What the map pane's shader is told, for C++ and shader.
#ifndef GNOMON_MAP_PANE_DATA_GLSL
#define GNOMON_MAP_PANE_DATA_GLSL
#include "base/glsl/shared.glsl"
#ifdef __cplusplus
namespace gnomon::viewer {
#endif

shared_constant uint k_channels_rgb = 4u;  // below: one channel, as grey

struct MapPaneArguments {
  vec2 origin_px;          // of the map's first texel
  float pixels_per_texel;
  uint size;               // texels along a side
  uint image, kind, layer;  // as MapProbeArguments
  uint channels;
  float least, most;       // black and white
};

#ifdef __cplusplus
}  // namespace gnomon::viewer
#endif

#endif
