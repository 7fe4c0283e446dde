// Building the acceleration structure.
#include "frame/rays/acceleration_structure.h"

#include <chrono>
#include <cstring>
#include <map>

#include "base/error.h"
#include "gpu/recorder.h"

namespace gnomon {
RayPipeline make_visibility_pipeline(Device& device, std::string_view raygen) {
  return RayPipeline(device, raygen, "frame/rays/visibility.rmiss", "frame/rays/visibility.rahit");
}

AccelerationStructure::AccelerationStructure(Device& device, const GpuScene& scene) : device_(device) {
  if (!device.info().ray_tracing) fail_device("'{}' has no ray-tracing pipeline", device.info().name);
  const auto start = std::chrono::steady_clock::now();
  std::map<uint32_t, uint64_t> address_of_part;  // by first index: instances share their part's structure
  const auto set_transform = [](VkTransformMatrixKHR& transform, const vec4& x, const vec4& y, const vec4& z) {
    std::memcpy(transform.matrix[0], &x, 16);
    std::memcpy(transform.matrix[1], &y, 16);
    std::memcpy(transform.matrix[2], &z, 16);
  };
  std::vector<VkAccelerationStructureInstanceKHR> instances;
  for (uint32_t i = 0; i < scene.item_count(); ++i) {
    const DrawItem& item = scene.item_list()[i];
    if (!(item.flags & k_item_casts)) continue;
    const mat4& placement = scene.scene().objects[item.object].world_from_object;
    const bool shared = invertible(placement);
    uint64_t baked = 0;
    uint64_t& address = shared ? address_of_part.try_emplace(item.first_index, 0).first->second : baked;
    if (address == 0) {
      VkAccelerationStructureGeometryKHR geometry = {VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR};
      geometry.geometryType = VK_GEOMETRY_TYPE_TRIANGLES_KHR;
      const bool masked = scene.scene().materials[item.material].caster_cutoff() >= 0.0f;
      geometry.flags = masked ? VK_GEOMETRY_NO_DUPLICATE_ANY_HIT_INVOCATION_BIT_KHR : VK_GEOMETRY_OPAQUE_BIT_KHR;
      auto& triangles = geometry.geometry.triangles;
      triangles.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_TRIANGLES_DATA_KHR;
      triangles.vertexFormat = VK_FORMAT_R32G32B32_SFLOAT;
      triangles.vertexData.deviceAddress = scene.positions().address() + item.first_vertex * sizeof(vec3);
      triangles.vertexStride = sizeof(vec3);
      triangles.maxVertex = static_cast<uint32_t>(scene.vertex_count()) - item.first_vertex - 1;
      triangles.indexType = VK_INDEX_TYPE_UINT32;
      triangles.indexData.deviceAddress = scene.indices().address() + item.first_index * sizeof(uint32_t);
      // An instance cannot have a transform that flattens: a structure of its own has it in its vertices.
      Buffer transform;
      if (!shared) {
        transform = Buffer(device, "baked transform", sizeof(VkTransformMatrixKHR), BufferMemory::upload,
                           VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR);
        set_transform(transform.mapped_as<VkTransformMatrixKHR>()[0], item.world_from_object_x, item.world_from_object_y,
                      item.world_from_object_z);
        transform.flush();
        triangles.transformData.deviceAddress = transform.address();
      }
      bottom_.push_back(build(geometry, item.index_count / 3, VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR, "part"));
      address = bottom_.back().address;
    }
    VkAccelerationStructureInstanceKHR instance = {};
    if (shared) {
      set_transform(instance.transform, item.world_from_object_x, item.world_from_object_y, item.world_from_object_z);
    } else {
      set_transform(instance.transform, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0});
    }
    instance.instanceCustomIndex = i & 0xffffffu;
    instance.mask = 0xff;
    instance.flags = VK_GEOMETRY_INSTANCE_TRIANGLE_FACING_CULL_DISABLE_BIT_KHR;
    instance.accelerationStructureReference = address;
    instances.push_back(instance);
    triangle_count_ += item.index_count / 3;
  }

  // Room for one even where nothing casts: no buffer is empty.
  instances_ = Buffer(device, "instances", std::max<size_t>(instances.size(), 1) * sizeof(instances[0]), BufferMemory::device,
                      VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR);
  if (!instances.empty()) upload(device, instances_, std::as_bytes(std::span(instances)));
  bytes_ += instances_.bytes();
  VkAccelerationStructureGeometryKHR geometry = {VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR};
  geometry.geometryType = VK_GEOMETRY_TYPE_INSTANCES_KHR;
  geometry.geometry.instances.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_INSTANCES_DATA_KHR;
  geometry.geometry.instances.data.deviceAddress = instances_.address();
  top_ = build(geometry, static_cast<uint32_t>(instances.size()), VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR, "scene");
  build_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

AccelerationStructure::Level AccelerationStructure::build(const VkAccelerationStructureGeometryKHR& geometry,
                                                          uint32_t primitives, VkAccelerationStructureTypeKHR type,
                                                          const char* name) {
  const auto& functions = device_.ray_tracing();
  VkAccelerationStructureBuildGeometryInfoKHR info = {VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_GEOMETRY_INFO_KHR};
  info.type = type;
  info.flags = VK_BUILD_ACCELERATION_STRUCTURE_PREFER_FAST_TRACE_BIT_KHR;
  info.mode = VK_BUILD_ACCELERATION_STRUCTURE_MODE_BUILD_KHR;
  info.geometryCount = 1;
  info.pGeometries = &geometry;
  VkAccelerationStructureBuildSizesInfoKHR sizes = {VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_SIZES_INFO_KHR};
  functions.build_sizes(device_.handle(), VK_ACCELERATION_STRUCTURE_BUILD_TYPE_DEVICE_KHR, &info, &primitives, &sizes);

  Level level(device_);
  level.storage = Buffer(device_, std::string("acceleration structure of ") + name, sizes.accelerationStructureSize,
                         BufferMemory::device, VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_STORAGE_BIT_KHR);
  bytes_ += sizes.accelerationStructureSize;
  VkAccelerationStructureCreateInfoKHR create = {VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_CREATE_INFO_KHR};
  create.buffer = level.storage.handle();
  create.size = sizes.accelerationStructureSize;
  create.type = type;
  device_.reserve_defer();
  vk_check(functions.create_acceleration_structure(device_.handle(), &create, nullptr, &level.handle),
           "vkCreateAccelerationStructureKHR");

  const uint64_t alignment = std::max<uint64_t>(device_.info().scratch_alignment, 1);
  const Buffer scratch(device_, "build scratch", sizes.buildScratchSize + alignment);
  info.dstAccelerationStructure = level.handle;
  info.scratchData.deviceAddress = (scratch.address() + alignment - 1) / alignment * alignment;
  VkAccelerationStructureBuildRangeInfoKHR range = {};
  range.primitiveCount = primitives;
  const VkAccelerationStructureBuildRangeInfoKHR* ranges = &range;
  run_once(device_, [&](VkCommandBuffer commands) { functions.cmd_build(commands, 1, &info, &ranges); });

  VkAccelerationStructureDeviceAddressInfoKHR address = {VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_DEVICE_ADDRESS_INFO_KHR};
  address.accelerationStructure = level.handle;
  level.address = functions.address(device_.handle(), &address);
  return level;
}

AccelerationStructure::Level::~Level() {
  if (!handle) return;
  device->defer([owner = device->handle(), destroy = device->ray_tracing().destroy_acceleration_structure, gone = handle] {
    destroy(owner, gone, nullptr);
  });
}

void AccelerationStructure::Level::swap(Level& other) noexcept {
  std::swap(device, other.device);
  std::swap(handle, other.handle);
  std::swap(storage, other.storage);
  std::swap(address, other.address);
}

}  // namespace gnomon
