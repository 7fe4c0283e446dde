// The pool is a list: it is searched where a pipeline would be made, which takes a thousand times as long.
#include "gpu/pipeline_pool.h"

#include <algorithm>

namespace gnomon {
namespace {

constexpr size_t k_most = 512;  // more than all techniques of one sample count need

}  // namespace

PipelinePool::PipelinePool(VkDevice device) : device_(device) { idle_.reserve(k_most + 1); }

PipelinePool::~PipelinePool() {
  for (const Idle& idle : idle_) vkDestroyPipeline(device_, idle.pipeline, nullptr);
}

VkPipeline PipelinePool::take(const PipelineRecipe& recipe) {
  const auto found = std::find_if(idle_.rbegin(), idle_.rend(), [&](const Idle& idle) { return idle.recipe == recipe; });
  if (recipe.empty() || found == idle_.rend()) return VK_NULL_HANDLE;
  const VkPipeline pipeline = found->pipeline;
  idle_.erase(std::next(found).base());
  return pipeline;
}

VkPipeline PipelinePool::keep(PipelineRecipe recipe, VkPipeline pipeline) noexcept {
  if (recipe.empty()) return pipeline;
  idle_.push_back({std::move(recipe), pipeline});
  if (idle_.size() <= k_most) return VK_NULL_HANDLE;
  const VkPipeline oldest = idle_.front().pipeline;
  idle_.erase(idle_.begin());
  return oldest;
}

}  // namespace gnomon
