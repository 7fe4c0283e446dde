// The scene's casters as an acceleration structure, and rays that ask it for visibility.
#pragma once

#include "frame/gpu_scene.h"
#include "gpu/pipeline.h"

namespace gnomon {

class AccelerationStructure {
 public:
  // One bottom level per mesh part, one instance per casting item; without casters an empty top level, and every ray arrives.
  // Throws Error (device) where the device cannot trace rays.
  AccelerationStructure(Device& device, const GpuScene& scene);
  AccelerationStructure(const AccelerationStructure&) = delete;
  AccelerationStructure& operator=(const AccelerationStructure&) = delete;

  uint64_t address() const { return top_.address; }
  size_t triangle_count() const { return triangle_count_; }  // instances counted
  uint64_t bytes() const { return bytes_; }
  double build_ms() const { return build_ms_; }

 private:
  struct Level {
    Level() = default;
    explicit Level(Device& owner) : device(&owner) {}
    ~Level();
    Level(Level&& other) noexcept { swap(other); }
    Level& operator=(Level&& other) noexcept {
      Level(std::move(other)).swap(*this);
      return *this;
    }
    void swap(Level& other) noexcept;

    Device* device = nullptr;
    VkAccelerationStructureKHR handle = VK_NULL_HANDLE;
    Buffer storage;
    uint64_t address = 0;
  };
  Level build(const VkAccelerationStructureGeometryKHR& geometry, uint32_t primitives, VkAccelerationStructureTypeKHR type,
              const char* name);

  Device& device_;
  std::vector<Level> bottom_;
  Level top_;
  Buffer instances_;
  size_t triangle_count_ = 0;
  uint64_t bytes_ = 0;
  double build_ms_ = 0.0;
};

// A ray-generation shader with gnomon's miss and any-hit shaders (alpha-tested casters).
RayPipeline make_visibility_pipeline(Device& device, std::string_view raygen);

}  // namespace gnomon
