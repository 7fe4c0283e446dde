// Passes, barriers, timestamps.
#include "gpu/recorder.h"

#include <algorithm>
#include <chrono>

#include "base/error.h"
#include "gpu/device_info.h"
#include "gpu/memory_barrier.h"

namespace gnomon {
namespace {

double now_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

constexpr uint32_t k_max_indirect_draws = 4096;

void full_barrier(VkCommandBuffer commands) {
  memory_barrier(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT,
                 VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT);
}

// What the CPU reads after waiting (readback buffers) must be made visible to it: waiting alone does not.
void host_barrier(VkCommandBuffer commands) {
  memory_barrier(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT, VK_PIPELINE_STAGE_2_HOST_BIT,
                 VK_ACCESS_2_HOST_READ_BIT);
}

void widen(VkMemoryBarrier2& memory, const Transition& transition) {
  memory.srcStageMask |= transition.from_stages;
  memory.srcAccessMask |= transition.from_access;
  memory.dstStageMask |= transition.to_stages;
  memory.dstAccessMask |= transition.to_access;
}

void destroy(Device& device, VkQueryPool timestamps, VkQueryPool statistics, VkCommandPool pool) {
  vkDestroyQueryPool(device.handle(), timestamps, nullptr);
  vkDestroyQueryPool(device.handle(), statistics, nullptr);
  vkDestroyCommandPool(device.handle(), pool, nullptr);
}

}  // namespace

std::string_view stage_name(PassStage stage) {
  switch (stage) {
    case PassStage::surface:
      return "surface";
    case PassStage::build:
      return "build";
    case PassStage::resolve:
      return "resolve";
    case PassStage::shade:
      return "shade";
    case PassStage::other:
      return "other";
  }
  return "other";
}

Recorder::Recorder(Device& device, TimingMode mode, bool isolate) : device_(device), mode_(mode), isolate_(isolate) {
  // Before the pools: it cleans up after itself, they do not.
  draw_counts_ = Buffer(device, "draw counts", k_max_indirect_draws * sizeof(uint32_t), BufferMemory::readback);
  try {
    VkCommandPoolCreateInfo pool = {VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool.queueFamilyIndex = device.queue_family();
    vk_check(vkCreateCommandPool(device.handle(), &pool, nullptr, &pool_), "vkCreateCommandPool");
    VkQueryPoolCreateInfo queries = {VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
    queries.queryType = VK_QUERY_TYPE_TIMESTAMP;
    queries.queryCount = 2 * k_max_passes;
    vk_check(vkCreateQueryPool(device.handle(), &queries, nullptr, &timestamps_), "vkCreateQueryPool");
    if (device.info().pipeline_statistics) {
      queries.queryType = VK_QUERY_TYPE_PIPELINE_STATISTICS;
      queries.queryCount = k_max_passes;
      queries.pipelineStatistics = VK_QUERY_PIPELINE_STATISTIC_INPUT_ASSEMBLY_PRIMITIVES_BIT;
      vk_check(vkCreateQueryPool(device.handle(), &queries, nullptr, &statistics_), "vkCreateQueryPool");
    }
  } catch (...) {
    destroy(device, timestamps_, statistics_, pool_);  // no destructor runs for an object that was not made
    throw;
  }
}

Recorder::~Recorder() {
  abandon();  // an exception left the frame unfinished
  vkDeviceWaitIdle(device_.handle());
  destroy(device_, timestamps_, statistics_, pool_);
}

void Recorder::begin_commands() {
  if (!commands_) {
    VkCommandBufferAllocateInfo allocate = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocate.commandPool = pool_;
    allocate.commandBufferCount = 1;
    vk_check(vkAllocateCommandBuffers(device_.handle(), &allocate, &commands_), "vkAllocateCommandBuffers");
  }
  vk_check(vkResetCommandPool(device_.handle(), pool_, 0), "vkResetCommandPool");
  VkCommandBufferBeginInfo begin = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  vk_check(vkBeginCommandBuffer(commands_, &begin), "vkBeginCommandBuffer");
  if (!recording_) device_.begin_recording();
  recording_ = true;
}

// What was recorded since the last submission never happens.
void Recorder::abandon() {
  if (!recording_) return;
  for (auto change = states_before_.rbegin(); change != states_before_.rend(); ++change) *change->first = change->second;
  states_before_.clear();
  recording_ = false;
  device_.end_recording();
}

void Recorder::begin() {
  abandon();
  passes_.clear();
  count_ranges_.clear();
  has_statistics_.clear();
  draw_count_words_ = 0;
  wall_ms_ = record_ms_ = submission_ms_ = 0.0;
  record_start_ = now_ms();
  begin_commands();
  if (isolate_) {
    full_barrier(commands_);
    submission_ms_ = submit_alone();
  }
  vkCmdResetQueryPool(commands_, timestamps_, 0, 2 * k_max_passes);
  if (statistics_) vkCmdResetQueryPool(commands_, statistics_, 0, k_max_passes);
  // What an earlier submission did (other recorders, uploads) was waited for; its writes are made visible here.
  full_barrier(commands_);
}

uint64_t Recorder::end_and_submit() {
  vk_check(vkEndCommandBuffer(commands_), "vkEndCommandBuffer");
  const uint64_t value = device_.submit(commands_);
  recording_ = false;
  states_before_.clear();
  device_.end_recording();
  record_ms_ += now_ms() - record_start_;
  return value;
}

// Wall time of what was recorded; the next commands are then open.
double Recorder::submit_alone() {
  const double start = now_ms();
  device_.wait(end_and_submit());
  record_start_ = now_ms();
  begin_commands();
  return record_start_ - start;
}

Transition Recorder::advance_state(const std::shared_ptr<ResourceState>& state, Use use) {
  states_before_.emplace_back(state, *state);
  return advance(*state, use);
}

void Recorder::barriers(std::span<const ResourceUse> uses) {
  if (mode_ == TimingMode::measure) full_barrier(commands_);
  std::vector<VkImageMemoryBarrier2> images;
  VkMemoryBarrier2 memory = {VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
  for (const auto& use : uses) {
    if (const auto* image = std::get_if<const Image*>(&use.resource)) {
      const Transition transition = advance_state((*image)->shared_state(), use.use);
      if (!transition.needed) continue;
      images.push_back(image_barrier((*image)->handle(), (*image)->aspect(), transition));
      // Beside the change of layout: validation takes every image of the bindless set for used by every dispatch.
      widen(memory, transition);
    } else {
      // Buffers have no layout: one global barrier covers all of them, and drivers do the same for both forms.
      const Transition transition = advance_state(std::get<const Buffer*>(use.resource)->shared_state(), use.use);
      if (transition.needed) widen(memory, transition);
    }
  }
  VkDependencyInfo dependency = {VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.memoryBarrierCount = memory.dstStageMask ? 1 : 0;
  dependency.pMemoryBarriers = &memory;
  dependency.imageMemoryBarrierCount = static_cast<uint32_t>(images.size());
  dependency.pImageMemoryBarriers = images.data();
  if (dependency.memoryBarrierCount || dependency.imageMemoryBarrierCount) vkCmdPipelineBarrier2(commands_, &dependency);
}

void Recorder::pass(std::string name, PassStage stage, std::span<const ResourceUse> uses,
                    const std::function<void(Commands&)>& record) {
  const auto index = static_cast<uint32_t>(passes_.size());
  if (index == k_max_passes) fail("pass '{}': a frame has at most {} passes", name, k_max_passes);
  device_.set_last_pass(name);
  device_.begin_label(commands_, name);
  // Before the barriers: changing layouts and waiting for caches is part of what a pass costs.
  const bool timestamps = device_.info().timestamp_ms > 0.0;
  if (timestamps) vkCmdWriteTimestamp2(commands_, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, timestamps_, 2 * index);
  barriers(uses);
  bool graphics = false;
  for (const auto& use : uses) graphics |= use.use == Use::depth_write || use.use == Use::colour_write;
  graphics = graphics && statistics_;

  if (graphics) vkCmdBeginQuery(commands_, statistics_, index, 0);
  Commands commands;
  commands.commands_ = commands_;
  commands.device_ = &device_;
  record(commands);
  if (graphics) vkCmdEndQuery(commands_, statistics_, index);
  if (timestamps) vkCmdWriteTimestamp2(commands_, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, timestamps_, 2 * index + 1);
  copy_draw_counts(commands);
  device_.end_label(commands_);

  PassResult result;
  result.name = std::move(name);
  result.stage = stage;
  result.draws = commands.draws_;
  result.dispatches = commands.dispatches_;
  has_statistics_.push_back(graphics);
  if (isolate_) {
    // Handing work over and waking up afterwards costs the same for an empty submission, and is none of the pass's.
    result.wall_ms = std::max(submit_alone() - submission_ms_, 0.0);
    wall_ms_ += result.wall_ms;
    full_barrier(commands_);
  }
  passes_.push_back(std::move(result));
  if (isolate_ && gives_up_ && gives_up_()) {
    finish();
    throw GivenUp();
  }
}

void Recorder::copy_draw_counts(const Commands& commands) {
  const uint32_t first = draw_count_words_;
  for (const auto& read : commands.count_reads_) {
    if (draw_count_words_ == k_max_indirect_draws) fail("a frame has at most {} indirect draws", k_max_indirect_draws);
    const VkBufferCopy region = {read.offset, draw_count_words_ * sizeof(uint32_t), sizeof(uint32_t)};
    vkCmdCopyBuffer(commands_, read.counts->handle(), draw_counts_.handle(), 1, &region);
    ++draw_count_words_;
  }
  count_ranges_.emplace_back(first, draw_count_words_ - first);
}

FrameResult Recorder::finish() {
  host_barrier(commands_);
  const double start = now_ms();
  const uint64_t value = end_and_submit();
  device_.wait(value);
  FrameResult result;
  result.wall_ms = isolate_ ? wall_ms_ : now_ms() - start;
  result.record_ms = record_ms_;
  result.submission_ms = submission_ms_;
  device_.check_validation();
  collect(result);
  return result;
}

FrameResult Recorder::frame(const std::function<void()>& record) {
  begin();
  try {
    record();
    return finish();
  } catch (...) {
    abandon();
    throw;
  }
}

void Recorder::collect(FrameResult& result) {
  result.passes = std::move(passes_);
  passes_.clear();
  const auto count = static_cast<uint32_t>(result.passes.size());
  if (count == 0) return;
  const double tick_ms = device_.info().timestamp_ms;
  std::vector<uint64_t> ticks(size_t{2} * count);
  if (tick_ms > 0.0) {
    vk_check(vkGetQueryPoolResults(device_.handle(), timestamps_, 0, 2 * count, ticks.size() * 8, ticks.data(), 8,
                                   VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
             "vkGetQueryPoolResults(timestamps)");
  }
  // Only so many bits of a timestamp count: the difference is right beyond where they wrap around, too.
  const uint64_t mask = timestamp_mask(device_.physical());
  const auto elapsed_ms = [&](uint64_t from, uint64_t to) { return static_cast<double>((to - from) & mask) * tick_ms; };
  draw_counts_.invalidate();
  const auto counts = draw_counts_.mapped_as<const uint32_t>();
  for (uint32_t i = 0; i < count; ++i) {
    PassResult& pass = result.passes[i];
    pass.gpu_ms = elapsed_ms(ticks[2 * i], ticks[2 * i + 1]);
    for (uint32_t word = 0; word < count_ranges_[i].second; ++word) pass.draws += counts[count_ranges_[i].first + word];
    if (has_statistics_[i]) {
      vk_check(vkGetQueryPoolResults(device_.handle(), statistics_, i, 1, 8, &pass.triangles, 8,
                                     VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
               "vkGetQueryPoolResults(statistics)");
    }
  }
  result.gpu_ms = elapsed_ms(ticks[0], ticks[2 * count - 1]);
}

void run_once(Device& device, const std::function<void(VkCommandBuffer)>& record) {
  struct Pool {
    explicit Pool(Device& owner) : device(owner.handle()) {
      VkCommandPoolCreateInfo info = {VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
      info.queueFamilyIndex = owner.queue_family();
      vk_check(vkCreateCommandPool(device, &info, nullptr, &handle), "vkCreateCommandPool");
    }
    ~Pool() { vkDestroyCommandPool(device, handle, nullptr); }
    VkDevice device;
    VkCommandPool handle = VK_NULL_HANDLE;
  };
  const Pool pool(device);
  VkCommandBufferAllocateInfo allocate = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  allocate.commandPool = pool.handle;
  allocate.commandBufferCount = 1;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  vk_check(vkAllocateCommandBuffers(device.handle(), &allocate, &commands), "vkAllocateCommandBuffers");
  VkCommandBufferBeginInfo begin = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  vk_check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
  full_barrier(commands);
  record(commands);
  host_barrier(commands);
  vk_check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
  device.wait(device.submit(commands));
  device.check_validation();
}

void upload(Device& device, const Buffer& target, std::span<const std::byte> bytes) {
  GNOMON_ASSERT(bytes.size() <= target.bytes());
  if (bytes.empty()) return;
  // In pieces, so that a large scene does not need its size twice.
  constexpr size_t k_piece = size_t{64} << 20;
  const Buffer staging(device, "staging for " + target.name(), std::min(bytes.size(), k_piece), BufferMemory::upload);
  for (size_t offset = 0; offset < bytes.size(); offset += k_piece) {
    const size_t size = std::min(k_piece, bytes.size() - offset);
    std::memcpy(staging.mapped(), bytes.data() + offset, size);
    staging.flush();
    run_once(device, [&](VkCommandBuffer commands) {
      const VkBufferCopy region = {0, offset, size};
      vkCmdCopyBuffer(commands, staging.handle(), target.handle(), 1, &region);
    });
  }
}

std::vector<std::byte> read_back(Device& device, const Buffer& source, size_t bytes) {
  GNOMON_ASSERT(bytes <= source.bytes());
  const Buffer staging(device, "readback of " + source.name(), bytes, BufferMemory::readback);
  run_once(device, [&](VkCommandBuffer commands) {
    const VkBufferCopy region = {0, 0, bytes};
    vkCmdCopyBuffer(commands, source.handle(), staging.handle(), 1, &region);
  });
  staging.invalidate();
  return {staging.mapped(), staging.mapped() + bytes};
}

}  // namespace gnomon
