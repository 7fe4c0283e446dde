// The barriers that the recorder puts out, for every pair of uses of a buffer and of an image. Validation does not see accesses
// by address, and a CPU driver hides what is missing: so the barriers themselves are looked at.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "support/device_tests.h"

namespace {

struct Barrier {
  VkPipelineStageFlags2 from_stages, to_stages;
  VkAccessFlags2 from_access, to_access;
  bool of_image;
  VkImageLayout from_layout, to_layout;
};

std::vector<Barrier> g_barriers;
PFN_vkCmdPipelineBarrier2 g_next = nullptr;

}  // namespace

// Stands before the loader's own, which the program would call: it writes down what it is given and hands it on.
extern "C" VKAPI_ATTR void VKAPI_CALL vkCmdPipelineBarrier2(VkCommandBuffer commands, const VkDependencyInfo* dependency) {
  for (uint32_t i = 0; i < dependency->memoryBarrierCount; ++i) {
    const VkMemoryBarrier2& b = dependency->pMemoryBarriers[i];
    g_barriers.push_back({b.srcStageMask, b.dstStageMask, b.srcAccessMask, b.dstAccessMask, false, {}, {}});
  }
  for (uint32_t i = 0; i < dependency->imageMemoryBarrierCount; ++i) {
    const VkImageMemoryBarrier2& b = dependency->pImageMemoryBarriers[i];
    g_barriers.push_back({b.srcStageMask, b.dstStageMask, b.srcAccessMask, b.dstAccessMask, true, b.oldLayout, b.newLayout});
  }
  if (!g_next) {
    g_next = reinterpret_cast<PFN_vkCmdPipelineBarrier2>(
        vkGetDeviceProcAddr(gnomon::test::device().handle(), "vkCmdPipelineBarrier2"));
  }
  g_next(commands, dependency);
}

namespace gnomon {
namespace {

using test::device;

// Vulkan's words for a use, written down a second time.
struct Known {
  Use use;
  const char* name;
  VkPipelineStageFlags2 stages;
  VkAccessFlags2 reads, writes;
  VkImageLayout layout;  // UNDEFINED: of buffers alone
};

constexpr Known k_uses[] = {
    {Use::compute_read, "compute_read", VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_READ_BIT, 0,
     VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL},
    {Use::compute_write, "compute_write", VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_READ_BIT,
     VK_ACCESS_2_SHADER_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL},
    {Use::graphics_read, "graphics_read", VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
     VK_ACCESS_2_SHADER_READ_BIT, 0, VK_IMAGE_LAYOUT_UNDEFINED},
    {Use::indirect_read, "indirect_read", VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT | VK_PIPELINE_STAGE_2_COPY_BIT,
     VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT | VK_ACCESS_2_TRANSFER_READ_BIT, 0, VK_IMAGE_LAYOUT_UNDEFINED},
    {Use::copy_read, "copy_read", VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT, 0,
     VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL},
    {Use::copy_write, "copy_write", VK_PIPELINE_STAGE_2_COPY_BIT, 0, VK_ACCESS_2_TRANSFER_WRITE_BIT,
     VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL},
};

VkPipelineStageFlags2 expanded(VkPipelineStageFlags2 stages) {
  if (stages & VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT) return ~VkPipelineStageFlags2{0};
  return stages & VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT ? stages | VK_PIPELINE_STAGE_2_COPY_BIT : stages;
}

// All stages of `second` wait for all of `first`, and see what it wrote.
bool orders(const Barrier& barrier, const Known& first, const Known& second) {
  const auto holds = [](uint64_t set, uint64_t part) { return (set & part) == part; };
  const bool waits = holds(expanded(barrier.from_stages), first.stages) && holds(expanded(barrier.to_stages), second.stages);
  return waits && holds(barrier.from_access, first.writes) &&
         (!first.writes || holds(barrier.to_access, second.reads | second.writes));
}

// The barriers before each pass, where passes use the same resource one after the other.
template <class Resource>
std::vector<std::vector<Barrier>> barriers_between(const Resource& resource, std::span<const Known> uses) {
  std::vector<std::vector<Barrier>> found;
  test::run_passes([&](Recorder& recorder) {
    g_barriers.clear();
    for (const Known& known : uses) {
      recorder.pass(known.name, PassStage::other, {{resource, known.use}}, [](Commands&) {});
      found.push_back(std::exchange(g_barriers, {}));
    }
  });
  return found;
}

size_t count_that_order(const std::vector<Barrier>& barriers, const Known& first, const Known& second) {
  return static_cast<size_t>(
      std::count_if(barriers.begin(), barriers.end(), [&](const Barrier& b) { return orders(b, first, second); }));
}

// Whether use `second` waits for use `first` and sees what it wrote, directly or by a chain of barriers (Vulkan, "Execution and
// Memory Dependencies"). More waiting than needed is no mistake here.
bool ordered(const std::vector<std::vector<Barrier>>& found, std::span<const Known> uses, size_t first, size_t second) {
  const auto holds = [](uint64_t set, uint64_t part) { return (set & part) == part; };
  const Known &from = uses[first], &to = uses[second];
  bool available = from.writes == 0, visible = from.writes == 0;
  VkPipelineStageFlags2 reached = 0;
  for (size_t i = first + 1; i <= second; ++i) {
    for (const Barrier& barrier : found[i]) {
      const bool direct = holds(expanded(barrier.from_stages), from.stages);
      if (!direct && !(expanded(barrier.from_stages) & reached)) continue;
      available |= direct && holds(barrier.from_access, from.writes);
      reached |= expanded(barrier.to_stages);
      visible |= available && holds(expanded(barrier.to_stages), to.stages) && holds(barrier.to_access, to.reads | to.writes);
    }
  }
  return holds(reached, to.stages) && visible;
}

TEST(Barriers, EveryPairOfUsesOfABuffer) {
  for (const Known& first : k_uses) {
    for (const Known& second : k_uses) {
      SCOPED_TRACE(fmt::format("{}, then {}", first.name, second.name));
      const Buffer buffer(device(), "buffer", 256);
      const std::array uses = {first, second};
      const auto found = barriers_between(buffer, uses);
      if (first.writes || second.writes) {
        EXPECT_TRUE(ordered(found, uses, 0, 1));
      } else if (first.use == second.use) {
        EXPECT_TRUE(found[1].empty()) << "readers need not wait for each other";
      }
    }
  }
}

TEST(Barriers, EveryReaderOfABufferWaitsForItsWriter) {
  for (const Known& writer : k_uses) {
    if (!writer.writes) continue;
    for (const Known& first : k_uses) {
      for (const Known& second : k_uses) {
        if (first.writes || second.writes) continue;
        SCOPED_TRACE(fmt::format("{}, then {}, then {}, then overwritten", writer.name, first.name, second.name));
        const Buffer buffer(device(), "buffer", 256);
        const std::array uses = {writer, first, second, writer};
        const auto found = barriers_between(buffer, uses);
        EXPECT_TRUE(ordered(found, uses, 0, 1)) << "the first reader";
        EXPECT_TRUE(ordered(found, uses, 0, 2) || first.use == second.use) << "the second reader";
        EXPECT_TRUE(ordered(found, uses, 1, 3)) << "overwritten while the first one reads";
        EXPECT_TRUE(ordered(found, uses, 2, 3)) << "overwritten while the second one reads";
      }
    }
  }
}

TEST(Barriers, EveryPairOfUsesOfAnImage) {
  ImageInfo info;
  info.name = "image";
  info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
               VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  for (const Known& first : k_uses) {
    for (const Known& second : k_uses) {
      if (first.layout == VK_IMAGE_LAYOUT_UNDEFINED || second.layout == VK_IMAGE_LAYOUT_UNDEFINED) continue;
      SCOPED_TRACE(fmt::format("{}, then {}", first.name, second.name));
      const Image image(device(), info);
      const auto found = barriers_between(image, std::array{first, second});
      ASSERT_FALSE(found[0].empty()) << "a new image has no layout";
      if (!first.writes && first.use == second.use) {
        EXPECT_TRUE(found[1].empty());
        continue;
      }
      size_t of_image = 0;
      for (const Barrier& barrier : found[1]) {
        if (!barrier.of_image) continue;
        ++of_image;
        EXPECT_TRUE(orders(barrier, first, second));
        EXPECT_EQ(barrier.from_layout, first.layout);
        EXPECT_EQ(barrier.to_layout, second.layout);
      }
      EXPECT_EQ(of_image, 1u);
      EXPECT_EQ(count_that_order(found[1], first, second), 2u) << "of all memory too: see Recorder::barriers";
    }
  }
}

// Measured passes have the device to themselves, whatever they use.
TEST(Barriers, MeasuredPassesWaitForEverything) {
  test::run_passes(
      [](Recorder& recorder) {
        for (int i = 0; i < 2; ++i) {
          g_barriers.clear();
          recorder.pass("alone", PassStage::other, {}, [](Commands&) {});
          ASSERT_EQ(g_barriers.size(), 1u);
          EXPECT_TRUE(g_barriers[0].from_stages & VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT);
          EXPECT_TRUE(g_barriers[0].to_stages & VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT);
          EXPECT_TRUE(g_barriers[0].from_access & VK_ACCESS_2_MEMORY_WRITE_BIT);
          EXPECT_TRUE(g_barriers[0].to_access & VK_ACCESS_2_MEMORY_READ_BIT);
          EXPECT_TRUE(g_barriers[0].to_access & VK_ACCESS_2_MEMORY_WRITE_BIT);
        }
      },
      TimingMode::measure);
}

TEST(Barriers, TheHostSeesWhatAFrameWrote) {
  g_barriers.clear();
  test::run_passes([](Recorder&) {});
  ASSERT_FALSE(g_barriers.empty());
  const Barrier& last = g_barriers.back();
  EXPECT_TRUE(last.from_access & VK_ACCESS_2_MEMORY_WRITE_BIT);
  EXPECT_TRUE(last.to_stages & VK_PIPELINE_STAGE_2_HOST_BIT);
  EXPECT_TRUE(last.to_access & VK_ACCESS_2_HOST_READ_BIT);
}

TEST(Barriers, ADispatchReadsWhatTheOneBeforeItWrote) {
  test::run_passes([](Recorder& recorder) {
    recorder.pass("two dispatches", PassStage::other, {}, [](Commands& commands) {
      g_barriers.clear();
      commands.compute_barrier();
    });
  });
  ASSERT_FALSE(g_barriers.empty());
  const Known compute = k_uses[1];
  EXPECT_TRUE(orders(g_barriers.front(), compute, compute));
}

}  // namespace
}  // namespace gnomon
