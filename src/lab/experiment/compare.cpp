// Times each technique, reads its masks, scores them, writes pictures and lines.
#include "lab/experiment/compare.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "frame/rays/acceleration_structure.h"
#include "lab/experiment/result_line.h"
#include "lab/timing/measure_layering.h"
#include "lab/timing/timing.h"
#include "measure/visibility_error.h"

namespace gnomon {
namespace {

std::string file_stem(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)) && c != '_'; }, '-');
  return text;
}

// A line of an earlier run stands for a new one where all of this is equal; the rest of it are results.
constexpr const char* k_identity[] = {"gnomon", "command", "scene",  "camera",    "lights",
                                      "size",   "samples", "device", "technique", "settings"};

// One view under one light: its reference, and a line for every technique.
class LightComparison {
 public:
  LightComparison(Session& session, const CompareOptions& options, ResultFolder& folder, std::string light_argument)
      : session_(session),
        options_(options),
        folder_(folder),
        light_argument_(std::move(light_argument)),
        stem_(file_stem(session.scene().name)) {
    if (!light_argument_.empty()) stem_ += "." + file_stem(light_argument_);
    common_ = describe_session(session_);
  }

  // The line of an unfinished run, or a new one.
  nlohmann::json run(const TechniqueSpec& spec) {
    nlohmann::json line;
    line["technique"] = spec.name;
    line["command"] = repeat_command(session_, spec.name, light_argument_);
    line["settings"] = session_.settings().to_json(session_.settings_of(spec, 0));
    line["status"] = "ok";
    line["reason"] = "";
    line.update(common_);
    if (auto kept = folder_.take_kept(line, k_identity)) {
      log_info("{}: kept from the unfinished run", spec.name);
      return *kept;
    }
    if (references_.lights.empty()) {
      make_reference();
      line.update(common_);
    }
    std::string reason = receivers_ > 0 ? session_.unavailable(spec) : "the light reaches nothing that the camera sees";
    if (reason.empty()) {
      try {
        measure(spec, line);
        return line;
      } catch (const Error& error) {
        if (error.code() != ExitCode::device) throw;
        reason = error.what();
      }
    }
    line["status"] = "unavailable";
    line["reason"] = reason;
    return line;
  }

 private:
  const LightReference& truth() const { return references_.lights.front(); }

  template <class Call>
  void for_each_truth(const Call& call) const {
    for (const Truth kind : k_truths) {
      if (const ReferenceResult* result = truth().find(kind)) call(truth_name(kind), *result);
    }
  }

  // Samples whose pixel has no truth are not scored against it.
  std::vector<uint8_t> scored_by(const ReferenceResult& result) const {
    std::vector<uint8_t> scored = scored_;
    for (size_t i = 0; i < scored.size(); ++i) scored[i] = scored[i] && result.receiver[i];
    return scored;
  }

  // The best truth as a mask; the next best of a sample where that one knows nothing.
  std::vector<float> mask_of_truth() const {
    std::vector<float> mask = truth().area ? truth().area->visibility : truth().hard.visibility;
    if (!truth().pixel) return mask;
    const ReferenceResult& pixel = truth().pixel->result;
    for (size_t i = 0; i < mask.size(); ++i) {
      if (pixel.receiver[i]) mask[i] = pixel.visibility[i];
    }
    return mask;
  }

  // Only when the first technique asks for it: where every line was kept, nothing is traced again.
  void make_reference() {
    session_.draw_surface();
    references_ = make_references(session_);
    common_["reference"] = describe_reference(references_, truth());
    find_scored_samples();
    if (receivers_ == 0 && session_.chosen_lights().size() == 1) {
      fail(
          "{}: nothing that the camera sees faces the light '{}': there is no shadow to compare; valid: another --camera or "
          "--light",
          session_.scene().name, session_.chosen_lights().front().name);
    }
    if (options_.pictures) write_reference_pictures();
  }

  // Samples that share another's answer (several on one surface in a pixel) say nothing about a technique: the score is of
  // those that were evaluated. What sharing itself costs is one figure of the view, with the reference as the technique.
  void find_scored_samples() {
    const ReferenceResult& hard = truth().hard;
    scored_ = hard.receiver;
    const auto leaders = session_.frame().read_leaders();
    double difference = 0.0;
    for (size_t i = 0; i < scored_.size(); ++i) {
      if (!hard.receiver[i]) continue;
      ++receivers_;
      difference += std::abs(static_cast<double>(hard.visibility[leaders[i]]) - static_cast<double>(hard.visibility[i]));
      if (leaders[i] != i) scored_[i] = 0;
    }
    if (session_.frame().samples() > 1 && receivers_ > 0) {
      common_["sharing"] = {{"mae", difference / static_cast<double>(receivers_)},
                            {"scored", std::count(scored_.begin(), scored_.end(), 1)},
                            {"receivers", receivers_}};
    }
  }

  void measure(const TechniqueSpec& spec, nlohmann::json& line) {
    TechniqueContext& context = session_.context();
    const uint64_t before = session_.device().allocated_bytes() - context.shared_bytes();
    context.forget_shared_use();
    const auto techniques = session_.make_techniques(spec);
    const uint64_t own = session_.device().allocated_bytes() - context.shared_bytes() - before;
    line["memory_bytes"] = own + context.shared_bytes_used();

    const Timing timing = time_frames(session_.device(), timing_options(session_.settings()),
                                      [&](Recorder& recorder) { session_.record_frame(recorder, techniques); });
    line["timing"] = timing_to_json(timing);
    line["passes"] = passes_to_json(timing);
    const double build = timing.stage_ms(PassStage::build), resolve = timing.stage_ms(PassStage::resolve);
    line["gpu_ms"] = {{"build", build}, {"resolve", resolve}, {"total", build + resolve}};

    const std::vector<float> mask = session_.frame().read_mask(0);
    for_each_truth([&](const char* name, const ReferenceResult& result) {
      line["visibility"][name] = visibility_error(mask, result.visibility, scored_by(result)).to_json();
    });
    line["artefacts"] = nlohmann::json::object();
    if (options_.pictures) write_pictures(spec, mask, line);
  }

  std::string write_picture(const std::string& name, const Image8& image) const {
    const std::string relative = "images/" + stem_ + "." + name + ".png";
    write_png(folder_.unfinished() / relative, image);
    return relative;
  }

  void write_pictures(const TechniqueSpec& spec, const std::vector<float>& mask, nlohmann::json& line) {
    const std::string name = file_stem(spec.name);
    const int samples = static_cast<int>(session_.frame().samples());
    const Image8 shaded = session_.frame().read_display();
    line["image"] = image_error(shaded, reference_shaded_).to_json();
    nlohmann::json& images = line["images"];
    images = reference_pictures_;
    images["shaded"] = write_picture(name + ".shaded", shaded);
    images["mask"] =
        write_picture(name + ".mask", mask_picture(mask, truth().hard.receiver, shaded.width, shaded.height, samples));
    for_each_truth([&](const char* kind, const ReferenceResult& result) {
      images["error"][kind] = write_picture(fmt::format("{}.error.{}", name, kind),
                                            signed_error_map(mask, result.visibility, result.receiver, samples, shaded));
    });
  }

  void write_reference_pictures() {
    const uvec2 size = session_.frame().size();
    const auto picture = [&](const ReferenceResult& result) {
      return mask_picture(result.visibility, result.receiver, static_cast<int>(size.x), static_cast<int>(size.y),
                          static_cast<int>(session_.frame().samples()));
    };
    make_folder(folder_.unfinished() / "images");
    for_each_truth([&](const char* kind, const ReferenceResult& result) {
      reference_pictures_["reference"][kind] = write_picture(fmt::format("reference.{}", kind), picture(result));
    });
    session_.frame().write_mask(0, mask_of_truth());
    reference_shaded_ = session_.shade();
    reference_pictures_["reference_shaded"] = write_picture("reference.shaded", reference_shaded_);
  }

  Session& session_;
  const CompareOptions& options_;
  ResultFolder& folder_;
  std::string light_argument_, stem_;
  ReferenceSet references_;
  std::vector<uint8_t> scored_;  // per sample: a receiver that was evaluated for itself
  size_t receivers_ = 0;
  nlohmann::json common_, reference_pictures_;
  Image8 reference_shaded_;
};

// What --light must say to choose this light alone: its name, or its number where the name would not do.
std::string light_argument(const Session& session, size_t index) {
  const auto& chosen = session.chosen_lights();
  if (chosen.size() == 1) return session.options().lights.empty() ? "" : session.options().lights.front();
  // What was typed, where it names one light.
  std::vector<std::string> typed;
  for (const std::string& text : session.options().lights)
    typed.insert(typed.end(), text == "all" ? session.scene().lights.size() : 1, text == "all" ? "" : text);
  if (index < typed.size() && !typed[index].empty()) return typed[index];
  const auto& all = session.scene().lights;
  const auto named = [&](const Light& light) { return light.name == chosen[index].name; };
  if (std::count_if(all.begin(), all.end(), named) == 1 && std::count_if(chosen.begin(), chosen.end(), named) == 1)
    return chosen[index].name;
  return std::to_string(session.light_number(index));
}

void measure_all(Session& session, const CompareOptions& options, const std::vector<const TechniqueSpec*>& specs,
                 ResultFolder& folder) {
  // Each light is measured by itself: its mask, its cost.
  const std::vector<Light> lights = session.chosen_lights();
  for (size_t i = 0; i < lights.size(); ++i) {
    session.use_light(i);
    LightComparison comparison(session, options, folder, light_argument(session, i));
    for (const TechniqueSpec* spec : specs) {
      check_interrupted();
      log_info("{}{}: {}", session.scene().name, lights.size() > 1 ? ", light " + lights[i].name : "", spec->name);
      folder.add(comparison.run(*spec));
    }
  }
}

std::string what_is_kept(const ResultFolder& folder, size_t planned) {
  const size_t count = folder.lines().size() + folder.kept_count();
  if (count == 0) return "no result was complete, nothing is kept";
  return fmt::format("{} of {} results are kept in {}; the same command with --resume measures the rest",
                     std::min(count, planned), planned, folder.unfinished().string());
}

}  // namespace

std::vector<const TechniqueSpec*> techniques_named(const std::vector<std::string>& names) {
  std::vector<const TechniqueSpec*> specs;
  const auto add = [&](const TechniqueSpec& spec) {
    if (std::find(specs.begin(), specs.end(), &spec) == specs.end()) specs.push_back(&spec);
  };
  for (const std::string& name : names) {
    if (name == "all") {
      for (const auto& spec : all_techniques()) add(spec);
    } else {
      add(find_technique(name));
    }
  }
  return specs;
}

std::unique_ptr<ResultFolder> compare(Device& device, const CompareOptions& options, const Settings& settings) {
  const auto specs = techniques_named(options.techniques);
  settings.check_used(specs);
  if (!options.resume) {
    if (const auto run = unfinished_run(options.output))
      log_warning("{}: the unfinished run is dropped; --resume would continue it", run->folder.string());
  }
  auto folder = std::make_unique<ResultFolder>(options.output, options.resume);
  if (options.resume && folder->kept_count() == 0)
    log_info("{}: holds no unfinished run: everything is measured anew", options.output.string());
  ensure_layering_measured(device);
  Session session(device, options.view, settings);
  const size_t planned = specs.size() * session.chosen_lights().size();
  const InterruptScope scope;
  try {
    measure_all(session, options, specs, *folder);
  } catch (const Interrupted&) {
    throw Error("interrupted: " + what_is_kept(*folder, planned), ExitCode::interrupted);
  } catch (const Error&) {
    if (!folder->lines().empty()) log_warning("{}", what_is_kept(*folder, planned));
    throw;
  }
  folder->complete();
  return folder;
}

}  // namespace gnomon
