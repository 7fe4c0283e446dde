// Pipelines that nobody holds any more, by what they were made from: whoever needs one of them again takes it. Making one costs
// a CPU driver a tenth of a second, and most of what a new technique is made of another one had before it.
#pragma once

#include <string>
#include <vector>

#include "gpu/vulkan.h"

namespace gnomon {

// All that decides what a pipeline does, as bytes. Empty: it cannot be told, and the pipeline is not kept.
using PipelineRecipe = std::string;

class PipelinePool {
 public:
  explicit PipelinePool(VkDevice device);
  ~PipelinePool();
  PipelinePool(const PipelinePool&) = delete;
  PipelinePool& operator=(const PipelinePool&) = delete;

  // VK_NULL_HANDLE when it has none.
  VkPipeline take(const PipelineRecipe& recipe);
  // The GPU may still use it. Returns one that is to be destroyed for it, or VK_NULL_HANDLE.
  VkPipeline keep(PipelineRecipe recipe, VkPipeline pipeline) noexcept;

 private:
  struct Idle {
    PipelineRecipe recipe;
    VkPipeline pipeline;
  };
  VkDevice device_;
  std::vector<Idle> idle_;  // the oldest first; never grows beyond what the constructor reserves
};

}  // namespace gnomon
