// Map, conversion, resolve.
#include "shadow/map/map_technique.h"

#include <cstring>

#include "base/error.h"

namespace gnomon {
namespace {

// The GLSL structs end in `uint table_end`.
size_t block_bytes(const ParamBlock& block) { return block.words().size_bytes() + sizeof(uint32_t); }

}  // namespace

MapTechnique::MapTechnique(TechniqueContext& context, const ProjectionInfo& projection, const FilterInfo& filter, const SettingsMap& settings)
    : projection_id_(projection.id),
      filter_id_(filter.id),
      name_(projection.id + "/" + filter.id),
      projection_(projection.make(settings.at(projection.id))),
      filter_(filter.make(settings.at(filter.id))) {
  Device& device = context.device();
  ImageInfo map;
  map.name = name_ + " depth map";
  map.width = map.height = projection_->map_size();
  map.layers = projection_->layers();
  map.array = true;
  map.format = VK_FORMAT_D32_SFLOAT;
  map.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
  depth_ = Image(device, map);
  filter_->prepare(device, depth_);
  views_ = Buffer(device, name_ + " views", map.layers * sizeof(ShadowView), BufferMemory::upload);
  filter_offset_ = block_bytes(settings.at(projection_id_));
  bias_offset_ = filter_offset_ + block_bytes(settings.at(filter_id_));
  params_ = Buffer(device, name_ + " parameters", bias_offset_ + block_bytes(settings.at("bias")), BufferMemory::upload);
  for (uint32_t layer = 0; layer < map.layers; ++layer) {
    draws_.emplace_back(device, context.frame().scene(), fmt::format("{} layer {}", name_, layer));
  }
  depth_pipelines_ = make_depth_pipelines(device, projection_->depth_clamp());
  resolve_ = make_compute_pipeline(device, "resolve/" + name_ + ".comp");
  set(settings);
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
  params_.flush();
}

void MapTechnique::record(Recorder& recorder, const Frame& frame, size_t light) {
  const std::vector<ShadowView> views = projection_->views(frame, frame.lights()[light]);
  GNOMON_ASSERT(views.size() == projection_->layers());
  std::memcpy(views_.mapped(), views.data(), views.size() * sizeof(ShadowView));
  views_.flush();

  const bool single_layer = projection_->layers() == 1;
  for (uint32_t layer = 0; layer < projection_->layers(); ++layer) {
    const uint64_t view = views_.address() + layer * sizeof(ShadowView);
    const std::string suffix = single_layer ? "" : fmt::format("/{}", layer);
    draws_[layer].record(recorder, frame.cull_pipeline(), projection_id_ + "/cull" + suffix, PassStage::build, view, k_cull_casters_only);
    record_depth_pass(recorder, projection_id_ + "/depth" + suffix, frame.scene(), depth_pipelines_, draws_[layer], depth_, layer, view,
                      bias_.front_face_culling != 0);
  }
  filter_->record(recorder, depth_);
  record_resolve(recorder, frame, light);
}

void MapTechnique::record_resolve(Recorder& recorder, const Frame& frame, size_t light) {
  struct Arguments {
    uint64_t frame, views, projection, filter, bias, mask;
    uint32_t light, map_image;
  };
  const Image& map = filter_->map(depth_);
  const Arguments arguments = {frame.data_address(),
                               views_.address(),
                               params_.address(),
                               params_.address() + filter_offset_,
                               params_.address() + bias_offset_,
                               frame.mask_address(light),
                               static_cast<uint32_t>(light),
                               map.sampled()};
  std::vector<ResourceUse> uses = frame.surface_uses(Use::compute_read);
  uses.emplace_back(map, Use::compute_read);
  uses.emplace_back(frame.mask(), Use::compute_write);
  recorder.pass(name_ + "/resolve", PassStage::resolve, uses, [&](Commands& commands) {
    commands.bind(resolve_);
    commands.push(arguments);
    commands.dispatch(frame.size(), {8, 8});
  });
}

}  // namespace gnomon
