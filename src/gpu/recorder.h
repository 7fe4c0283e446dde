// Records a frame as a list of passes. A pass is one scope: it names what it reads and writes, and barriers, debug label,
// timestamps and counters come from that. No graph: passes run in the order in which they are written.
#pragma once

#include <cstring>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/maths.h"
#include "gpu/buffer.h"
#include "gpu/image.h"
#include "gpu/pipeline.h"

namespace gnomon {

// How passes are separated, and so what their times mean.
enum class TimingMode {
  play,     // tight barriers: passes may overlap, as in a game
  measure,  // full barriers: a pass has the device to itself; its time is its own
};

// What a pass belongs to in a report: gpu_ms of a technique is the sum of build and resolve.
enum class PassStage { surface, build, resolve, shade, other };
std::string_view stage_name(PassStage stage);

struct PassResult {
  std::string name;
  PassStage stage = PassStage::other;
  double gpu_ms = 0.0;   // between the pass's timestamps
  double wall_ms = 0.0;  // of its own submission, less submission_ms; only when passes are submitted alone
  uint32_t draws = 0, dispatches = 0;
  uint64_t triangles = 0;  // assembled by the rasteriser
};

struct FrameResult {
  std::vector<PassResult> passes;
  double gpu_ms = 0.0;         // first to last timestamp
  double wall_ms = 0.0;        // submission to completion; the sum of the passes' when they are submitted alone
  double submission_ms = 0.0;  // wall time of a submission that does nothing; only when passes are submitted alone
  double record_ms = 0.0;      // CPU time to record and submit
};

// One resource and how a pass uses it.
struct ResourceUse {
  ResourceUse(const Buffer& buffer, Use how) : resource(&buffer), use(how) {}
  ResourceUse(const Image& image, Use how) : resource(&image), use(how) {}
  std::variant<const Buffer*, const Image*> resource;
  Use use;
};

// A colour or depth attachment of a rendering scope.
struct Attachment {
  VkImageView view = VK_NULL_HANDLE;
  VkClearValue clear = {};
};

// What may be recorded inside a pass.
class Commands {
 public:
  VkCommandBuffer handle() const { return commands_; }
  void bind(const Pipeline& pipeline);
  // At most 128 bytes, read by every shader of the pipeline.
  template <class T>
  void push(const T& constants) {
    push_bytes(std::as_bytes(std::span(&constants, 1)));
  }
  // Enough groups of `group` invocations to cover `count`.
  void dispatch(uvec2 count, uvec2 group);
  void dispatch_1d(uint32_t count, uint32_t group);
  void dispatch(glm::uvec3 groups);
  // Between two dispatches of one pass: the second reads what the first wrote.
  void compute_barrier();
  // view_mask: of multiview, else 0.
  void begin_rendering(uvec2 size, std::span<const Attachment> colours, const Attachment& depth, uint32_t layers = 1,
                       uint32_t view_mask = 0);
  void end_rendering();
  void cull_mode(VkCullModeFlags mode);
  // Indexed, indirect, with the count at `count_offset` of `counts` (bytes); at most `max_draws`.
  void draw_indirect(const Buffer& indices, const Buffer& draws, size_t draws_offset, const Buffer& counts, size_t count_offset,
                     uint32_t max_draws);
  void trace(const RayPipeline& pipeline, uvec2 size);
  void copy(const Buffer& from, const Buffer& to, size_t bytes, size_t from_offset = 0, size_t to_offset = 0);
  // Texels, row by row and layer by layer, into mip 0.
  void copy(const Buffer& from, const Image& to);

 private:
  friend class Recorder;
  void push_bytes(std::span<const std::byte> bytes);

  struct CountRead {
    const Buffer* counts;
    size_t offset;
  };
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  Device* device_ = nullptr;
  uint32_t draws_ = 0, dispatches_ = 0;
  std::vector<CountRead> count_reads_;
};

// Thrown by Recorder::pass: the frame is not drawn to its end.
struct GivenUp {};

class Recorder {
 public:
  static constexpr uint32_t k_max_passes = 256;

  // isolate: submits each pass alone and times it against the wall clock too (software devices: design rule 5).
  Recorder(Device& device, TimingMode mode, bool isolate);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  // Asked behind each pass that is submitted alone: true gives the frame up, and the passes so far stay done.
  void give_up_when(std::function<bool()> asked) { gives_up_ = std::move(asked); }

  void begin();
  // Throws GivenUp where that was asked for; the recorder can then begin again.
  void pass(std::string name, PassStage stage, std::span<const ResourceUse> uses, const std::function<void(Commands&)>& record);
  void pass(std::string name, PassStage stage, std::initializer_list<ResourceUse> uses,
            const std::function<void(Commands&)>& record) {
    pass(std::move(name), stage, std::span(uses.begin(), uses.size()), record);
  }
  // Submits, waits, returns the times. Throws ValidationError, DeviceLost.
  FrameResult finish();
  // All three, with the passes that `record` writes. Where it throws, none of them is submitted, and resources are tracked as
  // they were: for callers that go on.
  FrameResult frame(const std::function<void()>& record);

 private:
  void begin_commands();
  void abandon();
  Transition advance_state(const std::shared_ptr<ResourceState>& state, Use use);
  uint64_t end_and_submit();
  double submit_alone();
  void barriers(std::span<const ResourceUse> uses);
  void copy_draw_counts(const Commands& commands);
  void collect(FrameResult& result);

  Device& device_;
  TimingMode mode_;
  bool isolate_;
  bool recording_ = false;
  std::vector<std::pair<std::shared_ptr<ResourceState>, ResourceState>> states_before_;  // since the last submission, in order
  VkCommandPool pool_ = VK_NULL_HANDLE;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  VkQueryPool timestamps_ = VK_NULL_HANDLE, statistics_ = VK_NULL_HANDLE;
  Buffer draw_counts_;  // one word per indirect draw of the frame, copied back
  uint32_t draw_count_words_ = 0;
  std::vector<PassResult> passes_;
  std::vector<std::pair<uint32_t, uint32_t>> count_ranges_;  // per pass: first word and count in draw_counts_
  std::vector<bool> has_statistics_;
  std::function<bool()> gives_up_;
  double wall_ms_ = 0.0, record_ms_ = 0.0, submission_ms_ = 0.0;
  double record_start_ = 0.0;
};

// A one-off submission outside any frame: uploads, builds, readback.
void run_once(Device& device, const std::function<void(VkCommandBuffer)>& record);

// Copies to a device buffer through a staging buffer, and waits.
void upload(Device& device, const Buffer& target, std::span<const std::byte> bytes);
// Copies from a device buffer, and waits.
std::vector<std::byte> read_back(Device& device, const Buffer& source, size_t bytes);
template <class T>
std::vector<T> read_back_as(Device& device, const Buffer& source, size_t count) {
  const auto bytes = read_back(device, source, count * sizeof(T));
  std::vector<T> values(count);
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

}  // namespace gnomon
