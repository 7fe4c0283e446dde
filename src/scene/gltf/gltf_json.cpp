// JSON that knows its place in the file.
#include "scene/gltf/gltf_json.h"

#include <cmath>

namespace gnomon {
namespace {

using nlohmann::json;

std::string range_text(double low, double high) {
  if (low == -k_any && high == k_any) return "a finite number that fits 32 bits";
  if (high == k_any) return fmt::format("a number, {} or more", low);
  return fmt::format("a number from {} to {}", low, high);
}

// What stands there instead, short enough for a message.
std::string found(const json& value) {
  if (value.is_object() || value.is_array()) return value.type_name();
  std::string text = value.dump();
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  return text;
}

}  // namespace

void GltfValue::fail_at(const std::string& place, const std::string& what) const {
  fail("{}: {}: {}", *file_, place.empty() ? "top level" : place, what);
}

const json* GltfValue::find(std::string_view key) const {
  const auto member = value_->find(key);
  return member == value_->end() ? nullptr : &*member;
}

const json& GltfValue::require(std::string_view key) const {
  const json* value = find(key);
  if (!value) fail_in(key, "is missing");
  return *value;
}

const json* GltfValue::find_array(std::string_view key) const {
  const json* value = find(key);
  if (value && !value->is_array()) fail_in(key, "is {}; valid: an array of objects", found(*value));
  return value;
}

bool GltfValue::has(std::string_view key) const { return find(key) != nullptr; }

std::optional<GltfValue> GltfValue::object(std::string_view key) const {
  const json* value = find(key);
  if (!value) return std::nullopt;
  if (!value->is_object()) fail_in(key, "is {}; valid: an object", found(*value));
  return GltfValue(*value, *file_, where(key));
}

GltfValue GltfValue::required_object(std::string_view key) const {
  require(key);
  return *object(key);
}

std::vector<GltfValue> GltfValue::objects(std::string_view key) const {
  std::vector<GltfValue> result;
  const size_t elements = count(key);
  result.reserve(elements);
  for (size_t i = 0; i < elements; ++i) result.push_back(element(key, i));
  return result;
}

size_t GltfValue::count(std::string_view key) const {
  const json* value = find_array(key);
  return value ? value->size() : 0;
}

GltfValue GltfValue::element(std::string_view key, size_t index) const {
  const json* value = find_array(key);
  GNOMON_ASSERT(value && index < value->size());
  GltfValue result((*value)[index], *file_, fmt::format("{}[{}]", where(key), index));
  if (!result.value_->is_object()) result.fail_here("is {}; valid: an object", found(*result.value_));
  return result;
}

std::optional<GltfValue> GltfValue::extension(std::string_view name) const {
  const auto extensions = object("extensions");
  return extensions ? extensions->object(name) : std::nullopt;
}

double GltfValue::to_number(const json& value, const std::string& place, double low, double high) const {
  // Everything ends up in a float: a number beyond its range is as bad as infinity.
  const bool good = value.is_number() &&
                    std::abs(value.get<double>()) <= static_cast<double>(std::numeric_limits<float>::max()) &&
                    value.get<double>() >= low && value.get<double>() <= high;
  if (!good) fail_at(place, fmt::format("is {}; valid: {}", found(value), range_text(low, high)));
  return value.get<double>();
}

double GltfValue::number(std::string_view key, double otherwise, double low, double high) const {
  const json* value = find(key);
  return value ? to_number(*value, where(key), low, high) : otherwise;
}

double GltfValue::required_number(std::string_view key, double low, double high) const {
  return to_number(require(key), where(key), low, high);
}

uint64_t GltfValue::to_integer(const json& value, const std::string& place, uint64_t low, uint64_t high) const {
  // 5.0 is an integer too, as in JSON Schema.
  std::optional<uint64_t> integer;
  if (value.is_number_unsigned()) integer = value.get<uint64_t>();
  if (value.is_number_float() && value.get<double>() >= 0.0 && value.get<double>() <= 9e15 &&
      std::floor(value.get<double>()) == value.get<double>()) {
    integer = static_cast<uint64_t>(value.get<double>());
  }
  if (!integer || *integer < low || *integer > high)
    fail_at(place, fmt::format("is {}; valid: an integer from {} to {}", found(value), low, high));
  return *integer;
}

uint64_t GltfValue::integer(std::string_view key, uint64_t otherwise, uint64_t low, uint64_t high) const {
  const json* value = find(key);
  return value ? to_integer(*value, where(key), low, high) : otherwise;
}

uint64_t GltfValue::required_integer(std::string_view key, uint64_t low, uint64_t high) const {
  return to_integer(require(key), where(key), low, high);
}

int GltfValue::to_index(const json& value, const std::string& place, size_t count, std::string_view of) const {
  if (count == 0) fail_at(place, fmt::format("is {}; the file has no {}", found(value), of));
  const bool good = value.is_number_unsigned() && value.get<uint64_t>() < count;
  const bool good_float = value.is_number_float() && value.get<double>() >= 0 &&
                          value.get<double>() < static_cast<double>(count) &&
                          std::floor(value.get<double>()) == value.get<double>();
  if (!good && !good_float) fail_at(place, fmt::format("is {}; valid: an index into {}, 0 to {}", found(value), of, count - 1));
  return value.get<int>();
}

int GltfValue::index(std::string_view key, size_t count, std::string_view of) const {
  const json* value = find(key);
  return value ? to_index(*value, where(key), count, of) : -1;
}

int GltfValue::required_index(std::string_view key, size_t count, std::string_view of) const {
  return to_index(require(key), where(key), count, of);
}

std::vector<int> GltfValue::indices(std::string_view key, size_t count, std::string_view of) const {
  std::vector<int> result;
  const json* value = find(key);
  if (!value) return result;
  if (!value->is_array()) fail_in(key, "is {}; valid: an array of indices into {}", found(*value), of);
  for (size_t i = 0; i < value->size(); ++i)
    result.push_back(to_index((*value)[i], fmt::format("{}[{}]", where(key), i), count, of));
  return result;
}

std::vector<std::pair<std::string, int>> GltfValue::named_indices(size_t count, std::string_view of) const {
  std::vector<std::pair<std::string, int>> result;
  for (const auto& [key, value] : value_->items()) result.emplace_back(key, to_index(value, where(key), count, of));
  return result;
}

bool GltfValue::flag(std::string_view key, bool otherwise) const {
  const json* value = find(key);
  if (!value) return otherwise;
  if (!value->is_boolean()) fail_in(key, "is {}; valid: true or false", found(*value));
  return value->get<bool>();
}

std::string GltfValue::text(std::string_view key, const std::string& otherwise) const {
  const json* value = find(key);
  if (!value) return otherwise;
  if (!value->is_string()) fail_in(key, "is {}; valid: a string", found(*value));
  return value->get<std::string>();
}

std::vector<std::string> GltfValue::texts(std::string_view key) const {
  std::vector<std::string> result;
  const json* value = find(key);
  if (!value) return result;
  if (!value->is_array()) fail_in(key, "is {}; valid: an array of strings", found(*value));
  for (const json& item : *value) {
    if (!item.is_string()) fail_in(key, "holds {}; valid: strings", found(item));
    result.push_back(item.get<std::string>());
  }
  return result;
}

std::vector<float> GltfValue::floats(std::string_view key) const {
  const json* value = find(key);
  if (!value) return {};
  if (!value->is_array()) fail_in(key, "is {}; valid: an array of numbers", found(*value));
  std::vector<float> result(value->size());
  read_floats(key, result.size(), result.data());
  return result;
}

bool GltfValue::read_floats(std::string_view key, size_t count, float* values) const {
  const json* value = find(key);
  if (!value) return false;
  if (!value->is_array() || value->size() != count) fail_in(key, "is {}; valid: an array of {} numbers", found(*value), count);
  for (size_t i = 0; i < count; ++i) {
    values[i] = static_cast<float>(to_number((*value)[i], fmt::format("{}[{}]", where(key), i), -k_any, k_any));
  }
  return true;
}

std::optional<mat4> GltfValue::matrix(std::string_view key) const {
  mat4 result(1.0f);
  if (!read_floats(key, 16, &result[0][0])) return std::nullopt;
  return result;
}

}  // namespace gnomon
