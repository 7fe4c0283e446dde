// Shaders that change while the program runs, in a copy of the source tree.
#include "lab/live_shaders/shader_watch.h"

#include <algorithm>
#include <chrono>

#include "base/file.h"
#include "base/temporary_folder.h"
#include "support/scenes.h"
#include "support/view.h"

namespace gnomon {
namespace {

using test::device;

constexpr const char* k_pcf = "shadow/map/filter/pcf/pcf.glsl";

class ShaderWatching : public testing::Test {
 protected:
  ShaderWatching() : tree_(ShaderTree::of_this_build()) {
    const std::filesystem::path original = tree_.src();
    tree_.root = temporary_.path();
    std::filesystem::copy(original, tree_.src(), std::filesystem::copy_options::recursive);
    Scene scene = test::scene_with({test::floor_part(4.0f), test::box_part({-1, 1, -1}, {1, 2, 1})});
    scene.cameras.push_back(look_at("any", {0, 6, 6}, {0, 0, 0}, 50.0));
    scene.lights.push_back(test::make_sun({0.1f, -1.0f, 0.1f}));
    view_.emplace(std::move(scene));
  }
  ~ShaderWatching() override { set_replaced_shaders({}); }

  std::vector<float> mask(const std::string& technique = "single/pcf") {
    const TechniqueSpec& spec = find_technique(technique);
    return run_technique(*view_, spec, test::settings_of(spec)).mask;
  }
  static double share_of(const std::vector<float>& mask, float value) {
    return static_cast<double>(std::count(mask.begin(), mask.end(), value)) / static_cast<double>(mask.size());
  }

  static std::string unused_pcf() {
    const std::set<std::string> used = shaders_in_use();
    for (const TechniqueSpec& spec : all_techniques()) {
      const bool fits = spec.name.ends_with("/pcf") && spec.supports(LightKind::directional);
      if (fits && !used.contains("resolve/" + spec.name + ".comp")) return spec.name;
    }
    return {};
  }

  std::string text(const char* file) const { return read_text_file(tree_.src() / file); }
  void write(const char* file, const std::string& text) const { write_file(tree_.src() / file, text); }
  // The filter's answer becomes `expression`.
  void change_answer(const std::string& expression) {
    std::string changed = text(k_pcf);
    const std::string begin = "float lit(uint map_image, MapSample at, FilterParams params) {";
    const size_t at = changed.find(begin);
    ASSERT_NE(at, changed.npos);
    write(k_pcf, changed.insert(at + begin.size(), "\n  if (params.size > 0) return " + expression + ";"));
  }

  // What is told next. No test waits this long unless it fails.
  static ShaderNews news_of(ShaderWatch& watch) {
    for (int i = 0; i < 6000; ++i) {
      if (auto news = watch.poll()) return std::move(*news);
      usleep(10000);
    }
    ADD_FAILURE() << "no news";
    return {};
  }

  const TemporaryFolder temporary_;
  ShaderTree tree_;
  std::optional<test::View> view_;
};

TEST_F(ShaderWatching, AnEditChangesWhatIsComputed) {
  mask();
  ShaderWatch watch(tree_);
  ASSERT_EQ(watch.idle_reason(), "");
  change_answer("0.25");
  const ShaderNews news = news_of(watch);
  EXPECT_EQ(news.error, "");
  ASSERT_TRUE(news.compiled.contains("resolve/single/pcf.comp"));
  for (const auto& [name, words] : news.compiled)
    EXPECT_TRUE(name.starts_with("resolve/") && name.ends_with("/pcf.comp")) << name;
  EXPECT_EQ(share_of(mask(), 0.25f), 0.0) << "nothing is replaced before the caller does";
  set_replaced_shaders(news.compiled);
  EXPECT_GT(share_of(mask(), 0.25f), 0.5);
  set_replaced_shaders({});
  EXPECT_EQ(share_of(mask(), 0.25f), 0.0);
}

TEST_F(ShaderWatching, AMistakeIsToldWithItsPlaceAndGoesWhenItIsMended) {
  mask();
  mask("cascaded/pcf");
  ShaderWatch watch(tree_);
  const std::string whole = text(k_pcf);
  const auto line = std::count(whole.begin(), whole.end(), '\n') + 1;
  write(k_pcf, whole + "float no_semicolon() { return 1.0 }\n");
  const ShaderNews broken = news_of(watch);
  EXPECT_TRUE(broken.compiled.empty());
  EXPECT_NE(broken.error.find(fmt::format("{}:{}: error:", k_pcf, line)), std::string::npos) << broken.error;
  EXPECT_EQ(std::count(broken.error.begin(), broken.error.end(), '\n'), 0) << "told more than once: " << broken.error;

  // As it was: nothing is to be compiled.
  write(k_pcf, whole);
  const ShaderNews mended = news_of(watch);
  EXPECT_EQ(mended.error, "");
  EXPECT_TRUE(mended.compiled.empty());
}

TEST_F(ShaderWatching, NoneIsReplacedWhereOneFails) {
  mask();
  mask("single/hard");
  ShaderWatch watch(tree_);
  // Both filters read the first file; only one of them has the mistake.
  const char* common = "shadow/map/glsl/visibility.glsl";
  write(common, text(common) + "\nfloat not_used() { return 1.0; }\n");
  write(k_pcf, text(k_pcf) + "\nnonsense\n");
  const ShaderNews news = news_of(watch);
  EXPECT_TRUE(news.compiled.empty());
  EXPECT_NE(news.error.find(k_pcf), std::string::npos) << news.error;
}

TEST_F(ShaderWatching, AShaderThatIsUsedLaterHasTheChangeToo) {
  mask();
  ShaderWatch watch(tree_);
  change_answer("0.25");
  const ShaderNews first = news_of(watch);
  // One that no test has used before, whatever ran in this process.
  const std::string technique = unused_pcf();
  if (technique.empty()) GTEST_SKIP() << "every technique with this filter was used before";
  const std::string shader = "resolve/" + technique + ".comp";
  ASSERT_FALSE(first.compiled.contains(shader));
  mask(technique);
  const ShaderNews later = news_of(watch);
  ASSERT_TRUE(later.compiled.contains(shader));
  EXPECT_FALSE(later.compiled.contains("resolve/single/pcf.comp"));
  set_replaced_shaders(later.compiled);
  EXPECT_GT(share_of(mask(technique), 0.25f), 0.3);
}

TEST_F(ShaderWatching, WhatCppReadsTooNeedsABuild) {
  mask();
  ShaderWatch watch(tree_);
  const char* files[] = {"shadow/map/glsl/map_data.glsl", "shadow/map/filter/pcf/pcf.params"};
  for (const char* file : files) {
    const std::string before = text(file);
    write(file, before + "\n");
    const ShaderNews news = news_of(watch);
    EXPECT_TRUE(news.compiled.empty());
    EXPECT_NE(news.error.find(file), std::string::npos) << news.error;
    EXPECT_NE(news.error.find("build"), std::string::npos) << news.error;
    write(file, before);
    EXPECT_EQ(news_of(watch).error, "");
  }
}

TEST_F(ShaderWatching, OtherPushConstantsNeedABuild) {
  view_->draw();
  ShaderWatch watch(tree_);
  const char* file = "frame/shading/shade.comp";
  std::string changed = text(file);
  const size_t at = changed.find('{', changed.find("layout(push_constant"));
  ASSERT_NE(at, changed.npos);
  write(file, changed.insert(at + 1, "uint added;"));
  const ShaderNews news = news_of(watch);
  EXPECT_TRUE(news.compiled.empty());
  EXPECT_NE(news.error.find("frame/shading/shade.comp: its push constants"), std::string::npos) << news.error;
}

TEST_F(ShaderWatching, WithoutTreeOrCompilerItSaysWhyNothingIsWatched) {
  ShaderTree no_tree = tree_, no_compiler = tree_;
  no_tree.root /= "absent";
  no_compiler.compiler = "/absent/glslc";
  for (const ShaderTree& tree : {no_tree, no_compiler}) {
    ShaderWatch watch(tree);
    EXPECT_NE(watch.idle_reason().find("absent"), std::string::npos) << watch.idle_reason();
    EXPECT_FALSE(watch.poll());
  }
}

}  // namespace
}  // namespace gnomon
