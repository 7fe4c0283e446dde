// One level of a moment map from the one before: the mean of 2 x 2 texels, or of the exponentials whose logarithms they hold.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame/glsl/bindless.glsl"

layout(push_constant) uniform Push { uint from, to, size, unused; };
layout(constant_id = 0) const uint k_logarithms = 0u;
layout(local_size_x = 8, local_size_y = 8) in;

void main() {
  ivec3 at = ivec3(gl_GlobalInvocationID);
  if (any(greaterThanEqual(at.xy, ivec2(size)))) return;
  // A side of 2n + 1 texels leaves its last row out, as linear filtering of the hardware does.
  ivec3 corner = ivec3(at.xy * 2, at.z);
  ivec2 last = imageSize(storage_images[from]).xy - 1;
  vec4 sum = vec4(0.0), texels[4];
  for (int i = 0; i < 4; ++i)
    texels[i] = imageLoad(storage_images[from], ivec3(min(corner.xy + ivec2(i & 1, i >> 1), last), at.z));
  vec4 most = k_logarithms != 0u ? max(max(texels[0], texels[1]), max(texels[2], texels[3])) : vec4(0.0);
  for (int i = 0; i < 4; ++i) sum += 0.25 * (k_logarithms != 0u ? exp(texels[i] - most) : texels[i]);
  imageStore(storage_images[to], at, k_logarithms != 0u ? most + log(sum) : sum);
}
