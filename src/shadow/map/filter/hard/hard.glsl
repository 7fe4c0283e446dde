// The texel that holds the point, compared once. (lit = stored >= receiver; Williams 1978)
#include "shadow/map/glsl/compare.glsl"

float lit(uint map_image, MapSample at, FilterParams params) {
  ivec2 texel = clamp(ivec2(floor(at.uv * at.size)), ivec2(0), ivec2(int(at.size) - 1));
  // The stored depth is that of the texel's centre: follow the receiver's plane there.
  float receiver = depth_at(at, (vec2(texel) + 0.5) / at.size);
  float stored = texelFetch(images_2d_array[nonuniformEXT(map_image)], ivec3(texel, at.layer), 0).x;
  return stored >= receiver ? 1.0 : 0.0;
}

float filter_radius(FilterParams params) { return 0.5; }
