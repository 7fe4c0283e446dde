// Parameter tables: a parameter is one line of a `.params` file - name, default, range, update, help - that C++ and GLSL
// include under different macros. Every value is a 4-byte scalar, so both languages agree on the layout.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

enum class ParamType { float_, int_, bool_, choice };

// live: takes effect in the next frame; rebuild: the owner is destroyed and constructed again.
enum class ParamUpdate { live, rebuild };

struct ParamInfo {
  std::string_view name;
  ParamType type;
  double default_value, min, max;  // of a choice: an index
  ParamUpdate update;
  std::string_view help;  // one sentence; ends in "[unit]" where there is one
  std::vector<std::string_view> choices = {};

  std::string_view unit() const;   // the text between the brackets, or empty
  std::string valid_text() const;  // "0 to 10", "true or false", "scene, view": for errors and `describe`
};

using ParamTable = std::span<const ParamInfo>;

// Values of one table, in its order; `words()` is what the GPU reads.
class ParamBlock {
 public:
  explicit ParamBlock(ParamTable table);

  ParamTable table() const { return table_; }
  std::span<const uint32_t> words() const { return words_; }

  // From text, as on the command line; `where` ("pcf.size") names the key in the error. Throws Error (usage).
  void set(std::string_view name, std::string_view text, std::string_view where);
  void set_number(std::string_view name, double value, std::string_view where);

  double number(std::string_view name) const;     // of a bool 0 or 1, of a choice its index
  std::string text(std::string_view name) const;  // as `set` reads it
  nlohmann::json to_json() const;                 // object: name -> number, bool or string

  // The values as the struct that base/params_define.h makes from the same table.
  template <class Params>
  Params as() const {
    Params params;
    copy_to(&params, sizeof params);
    return params;
  }

  bool operator==(const ParamBlock& other) const { return words_ == other.words_; }

 private:
  size_t index_of(std::string_view name, std::string_view where) const;
  double value_at(size_t index) const;
  void store(size_t index, double value);
  void copy_to(void* params, size_t size) const;

  ParamTable table_;
  std::vector<uint32_t> words_;
};

}  // namespace gnomon
