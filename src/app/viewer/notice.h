// What the user is told though nothing failed.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace gnomon::viewer {

// How long a notice stays: as long as reading it takes.
inline constexpr double k_notice_s = 8.0, k_long_notice_s = 30.0;

// Those that are on screen, one below the other. Each goes by itself, or all when the user closes them.
class Notices {
 public:
  // An empty text adds nothing.
  void add(std::string text, double seconds = k_notice_s);
  // Once for each frame that shows them: `seconds` since the last one.
  void pass(double seconds);
  void clear() { notices_.clear(); }
  std::string text() const;  // empty: none

 private:
  struct Notice {
    std::string text;
    double left_s = 0.0;
    bool seen = false;  // its time begins with its first frame, however long that took
  };
  std::vector<Notice> notices_;
};

// How many warnings opening a scene gave, and the first ones; empty: none.
std::string warnings_notice(const std::string& scene, std::span<const std::string> warnings);

// Of several files that were dropped together; empty: one alone.
std::string drop_notice(std::span<const std::string> paths);

// What a picture holds, beside or instead of what is on screen.
struct PictureContent {
  std::string drawn_over;         // what its command does not draw; empty: nothing
  bool first_side_alone = false;  // the window shows another one, too
};

// Of a picture that was written.
std::string picture_notice(const std::string& path, const PictureContent& content);

}  // namespace gnomon::viewer
