// The main job: several techniques on one view, each timed and compared with the reference of the same samples.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/result_folder.h"
#include "lab/view/session.h"

namespace gnomon {

struct CompareOptions {
  ViewOptions view;
  std::vector<std::string> techniques;  // names, or "all"
  std::filesystem::path output;
  bool pictures = true;
  bool resume = false;  // keep the lines of an unfinished run that are still true
};

// Writes results.jsonl and images/ (docs/results_format.md) and returns their folder: complete, not yet published. The output
// folder is made once the scene is loaded. Throws Interrupted, saying what is kept.
std::unique_ptr<ResultFolder> compare(Device& device, const CompareOptions& options, const Settings& settings);

// The techniques that a list on the command line names, each once, in the order of their first names. Throws Error (usage).
std::vector<const TechniqueSpec*> techniques_named(const std::vector<std::string>& names);

}  // namespace gnomon
