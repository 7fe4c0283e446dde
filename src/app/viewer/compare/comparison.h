// Collected settings, and the report that `gnomon compare` makes of them: each is measured by a program of its own, so that the
// window lives on and every row has a command. A row belongs to no scene, unless it has settings for a light by name: the
// report is of the scene that is shown when it is written.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/viewer/state/view_state.h"
#include "base/child_process.h"

namespace gnomon::viewer {

class Comparison {
 public:
  // `device`: the words that choose the same device.
  explicit Comparison(std::vector<std::string> device) : device_(std::move(device)) {}

  // Technique and settings as they are now; false where the list has them.
  bool add(const ViewState& state);
  void remove(size_t row) { rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(row)); }
  size_t size() const { return rows_.size(); }
  std::string label(size_t row) const;

  // Why a row cannot be measured under these lights; empty where it can.
  std::string obstacle(size_t row, std::span<const Light> lights) const;
  // How many can.
  size_t measurable(std::span<const Light> lights) const;
  // `compare SCENE ...` that measures a row in the view of `now`: its scene, camera and lights.
  std::vector<std::string> words(size_t row, const ViewState& now, uvec2 size) const;

  // Measures every row that can be, one at least. `lights`: those of `now`. Throws Error where the folder cannot be made.
  void write_report(const ViewState& now, std::span<const Light> lights, uvec2 size, const std::filesystem::path& folder);
  // Call it once a frame: goes on with the next command where one has ended. Throws Error where one failed: the report is then
  // given up.
  void update();
  void stop();
  bool busy() const { return child_ != nullptr; }
  // Of the command at work, to be shown; and how many were before it and are to be in all.
  std::string command() const;
  size_t done() const { return step_; }
  size_t steps() const { return steps_.size(); }
  // Of the last finished one; empty before.
  const std::filesystem::path& report() const { return report_; }

 private:
  struct Row {
    std::vector<std::string> techniques, assignments;  // of the technique's parts: "pcf.size=5"
    bool operator==(const Row&) const = default;
  };
  void next();
  void merge() const;
  std::filesystem::path step_folder(size_t step) const;

  std::vector<std::string> device_;
  std::vector<Row> rows_;
  std::filesystem::path folder_, report_;
  std::vector<std::vector<std::string>> steps_;  // the words of each command, without the program's name
  size_t step_ = 0;
  std::unique_ptr<ChildProcess> child_;
};

}  // namespace gnomon::viewer
