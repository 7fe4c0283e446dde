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

  // Whether a parameter is offered.
  using Offers = std::function<bool(std::string_view name)>;

  void search_field();  // parameters that do not contain its text are left out
  // `starts`: the values that "reset" goes back to. Without `offers` all are offered.
  void show(const std::string& id, const ParamBlock& block, const ParamBlock& starts, const Change& change,
            const Offers& offers = {});
  // Behind all that was shown since search_field: says where none has been found.
  void end_search() const;

 private:
  bool found(const std::string& key, const ParamInfo& info) const;
  void row(const std::string& key, const ParamInfo& info, const ParamBlock& block, const ParamBlock& starts,
           const Change& change);

  char search_[64] = {};
  bool any_found_ = false;
  // A value being dragged: of a `rebuild` parameter it counts when it is let go.
  std::string dragged_key_;
  double dragged_ = 0.0;
};

}  // namespace gnomon::viewer
