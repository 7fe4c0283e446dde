// Blocks of runs, taking turns; lines; what an earlier run left.
#include "lab/experiment/bench.h"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/version.h"
#include "lab/experiment/bench_run.h"
#include "lab/experiment/result_line.h"
#include "lab/plan/quantity.h"
#include "lab/timing/bench_kernels.h"
#include "lab/timing/measure_layering.h"
#include "lab/timing/timing.h"

namespace gnomon {
namespace {

using nlohmann::json;

// Settings for all runs that no run has are a mistake.
void check_override(const BenchOptions& options, const std::vector<BenchRun>& runs) {
  for (const auto& [key, value] : options.override.set) {
    const std::string id = key.substr(0, key.find('.'));
    const bool used = !Settings::is_technique_part(id) || std::any_of(runs.begin(), runs.end(), [&](const BenchRun& run) {
      return run.values.find(id) != run.values.end();
    });
    if (!used) fail_usage("--set {}={}: no technique of this suite has the part '{}'", key, value, id);
  }
}

std::vector<BenchRun> prepare_runs(const BenchOptions& options) {
  std::vector<BenchRun> runs;
  for (const SuiteRun& run : options.suite.runs) runs.push_back(prepare_run(run, options));
  check_override(options, runs);
  return runs;
}

// What a kept line must agree in.
std::string key_of(const BenchRun& run, const DeviceInfo& device) {
  const json key = {run.view_key(), run.all_settings(), run.technique(), commit(),
                    version(),      build_type(),       device.name,     device.driver_version};
  ContentHash hash;
  const std::string text = key.dump();
  hash.add(std::as_bytes(std::span(text)));
  return hash.hex();
}

bool wants_mask(const Suite& suite, const std::string& run) {
  return std::any_of(suite.rows.begin(), suite.rows.end(), [&](const SuiteRow& row) {
    return row.kind == SuiteRow::Kind::masks && std::find(row.runs.begin(), row.runs.end(), run) != row.runs.end();
  });
}

// A run of a block between its sessions and its line.
struct Entry {
  const BenchRun* run = nullptr;
  Session* session = nullptr;
  std::vector<std::unique_ptr<Technique>> techniques;
  std::unique_ptr<FrameTimer> timer;
  json line;
};

class Block {
 public:
  Block(Device& device, const BenchOptions& options, const std::vector<BenchRun>& runs, const std::vector<size_t>& members)
      : device_(device), options_(options) {
    for (const size_t member : members) entries_.push_back(make_entry(runs[member], members, runs));
  }

  std::vector<json> measure() {
    take_turns();
    std::vector<json> lines;
    for (Entry& entry : entries_) {
      if (entry.timer) finish(entry);
      lines.push_back(std::move(entry.line));
    }
    return lines;
  }

 private:
  Session& session_for(const BenchRun& run) {
    auto& session = sessions_[run.view_key()];
    if (!session) session = std::make_unique<Session>(device_, run.view, run.settings);
    return *session;
  }

  Entry make_entry(const BenchRun& run, const std::vector<size_t>& members, const std::vector<BenchRun>& runs) {
    Entry entry;
    entry.run = &run;
    entry.session = &session_for(run);
    Session& session = *entry.session;
    json& line = entry.line = describe_session(session);
    line["technique"] = run.technique();
    line["command"] = options_.command + " --only '" + run.run->name + "' -o out";
    line["settings"] = run.all_settings();
    line["settings"].update(session.settings().to_json({}));  // with what the scene decided about camera and lights
    line["status"] = "ok";
    line["reason"] = "";
    json& about =
        line["bench"] = {{"suite", options_.suite.name}, {"run", run.run->name},    {"key", key_of(run, device_.info())},
                         {"scale", options_.scale},      {"quick", options_.quick}, {"counters", run.run->counters}};
    about["side_by_side"] = json::array();
    for (const size_t member : members) about["side_by_side"].push_back(runs[member].run->name);
    if (run.run->plot) about["plot"] = plot_json(*run.run->plot);
    const std::string reason = prepare(entry);
    if (!reason.empty()) line["status"] = "unavailable", line["reason"] = reason;
    return entry;
  }

  static json plot_json(const PlotPoint& plot) {
    json result = {{"title", plot.title}, {"series", plot.series}, {"x", plot.x}, {"x_label", plot.x_label}, {"of", plot.of}};
    result["published"] = plot.published ? json(*plot.published) : json();
    return result;
  }

  // Makes the techniques and the timer; the reason where the device cannot.
  std::string prepare(Entry& entry) {
    Session& session = *entry.session;
    const BenchRun& run = *entry.run;
    if (run.spec) {
      if (std::string reason = session.unavailable(*run.spec); !reason.empty()) return reason;
    }
    try {
      TechniqueContext& context = session.context();
      const uint64_t before = device_.allocated_bytes() - context.shared_bytes();
      context.forget_shared_use();
      for (size_t light = 0; light < session.frame().lights().size(); ++light) {
        entry.techniques.push_back(run.spec ? run.spec->make(context, run.values)
                                            : make_bench_kernel(device_, run.run->kernel, run.texels));
      }
      entry.line["memory_bytes"] = device_.allocated_bytes() - context.shared_bytes() - before + context.shared_bytes_used();
      const std::span<const std::unique_ptr<Technique>> techniques = entry.techniques;
      entry.timer = std::make_unique<FrameTimer>(
          device_, timing_options(run.settings),
          [&session, techniques](Recorder& recorder) { session.record_frame(recorder, techniques); });
      entry.timer->warm_up();  // what the device cannot do shows here
    } catch (const Error& error) {
      if (error.code() != ExitCode::device) throw;
      entry.techniques.clear();
      entry.timer.reset();
      return error.what();
    }
    return {};
  }

  // A B C A B C: each run's n-th frame is drawn beside the others' n-th.
  void take_turns() {
    std::vector<Entry*> timed;
    for (Entry& entry : entries_) {
      if (entry.timer) timed.push_back(&entry);
    }
    if (timed.empty()) return;
    const TimingOptions timing = timing_options(timed.front()->run->settings);
    for (int i = 1; i < timing.warm_up; ++i) {
      for (Entry* entry : timed) entry->timer->warm_up();
    }
    const double budget = timing.max_seconds * static_cast<double>(timed.size());
    const auto start = std::chrono::steady_clock::now();
    Progress progress(options_.suite.name, static_cast<uint64_t>(timing.frames));
    for (int round = 0; round < timing.frames; ++round) {
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
      if (round >= k_min_frames && elapsed.count() > budget) break;
      for (Entry* entry : timed) entry->timer->frame();
      progress.update(static_cast<uint64_t>(round) + 1);
    }
  }

  void finish(Entry& entry) {
    const Timing timing = entry.timer->timing();
    json& line = entry.line;
    line["timing"] = timing_to_json(timing);
    line["passes"] = passes_to_json(timing);
    const double build = timing.stage_ms(PassStage::build), resolve = timing.stage_ms(PassStage::resolve);
    line["gpu_ms"] = {{"build", build}, {"resolve", resolve}, {"total", build + resolve}};
    if (!wants_mask(options_.suite, entry.run->run->name)) return;
    // The frame's masks are those of the run that drew last: draw once more.
    entry.timer->warm_up();
    ContentHash hash;
    for (size_t light = 0; light < entry.session->frame().lights().size(); ++light)
      hash.add_values(entry.session->frame().read_mask(light));
    line["bench"]["mask_hash"] = hash.hex();
  }

  Device& device_;
  const BenchOptions& options_;
  std::map<std::string, std::unique_ptr<Session>> sessions_;
  std::vector<Entry> entries_;
};

// Lines of earlier runs, finished or not, by their keys. What is not a line of a bench is not ours.
std::map<std::string, json> earlier_lines(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files = {folder / "results.jsonl"};
  if (const auto run = unfinished_run(folder)) files.push_back(run->folder / "results.jsonl");
  std::map<std::string, json> lines;
  for (const auto& file : files) {
    if (!std::filesystem::exists(file)) continue;
    const std::string text = read_text_file(file);
    for (size_t begin = 0; begin < text.size();) {
      const size_t end = std::min(text.find('\n', begin), text.size());
      json line = json::parse(std::string_view(text).substr(begin, end - begin), nullptr, false);
      begin = end + 1;
      if (!line.is_object() || !line.contains(json::json_pointer("/bench/key")) || !line["bench"]["key"].is_string()) continue;
      const std::string key = line["bench"]["key"].get<std::string>() + line["bench"].value("run", "");
      lines[key] = std::move(line);
    }
  }
  return lines;
}

// The lines of a block that an earlier run measured, side by side; empty where it has not all of them.
std::vector<json> kept_block(std::map<std::string, json>& earlier, const Device& device, const std::vector<BenchRun>& runs,
                             const std::vector<size_t>& members) {
  std::vector<json> lines;
  for (const size_t member : members) {
    const auto found = earlier.find(key_of(runs[member], device.info()) + runs[member].run->name);
    if (found == earlier.end() || found->second["bench"]["side_by_side"].size() != members.size()) return {};
    lines.push_back(found->second);
  }
  return lines;
}

// What the suite's rows say of a block's runs: all runs of a row are in one block. A row stands in the line of its first run.
void add_rows(const Suite& suite, std::vector<json>& block) {
  for (json& line : block) line["bench"]["rows"] = json::array();
  for (size_t i = 0; i < suite.rows.size(); ++i) {
    for (json& line : block) {
      if (line["bench"]["run"] != suite.rows[i].runs.front()) continue;
      json row = evaluate_row(suite.rows[i], block);
      row["index"] = i;
      line["bench"]["rows"].push_back(std::move(row));
    }
  }
}

void measure_all(Device& device, const BenchOptions& options, const std::vector<BenchRun>& runs,
                 std::map<std::string, json>& earlier, ResultFolder& folder) {
  const auto blocks = side_by_side(options.suite);
  for (size_t i = 0; i < blocks.size(); ++i) {
    check_interrupted();
    const std::string what = fmt::format("{}: block {} of {}, {} run{}", options.suite.name, i + 1, blocks.size(),
                                         blocks[i].size(), blocks[i].size() == 1 ? "" : "s");
    std::vector<json> block = kept_block(earlier, device, runs, blocks[i]);
    if (block.empty()) {
      log_info("{}", what);
      block = Block(device, options, runs, blocks[i]).measure();
    } else {
      log_info("{}: kept", what);
    }
    add_rows(options.suite, block);
    for (json& line : block) folder.add(std::move(line));
  }
}

}  // namespace

void check_bench(const BenchOptions& options) { prepare_runs(options); }

std::unique_ptr<ResultFolder> bench(Device& device, const BenchOptions& options) {
  const std::vector<BenchRun> runs = prepare_runs(options);
  auto earlier = options.resume ? earlier_lines(options.output) : std::map<std::string, json>();
  if (!options.resume) {
    if (const auto run = unfinished_run(options.output))
      log_warning("{}: the unfinished run is dropped; --resume would continue it", run->folder.string());
  }
  auto folder = std::make_unique<ResultFolder>(options.output, options.resume);
  ensure_layering_measured(device);
  const InterruptScope scope;
  try {
    measure_all(device, options, runs, earlier, *folder);
  } catch (const Interrupted&) {
    throw Error(fmt::format("interrupted: {} of {} runs are kept in {}; the same command with --resume measures the rest",
                            folder->lines().size(), runs.size(), folder->unfinished().string()),
                ExitCode::interrupted);
  }
  folder->complete();
  return folder;
}

}  // namespace gnomon
