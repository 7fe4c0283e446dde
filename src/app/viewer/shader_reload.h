// Shaders whose files change take effect while the viewer runs; what does not compile is said, and changes nothing.
#pragma once

#include <functional>
#include <string>

#include "lab/live_shaders/shader_watch.h"

namespace gnomon::viewer {

class ShaderReload {
 public:
  ShaderReload();

  // Between frames. `rebuild` makes all pipelines again; where it throws Error with new shaders, it is called once more with
  // the old.
  void update(const std::function<void()>& rebuild);
  // Why the last change took no effect, until the files are mended.
  std::string& message() { return message_; }

 private:
  ShaderWatch watch_;
  std::string message_;
};

}  // namespace gnomon::viewer
