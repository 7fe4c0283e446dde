// Lets one text be GLSL and C++: shared structs and functions are written once. Shared text uses the vector types, uint, float,
// `inline_function` before functions, `shared_constant` before constants, `exact_float` before floats that must round the same
// way in both (no fused multiply-add), and the functions that GLSL and GLM have in common.
#ifndef GNOMON_SHARED_GLSL
#define GNOMON_SHARED_GLSL
#ifdef __cplusplus
#include "base/maths.h"
#define inline_function inline
#define shared_constant inline constexpr
#define exact_float
namespace gnomon {
using uint = uint32_t;
using glm::abs;
using glm::clamp;
using glm::cos;
using glm::cross;
using glm::dot;
using glm::floatBitsToInt;
using glm::floatBitsToUint;
using glm::floor;
using glm::fract;
using glm::intBitsToFloat;
using glm::length;
using glm::max;
using glm::min;
using glm::mix;
using glm::normalize;
using glm::sign;
using glm::sin;
using glm::sqrt;
using glm::uintBitsToFloat;
using glm::uvec4;
}  // namespace gnomon
#else
#define inline_function
#define shared_constant const
#define exact_float precise
#endif
#endif
