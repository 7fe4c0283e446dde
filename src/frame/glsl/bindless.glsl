// The bindless sets (gpu/bindless.h): images and samplers by index. The same images are declared once per shape.
#ifndef GNOMON_BINDLESS_GLSL
#define GNOMON_BINDLESS_GLSL
#include "gpu/glsl/samplers.glsl"
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_samplerless_texture_functions : require
#extension GL_EXT_shader_image_load_formatted : require

layout(set = 0, binding = 0) uniform texture2D material_textures[];
layout(set = 1, binding = 0) uniform texture2D images_2d[];
layout(set = 1, binding = 0) uniform texture2DArray images_2d_array[];
layout(set = 1, binding = 0) uniform texture2DMS images_2d_ms[];
layout(set = 1, binding = 0) uniform texture2DMSArray images_2d_ms_array[];
layout(set = 1, binding = 0) uniform utexture2DArray images_2d_array_uint[];
layout(set = 1, binding = 1) uniform image2DArray storage_images[];
layout(set = 1, binding = 1) uniform uimage2DArray storage_images_uint[];
layout(set = 0, binding = 1) uniform sampler samplers[];
layout(set = 0, binding = 1) uniform samplerShadow shadow_samplers[];

#endif
