// A parameter table as widgets: name, range, unit and help come from the table.
#pragma once

#include <functional>
#include <string>

#include "base/params.h"

namespace gnomon::viewer {

class ParamEditor {
 public:
  // Called with name and value, as --set reads it; nullptr: back to where the value came from.
  using Change = std::function<void(std::string_view name, const std::string* value)>;

  void search_field();  // parameters that do not contain its text are left out
  // `starts`: the values that "reset" goes back to.
  void show(const std::string& id, const ParamBlock& block, const ParamBlock& starts, const Change& change);

 private:
  bool found(const std::string& key, const ParamInfo& info) const;
  void row(const std::string& key, const ParamInfo& info, const ParamBlock& block, const ParamBlock& starts, const Change& change);

  char search_[64] = {};
  // A value being dragged: of a `rebuild` parameter it counts when it is let go.
  std::string dragged_key_;
  double dragged_ = 0.0;
};

}  // namespace gnomon::viewer
