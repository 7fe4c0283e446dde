// The two kernels.
#include "lab/timing/bench_kernels.h"

#include "base/error.h"

namespace gnomon {
namespace {

class CopyKernel : public Technique {
 public:
  CopyKernel(Device& device, uint32_t texels)
      : side_(texels),
        from_(device, "copy source", size_t{4} * texels * texels),
        to_(device, "copy target", size_t{8} * texels * texels),
        pipeline_(make_compute_pipeline(device, "lab/timing/bench_copy.comp")) {
    const std::vector<float> zeros(size_t{texels} * texels);
    upload(device, from_, std::as_bytes(std::span(zeros)));
  }
  void set(const SettingsMap&) override {}
  void record(Recorder& recorder, const Frame&, size_t) override {
    recorder.pass("kernel/copy", PassStage::build, {{from_, Use::compute_read}, {to_, Use::compute_write}},
                  [&](Commands& commands) {
                    struct Arguments {
                      uint64_t from, to;
                      uint32_t side, unused;
                    };
                    commands.bind(pipeline_);
                    commands.push(Arguments{from_.address(), to_.address(), side_, 0});
                    commands.dispatch(uvec2(side_), {64, 4});
                  });
  }

 private:
  uint32_t side_;
  Buffer from_, to_;
  Pipeline pipeline_;
};

class SurfaceReadKernel : public Technique {
 public:
  explicit SurfaceReadKernel(Device& device) : pipeline_(make_compute_pipeline(device, "lab/timing/bench_surface_read.comp")) {}
  void set(const SettingsMap&) override {}
  void record(Recorder& recorder, const Frame& frame, size_t light) override {
    std::vector<ResourceUse> uses = frame.surface_uses(Use::compute_read);
    uses.emplace_back(frame.mask(), Use::compute_write);
    recorder.pass("kernel/surface_read", PassStage::resolve, uses, [&](Commands& commands) {
      struct Arguments {
        uint64_t frame, mask;
      };
      commands.bind(pipeline_);
      commands.push(Arguments{frame.data_address(), frame.mask_address(light)});
      commands.dispatch(frame.size(), {8, 8});
    });
  }

 private:
  Pipeline pipeline_;
};

}  // namespace

std::unique_ptr<Technique> make_bench_kernel(Device& device, const std::string& kernel, uint32_t texels) {
  if (kernel == "copy") return std::make_unique<CopyKernel>(device, texels);
  GNOMON_ASSERT(kernel == "surface_read");
  return std::make_unique<SurfaceReadKernel>(device);
}

}  // namespace gnomon
