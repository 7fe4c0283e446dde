// Text -> HTML without surprises: results are data, whatever characters they hold.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gnomon {

// For text and for attribute values in either kind of quotes.
std::string escape_html(std::string_view text);

// JSON that may stand inside <script>: "</script>" and "<!--" cannot occur in it.
std::string script_json(const nlohmann::json& value);

// The page with each {{name}} replaced by its value; values are not searched again. An unknown name is a bug.
std::string fill_template(std::string_view page, const std::vector<std::pair<std::string_view, std::string_view>>& values);

}  // namespace gnomon
