// Culling and drawing of casters.
#include "frame/casters/caster_draws.h"

#include <algorithm>

#include "base/error.h"

namespace gnomon {
namespace {

uint32_t draw_layout(LayeringPath path) {
  switch (path) {
    case LayeringPath::per_layer:
      return k_draws_per_layer;
    case LayeringPath::vertex_layer:
      return k_draws_layered;
    case LayeringPath::geometry:
    case LayeringPath::multiview:
      return k_draws_union;
  }
  return k_draws_per_layer;
}

}  // namespace

std::string_view layering_path_name(LayeringPath path) {
  constexpr std::string_view k_names[] = {"per_layer", "vertex_layer", "geometry", "multiview"};
  return k_names[static_cast<size_t>(path)];
}

std::string layering_path_missing(const DeviceInfo& device, LayeringPath path) {
  if (path == LayeringPath::vertex_layer && !device.vertex_layer) return "shaderOutputLayer";
  if (path == LayeringPath::geometry && !device.geometry_shader) return "geometryShader";
  if (path == LayeringPath::multiview && !device.multiview) return "multiview";
  return {};
}

CasterDraws::CasterDraws(Device& device, const GpuScene& scene, const std::string& name, const CasterDrawOptions& options)
    : device_(&device), scene_(&scene), options_(options) {
  // With one layer all paths are the same work.
  if (options_.layers == 1) options_.path = LayeringPath::per_layer;
  if (options_.paraboloid) options_.path = LayeringPath::geometry;
  if (const std::string missing = layering_path_missing(device.info(), options_.path); !missing.empty()) {
    fail_device("submission.path={}: '{}' lacks {}", layering_path_name(options_.path), device.info().name, missing);
  }
  const size_t ranges = std::max<size_t>(scene.caster_clusters().range_count, 1),
               chunks = std::max<size_t>(scene.caster_clusters().chunk_count, 1);
  draws_ = Buffer(device, name + " draws", options_.layers * ranges * sizeof(DrawCommand));
  counts_ = Buffer(device, name + " draw counts", options_.layers * k_bucket_count * sizeof(uint32_t));
  chunk_counts_ = Buffer(device, name + " chunk counts", options_.layers * chunks * sizeof(uint32_t));
  count_ = make_compute_pipeline(device, "frame/casters/culling/cull_casters.comp", {0});
  write_ = make_compute_pipeline(device, "frame/casters/culling/cull_casters.comp", {1});
  clipped_ = make_pipelines(false);
  if (options_.depth_clamp) clamped_ = make_pipelines(true);
}

CasterDraws::DrawPipelines CasterDraws::make_pipelines(bool depth_clamp) const {
  DrawPipelines pipelines;
  GraphicsPipelineInfo info;
  info.depth_compare = VK_COMPARE_OP_LESS;
  info.depth_clamp = depth_clamp;
  info.samples = options_.samples;
  if (options_.object_ids) info.colour_formats = {VK_FORMAT_R32_UINT}, info.constants = {options_.item_ids};
  if (options_.path == LayeringPath::multiview) info.view_mask = (1u << options_.layers) - 1u;
  const std::string path(layering_path_name(options_.path));
  const std::string_view fragment = options_.object_ids ? "frame/casters/draw/caster_id.frag" : "";
  for (const bool masked : {false, true}) {
    // The vertex shader of masked items also tells the item.
    const std::string kind = masked || options_.object_ids ? "masked" : "opaque";
    info.vertex = fmt::format("frame/casters/draw/caster_{}_{}.vert", path, kind);
    if (options_.path == LayeringPath::geometry) info.geometry = fmt::format("frame/casters/draw/caster_{}.geom", kind);
    info.fragment =
        masked ? (options_.object_ids ? "frame/casters/draw/caster_masked_id.frag" : "frame/casters/draw/caster_masked.frag")
               : fragment;
    if (options_.paraboloid) {
      info.vertex = "frame/casters/draw/caster_geometry_masked.vert";
      info.geometry = "frame/casters/draw/caster_paraboloid.geom";
      info.fragment = fmt::format("frame/casters/draw/caster_paraboloid{}{}.frag", masked ? "_masked" : "",
                                  options_.object_ids ? "_id" : "");
    }
    (masked ? pipelines.masked : pipelines.opaque) = make_graphics_pipeline(*device_, info);
  }
  return pipelines;
}

void CasterDraws::record(Recorder& recorder, const std::string& prefix, const LightViews& views, CasterCulling culling,
                         bool front_face_culling, const Image& map, const Image* ids) {
  GNOMON_ASSERT(views.layers == options_.layers && options_.object_ids == (ids != nullptr));
  record_cull(recorder, prefix, views, culling);
  const CasterList& list = scene_->casters(culling == CasterCulling::clusters);
  if (options_.path != LayeringPath::per_layer || options_.layers == 1) {
    record_layers(recorder, prefix + "/depth", views, list, front_face_culling, map, ids, 0, options_.layers);
    return;
  }
  for (uint32_t layer = 0; layer < options_.layers; ++layer) {
    record_layers(recorder, fmt::format("{}/depth/{}", prefix, layer), views, list, front_face_culling, map, ids, layer, 1);
  }
}

void CasterDraws::record_cull(Recorder& recorder, const std::string& prefix, const LightViews& views, CasterCulling culling) {
  const CasterList& list = scene_->casters(culling == CasterCulling::clusters);
  const uint32_t layout = draw_layout(options_.path);
  const CasterCullArguments arguments = {views.address(),
                                         list.ranges.address(),
                                         list.chunks.address(),
                                         scene_->items().address(),
                                         draws_.address(),
                                         counts_.address(),
                                         chunk_counts_.address(),
                                         views.stride,
                                         views.layers,
                                         list.chunk_count,
                                         list.range_count,
                                         layout,
                                         culling != CasterCulling::none};
  const uint32_t rows = layout == k_draws_union ? 1 : views.layers;
  recorder.pass(prefix + "/cull", PassStage::build,
                {{*views.buffer, Use::compute_read},
                 {draws_, Use::compute_write},
                 {counts_, Use::compute_write},
                 {chunk_counts_, Use::compute_write}},
                [&](Commands& commands) {
                  if (list.chunk_count == 0) return;
                  for (const Pipeline* pipeline : {&count_, &write_}) {
                    if (pipeline == &write_) commands.compute_barrier();
                    commands.bind(*pipeline);
                    commands.push(arguments);
                    commands.dispatch({list.chunk_count, rows}, {1, 1});
                  }
                });
}

void CasterDraws::record_layers(Recorder& recorder, const std::string& name, const LightViews& views, const CasterList& list,
                                bool front_face_culling, const Image& map, const Image* ids, uint32_t first_layer,
                                uint32_t layer_count) {
  struct Arguments {
    uint64_t views;
    uint32_t stride, layers;
    SceneData scene;
  };
  const DrawPipelines& pipelines = options_.depth_clamp && !views.clip_near ? clamped_ : clipped_;
  const bool whole = layer_count > 1;
  const bool per_layer = draw_layout(options_.path) == k_draws_per_layer;
  std::vector<ResourceUse> uses = {{*views.buffer, Use::graphics_read},
                                   {draws_, Use::indirect_read},
                                   {counts_, Use::indirect_read},
                                   {map, Use::depth_write}};
  if (ids) uses.emplace_back(*ids, Use::colour_write);
  recorder.pass(name, PassStage::build, uses, [&](Commands& commands) {
    Attachment depth;
    depth.view = whole ? map.attachment_view() : map.layer_view(first_layer);
    depth.clear.depthStencil = {1.0f, 0};
    std::vector<Attachment> colours;
    if (ids) colours.push_back({whole ? ids->attachment_view() : ids->layer_view(first_layer), {}});
    const bool multiview = options_.path == LayeringPath::multiview;
    commands.begin_rendering({map.info().width, map.info().height}, colours, depth, multiview ? 1 : layer_count,
                             multiview ? (1u << layer_count) - 1u : 0u);
    for (const bool masked : {false, true}) {
      commands.bind(masked ? pipelines.masked : pipelines.opaque);
      commands.push(
          Arguments{views.address() + uint64_t{views.stride} * first_layer, views.stride, layer_count, scene_->data()});
      for (uint32_t bucket = 0; bucket < k_bucket_count; ++bucket) {
        if (((bucket & Bucket::k_masked) != 0) != masked || list.begin[bucket] == list.end[bucket]) continue;
        const VkCullModeFlags front = bucket & Bucket::k_mirrored ? VK_CULL_MODE_BACK_BIT : VK_CULL_MODE_FRONT_BIT;
        commands.cull_mode(front_face_culling && !masked ? front : VkCullModeFlags{VK_CULL_MODE_NONE});
        const uint32_t size = list.end[bucket] - list.begin[bucket];
        const uint32_t shared = options_.path == LayeringPath::vertex_layer ? options_.layers : 1;
        const uint32_t first = per_layer ? first_layer * list.range_count + list.begin[bucket] : list.begin[bucket] * shared;
        const uint32_t count = per_layer ? first_layer * k_bucket_count + bucket : bucket;
        commands.draw_indirect(scene_->indices(), draws_, first * sizeof(DrawCommand), counts_, count * sizeof(uint32_t),
                               size * shared);
      }
    }
    commands.end_rendering();
  });
}

}  // namespace gnomon
