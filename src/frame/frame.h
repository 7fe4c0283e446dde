// What all techniques share in one frame: surface buffer, visibility masks, shading.
#pragma once

#include <span>
#include <vector>

#include "base/glsl/same_surface.glsl"
#include "base/image.h"
#include "base/params.h"
#include "frame/camera_data.h"
#include "frame/casters/culling/cull.h"
#include "frame/gpu_scene.h"
#include "scene/surface_point.h"

namespace gnomon {

namespace frame_params {
#define GNOMON_PARAMS_FILE "frame/frame.params"
#include "base/params_define.h"
#undef GNOMON_PARAMS_FILE
}  // namespace frame_params

class Frame {
 public:
  // Throws Error (device) for a sample count that the device does not offer, naming those it does.
  Frame(Device& device, const GpuScene& scene, uvec2 size, uint32_t samples, std::span<const Light> lights);

  // Another size. Memory grows to the largest size so far and is then kept: a smaller frame uses a part of it, so a size may
  // change with every frame. Techniques stay valid. What was drawn is lost; set_camera must follow. Throws Error where memory
  // is used up, and keeps the old size.
  void resize(uvec2 size);

  // What techniques read: valid between set_camera and the next one.
  // subpixel: CameraData::subpixel.
  void set_camera(const Camera& camera, vec2 subpixel = vec2(0.0f));
  // The same lights at other places, or of other strength: as many as before, and of the same kinds. The exposure stays that of
  // the first lights, so that an evening gets dark.
  void set_lights(std::span<const Light> lights);
  void expose();  // for the lights as they are now; in force with the next set_camera
  void set_params(const frame_params::Params& params) { params_ = params; }
  const CameraData& camera() const { return data_.camera; }
  const GpuScene& scene() const { return scene_; }
  Device& device() const { return device_; }
  std::span<const Light> lights() const { return lights_; }
  uvec2 size() const { return size_; }
  uint32_t samples() const { return samples_; }
  size_t sample_count() const { return size_t{size_.x} * size_.y * samples_; }
  // View depths (metres) between which the scene's bounds can be seen: {near plane, farthest corner}, for fits that slice the
  // view.
  std::pair<float, float> visible_range() const;
  uint64_t data_address() const { return frame_data_.address(); }
  const Pipeline& cull_pipeline() const { return cull_pipeline_; }
  const CulledDraws& camera_draws() const { return draws_; }  // as record_surface left them

  // Camera culling, raster, packing.
  void record_surface(Recorder& recorder);
  // Lights the surface through the masks, or through others that are laid out like them; what is below 0 there counts as 0.
  void record_shade(Recorder& recorder) { record_shade(recorder, mask_); }
  void record_shade(Recorder& recorder, const Buffer& masks);

  // The buffers that a pass reading the surface must name.
  std::vector<ResourceUse> surface_uses(Use use) const;
  // Visibility of light i: floats, in the surface buffer's order.
  const Buffer& mask() const { return mask_; }
  uint64_t mask_address(size_t light) const { return mask_.address() + light * sample_count() * sizeof(float); }

  // The picture: a word per pixel, row by row, sRGB-encoded RGBA of 8 bits each.
  const Buffer& display() const { return display_; }

  // Results of the last finished frame; these wait for the GPU.
  Image8 read_display() const;
  ImageF read_linear() const;  // RGBA, scene linear
  std::vector<float> read_mask(size_t light) const;
  void write_mask(size_t light, std::span<const float> visibility) const;  // to shade with the reference
  // Per sample: the index of the sample whose answer it shares (its own where it leads its surface).
  std::vector<uint32_t> read_leaders() const;
  std::vector<SurfacePoint> read_points() const;
  std::vector<SurfaceSample> read_surface(std::span<const SurfacePoint> points) const;  // of the same samples, which are read
  // The same points for the GPU's reference.
  Buffer make_points() const;

 private:
  void create_images();
  void create_buffers();
  void fill_frame_data();
  void fill_lights();

  Device& device_;
  const GpuScene& scene_;
  uvec2 size_;
  uvec2 capacity_;  // of the images: at least size_ along each side
  uint32_t samples_;
  std::vector<Light> lights_;
  float key_irradiance_;  // that pictures are exposed for
  frame_params::Params params_;
  FrameData data_ = {};
  Image albedo_, normal_, id_, depth_;
  Buffer view_z_, geometric_normal_, item_, primitive_, share_, mask_, display_, linear_, frame_data_, light_buffer_;
  CulledDraws draws_;
  Pipeline cull_pipeline_, surface_pipeline_, pack_pipeline_, shade_pipeline_, points_pipeline_;
};

}  // namespace gnomon
