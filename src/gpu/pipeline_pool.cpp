// The pool is a list: it is searched where a pipeline would be made, which takes a thousand times as long.
#include "gpu/pipeline_pool.h"

#include <algorithm>

namespace gnomon {
namespace {

constexpr size_t k_most = 512;  // more than all techniques of one sample count need

}  // namespace

PipelinePool::~PipelinePool() {
  for (const Idle& idle : idle_) vkDestroyPipeline(device_, idle.pipeline, nullptr);
}

VkPipeline PipelinePool::take(const PipelineRecipe& recipe) {
  const auto found = std::find_if(idle_.begin(), idle_.end(), [&](const Idle& idle) { return idle.recipe == recipe; });
  if (recipe.empty() || found == idle_.end()) return VK_NULL_HANDLE;
  const VkPipeline pipeline = found->pipeline;
  idle_.erase(found);
  return pipeline;
}

VkPipeline PipelinePool::keep(PipelineRecipe recipe, VkPipeline pipeline) {
  if (recipe.empty()) return pipeline;
  idle_.push_front({std::move(recipe), pipeline});
  if (idle_.size() <= k_most) return VK_NULL_HANDLE;
  const VkPipeline oldest = idle_.back().pipeline;
  idle_.pop_back();
  return oldest;
}

}  // namespace gnomon
