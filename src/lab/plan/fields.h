// Reading a JSON object that people write: every error names file, place, key and what would be valid.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

class Fields {
 public:
  // where: "presets/mine.json" or "presets/mine.json: runs[3]". Throws Error (usage) for anything but an object with these
  // keys.
  Fields(const nlohmann::json& object, std::string where, std::initializer_list<std::string_view> keys);

  bool has(const char* key) const { return object_.contains(key); }
  const nlohmann::json& at(const char* key) const { return object_.at(key); }
  const std::string& where() const { return where_; }

  // Nothing where the key is absent; Error (usage) where its value is of another kind.
  std::optional<std::string> text(const char* key) const;
  std::string required_text(const char* key) const;
  std::optional<double> number(const char* key) const;
  bool flag(const char* key) const;
  std::vector<std::string> texts(const char* key) const;  // of a list, or of one string

  [[noreturn]] void fail_value(const char* key, std::string_view valid) const;

 private:
  const nlohmann::json& object_;
  std::string where_;
};

// Throws Error (usage) with the line of what is not JSON.
nlohmann::json parse_plan(std::string_view text, const std::string& where);

// Plans that the build embedded as {name, text}, by name.
template <class Parse>
auto parse_embedded(std::span<const std::pair<std::string_view, std::string_view>> texts, const Parse& parse) {
  std::vector<decltype(parse(std::string_view(), std::string()))> list;
  for (const auto& [name, text] : texts) list.push_back(parse(text, std::string(name)));
  std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return list;
}

}  // namespace gnomon
