// Letters of ASCII only: what file systems and formats that know no difference between cases agree about.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace gnomon {

inline std::string lower_case(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return result;
}

}  // namespace gnomon
