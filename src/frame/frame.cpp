// The frame's passes.
#include "frame/frame.h"

#include <algorithm>
#include <cstring>

#include "base/error.h"
#include "frame/light_data.h"
#include "frame/surface/pixel_tile.glsl"

namespace gnomon {
namespace {

constexpr uvec2 k_group = {8, 8};

// The irradiance that pictures are exposed for: of a surface that faces the brightest light (from the middle of the scene).
// Files state lights in anything from 1 to 100 000 lux.
float key_irradiance(std::span<const Light> lights, const Box& bounds) {
  float key = 0.0f;
  for (const Light& light : lights) {
    float irradiance = light.intensity * std::max(light.colour.x, std::max(light.colour.y, light.colour.z));
    if (!light.parallel()) {
      const float distance = std::max(glm::length(light.position - bounds.centre()), 0.5f * bounds.radius());
      irradiance /= std::max(distance * distance, 1e-6f);
    }
    key = std::max(key, irradiance);
  }
  return key > 0.0f ? key : 1.0f;
}

struct ShadeArguments {
  uint64_t frame, mask, display, linear;
};

}  // namespace

Frame::Frame(Device& device, const GpuScene& scene, uvec2 size, uint32_t samples, std::span<const Light> lights)
    : device_(device), scene_(scene), size_(size), capacity_(size), samples_(samples), lights_(lights.begin(), lights.end()) {
  const auto& counts = device.info().sample_counts;
  if (std::find(counts.begin(), counts.end(), static_cast<int>(samples)) == counts.end()) {
    fail_device("{} samples: '{}' offers {}", samples, device.info().name, fmt::join(counts, ", "));
  }
  if (lights_.empty()) fail("{}: the scene has no light; give one with --light", scene.scene().name);
  create_images();
  create_buffers();
  frame_data_ = Buffer(device, "frame data", sizeof(FrameData), BufferMemory::upload);
  light_buffer_ = Buffer(device, "lights", lights_.size() * sizeof(LightData), BufferMemory::upload);
  fill_lights();
  expose();

  draws_ = CulledDraws(device, scene, "camera");
  cull_pipeline_ = make_cull_pipeline(device);
  GraphicsPipelineInfo surface;
  surface.vertex = "frame/surface/surface.vert";
  surface.fragment = "frame/surface/surface.frag";
  surface.colour_formats = {albedo_.info().format, normal_.info().format, id_.info().format};
  surface.samples = samples;
  surface_pipeline_ = make_graphics_pipeline(device, surface);
  pack_pipeline_ = make_compute_pipeline(device, "frame/surface/surface_pack.comp", {samples});
  shade_pipeline_ = make_compute_pipeline(device, "frame/shading/shade.comp", {samples});
  points_pipeline_ = make_compute_pipeline(device, "frame/surface/surface_points.comp");
}

void Frame::create_images() {
  const auto make = [&](const char* name, VkFormat format, VkImageUsageFlags usage) {
    ImageInfo info;
    info.name = name;
    info.width = capacity_.x, info.height = capacity_.y;
    info.format = format;
    info.usage = usage | VK_IMAGE_USAGE_SAMPLED_BIT;
    info.samples = samples_;
    return Image(device_, info);
  };
  albedo_ = make("surface albedo", VK_FORMAT_R8G8B8A8_SRGB, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
  normal_ = make("surface shading normal", VK_FORMAT_R16G16B16A16_SFLOAT, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
  id_ = make("surface ids", VK_FORMAT_R32G32_SFLOAT, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
  depth_ = make("surface depth", VK_FORMAT_D32_SFLOAT, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
}

void Frame::create_buffers() {
  const size_t pixels = size_t{capacity_.x} * capacity_.y, n = pixels * samples_;
  view_z_ = Buffer(device_, "surface view_z", n * 4);
  geometric_normal_ = Buffer(device_, "surface normal", n * 4);
  item_ = Buffer(device_, "surface item", n * 4);
  primitive_ = Buffer(device_, "surface primitive", n * 4);
  share_ = Buffer(device_, "surface share", pixels * 4);
  mask_ = Buffer(device_, "visibility mask", lights_.size() * n * 4);
  display_ = Buffer(device_, "display", pixels * 4);
  linear_ = Buffer(device_, "linear", pixels * 16);
}

void Frame::resize(uvec2 size) {
  const uvec2 old_size = std::exchange(size_, size), old_capacity = capacity_;
  if (glm::all(glm::lessThanEqual(size, capacity_))) return;
  capacity_ = glm::max(capacity_, size);
  try {
    create_images();
    create_buffers();
  } catch (...) {
    size_ = old_size, capacity_ = old_capacity;
    create_images();
    create_buffers();
    throw;
  }
}

void Frame::set_camera(const Camera& camera, vec2 subpixel) {
  data_.camera = camera_data(camera, size_, samples_, subpixel);
  fill_frame_data();
}

void Frame::set_lights(std::span<const Light> lights) {
  const auto same_kind = [](const Light& a, const Light& b) { return a.kind == b.kind; };
  GNOMON_ASSERT(std::equal(lights.begin(), lights.end(), lights_.begin(), lights_.end(), same_kind));
  lights_.assign(lights.begin(), lights.end());
  fill_lights();
}

void Frame::expose() { key_irradiance_ = key_irradiance(lights_, scene_.bounds()); }

void Frame::fill_lights() {
  const auto list = light_buffer_.mapped_as<LightData>();
  for (size_t i = 0; i < lights_.size(); ++i) list[i] = light_data(lights_[i]);
  light_buffer_.flush();
}

void Frame::fill_frame_data() {
  data_.scene = scene_.data();
  data_.surface = {view_z_.address(), geometric_normal_.address(), item_.address(), primitive_.address(), share_.address()};
  data_.light_count = static_cast<uint32_t>(lights_.size());
  // The curve's own middle lies at an irradiance of 3.
  const float key = key_irradiance_ / 3.0f;
  data_.ambient = params_.ambient * key;
  data_.exposure = params_.exposure / key;
  data_.normal_maps = params_.normal_maps;
  data_.specular = params_.specular;
  data_.albedo_image = albedo_.sampled();
  data_.normal_image = normal_.sampled();
  data_.id_image = id_.sampled();
  data_.depth_image = depth_.sampled();
  data_.lights = light_buffer_.address();
  std::memcpy(frame_data_.mapped(), &data_, sizeof data_);
  frame_data_.flush();
}

std::pair<float, float> Frame::visible_range() const {
  const CameraData& camera = data_.camera;
  float farthest = camera.near_m;
  for (int i = 0; i < 8; ++i) {
    farthest = std::max(farthest, glm::dot(scene_.bounds().corner(i) - camera.eye_ws, camera.forward_ws));
  }
  return {camera.near_m, farthest};
}

void Frame::record_surface(Recorder& recorder) {
  draws_.record(recorder, cull_pipeline_, "surface/cull", PassStage::surface,
                frame_data_.address() + offsetof(FrameData, camera) + offsetof(CameraData, clip_from_world), k_cull_depth);

  std::vector<ResourceUse> uses = draws_.uses();
  for (const Image* image : {&albedo_, &normal_, &id_}) uses.emplace_back(*image, Use::colour_write);
  uses.emplace_back(depth_, Use::depth_write);
  recorder.pass("surface/draw", PassStage::surface, uses, [&](Commands& commands) {
    const Attachment colours[] = {{albedo_.layer_view(0), {}}, {normal_.layer_view(0), {}}, {id_.layer_view(0), {}}};
    commands.begin_rendering(size_, colours, {depth_.layer_view(0), {.depthStencil = {0.0f, 0}}});
    commands.bind(surface_pipeline_);
    commands.push(frame_data_.address());
    for (uint32_t bucket = 0; bucket < k_bucket_count; ++bucket) {
      commands.cull_mode(bucket_cull_mode(bucket));
      draws_.draw_bucket(commands, bucket);
    }
    commands.end_rendering();
  });

  recorder.pass("surface/pack", PassStage::surface,
                {{albedo_, Use::compute_read},
                 {normal_, Use::compute_read},
                 {id_, Use::compute_read},
                 {depth_, Use::compute_read},
                 {view_z_, Use::compute_write},
                 {geometric_normal_, Use::compute_write},
                 {item_, Use::compute_write},
                 {primitive_, Use::compute_write},
                 {share_, Use::compute_write}},
                [&](Commands& commands) {
                  commands.bind(pack_pipeline_);
                  commands.push(frame_data_.address());
                  commands.dispatch(size_, uvec2(k_pixel_tile));
                });
}

void Frame::record_shade(Recorder& recorder, const Buffer& masks) {
  std::vector<ResourceUse> uses = surface_uses(Use::compute_read);
  for (const Image* image : {&albedo_, &normal_}) uses.emplace_back(*image, Use::compute_read);
  uses.emplace_back(masks, Use::compute_read);
  uses.emplace_back(display_, Use::compute_write);
  uses.emplace_back(linear_, Use::compute_write);
  recorder.pass("shade", PassStage::shade, uses, [&](Commands& commands) {
    commands.bind(shade_pipeline_);
    commands.push(ShadeArguments{frame_data_.address(), masks.address(), display_.address(), linear_.address()});
    commands.dispatch(size_, uvec2(k_pixel_tile));
  });
}

std::vector<ResourceUse> Frame::surface_uses(Use use) const {
  return {{view_z_, use}, {geometric_normal_, use}, {item_, use}, {primitive_, use}, {share_, use}};
}

Image8 Frame::read_display() const {
  const auto bytes = read_back(device_, display_, size_t{size_.x} * size_.y * 4);
  Image8 image(static_cast<int>(size_.x), static_cast<int>(size_.y));
  std::memcpy(image.rgba.data(), bytes.data(), bytes.size());
  return image;
}

ImageF Frame::read_linear() const {
  const auto bytes = read_back(device_, linear_, size_t{size_.x} * size_.y * 16);
  ImageF image(static_cast<int>(size_.x), static_cast<int>(size_.y), 4);
  std::memcpy(image.values.data(), bytes.data(), bytes.size());
  return image;
}

std::vector<float> Frame::read_mask(size_t light) const {
  const auto all = read_back_as<float>(device_, mask_, lights_.size() * sample_count());
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(light * sample_count());
  return {begin, begin + static_cast<std::ptrdiff_t>(sample_count())};
}

void Frame::write_mask(size_t light, std::span<const float> visibility) const {
  GNOMON_ASSERT(visibility.size() == sample_count());
  const Buffer staging(device_, "mask staging", visibility.size_bytes(), BufferMemory::upload);
  std::memcpy(staging.mapped(), visibility.data(), visibility.size_bytes());
  staging.flush();
  run_once(device_, [&](VkCommandBuffer commands) {
    const VkBufferCopy region = {0, light * sample_count() * sizeof(float), visibility.size_bytes()};
    vkCmdCopyBuffer(commands, staging.handle(), mask_.handle(), 1, &region);
  });
}

Buffer Frame::make_points() const {
  Buffer points(device_, "surface points", sample_count() * sizeof(SurfacePoint));
  struct Arguments {
    uint64_t frame, points;
  };
  Recorder recorder(device_, TimingMode::play, false);
  recorder.begin();
  std::vector<ResourceUse> uses = surface_uses(Use::compute_read);
  uses.emplace_back(points, Use::compute_write);
  recorder.pass("surface/points", PassStage::other, uses, [&](Commands& commands) {
    commands.bind(points_pipeline_);
    commands.push(Arguments{frame_data_.address(), points.address()});
    commands.dispatch(size_, k_group);
  });
  recorder.finish();
  return points;
}

std::vector<uint32_t> Frame::read_leaders() const {
  const auto share = read_back_as<uint32_t>(device_, share_, size_t{size_.x} * size_.y);
  std::vector<uint32_t> leaders(sample_count());
  for (size_t pixel = 0; pixel < share.size(); ++pixel) {
    for (uint32_t s = 0; s < samples_; ++s) {
      leaders[pixel * samples_ + s] = static_cast<uint32_t>(pixel) * samples_ + ((share[pixel] >> (4 * s)) & 15u);
    }
  }
  return leaders;
}

std::vector<SurfacePoint> Frame::read_points() const {
  const Buffer points = make_points();
  return read_back_as<SurfacePoint>(device_, points, sample_count());
}

std::vector<SurfaceSample> Frame::read_surface(std::span<const SurfacePoint> points) const {
  const auto z = read_back_as<float>(device_, view_z_, sample_count());
  const auto item = read_back_as<uint32_t>(device_, item_, sample_count()),
             primitive = read_back_as<uint32_t>(device_, primitive_, sample_count());
  std::vector<SurfaceSample> surface(sample_count());
  for (size_t i = 0; i < surface.size(); ++i) surface[i] = {z[i], points[i].geometric_normal_ws, item[i], primitive[i]};
  return surface;
}

}  // namespace gnomon
