// Hazard tracking: the barriers that advance() asks for, checked by a model of what Vulkan promises without them.
#include "gpu/use.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace gnomon {
namespace {

constexpr Use k_uses[] = {Use::compute_read, Use::compute_write, Use::graphics_read, Use::sampled,    Use::colour_write,
                          Use::depth_write,  Use::indirect_read, Use::copy_read,     Use::copy_write, Use::ray_read,
                          Use::ray_write,    Use::build_read,    Use::build_write};

// "All transfer" names the copy stage too.
VkPipelineStageFlags2 expanded(VkPipelineStageFlags2 stages) {
  return stages & VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT ? stages | VK_PIPELINE_STAGE_2_COPY_BIT : stages;
}

struct Scope {
  VkPipelineStageFlags2 stages;
  VkAccessFlags2 access;
};

// One thing the GPU did, and who is ordered after it.
struct Operation {
  Scope scope;
  bool writes;
  bool available;
  VkPipelineStageFlags2 reached = 0;  // stages of later commands that wait for it
  std::vector<Scope> visible;         // readers to whom its write is visible
};

// What the Vulkan specification ("Execution and Memory Dependencies") promises about one resource on one queue.
class Model {
 public:
  void barrier(const Transition& t, bool image) {
    const VkPipelineStageFlags2 from = expanded(t.from_stages), to = expanded(t.to_stages);
    for (Operation& operation : done_) {
      const bool direct = (operation.scope.stages & from) != 0;
      if (!direct && !(operation.reached & from)) continue;
      operation.reached |= to;
      if (!operation.writes) continue;
      if (direct && (operation.scope.access & t.from_access)) operation.available = true;
      if (operation.available) operation.visible.push_back({to, t.to_access});
    }
    if (!image || t.from_layout == t.to_layout) return;
    // A change of layout reads and writes the image between the two scopes; it must itself come after everything.
    for (const Operation& operation : done_)
      check((operation.reached & to) == to, "the layout changes under an earlier access");
    done_.push_back({{to, 0}, true, true, to, {{to, t.to_access}}});
    layout_ = t.to_layout;
  }

  void use(Use use, bool image) {
    const UseInfo info = use_info(use);
    const Scope scope = {expanded(info.stages), info.access};
    check(!image || layout_ == info.layout, "wrong layout");
    bool newest_write = true;
    for (auto operation = done_.rbegin(); operation != done_.rend(); ++operation) {
      if (operation->writes || info.writes) {
        check((scope.stages & ~operation->reached) == 0, "no execution dependency on an earlier access");
      }
      if (!operation->writes || !newest_write) continue;
      newest_write = false;
      check(sees(*operation, scope), "an earlier write is not visible");
    }
    done_.push_back({scope, info.writes, false, 0, {}});
  }

  const std::string& problem() const { return problem_; }  // empty: everything was safe

 private:
  void check(bool holds, const char* problem) {
    if (!holds) problem_ = problem;
  }
  static bool sees(const Operation& write, const Scope& reader) {
    for (VkFlags64 stage = 1; stage && stage <= reader.stages; stage <<= 1) {
      if (!(reader.stages & stage)) continue;
      VkAccessFlags2 missing = reader.access;
      for (const Scope& scope : write.visible) {
        if (scope.stages & stage) missing &= ~scope.access;
      }
      if (missing) return false;
    }
    return true;
  }

  std::vector<Operation> done_;
  VkImageLayout layout_ = VK_IMAGE_LAYOUT_UNDEFINED;
  std::string problem_;
};

void check_sequence(const std::vector<Use>& sequence, bool image) {
  ResourceState state;
  Model model;
  std::string text;
  for (const Use use : sequence) {
    text += " " + std::to_string(static_cast<int>(use));
    const Transition transition = advance(state, use);
    if (transition.needed) model.barrier(transition, image);
    model.use(use, image);
    ASSERT_EQ(model.problem(), "") << (image ? "image," : "buffer,") << " uses" << text;
  }
}

bool for_images(Use use) { return use_info(use).layout != VK_IMAGE_LAYOUT_UNDEFINED; }

TEST(Use, EveryUseNamesStagesAndAccesses) {
  for (const Use use : k_uses) {
    const UseInfo info = use_info(use);
    EXPECT_NE(info.stages, 0u);
    EXPECT_NE(info.access, 0u);
    constexpr VkAccessFlags2 k_writes = VK_ACCESS_2_SHADER_WRITE_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT |
                                        VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT |
                                        VK_ACCESS_2_ACCELERATION_STRUCTURE_WRITE_BIT_KHR;
    EXPECT_EQ(info.writes, (info.access & k_writes) != 0) << static_cast<int>(use);
  }
}

TEST(Use, EverySequenceOfThreeIsSafe) {
  for (const bool image : {false, true}) {
    for (const Use a : k_uses) {
      for (const Use b : k_uses) {
        for (const Use c : k_uses) {
          if (image && !(for_images(a) && for_images(b) && for_images(c))) continue;
          check_sequence({a, b, c}, image);
          if (HasFailure()) return;
        }
      }
    }
  }
}

TEST(Use, LongSequencesAreSafe) {
  std::mt19937 random(1);
  for (int i = 0; i < 20000 && !HasFailure(); ++i) {
    const bool image = i % 2 == 1;
    std::vector<Use> sequence;
    while (sequence.size() < 10) {
      const Use use = k_uses[random() % std::size(k_uses)];
      if (!image || for_images(use)) sequence.push_back(use);
    }
    check_sequence(sequence, image);
  }
}

TEST(Use, TheModelNoticesMissingBarriers) {
  Model read_after_write, write_after_read;
  read_after_write.use(Use::compute_write, false);
  read_after_write.use(Use::compute_read, false);
  EXPECT_NE(read_after_write.problem(), "");
  write_after_read.use(Use::compute_read, false);
  write_after_read.use(Use::copy_write, false);
  EXPECT_NE(write_after_read.problem(), "");
}

TEST(Use, ReadsOfOneKindWaitOnce) {
  ResourceState state;
  EXPECT_TRUE(advance(state, Use::copy_write).needed);
  EXPECT_TRUE(advance(state, Use::compute_read).needed);
  EXPECT_FALSE(advance(state, Use::compute_read).needed) << "the second reader of the same kind has nothing to wait for";
  const Transition write = advance(state, Use::compute_write);
  EXPECT_TRUE(write.needed) << "a writer waits for the readers";
  EXPECT_NE(write.from_stages & VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, 0u);
}

TEST(Use, ABufferThatNobodyTouchedNeedsNoBarrierToBeRead) {
  for (const Use use : {Use::graphics_read, Use::indirect_read, Use::build_read}) {
    ResourceState state;
    EXPECT_FALSE(advance(state, use).needed);
  }
}

}  // namespace
}  // namespace gnomon
