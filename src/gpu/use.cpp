// The table of uses, and hazard tracking for one queue.
#include "gpu/use.h"

namespace gnomon {

UseInfo use_info(Use use) {
  constexpr auto k_none = VK_IMAGE_LAYOUT_UNDEFINED;
  constexpr auto k_read = VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL;
  constexpr auto k_compute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
  constexpr auto k_ray = VK_PIPELINE_STAGE_2_RAY_TRACING_SHADER_BIT_KHR;
  constexpr auto k_build = VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR;
  constexpr auto k_shader_read = VK_ACCESS_2_SHADER_READ_BIT;
  constexpr auto k_shader_write = VK_ACCESS_2_SHADER_READ_BIT | VK_ACCESS_2_SHADER_WRITE_BIT;
  switch (use) {
    case Use::compute_read:
      return {k_compute, k_shader_read, k_read, false};
    case Use::compute_write:
      return {k_compute, k_shader_write, VK_IMAGE_LAYOUT_GENERAL, true};
    case Use::graphics_read:
      return {VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, k_shader_read, k_none, false};
    case Use::sampled:
      return {VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, k_shader_read, k_read, false};
    case Use::colour_write:
      return {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
              VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
              VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL, true};
    case Use::depth_write:
      return {VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
              VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
              VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL, true};
    case Use::indirect_read:
      return {VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT | VK_PIPELINE_STAGE_2_COPY_BIT,
              VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT | VK_ACCESS_2_TRANSFER_READ_BIT, k_none, false};
    case Use::copy_read:
      return {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, false};
    case Use::copy_write:
      return {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, true};
    case Use::ray_read:
      return {k_ray, k_shader_read | VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR, k_read, false};
    case Use::ray_write:
      return {k_ray, k_shader_write, VK_IMAGE_LAYOUT_GENERAL, true};
    case Use::build_read:
      return {k_build, k_shader_read | VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR, k_none, false};
    case Use::build_write:
      return {k_build, VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR | VK_ACCESS_2_ACCELERATION_STRUCTURE_WRITE_BIT_KHR,
              k_none, true};
  }
  return {};
}

Transition advance(ResourceState& state, Use use) {
  const UseInfo info = use_info(use);
  const bool new_layout = info.layout != VK_IMAGE_LAYOUT_UNDEFINED && info.layout != state.layout;
  Transition transition = {false, state.write_stages, info.stages, state.write_access, info.access, state.layout, info.layout};
  if (info.writes || new_layout) {
    // A write (and a layout change is one) waits for the last write and for everyone who reads it.
    transition.from_stages |= state.read_stages;
    transition.needed = new_layout || transition.from_stages != 0;
    // The first use of an image waits for everything: its memory may have had another tenant.
    if (transition.from_stages == 0) transition.from_stages = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    state = {};
    state.write_stages = info.stages;
    state.write_access = info.writes ? info.access : 0;
    state.visible_stages = info.writes ? 0 : info.stages;
    state.visible_access = info.writes ? 0 : info.access;
    state.read_stages = info.writes ? 0 : info.stages;
    state.layout = info.layout != VK_IMAGE_LAYOUT_UNDEFINED ? info.layout : transition.from_layout;
    return transition;
  }
  const bool seen = (info.stages & ~state.visible_stages) == 0 && (info.access & ~state.visible_access) == 0;
  transition.needed = state.write_stages != 0 && !seen;
  transition.to_layout = state.layout;
  state.visible_stages |= info.stages;
  state.visible_access |= info.access;
  state.read_stages |= info.stages;
  return transition;
}

}  // namespace gnomon
