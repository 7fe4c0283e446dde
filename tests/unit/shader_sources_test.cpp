// Which files belong to a shader: of this tree, and of one written here.
#include "lab/live_shaders/shader_sources.h"

#include <gtest/gtest.h>

#include "base/file.h"
#include "base/temporary_folder.h"
#include "support/paths.h"

namespace gnomon {
namespace {

const std::filesystem::path k_src = source_dir() / "src";

TEST(ShaderSources, AKernelIsItsTemplateWithTheNamesOfItsTechnique) {
  ShaderSources sources(k_src);
  const std::string name = "resolve/single/pcf.comp";
  EXPECT_TRUE(sources.is_kernel(name));
  EXPECT_EQ(sources.file_of(name), "shadow/map/kernels/resolve.comp.in");
  EXPECT_NE(sources.kernel_text(name).find("#include \"shadow/map/projection/single/single.glsl\""), std::string::npos);
  EXPECT_EQ(sources.kernel_text(name).find('@'), std::string::npos);
  const auto files = sources.files_of(name);
  for (const char* file :
       {"shadow/map/kernels/resolve.comp.in", "shadow/map/filter/pcf/pcf.glsl", "shadow/map/filter/pcf/pcf.params",
        "shadow/map/projection/single/single.glsl", "shadow/map/glsl/compare.glsl", "base/glsl/shared.glsl"}) {
    EXPECT_TRUE(files.contains(file)) << file;
  }
  EXPECT_FALSE(files.contains("shadow/map/filter/hard/hard.glsl"));
  EXPECT_FALSE(sources.is_kernel("frame/shading/shade.comp"));
  EXPECT_TRUE(sources.files_of("convert/vsm.comp").contains("shadow/map/filter/vsm/vsm_encode.glsl"));
}

// As the build wrote them (cmake/gnomon_techniques.cmake).
TEST(ShaderSources, EveryFileOfAShaderIsThere) {
  ShaderSources sources(k_src);
  for (const char* name :
       {"frame/shading/shade.comp", "frame/rays/visibility.rahit", "frame/casters/draw/caster_paraboloid.geom",
        "resolve/cube/pcss.comp", "history/evsm.comp", "explain/cascaded.comp", "radius/pcss.comp"}) {
    for (const std::string& file : sources.files_of(name)) EXPECT_NE(sources.hash(file), "") << name << " includes " << file;
  }
}

TEST(ShaderSources, KnowsWhatCppReadsToo) {
  const auto shared = ShaderSources(k_src).shared_with_cpp();
  for (const char* file : {"frame/glsl/frame_data.glsl", "shadow/map/glsl/map_data.glsl", "base/glsl/shared.glsl",
                           "gpu/glsl/samplers.glsl", "shadow/map/filter/pcf/pcf.params", "shadow/map/bias.params"}) {
    EXPECT_TRUE(shared.contains(file)) << file;
  }
  for (const char* file : {"shadow/map/filter/pcf/pcf.glsl", "frame/shading/shade.comp", "shadow/map/glsl/compare.glsl"}) {
    EXPECT_FALSE(shared.contains(file)) << file;
  }
}

TEST(ShaderSources, FollowsIncludesHoweverTheyAreWritten) {
  const TemporaryFolder temporary;
  const std::filesystem::path& src = temporary.path();
  make_folder(src / "a");
  write_file(
      src / "a/main.comp",
      "#include \"a/one.glsl\"\n  #  include   \"beside.glsl\"\n#include <system>\n// #included\n#include \"a/absent.glsl\"\n");
  write_file(src / "a/one.glsl", "#include \"a/main.comp\"\n");  // a circle is no endless loop
  write_file(src / "a/beside.glsl", "");
  ShaderSources sources(src);
  EXPECT_EQ(sources.files_of("a/main.comp"),
            (std::set<std::string>{"a/main.comp", "a/one.glsl", "a/beside.glsl", "a/absent.glsl"}));
  EXPECT_EQ(sources.hash("a/absent.glsl"), "");
  const std::string before = sources.hash("a/one.glsl");
  write_file(src / "a/one.glsl", "changed\n");
  EXPECT_EQ(sources.hash("a/one.glsl"), before) << "an object sees one state of the tree";
  EXPECT_NE(ShaderSources(src).hash("a/one.glsl"), before);
}

}  // namespace
}  // namespace gnomon
