// Running a technique; reading the surface buffer.
#include "support/view.h"

namespace gnomon::test {

TechniqueRun run_technique(View& view, const TechniqueSpec& spec, const SettingsMap& settings, TimingMode mode) {
  TechniqueRun run;
  const uint64_t before = device().allocated_bytes() - view.context().shared_bytes();
  const auto technique = spec.make(view.context(), settings);
  run.bytes = device().allocated_bytes() - view.context().shared_bytes() - before;
  run.frame = run_passes(
      [&](Recorder& recorder) {
        view.frame().record_surface(recorder);
        technique->record(recorder, view.frame(), 0);
      },
      mode);
  run.mask = view.frame().read_mask(0);
  return run;
}

SettingsMap settings_of(const TechniqueSpec& spec, std::initializer_list<std::string_view> assignments) {
  SettingsMap settings = spec.default_settings();
  for (const std::string_view assignment : assignments) {
    const size_t dot = assignment.find('.'), equals = assignment.find('=');
    settings.find(assignment.substr(0, dot))
        ->second.set(assignment.substr(dot + 1, equals - dot - 1), assignment.substr(equals + 1), assignment);
  }
  return settings;
}

std::vector<uint32_t> read_surface_buffer(View& view, std::string_view name) {
  for (const ResourceUse& use : view.frame().surface_uses(Use::compute_read)) {
    const Buffer& buffer = **std::get_if<const Buffer*>(&use.resource);
    if (buffer.name() == name) return read_back_as<uint32_t>(device(), buffer, buffer.bytes() / 4);
  }
  fail("the surface buffer has no '{}'", name);
}

}  // namespace gnomon::test
