// The viewer's history of states.
#include <gtest/gtest.h>

#include "app/viewer/state/undo_history.h"

namespace gnomon::viewer {
namespace {

class Undo : public ::testing::Test {
 protected:
  static ViewState first() {
    ViewState state;
    state.view.scene = "courtyard";
    state.techniques = {"single/pcf"};
    return state;
  }
  void frame(bool held, double seconds = 0.05) { history.tick(now += seconds, held); }
  void set(const std::string& key, const std::string& value) {
    state.edits[key] = value;
    history.add(state);
  }
  void look_from(const std::string& camera) {
    state.view.camera = camera;
    history.add(state);
  }
  int steps_back() {
    int steps = 0;
    for (; history.can_undo(); ++steps) history.undo();
    return steps;
  }

  double now = 0.0;
  ViewState state = first();
  UndoHistory history{state, 5};
};

TEST_F(Undo, steps_go_back_and_forth) {
  EXPECT_FALSE(history.can_undo() || history.can_redo());
  frame(false), set("pcf.size", "5");
  frame(false), set("pcf.size", "7");
  EXPECT_EQ(history.undo().edits.at("pcf.size"), "5");
  EXPECT_TRUE(history.undo().edits.empty());
  EXPECT_FALSE(history.can_undo());
  EXPECT_EQ(history.redo().edits.at("pcf.size"), "5");
  EXPECT_EQ(history.redo().edits.at("pcf.size"), "7");
  EXPECT_FALSE(history.can_redo());
}

TEST_F(Undo, a_change_after_undo_forgets_what_was_undone) {
  frame(false), set("pcf.size", "5");
  state = history.undo();
  frame(false), set("pcf.size", "9");
  EXPECT_FALSE(history.can_redo());
  EXPECT_TRUE(history.undo().edits.empty());
}

TEST_F(Undo, a_drag_is_one_step) {
  for (const char* value : {"5", "7", "9"}) frame(true), set("pcf.size", value);
  frame(true), frame(false);
  for (const char* value : {"11", "13"}) frame(true), set("pcf.size", value);  // the same slider again
  frame(true), set("bias.depth", "1");                                         // another thing
  EXPECT_EQ(history.undo().edits.at("pcf.size"), "13");
  EXPECT_EQ(history.undo().edits.at("pcf.size"), "9");
  EXPECT_TRUE(history.undo().edits.empty());
}

TEST_F(Undo, a_walk_is_one_step_until_it_rests) {
  for (const char* camera : {"0,0,0:1,0,0", "1,0,0:2,0,0"}) frame(false), look_from(camera);
  frame(false, 0.3), look_from("2,0,0:3,0,0");  // keys were let go for a moment
  frame(false, 1.0), look_from("3,0,0:4,0,0");  // a slow frame
  for (int i = 0; i < 40; ++i) frame(false);
  look_from("4,0,0:5,0,0");
  EXPECT_EQ(history.undo().view.camera, "3,0,0:4,0,0");
  EXPECT_EQ(history.undo().view.camera, "");
}

TEST_F(Undo, the_lens_that_a_walk_pins_belongs_to_it) {
  state.edits["camera.vertical_fov"] = "50";
  frame(false), look_from("0,0,0:1,0,0");
  frame(false), look_from("1,0,0:2,0,0");
  EXPECT_EQ(steps_back(), 1);
}

TEST_F(Undo, the_same_state_is_no_step) {
  frame(false);
  state.view.size = {123, 456};  // follows the window
  history.add(state);
  EXPECT_FALSE(history.can_undo());
}

TEST_F(Undo, the_oldest_steps_go) {
  for (int i = 0; i < 20; ++i) frame(false), set("pcf.size", std::to_string(i));
  EXPECT_EQ(steps_back(), 5);
}

}  // namespace
}  // namespace gnomon::viewer
