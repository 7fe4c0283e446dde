// Summed-area variance shadow maps (Lauritzen 2007, "Summed-Area Variance Shadow Maps", GPU Gems 3, chapter 8): a table of
// running sums gives the moments of any rectangle at a constant number of reads. Cost: two passes over the map (rows, columns),
// 16 reads a point. Fails: as vsm, and with a box instead of a Gaussian.
#include <array>

#include "shadow/map/filter.h"
#include "shadow/registry.h"

namespace gnomon {
namespace {

#include "shadow/technique_params.h"

constexpr const char* k_manual =
    "Summed-area variance shadow map: mean and variance of depth over a square of any width, at constant cost.\n"
    "Lauritzen 2007 (GPU Gems 3, chapter 8). Running sums of depth and of its square in 32-bit integers, which are exact "
    "however\n"
    "large the map: sums wrap around, and only the square that is read must fit (savsm.width=3 leaves 27 bits for a texel,\n"
    "64 leaves 19). The edges of the square fall between texels, so the width is continuous. Light bleeds as with vsm.";

class Savsm : public Filter {
 public:
  explicit Savsm(const ParamBlock& params) { set(params); }
  void set(const ParamBlock& params) override { params_ = params.as<Params>(); }
  float reach() const override { return 0.5f * params_.width + 3.0f; }
  void prepare(Device& device, const MapInfo& info) override {
    name_ = info.name;
    ImageInfo table;
    table.name = info.name + " sums";
    table.width = table.height = info.size;
    table.layers = info.layers;
    table.array = true;
    table.format = VK_FORMAT_R32G32_UINT;
    table.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    table_ = Image(device, table);
    for (const uint32_t columns : {0u, 1u}) {
      sums_[columns] =
          make_compute_pipeline(device, "shadow/map/filter/savsm/sum.comp", {columns, columns ? k_columns_at_once : 1u});
    }
  }
  void record(Recorder& recorder, const DrawnMap& map) override {
    const uint32_t size = table_.info().width, layers = table_.info().layers;
    const Arguments arguments = {map.views.address(), map.depth.sampled(), table_.storage(), size, params_.width};
    const auto sum = [&](uint32_t columns, uint32_t groups) {
      return [=, this](Commands& commands) {
        commands.bind(sums_[columns]);
        commands.push(arguments);
        commands.dispatch(glm::uvec3(groups, layers, 1));
      };
    };
    recorder.pass(name_ + "/sum_rows", PassStage::build,
                  {{map.depth, Use::compute_read}, {map.views, Use::compute_read}, {table_, Use::compute_write}}, sum(0, size));
    recorder.pass(name_ + "/sum_columns", PassStage::build, {{map.views, Use::compute_read}, {table_, Use::compute_write}},
                  sum(1, (size + k_columns_at_once - 1) / k_columns_at_once));
  }
  const Image& map(const DrawnMap&) const override { return table_; }

 private:
  static constexpr uint32_t k_columns_at_once = 16;
  struct Arguments {
    uint64_t views;
    uint32_t depth_image, table, size;
    float width;
  };
  Params params_;
  std::string name_;
  Image table_;
  std::array<Pipeline, 2> sums_;  // along rows, along columns
};

}  // namespace

GNOMON_REGISTER(filter, Filter) {
  return {GNOMON_ID_TEXT, k_manual, param_table_storage(), [](const ProjectionInfo&) { return std::string(); },
          [](const ParamBlock& params) -> std::unique_ptr<Filter> { return std::make_unique<Savsm>(params); }};
}

}  // namespace gnomon
