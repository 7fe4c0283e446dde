// Parsing, checking and printing of parameter values.
#include "base/params.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace gnomon {
namespace {

std::string join(const std::vector<std::string_view>& words) { return fmt::format("{}", fmt::join(words, ", ")); }

// The whole text as a finite number, or NaN.
double parse_number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? value : std::nan("");
}

}  // namespace

std::string_view ParamInfo::unit() const {
  const size_t open = help.rfind('['), close = help.rfind(']');
  if (open == help.npos || close == help.npos || close < open) return {};
  return help.substr(open + 1, close - open - 1);
}

std::string ParamInfo::valid_text() const {
  switch (type) {
    case ParamType::float_:
      return fmt::format("a number from {} to {}", min, max);
    case ParamType::int_:
      return fmt::format("a whole number from {} to {}", min, max);
    case ParamType::bool_:
      return "true or false";
    case ParamType::choice:
      return "one of " + join(choices);
  }
  return {};
}

ParamBlock::ParamBlock(ParamTable table) : table_(table), words_(table.size()) {
  for (size_t i = 0; i < table_.size(); ++i) store(i, table_[i].default_value);
}

size_t ParamBlock::index_of(std::string_view name, std::string_view where) const {
  std::vector<std::string_view> names;
  for (size_t i = 0; i < table_.size(); ++i) {
    if (table_[i].name == name) return i;
    names.push_back(table_[i].name);
  }
  fail_usage("{}: unknown parameter '{}'; valid: {}", where, name, names.empty() ? "none" : join(names));
}

void ParamBlock::store(size_t index, double value) {
  switch (table_[index].type) {
    case ParamType::float_:
      words_[index] = std::bit_cast<uint32_t>(static_cast<float>(value));
      break;
    case ParamType::int_:
      words_[index] = static_cast<uint32_t>(static_cast<int32_t>(value));
      break;
    case ParamType::bool_:
    case ParamType::choice:
      words_[index] = static_cast<uint32_t>(value);
      break;
  }
}

double ParamBlock::value_at(size_t index) const {
  switch (table_[index].type) {
    case ParamType::float_:
      return std::bit_cast<float>(words_[index]);
    case ParamType::int_:
      return static_cast<int32_t>(words_[index]);
    case ParamType::bool_:
    case ParamType::choice:
      return words_[index];
  }
  return 0.0;
}

void ParamBlock::set(std::string_view name, std::string_view text, std::string_view where) {
  const size_t index = index_of(name, where);
  const ParamInfo& info = table_[index];
  double value = std::nan("");
  switch (info.type) {
    case ParamType::float_:
    case ParamType::int_:
      value = parse_number(text);
      break;
    case ParamType::bool_:
      if (text == "true" || text == "1" || text == "on") value = 1.0;
      if (text == "false" || text == "0" || text == "off") value = 0.0;
      break;
    case ParamType::choice:
      for (size_t i = 0; i < info.choices.size(); ++i) {
        if (info.choices[i] == text) value = static_cast<double>(i);
      }
      break;
  }
  if (!std::isfinite(value)) fail_usage("{}: '{}' is not valid; valid: {}", where, text, info.valid_text());
  set_number(name, value, where);
}

void ParamBlock::set_number(std::string_view name, double value, std::string_view where) {
  const size_t index = index_of(name, where);
  const ParamInfo& info = table_[index];
  const bool whole = info.type == ParamType::float_ || value == std::floor(value);
  if (!std::isfinite(value) || value < info.min || value > info.max || !whole) {
    fail_usage("{}: {} is not valid; valid: {}", where, value, info.valid_text());
  }
  store(index, value);
}

double ParamBlock::number(std::string_view name) const { return value_at(index_of(name, name)); }

std::string ParamBlock::text(std::string_view name) const {
  const size_t index = index_of(name, name);
  const ParamInfo& info = table_[index];
  switch (info.type) {
    case ParamType::float_:
      return fmt::format("{}", std::bit_cast<float>(words_[index]));
    case ParamType::int_:
      return fmt::format("{}", static_cast<int32_t>(words_[index]));
    case ParamType::bool_:
      return words_[index] ? "true" : "false";
    case ParamType::choice:
      return std::string(info.choices[words_[index]]);
  }
  return {};
}

nlohmann::json ParamBlock::to_json() const {
  nlohmann::json object = nlohmann::json::object();
  for (size_t i = 0; i < table_.size(); ++i) {
    const std::string key(table_[i].name);
    switch (table_[i].type) {
      // Through the shortest text of the float, so that 0.1f is not written as 0.10000000149.
      case ParamType::float_:
        object[key] = parse_number(text(key));
        break;
      case ParamType::int_:
        object[key] = static_cast<int32_t>(words_[i]);
        break;
      case ParamType::bool_:
        object[key] = words_[i] != 0;
        break;
      case ParamType::choice:
        object[key] = text(key);
        break;
    }
  }
  return object;
}

void ParamBlock::copy_to(void* params, size_t size) const {
  GNOMON_ASSERT(size == words_.size() * sizeof(uint32_t));
  std::memcpy(params, words_.data(), size);
}

}  // namespace gnomon
