// Numbers and options of MTL, as the format has them and as files have them.
#include "scene/obj/mtl_text.h"

#include <algorithm>
#include <map>

#include "base/log.h"
#include "base/lower_case.h"
#include "scene/lost_pictures.h"
#include "scene/obj/obj_text.h"

namespace gnomon {
namespace {

// CIE XYZ to linear sRGB (IEC 61966-2-1).
vec3 rgb_of_xyz(const vec3& c) {
  return {3.2406f * c.x - 1.5372f * c.y - 0.4986f * c.z, -0.9689f * c.x + 1.8758f * c.y + 0.0415f * c.z,
          0.0557f * c.x - 0.2040f * c.y + 1.0570f * c.z};
}

class MtlReader {
 public:
  MtlReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  std::vector<MtlMaterial> read() {
    ObjStatements statements(text_);
    for (ObjStatement s; statements.next(s);) {
      line_ = s.line;
      keyword_ = s.keyword;
      const std::string key = lower_case(s.keyword);
      if (key == "newmtl") {
        materials_.emplace_back().name = s.rest;
      } else if (!materials_.empty()) {
        read_statement(materials_.back(), key, s.rest);
      }
    }
    say_unknown();
    return std::move(materials_);
  }

 private:
  // Of the format and its extensions (PBR); what is not read changes no shadow.
  static bool is_known(const std::string& key) {
    constexpr std::string_view k_not_read[] = {"ka",      "ni",      "tf",        "illum",    "sharpness", "disp",     "decal",
                                               "refl",    "aniso",   "anisor",    "pr",       "pm",        "ps",       "pc",
                                               "pcr",     "map_ka",  "map_ks",    "map_ke",   "map_ns",    "map_ni",   "map_tf",
                                               "map_pr",  "map_pm",  "map_ps",    "map_pc",   "map_refl",  "map_disp", "map_ao",
                                               "map_rma", "map_orm", "map_aniso", "map_norm", "map_aat"};
    return std::find(std::begin(k_not_read), std::end(k_not_read), key) != std::end(k_not_read);
  }

  // A keyword that is misspelt may be one that cuts holes.
  void say_unknown() const {
    if (unknown_.empty()) return;
    std::vector<std::string> names;
    size_t first_line = unknown_.begin()->second;
    for (const auto& [name, line] : unknown_) {
      names.push_back(fmt::format("{} (line {})", name, line));
      first_line = std::min(first_line, line);
    }
    log_warning("{}:{}: keywords that MTL does not have are ignored: {}", file_, first_line, first_names(names));
  }

  void read_statement(MtlMaterial& m, const std::string& key, std::string_view rest) {
    if (key == "kd") return read_colour(m.diffuse, rest);
    if (key == "ks") return read_colour(m.specular, rest);
    if (key == "ke") return read_colour(m.emission, rest);
    if (key == "ns") return read_number(m.shininess, rest, 1.0f, 1e4f);
    if (key == "d") return read_dissolve(m, rest);
    if (key == "tr") return read_transparency(m, rest);
    if (key == "map_kd") return read_picture(m.colour, rest);
    if (key == "map_d" || key == "map_opacity") return read_picture(m.alpha, rest);
    if (key == "map_tr") return read_picture(m.alpha, rest), void(m.alpha.inverted = true);
    if (key == "norm") return read_picture(m.normal, rest);
    if (key == "bump" || key == "map_bump") return read_picture(m.bump, rest);
    if (!is_known(key)) unknown_.try_emplace(keyword_, line_);
  }

  // --- numbers ---

  // "0,5" of exporters that follow the language of their system is 0.5; nothing else in MTL has a comma.
  std::optional<float> number(std::string_view word) {
    if (const auto value = parse_number(word)) return value;
    std::string dotted(word);
    if (std::count(dotted.begin(), dotted.end(), ',') != 1 || dotted.back() == ',') return std::nullopt;
    dotted[dotted.find(',')] = '.';
    const auto value = parse_number(dotted);
    if (value) commas_ = true;
    return value;
  }

  void say_commas() {
    if (commas_) log_warning("{}:{}: {}: the commas are read as decimal points", file_, line_, keyword_);
    commas_ = false;
  }

  void read_colour(vec3& colour, std::string_view rest) {
    std::string_view after = rest;
    const std::string_view first = next_word(after);
    if (first == "spectral") {
      log_warning("{}:{}: {} spectral: curves of reflectance are not read; {} is used instead", file_, line_, keyword_,
                  as_text(colour));
      return;
    }
    const bool is_xyz = first == "xyz";
    const auto values = three_numbers(is_xyz ? after : rest);
    if (!values) {
      log_warning("{}:{}: {} {}: no colour; valid: one or three numbers, or xyz and three; {} is used instead", file_, line_,
                  keyword_, rest, as_text(colour));
      return;
    }
    say_commas();
    const vec3 rgb = is_xyz ? rgb_of_xyz(*values) : *values;
    constexpr float k_most = 1.01f;  // white in CIE XYZ is not quite 1
    if (&colour == &materials_.back().diffuse && std::max({rgb.x, rgb.y, rgb.z}) > k_most) {
      log_warning("{}:{}: {} {}: more light than falls on it; valid: 0 to 1; it is used as it stands", file_, line_, keyword_,
                  rest);
    }
    colour = glm::clamp(rgb, vec3(0.0f), vec3(1e6f));
  }

  // One number stands for all three.
  std::optional<vec3> three_numbers(std::string_view rest) {
    vec3 values(0.0f);
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = next_word(rest);
      if (i == 1 && word.empty()) return vec3(values.x);
      const auto value = number(word);
      if (!value) {
        commas_ = false;
        return std::nullopt;
      }
      values[i] = *value;
    }
    return values;
  }

  static std::string as_text(const vec3& colour) { return fmt::format("{:g} {:g} {:g}", colour.x, colour.y, colour.z); }

  void read_number(float& target, std::string_view rest, float low, float high) {
    const auto value = number(next_word(rest));
    if (!value) {
      log_warning("{}:{}: {}: has no number that can be read; {:g} is used instead", file_, line_, keyword_, target);
      return;
    }
    say_commas();
    target = std::clamp(*value, low, high);
    if (&target != &materials_.back().shininess && target != *value)  // of Ns only a highlight is another
      log_warning("{}:{}: {}: is {:g}; valid: {:g} to {:g}; {:g} is used instead", file_, line_, keyword_, *value, low, high,
                  target);
  }

  // -halo: solid at the silhouette, `d` where the surface faces the eye. A shadow has one opacity.
  void read_dissolve(MtlMaterial& m, std::string_view rest) {
    std::string_view after = rest;
    if (next_word(after) == "-halo") {
      log_warning("{}:{}: d -halo: opacity that depends on the view is not read; the same opacity is used all over", file_,
                  line_);
      rest = after;
    }
    read_number(m.dissolve, rest, 0.0f, 1.0f);
    dissolve_of_ = materials_.size();
  }

  // The opposite of `d`, which goes before it: exporters that write both do not agree on what Tr means.
  void read_transparency(MtlMaterial& m, std::string_view rest) {
    float transparency = 1.0f - m.dissolve;
    read_number(transparency, rest, 0.0f, 1.0f);
    if (dissolve_of_ != materials_.size()) m.dissolve = 1.0f - transparency;
  }

  // --- pictures ---

  void read_picture(MtlPicture& picture, std::string_view rest) {
    picture = {};
    for (std::string_view after = rest;; after = rest) {
      const std::string option = lower_case(next_word(after));
      if (!read_option(picture, option, after)) break;
      rest = after;
    }
    say_commas();
    const size_t start = rest.find_first_not_of(" \t");
    if (start != rest.npos) picture.name = rest.substr(start);
  }

  // Cuts the option's values off `after`; false where it is none, but the picture's name.
  bool read_option(MtlPicture& picture, const std::string& option, std::string_view& after) {
    float ignored[3];
    if (option == "-s") return read_values(option, after, {&picture.scale.x, &picture.scale.y, &ignored[2]}, 1);
    if (option == "-o") return read_values(option, after, {&picture.offset.x, &picture.offset.y, &ignored[2]}, 1);
    if (option == "-bm") return read_values(option, after, {&picture.bump_multiplier}, 1);
    if (option == "-t") return read_values(option, after, {&ignored[0], &ignored[1], &ignored[2]}, 1);
    if (option == "-mm") return read_values(option, after, {&ignored[0], &ignored[1]}, 2);
    if (option == "-boost" || option == "-texres") return read_values(option, after, {&ignored[0]}, 1);
    if (option == "-clamp") return picture.clamp = next_word(after) == "on", true;
    for (const std::string_view known : {"-blendu", "-blendv", "-cc", "-imfchan", "-type", "-colorspace"}) {
      if (option == known) return next_word(after), true;
    }
    return false;
  }

  // As many numbers as follow. What follows the last may be a picture called "7".
  bool read_values(const std::string& option, std::string_view& after, std::initializer_list<float*> targets, size_t required) {
    size_t count = 0;
    for (float* target : targets) {
      std::string_view behind = after;
      const auto value = number(next_word(behind));
      if (!value || (count >= required && behind.find_first_not_of(" \t") == behind.npos)) break;
      *target = *value;
      after = behind;
      ++count;
    }
    if (count < required) {
      log_warning("{}:{}: {} {}: has {} number(s) where {} are needed; it is ignored", file_, line_, keyword_, option, count,
                  required);
    }
    return true;
  }

  std::string_view text_;
  const std::string& file_;
  size_t line_ = 0;
  std::string keyword_;
  bool commas_ = false;     // in what was read of the statement
  size_t dissolve_of_ = 0;  // count of materials when the last `d` was read
  std::vector<MtlMaterial> materials_;
  std::map<std::string, size_t> unknown_;  // keyword -> line of the first
};

}  // namespace

std::vector<MtlMaterial> read_mtl(std::string_view text, const std::string& file) { return MtlReader(text, file).read(); }

}  // namespace gnomon
