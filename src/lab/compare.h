// The main job: several techniques on one view, each timed and compared with the reference of the same samples.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "lab/session.h"

namespace gnomon {

struct CompareOptions {
  ViewOptions view;
  std::vector<std::string> techniques;  // names, or "all"
  std::filesystem::path output;
  bool pictures = true;
};

// Writes results.jsonl and images/ into the output folder (docs/results_format.md) and returns the lines. The file is whole after
// each technique: an interrupted run leaves what it had finished.
std::vector<nlohmann::json> compare(Device& device, const CompareOptions& options, const Settings& settings);

// The techniques that a list on the command line names. Throws Error (usage).
std::vector<const TechniqueSpec*> techniques_named(const std::vector<std::string>& names);

}  // namespace gnomon
