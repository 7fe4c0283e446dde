// gnomon doctor: the device, its features, and what falls back to what.
#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <iostream>

#include "app/cli/command.h"
#include "frame/casters/layering_choice.h"
#include "lab/timing/measure_layering.h"

namespace gnomon::cli {
namespace {

void print(const char* what, const std::string& value) { std::cout << fmt::format("{:<22} {}\n", what, value); }
std::string either(bool present, const char* yes, const char* no) { return present ? yes : no; }

void print_device(const DeviceInfo& info) {
  print("device", fmt::format("{} ({})", info.name, info.type));
  print("driver", fmt::format("{}, {}", info.driver, info.driver_version));
  print("Vulkan", fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(info.api_version), VK_API_VERSION_MINOR(info.api_version),
                              VK_API_VERSION_PATCH(info.api_version)));
  print("memory", fmt::format("{:.1f} GiB", static_cast<double>(info.memory_bytes) / 1073741824.0));
  print("samples per pixel", fmt::format("{}", fmt::join(info.sample_counts, ", ")));
  print("timing", info.software || info.timestamp_ms == 0.0
                      ? "wall clock, each pass submitted alone (a software device's timestamps lie)"
                      : fmt::format("GPU timestamps of {:.3g} ns", info.timestamp_ms * 1e6));
  print("ray-tracing pipeline", either(info.ray_tracing, "yes: technique ray_traced", "no: ray_traced is unavailable"));
  print("reference",
        either(info.ray_tracing && !info.software, "the GPU's ray-tracing pipeline (reference.kind=embree for the CPU)",
               info.ray_tracing ? "Embree on the CPU (the pipeline of a software device is slow: reference.kind=pipeline)"
                                : "Embree on the CPU"));
  print("depth clamp",
        either(info.depth_clamp, "yes", "no: casters before the near plane are lost; the fit keeps them behind it"));
  print("anisotropy", info.anisotropy ? fmt::format("up to {:.0f}", info.max_anisotropy) : "no: trilinear");
  print("pipeline statistics", either(info.pipeline_statistics, "yes", "no: triangles are counted on the CPU"));
  print("layer from vertex", either(info.vertex_layer, "yes", "no"));
  print("multiview", either(info.multiview, "yes", "no"));
  print("geometry shader", either(info.geometry_shader, "yes", "no"));
  print("mesh shaders", either(info.mesh_shader, "yes (unused)", "no"));
  print("ray queries", either(info.ray_query, "yes (unused: the pipeline is the common denominator)", "no (not needed)"));
}

// Measured anew: what is stored may be from before the machine changed.
void print_layering(Device& device) {
  std::vector<std::string> times;
  for (const LayeringTime& time : measure_layering(device)) {
    times.push_back(time.missing.empty() ? fmt::format("{} {:.2f} ms", layering_path_name(time.path), time.ms)
                                         : fmt::format("{} lacks {}", layering_path_name(time.path), time.missing));
  }
  print("layers of a map", fmt::format("{} (four cascades of the courtyard: {})",
                                       layering_path_name(fastest_layering_path(device.info())), fmt::join(times, ", ")));
}

}  // namespace

void add_doctor(CLI::App& app, const Globals& globals) {
  auto* command = app.add_subcommand("doctor", "the device, its features, and what will be used for what");
  command->callback([&globals] {
    const auto device = globals.open_device();
    print_device(device->info());
    print_layering(*device);
    device->check_validation();
    std::cout << "All required features are present.\n";
  });
}

}  // namespace gnomon::cli
