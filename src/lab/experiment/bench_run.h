// One run of a suite, made ready: its view, its settings, its technique or kernel.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>

#include "lab/experiment/bench.h"

namespace gnomon {

struct BenchRun {
  const SuiteRun* run = nullptr;
  ViewOptions view;
  Settings settings;
  const TechniqueSpec* spec = nullptr;  // null: a kernel
  SettingsMap values;                   // of the technique, scaled
  uint32_t texels = 0;                  // of the kernel "copy", scaled

  std::string technique() const;  // "cascaded/vsm", "kernel/copy"
  std::string view_key() const;   // runs with equal keys share a session
  nlohmann::json all_settings() const;
};

// Throws Error (usage), naming the run, for a technique, scene or setting that there is not.
BenchRun prepare_run(const SuiteRun& run, const BenchOptions& options);

}  // namespace gnomon
