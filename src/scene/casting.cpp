// Matching names.
#include "scene/casting.h"

#include <fnmatch.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "base/error.h"

namespace gnomon {
namespace {

struct Rule {
  std::string glob;
  bool on = true;
  bool literal = false;
  bool fits(const std::string& name) const { return literal ? glob == name : fnmatch(glob.c_str(), name.c_str(), 0) == 0; }
};

// Names may have the letters of globs ("nodes[3]"): what is the name of something means that.
bool is_name(const Scene& scene, const std::string& text) {
  const auto has_it = [&](const auto& item) { return item.name == text; };
  return std::any_of(scene.objects.begin(), scene.objects.end(), has_it) ||
         std::any_of(scene.materials.begin(), scene.materials.end(), has_it);
}

std::string place(const std::string& source) { return source.empty() ? "--cast" : source + ": 'casts':"; }

// The last '=' parts them: names may have others.
Rule parse(const std::string& text, const std::string& source) {
  const size_t equals = text.rfind('=');
  const std::string answer = equals == text.npos ? "" : text.substr(equals + 1);
  if (equals == text.npos || equals == 0 || (answer != "on" && answer != "off")) {
    fail_usage("{} {}: valid: GLOB=on or GLOB=off, where GLOB is a name of objects or materials, or has *, ? or [...]",
               place(source), text);
  }
  return {text.substr(0, equals), answer == "on"};
}

std::string some_names(const Scene& scene) {
  constexpr size_t k_shown = 8;
  const auto list = [](const auto& items) {
    std::set<std::string> names;
    for (const auto& item : items) names.insert(item.name);
    std::string text;
    size_t shown = 0;
    for (const std::string& name : names) {
      if (++shown > k_shown) return text + fmt::format(" and {} more", names.size() - k_shown);
      text += (text.empty() ? "'" : ", '") + name + "'";
    }
    return text;
  };
  return fmt::format("objects {}; materials {}", list(scene.objects), list(scene.materials));
}

// For each item the last rule that fits. `used`: rules that fit anything.
template <class Item>
std::vector<NamedCast> named(const std::vector<Item>& items, std::span<const Rule> rules, std::vector<bool>& used) {
  std::vector<NamedCast> result(items.size());
  for (size_t i = 0; i < items.size(); ++i) {
    for (size_t r = 0; r < rules.size(); ++r) {
      if (!rules[r].fits(items[i].name)) continue;
      used[r] = true;
      result[i] = {static_cast<int>(r), rules[r].on};
    }
  }
  return result;
}

}  // namespace

void check_cast_rule(const std::string& rule, const std::string& source) { parse(rule, source); }

void apply_casting(Scene& scene, std::span<const std::string> texts, const CastSources& sources) {
  const auto source_of = [&](const std::string& text) {
    const auto found = sources.find(text);
    return found == sources.end() ? std::string() : found->second;
  };
  std::vector<Rule> rules;
  for (const std::string& text : texts) {
    rules.push_back(parse(text, source_of(text)));
    rules.back().literal = is_name(scene, rules.back().glob);
  }
  std::vector<bool> used(rules.size(), false);
  const auto of_objects = named(scene.objects, rules, used), of_materials = named(scene.materials, rules, used);
  for (size_t r = 0; r < rules.size(); ++r) {
    if (!used[r])
      fail_usage("{} {}: nothing has such a name in {}; there are {}", place(source_of(texts[r])), texts[r], scene.name,
                 some_names(scene));
  }
  for (size_t i = 0; i < scene.objects.size(); ++i) scene.objects[i].named_cast = of_objects[i];
  for (size_t i = 0; i < scene.materials.size(); ++i) scene.materials[i].named_cast = of_materials[i];
}

void set_cast(std::vector<std::string>& rules, const std::string& name, bool on) {
  std::string glob;
  for (const char c : name) {
    if (std::string_view("*?[]\\").find(c) != std::string_view::npos) glob += '\\';
    glob += c;
  }
  std::erase(rules, glob + "=on");
  std::erase(rules, glob + "=off");
  rules.push_back(glob + (on ? "=on" : "=off"));
}

bool object_casts(const Scene& scene, const Object& object) {
  const auto& parts = scene.meshes[static_cast<size_t>(object.mesh)].parts;
  return std::any_of(parts.begin(), parts.end(), [&](const MeshPart& part) {
    return part_casts(object, scene.materials[static_cast<size_t>(part.material)]);
  });
}

}  // namespace gnomon
