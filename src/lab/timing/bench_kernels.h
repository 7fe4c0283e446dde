// Kernels that do nothing but move the bytes that a technique must move: what its passes are measured against.
#pragma once

#include <memory>
#include <string>

#include "shadow/technique.h"

namespace gnomon {

// "copy": texels x texels of depth read and twice as much written; "surface_read": depth and normal of every sample read, its
// mask written. Passes "kernel/copy" (build) and "kernel/surface_read" (resolve).
std::unique_ptr<Technique> make_bench_kernel(Device& device, const std::string& kernel, uint32_t texels);

}  // namespace gnomon
