#include "base/percent_encoding.h"

#include <charconv>

namespace gnomon {

std::string percent_decoded(std::string_view text) {
  std::string bytes;
  for (size_t i = 0; i < text.size(); ++i) {
    unsigned char byte = 0;
    const bool escaped = text[i] == '%' && i + 2 < text.size();
    const char* const end = escaped ? text.data() + i + 3 : text.data();
    if (escaped && std::from_chars(text.data() + i + 1, end, byte, 16).ptr == end) {
      bytes += static_cast<char>(byte);
      i += 2;
    } else {
      bytes += text[i];
    }
  }
  return bytes;
}

}  // namespace gnomon
