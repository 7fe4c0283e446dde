#include "app/viewer/compare/comparison.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/log.h"
#include "base/shell.h"

namespace gnomon::viewer {
namespace {

bool of_technique(const std::string& assignment) {
  return Settings::is_technique_part(part_of(assignment.substr(0, assignment.find('='))));
}

// Of "sun@pcf.size=5" where the light's name ends; 0 where it is for all lights.
size_t light_end(const std::string& assignment) {
  const size_t at = assignment.find('@');
  return at < assignment.find('=') ? at : 0;
}

// A line's pictures are named relative to its folder.
void move_pictures(nlohmann::json& images, const std::string& folder) {
  if (images.is_string()) images = folder + "/" + images.get<std::string>();
  if (!images.is_structured()) return;
  for (auto& image : images) move_pictures(image, folder);
}

std::string last_line(const std::string& text) {
  const size_t end = text.find_last_not_of('\n');
  if (end == text.npos) return "it says nothing";
  const size_t begin = text.rfind('\n', end);
  return text.substr(begin == text.npos ? 0 : begin + 1, end - (begin == text.npos ? 0 : begin));
}

}  // namespace

bool Comparison::add(const ViewState& state) {
  Row row = {state.techniques, {}};
  const auto words = state.words("compare", "--techniques", state.view.size);
  for (size_t i = 0; i + 1 < words.size(); ++i) {
    if (words[i] == "--set" && of_technique(words[i + 1])) row.assignments.push_back(words[i + 1]);
  }
  std::sort(row.assignments.begin(), row.assignments.end());
  if (std::find(rows_.begin(), rows_.end(), row) != rows_.end()) return false;
  rows_.push_back(std::move(row));
  return true;
}

std::string Comparison::label(size_t row) const {
  return fmt::format("{} {}", fmt::join(rows_[row].techniques, ","), fmt::join(rows_[row].assignments, " "));
}

std::string Comparison::obstacle(size_t row, std::span<const Light> lights) const {
  const auto named = [&](const std::string& name) {
    return std::any_of(lights.begin(), lights.end(), [&](const Light& light) { return light.name == name; });
  };
  for (const std::string& assignment : rows_[row].assignments) {
    const std::string name = assignment.substr(0, light_end(assignment));
    if (!name.empty() && !named(name)) return fmt::format("no light '{}' here", name);
  }
  const auto serves = [&](const Light& light) { return technique_for(rows_[row].techniques, light.kind) != nullptr; };
  return std::any_of(lights.begin(), lights.end(), serves) ? "" : "not for the lights here";
}

size_t Comparison::measurable(std::span<const Light> lights) const {
  size_t count = 0;
  for (size_t row = 0; row < rows_.size(); ++row) count += obstacle(row, lights).empty();
  return count;
}

std::vector<std::string> Comparison::words(size_t row, const ViewState& now, uvec2 size) const {
  ViewState state = now;
  state.techniques = rows_[row].techniques;
  // Techniques as collected, all else as it is now: only then can rows be compared.
  std::vector<std::string> words;
  for (std::string& word : state.words("compare", "--techniques", size)) {
    const bool replaced = !words.empty() && words.back() == "--set" && of_technique(word);
    replaced ? words.pop_back() : words.push_back(std::move(word));
  }
  for (const std::string& assignment : rows_[row].assignments) words.insert(words.end(), {"--set", assignment});
  return words;
}

std::filesystem::path Comparison::step_folder(size_t step) const { return folder_ / fmt::format("{:02}", step + 1); }

void Comparison::write_report(const ViewState& now, std::span<const Light> lights, uvec2 size,
                              const std::filesystem::path& folder) {
  GNOMON_ASSERT(!busy() && measurable(lights) > 0);
  folder_ = folder;
  make_folder(folder_);
  steps_.clear();
  for (size_t row = 0; row < rows_.size(); ++row) {
    if (!obstacle(row, lights).empty()) continue;
    std::vector<std::string> step = words(row, now, size);
    step.insert(step.end(), {"-o", step_folder(steps_.size()).string()});
    step.insert(step.end(), device_.begin(), device_.end());
    steps_.push_back(std::move(step));
  }
  steps_.push_back({"report", folder_.string()});
  step_ = 0;
  next();
}

void Comparison::next() {
  if (step_ + 1 == steps_.size()) merge();
  log_info("{}", command());
  std::vector<std::string> words = {std::filesystem::read_symlink("/proc/self/exe").string()};
  words.insert(words.end(), steps_[step_].begin(), steps_[step_].end());
  child_ = std::make_unique<ChildProcess>(words);
}

std::string Comparison::command() const {
  std::string command = "gnomon";
  for (const std::string& word : steps_[step_]) command += " " + shell_quoted(word);
  return command;
}

void Comparison::update() {
  if (!busy() || child_->running()) return;
  const auto child = std::move(child_);
  if (child->exit_code() != 0) fail("{}\nended with {}: {}", command(), child->exit_code(), last_line(child->output()));
  if (++step_ < steps_.size()) return next();
  report_ = std::filesystem::absolute(folder_ / "report.html");
  log_info("report: {}", report_.string());
}

void Comparison::stop() { child_.reset(); }

// The rows' lines as one result: `gnomon report FOLDER` reads it like any other.
void Comparison::merge() const {
  std::string lines;
  for (size_t step = 0; step + 1 < steps_.size(); ++step) {
    const std::string text = read_text_file(step_folder(step) / "results.jsonl");
    for (size_t begin = 0; begin < text.size();) {
      const size_t end = std::min(text.find('\n', begin), text.size());
      nlohmann::json line = nlohmann::json::parse(text.substr(begin, end - begin));
      if (line.contains("images")) move_pictures(line["images"], step_folder(step).filename().string());
      lines += line.dump() + "\n";
      begin = end + 1;
    }
  }
  write_file(folder_ / "results.jsonl", lines);
}

}  // namespace gnomon::viewer
