// What the window needs to show anything: interface, canvas, swapchain. It stays while scenes come and go.
#pragma once

#include <functional>

#include "app/viewer/window/canvas.h"
#include "app/viewer/window/interface.h"
#include "app/viewer/window/swapchain.h"

namespace gnomon::viewer {

struct Screen {
  Screen(Window& shown_in, Device& on)
      : window(shown_in), device(on), interface(on, shown_in), canvas(on), swapchain(on, shown_in) {}

  // The canvas in the window's size.
  void fit_canvas();
  // A frame without a scene: a dark window with panels.
  void show_panels(const std::function<void()>& panels);

  Window& window;
  Device& device;
  Interface interface;
  Canvas canvas;
  Swapchain swapchain;
};

}  // namespace gnomon::viewer
