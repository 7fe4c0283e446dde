// Suites of benchmarks: runs that belong together take turns, frame by frame, so that a busy machine hurts all of them alike.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/result_folder.h"
#include "lab/plan/suite.h"
#include "lab/view/session.h"

namespace gnomon {

struct BenchOptions {
  Suite suite;
  std::filesystem::path output;
  Preset override;      // size, samples, camera, lights and settings that replace those of every run where they apply
  double scale = 1.0;   // of pictures' sides and maps' sides
  bool quick = false;   // few frames, small scenes: for trying a suite, not for its numbers
  bool resume = false;  // keeps what DIR/results.jsonl has of the same settings, commit and device
  std::string command;  // that repeats this, up to the run's name
};

// Throws Error (usage) for what no run can use, before a device is opened.
void check_bench(const BenchOptions& options);

// Writes results.jsonl (docs/results_format.md) and returns its folder: complete, not yet published. The file is whole after
// each block of runs. Throws Interrupted, saying what is kept.
std::unique_ptr<ResultFolder> bench(Device& device, const BenchOptions& options);

}  // namespace gnomon
