// Instructions one by one, by the SPIR-V specification: opcode in the low half of the first word, count of words in the high
// one.
#include "gpu/spirv.h"

#include <map>

#include "base/error.h"

namespace gnomon {
namespace {

constexpr size_t k_header_words = 5;
constexpr uint32_t k_op_type_pointer = 32, k_op_member_decorate = 72;
constexpr uint32_t k_storage_push_constant = 9, k_decoration_offset = 35;

}  // namespace

std::vector<uint32_t> push_constant_offsets(std::span<const uint32_t> spirv) {
  std::map<uint32_t, std::map<uint32_t, uint32_t>> offsets;  // struct -> member -> bytes
  for (size_t at = k_header_words; at < spirv.size();) {
    const uint32_t opcode = spirv[at] & 0xffffu, count = spirv[at] >> 16;
    GNOMON_ASSERT(count > 0 && at + count <= spirv.size());
    const auto operands = spirv.subspan(at + 1, count - 1);
    if (opcode == k_op_member_decorate && operands[2] == k_decoration_offset) offsets[operands[0]][operands[1]] = operands[3];
    // Decorations come before types.
    if (opcode == k_op_type_pointer && operands[1] == k_storage_push_constant && offsets.contains(operands[2])) {
      std::vector<uint32_t> result;
      for (const auto& [member, bytes] : offsets[operands[2]]) result.push_back(bytes);
      return result;
    }
    at += count;
  }
  return {};
}

}  // namespace gnomon
