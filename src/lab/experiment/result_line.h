// The parts of a line of results.jsonl that describe where a number comes from.
#pragma once

#include <nlohmann/json.hpp>

#include "lab/experiment/reference_set.h"

namespace gnomon {

// Everything but the technique's own results: gnomon, scene, camera, lights, size, samples, device.
nlohmann::json describe_session(Session& session);
nlohmann::json describe_reference(const ReferenceSet& set, const LightReference& reference);
// The command that repeats a row.
std::string repeat_command(const Session& session, const std::string& technique, const std::string& light);

}  // namespace gnomon
