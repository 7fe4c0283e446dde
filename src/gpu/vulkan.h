// Vulkan, and the check that every call goes through.
#pragma once

#include <vulkan/vulkan.h>

#include <string_view>

namespace gnomon {

// Throws Error unless `result` is VK_SUCCESS: call, result name, and for out-of-memory or a lost device what it means.
void vk_check(VkResult result, std::string_view call);
std::string_view vk_result_name(VkResult result);

}  // namespace gnomon
