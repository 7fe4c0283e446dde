// Kinds and messages.
#include "lab/plan/fields.h"

#include <algorithm>

#include "base/error.h"

namespace gnomon {

Fields::Fields(const nlohmann::json& object, std::string where, std::initializer_list<std::string_view> keys)
    : object_(object), where_(std::move(where)) {
  if (!object.is_object()) fail_usage("{}: not an object; valid keys: {}", where_, fmt::join(keys, ", "));
  for (const auto& [key, value] : object.items()) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      fail_usage("{}: unknown key '{}'; valid: {}", where_, key, fmt::join(keys, ", "));
  }
}

void Fields::fail_value(const char* key, std::string_view valid) const {
  fail_usage("{}: '{}' is {}; valid: {}", where_, key, object_.at(key).dump(), valid);
}

std::optional<std::string> Fields::text(const char* key) const {
  if (!has(key)) return std::nullopt;
  if (!at(key).is_string()) fail_value(key, "a string");
  return at(key).get<std::string>();
}

std::string Fields::required_text(const char* key) const {
  const auto value = text(key);
  if (!value || value->empty()) fail_usage("{}: no key '{}'; it is needed", where_, key);
  return *value;
}

std::optional<double> Fields::number(const char* key) const {
  if (!has(key)) return std::nullopt;
  if (!at(key).is_number()) fail_value(key, "a number");
  return at(key).get<double>();
}

bool Fields::flag(const char* key) const {
  if (!has(key)) return false;
  if (!at(key).is_boolean()) fail_value(key, "true or false");
  return at(key).get<bool>();
}

std::vector<std::string> Fields::texts(const char* key) const {
  if (!has(key)) return {};
  if (at(key).is_string()) return {at(key).get<std::string>()};
  const auto is_text = [](const nlohmann::json& item) { return item.is_string(); };
  if (!at(key).is_array() || at(key).empty() || !std::all_of(at(key).begin(), at(key).end(), is_text))
    fail_value(key, "a list of strings, or one string");
  return at(key).get<std::vector<std::string>>();
}

nlohmann::json parse_plan(std::string_view text, const std::string& where) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const auto read = text.substr(0, std::min(error.byte, text.size()));
    fail_usage("{}:{}: not JSON: {}", where, 1 + std::count(read.begin(), read.end(), '\n'), error.what());
  }
}

}  // namespace gnomon
