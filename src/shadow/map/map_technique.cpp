// Map, conversion, resolve.
#include "shadow/map/map_technique.h"

#include <cstring>

#include "base/error.h"
#include "frame/casters/layering_choice.h"
#include "frame/surface/pixel_tile.glsl"
#include "scene/light_shape.h"

namespace gnomon {
namespace {

// The GLSL structs end in `uint table_end`; shaders take each block's address for a multiple of 16.
size_t block_bytes(const ParamBlock& block) { return (block.words().size_bytes() + sizeof(uint32_t) + 15) / 16 * 16; }

LayeringPath chosen_path(const submission_params::Params& params, const DeviceInfo& device) {
  if (params.path == submission_params::path_automatic) return fastest_layering_path(device);
  return static_cast<LayeringPath>(params.path - submission_params::path_per_layer);
}

// A map that does not change is drawn until less than this of it is from before its last change, and then kept
// (submission.cache).
constexpr float k_settled = 1e-3f;

}  // namespace

MapTechnique::MapTechnique(TechniqueContext& context, const ProjectionInfo& projection, const FilterInfo& filter,
                           const SettingsMap& settings)
    : projection_id_(projection.id),
      filter_id_(filter.id),
      name_(projection.id + "/" + filter.id),
      projection_(projection.make(settings.at(projection.id))),
      filter_(filter.make(settings.at(filter.id))) {
  Device& device = context.device();
  submission_ = settings.at("submission").as<submission_params::Params>();
  history_ = settings.at("temporal").as<temporal_params::Params>().history;
  if (history_ > 0.0f && filter_->object_ids()) {
    fail_usage("temporal.history={}: {} stores objects, and there is no mean of two objects; valid: 0", history_, filter_id_);
  }
  create_map(device, context.frame().scene());
  const MapInfo map = {name_, projection_->map_size(), projection_->layers(), history_};
  filter_->prepare(device, map);
  if (history_ > 0.0f && !filter_->blends_history()) depth_history_ = DepthHistory(device, map);
  const auto make_views = [&](const char* suffix) {
    return Buffer(device, name_ + suffix, sizeof(ShadowMapData) + projection_->layers() * sizeof(ShadowView),
                  BufferMemory::upload);
  };
  views_ = make_views(" views");
  if (history_ > 0.0f) last_views_ = make_views(" last views");
  view_bytes_.resize(views_.bytes());
  filter_offset_ = block_bytes(settings.at(projection_id_));
  bias_offset_ = filter_offset_ + block_bytes(settings.at(filter_id_));
  params_ = Buffer(device, name_ + " parameters", bias_offset_ + block_bytes(settings.at("bias")), BufferMemory::upload);
  resolve_ = make_compute_pipeline(device, "resolve/" + name_ + ".comp", {context.frame().samples()});
  set(settings);
}

void MapTechnique::create_map(Device& device, const GpuScene& scene) {
  ImageInfo map;
  map.name = name_ + " depth map";
  map.width = map.height = projection_->map_size();
  map.layers = projection_->layers();
  map.array = true;
  map.format = VK_FORMAT_D32_SFLOAT;
  map.samples = filter_->depth_samples();
  map.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
  if (history_ > 0.0f && !filter_->blends_history()) map.usage |= VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  depth_ = Image(device, map);
  if (filter_->object_ids()) {
    map.name = name_ + " object ids";
    map.format = VK_FORMAT_R32_UINT;
    map.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
    object_ids_ = Image(device, map);
  }
  CasterDrawOptions options;
  options.path = chosen_path(submission_, device.info());
  options.depth_clamp = projection_->depth_clamp();
  options.paraboloid = projection_->exact_paraboloid();
  options.layers = map.layers;
  options.samples = map.samples;
  options.object_ids = filter_->object_ids();
  options.item_ids = filter_->item_ids();
  draws_ = std::make_unique<CasterDraws>(device, scene, name_, options);
}

void MapTechnique::set(const SettingsMap& settings) {
  const auto store = [&](std::string_view id, size_t offset) -> const ParamBlock& {
    const ParamBlock& block = settings.find(id)->second;
    if (!block.words().empty()) std::memcpy(params_.mapped() + offset, block.words().data(), block.words().size_bytes());
    return block;
  };
  projection_->set(store(projection_id_, 0));
  filter_->set(store(filter_id_, filter_offset_));
  bias_ = store("bias", bias_offset_).as<bias_params::Params>();
  submission_ = settings.at("submission").as<submission_params::Params>();
  params_.flush();
  map_is_current_ = false;
}

bool MapTechnique::update_views(const Frame& frame, const Light& light) {
  std::vector<ShadowView> views = projection_->views(frame, light);
  for (ShadowView& view : views) {
    view.raster.kernel_m = filter_->reach() * view.texel_m;
    // What nobody reads in this frame the next one may blend with.
    if (history_ > 0.0f) view.raster.served = 0.0f;
  }
  GNOMON_ASSERT(views.size() <= projection_->layers());
  std::vector<std::byte> bytes(views_.bytes());
  const CameraData& camera = frame.camera();
  ShadowMapData map = {};
  map.eye_depth = vec4(camera.forward_ws, -glm::dot(camera.forward_ws, camera.eye_ws));
  map.emitter_radius = light_shape(light, true).emitter_radius;
  map.parallel = light.parallel();
  map.layers = static_cast<uint32_t>(views.size());
  std::memcpy(bytes.data(), &map, sizeof map);
  std::memcpy(bytes.data() + sizeof map, views.data(), views.size() * sizeof(ShadowView));
  // Layers that this frame does not need keep `in_use` at 0.
  const bool same = std::memcmp(bytes.data() + sizeof map, view_bytes_.data() + sizeof map, bytes.size() - sizeof map) == 0;
  view_bytes_ = std::move(bytes);
  if (history_ > 0.0f) std::swap(views_, last_views_);
  std::memcpy(views_.mapped(), view_bytes_.data(), view_bytes_.size());
  views_.flush();
  return !same;
}

DrawnMap MapTechnique::drawn() const {
  return {depth_, filter_->object_ids() ? &object_ids_ : nullptr, views_, params_.address() + filter_offset_,
          history_ > 0.0f && map_is_current_ ? &last_views_ : nullptr};
}

void MapTechnique::record(Recorder& recorder, const Frame& frame, size_t light) {
  const bool moved = update_views(frame, frame.lights()[light]) || projection_->on_gpu();
  if (moved) unsettled_ = 1.0f;
  if (!map_is_current_) unsettled_ = 0.0f;
  kept_ = submission_.cache && !moved && map_is_current_ && unsettled_ <= k_settled;
  if (!kept_) {
    try {
      record_map(recorder, frame, light);
    } catch (...) {
      map_is_current_ = false;  // the recorder may have given it up halfway
      throw;
    }
    unsettled_ *= history_;
  }
  map_is_current_ = true;
  record_resolve(recorder, frame, light);
}

std::optional<ShadowMapView> MapTechnique::shadow_map() const {
  if (!map_is_current_) return std::nullopt;
  const DrawnMap map = drawn();
  return ShadowMapView{projection_id_, filter_id_,     &depth_,      &filter_->map(map),    map.object_ids, &views_,
                       &params_,       filter_offset_, bias_offset_, projection_->layers(), kept_,          unsettled_};
}

void MapTechnique::record_map(Recorder& recorder, const Frame& frame, size_t light) {
  projection_->record_views(recorder, frame, frame.lights()[light], views_);
  // What stands behind a projector must not be drawn onto its near plane.
  const bool clip_near = frame.lights()[light].kind == LightKind::projector;
  const LightViews views = {&views_, sizeof(ShadowMapData), sizeof(ShadowView), projection_->layers(), clip_near};
  draws_->record(recorder, projection_id_, views, static_cast<CasterCulling>(submission_.culling),
                 bias_.front_face_culling != 0, depth_, filter_->object_ids() ? &object_ids_ : nullptr);
  if (history_ > 0.0f && !filter_->blends_history()) depth_history_.record(recorder, drawn());
  filter_->record(recorder, drawn());
}

void MapTechnique::record_resolve(Recorder& recorder, const Frame& frame, size_t light) {
  struct Arguments {
    uint64_t frame, views, projection, filter, bias, mask;
    uint32_t light, map_image, object_image, unused;
  };
  const Image& map = filter_->map(drawn());
  const Arguments arguments = {frame.data_address(),
                               views_.address(),
                               params_.address(),
                               params_.address() + filter_offset_,
                               params_.address() + bias_offset_,
                               frame.mask_address(light),
                               static_cast<uint32_t>(light),
                               map.sampled(),
                               filter_->object_ids() ? object_ids_.sampled() : 0,
                               0};
  std::vector<ResourceUse> uses = frame.surface_uses(Use::compute_read);
  uses.emplace_back(map, Use::compute_read);
  if (filter_->object_ids()) uses.emplace_back(object_ids_, Use::compute_read);
  uses.emplace_back(views_, Use::compute_read);
  uses.emplace_back(frame.mask(), Use::compute_write);
  recorder.pass(name_ + "/resolve", PassStage::resolve, uses, [&](Commands& commands) {
    commands.bind(resolve_);
    commands.push(arguments);
    commands.dispatch(frame.size(), glm::uvec2(k_pixel_tile));
  });
}

}  // namespace gnomon
