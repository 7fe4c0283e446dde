// The passes of overlays and picks.
#include "shadow/explainer.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "base/error.h"
#include "frame/surface/pixel_tile.glsl"

namespace gnomon {
namespace {

constexpr std::array<std::string_view, k_overlay_count> k_overlay_names = {"none",      "layers", "texels",
                                                                           "footprint", "flags",  "overdraw"};

bool stores_integers(VkFormat format) { return format == VK_FORMAT_R32G32_UINT || format == VK_FORMAT_R32_UINT; }

}  // namespace

std::string_view overlay_name(uint32_t overlay) { return k_overlay_names[overlay]; }

bool overlay_needs_map(uint32_t overlay) {
  return overlay == k_overlay_layers || overlay == k_overlay_texels || overlay == k_overlay_footprint;
}

Explainer::Explainer(Device& device)
    : device_(device),
      radius_(device, "explain radius", sizeof(float)),
      record_(device, "explain pick", sizeof(PickRecord), BufferMemory::readback),
      views_(device, "explain views", sizeof(ShadowMapData) + k_max_layers * sizeof(ShadowView), BufferMemory::readback) {}

const Pipeline& Explainer::pipeline(const std::string& shader, uint32_t samples) {
  Pipeline& made = pipelines_[fmt::format("{} {}", shader, samples)];
  if (!made) made = make_compute_pipeline(device_, shader, {samples});
  return made;
}

void Explainer::record_overlay(Recorder& recorder, const Frame& frame, size_t light, const Technique& technique,
                               uint32_t overlay, float opacity) {
  GNOMON_ASSERT(overlay > k_overlay_none && overlay < k_overlay_count);
  // Overdraw is the frame's own.
  const auto map = overlay == k_overlay_overdraw ? std::nullopt : technique.shadow_map();
  if (overlay_needs_map(overlay) && !map) return;
  ExplainArguments arguments = {};
  arguments.overlay = overlay;
  arguments.opacity = opacity;
  arguments.output_words = frame.display().address();
  if (overlay == k_overlay_overdraw) {
    if (!overdraw_ || overdraw_->size() != frame.size()) overdraw_.emplace(device_, frame.size());
    overdraw_->record(recorder, frame);
    arguments.overdraw_image = overdraw_->image().sampled();
  }
  record(recorder, "explain/overlay", frame, light, map, arguments, frame.display());
}

void Explainer::record_pick(Recorder& recorder, const Frame& frame, size_t light, const Technique& technique, uvec2 pixel) {
  ExplainArguments arguments = {};
  arguments.overlay = k_overlay_none;
  arguments.pixel = glm::min(pixel, frame.size() - 1u);
  arguments.output_words = record_.address();
  record(recorder, "explain/pick", frame, light, technique.shadow_map(), arguments, record_);
}

void Explainer::record(Recorder& recorder, const char* pass, const Frame& frame, size_t light,
                       const std::optional<ShadowMapView>& map, ExplainArguments arguments, const Buffer& output) {
  arguments.frame = frame.data_address();
  arguments.light = static_cast<uint32_t>(light);
  arguments.mask = frame.mask_address(light);
  std::vector<ResourceUse> uses = frame.surface_uses(Use::compute_read);
  uses.emplace_back(frame.mask(), Use::compute_read);
  uses.emplace_back(output, Use::compute_write);
  if (arguments.overlay == k_overlay_overdraw) uses.emplace_back(overdraw_->image(), Use::compute_read);
  if (map) {
    const struct { uint64_t filter, radius; } of_radius = {map->params->address() + map->filter_offset, radius_.address()};
    recorder.pass("explain/radius", PassStage::other, {{radius_, Use::compute_write}}, [&](Commands& commands) {
      commands.bind(pipeline("radius/" + map->filter + ".comp", 1));
      commands.push(of_radius);
      commands.dispatch({1, 1}, {1, 1});
    });
    arguments.views = map->views->address();
    arguments.projection = map->params->address();
    arguments.bias = map->params->address() + map->bias_offset;
    arguments.radius = radius_.address();
    arguments.depth_image = map->depth->sampled();
    arguments.filtered_image = map->filtered->sampled();
    arguments.object_image = map->object_ids ? map->object_ids->sampled() : 0;
    arguments.flags = (map->depth->info().samples > 1 ? k_explain_multisampled : 0) |
                      (stores_integers(map->filtered->info().format) ? k_explain_integers : 0) |
                      (map->object_ids ? k_explain_objects : 0);
    uses.emplace_back(*map->depth, Use::compute_read);
    if (map->filtered != map->depth) uses.emplace_back(*map->filtered, Use::compute_read);
    if (map->object_ids) uses.emplace_back(*map->object_ids, Use::compute_read);
    uses.emplace_back(*map->views, Use::compute_read);
    uses.emplace_back(radius_, Use::compute_read);
  }
  const bool picks = arguments.overlay == k_overlay_none;
  recorder.pass(pass, PassStage::other, uses, [&](Commands& commands) {
    commands.bind(pipeline(map ? "explain/" + map->projection + ".comp" : "shadow/explain.comp", frame.samples()));
    commands.push(arguments);
    commands.dispatch(picks ? uvec2(1) : frame.size(), uvec2(k_pixel_tile));
  });
}

void Explainer::record_views(Recorder& recorder, const Technique& technique) {
  const auto map = technique.shadow_map();
  has_views_ = map.has_value();
  if (!map) return;
  recorder.pass("explain/views", PassStage::other, {{*map->views, Use::copy_read}, {views_, Use::copy_write}},
                [&](Commands& commands) { commands.copy(*map->views, views_, std::min(map->views->bytes(), views_.bytes())); });
}

PickRecord Explainer::picked() const {
  record_.invalidate();
  PickRecord record;
  std::memcpy(&record, record_.mapped(), sizeof record);
  return record;
}

std::vector<ShadowView> Explainer::views() const {
  if (!has_views_) return {};
  views_.invalidate();
  ShadowMapData map;
  std::memcpy(&map, views_.mapped(), sizeof map);
  std::vector<ShadowView> views(std::min(map.layers, k_max_layers));
  std::memcpy(views.data(), views_.mapped() + sizeof map, views.size() * sizeof(ShadowView));
  return views;
}

}  // namespace gnomon
