// Parameter tables: one text read as a struct, as descriptions, and as values from the command line.
#include "base/params.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstddef>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace gnomon {
namespace {

#define GNOMON_PARAMS_FILE "../tests/unit/example.params"
#include "base/params_define.h"
#undef GNOMON_PARAMS_FILE

ParamBlock example() { return ParamBlock(param_table_storage()); }

// The message of the usage error that setting `name` to `text` must give.
std::string refusal(std::string_view name, std::string_view text) {
  ParamBlock block = example();
  try {
    block.set(name, text, "pcf.key");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::usage);
    EXPECT_EQ(block, example()) << "a refused value must not be stored";
    return error.what();
  }
  return "no error";
}

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

TEST(Params, TableDescribesItself) {
  const ParamTable table = param_table_storage();
  ASSERT_EQ(table.size(), 4u);
  EXPECT_EQ(table[0].name, "size");
  EXPECT_EQ(table[0].type, ParamType::int_);
  EXPECT_EQ(table[0].update, ParamUpdate::rebuild);
  EXPECT_EQ(table[0].unit(), "texels");
  EXPECT_EQ(table[0].valid_text(), "a whole number from 16 to 16384");
  EXPECT_EQ(table[1].update, ParamUpdate::live);
  EXPECT_EQ(table[2].unit(), "");
  EXPECT_EQ(table[3].default_value, 1.0);
  EXPECT_EQ(table[3].valid_text(), "one of scene, view, depth");
}

TEST(Params, DefaultsOfBlockAndStructAgree) {
  const Params from_block = example().as<Params>(), fresh;
  EXPECT_EQ(from_block.size, fresh.size);
  EXPECT_EQ(from_block.bias, fresh.bias);
  EXPECT_EQ(from_block.stable, fresh.stable);
  EXPECT_EQ(from_block.fit, uint32_t{fit_view});
  EXPECT_EQ(sizeof(Params), 4 * param_table_storage().size());
  EXPECT_EQ(example().words()[1], std::bit_cast<uint32_t>(0.1f)) << "what the GPU reads";
}

TEST(Params, ReadsEveryType) {
  ParamBlock block = example();
  block.set("size", "2048", "x");
  block.set("bias", "-2.5e-1", "x");
  block.set("stable", "off", "x");
  block.set("fit", "depth", "x");
  const auto params = block.as<Params>();
  EXPECT_EQ(params.size, 2048);
  EXPECT_EQ(params.bias, -0.25f);
  EXPECT_EQ(params.stable, 0u);
  EXPECT_EQ(params.fit, uint32_t{fit_depth});
  EXPECT_EQ(block.text("bias"), "-0.25");
  EXPECT_EQ(block.text("stable"), "false");
  EXPECT_EQ(block.text("fit"), "depth");
  EXPECT_EQ(block.number("fit"), 2.0);
}

TEST(Params, RangeIncludesItsEnds) {
  ParamBlock block = example();
  for (const char* text : {"-1", "2.5"}) EXPECT_NO_THROW(block.set("bias", text, "x")) << text;
  for (const char* text : {"-1.001", "2.6", "inf", "nan", "", "1m", " 1"}) {
    EXPECT_TRUE(contains(refusal("bias", text), "a number from -1 to 2.5")) << refusal("bias", text);
  }
}

TEST(Params, WholeNumbersAreWhole) {
  EXPECT_TRUE(contains(refusal("size", "100.5"), "a whole number from 16 to 16384"));
  EXPECT_TRUE(contains(refusal("size", "8"), "pcf.key: 8 is not valid"));
}

TEST(Params, ChoicesAndTruthValuesAreNamed) {
  EXPECT_TRUE(contains(refusal("fit", "camera"), "one of scene, view, depth"));
  EXPECT_TRUE(contains(refusal("fit", "1"), "one of scene, view, depth"));
  EXPECT_TRUE(contains(refusal("stable", "yes"), "true or false"));
}

TEST(Params, UnknownKeyListsTheValidOnes) {
  EXPECT_EQ(refusal("sise", "1"), "pcf.key: unknown parameter 'sise'; valid: size, bias, stable, fit");
}

TEST(Params, JsonRoundTrip) {
  ParamBlock block = example();
  block.set("bias", "0.3", "x");
  block.set("fit", "scene", "x");
  const nlohmann::json json = block.to_json();
  EXPECT_EQ(json.at("bias").dump(), "0.3") << "not 0.30000001192";
  EXPECT_EQ(json.at("size"), 1024);
  EXPECT_EQ(json.at("stable"), true);
  ParamBlock copy = example();
  for (const auto& [key, value] : json.items()) copy.set(key, value.is_string() ? value.get<std::string>() : value.dump(), key);
  EXPECT_EQ(copy, block);
}

TEST(Params, SetNumberChecksToo) {
  ParamBlock block = example();
  EXPECT_THROW(block.set_number("fit", 3.0, "x"), Error);
  EXPECT_THROW(block.set_number("size", 16.5, "x"), Error);
  block.set_number("fit", 0.0, "x");
  EXPECT_EQ(block.text("fit"), "scene");
}

}  // namespace
}  // namespace gnomon
