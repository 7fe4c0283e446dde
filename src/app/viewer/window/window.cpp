// GLFW.
#include "app/viewer/window/window.h"

#include <GLFW/glfw3.h>  // after Vulkan's header: it then declares what concerns Vulkan

#include <algorithm>
#include <utility>

#include "base/error.h"

namespace gnomon::viewer {
namespace {

std::string last_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason given";
}

vec2 pointer(GLFWwindow* window) {
  double x = 0.0, y = 0.0;
  glfwGetCursorPos(window, &x, &y);
  return {static_cast<float>(x), static_cast<float>(y)};
}

}  // namespace

Window::Window(uvec2 size, const std::string& title) {
  if (!glfwInit()) {
    fail_device("no window can be opened here ({}); without a display use 'gnomon render' or 'gnomon compare'", last_error());
  }
  if (!glfwVulkanSupported()) {
    glfwTerminate();
    fail_device("no Vulkan on this display; without a window use 'gnomon render' or 'gnomon compare'");
  }
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  window_ = glfwCreateWindow(static_cast<int>(size.x), static_cast<int>(size.y), title.c_str(), nullptr, nullptr);
  if (!window_) {
    const std::string reason = last_error();
    glfwTerminate();
    fail_device("no window of {} x {} can be opened ({}); without a window use 'gnomon render' or 'gnomon compare'", size.x,
                size.y, reason);
  }
  glfwSetWindowUserPointer(window_, this);
  glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int) {
    if (action == GLFW_PRESS) of(window).pressed_.push_back(key);
    of(window).input_ = true;
  });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double, double) {
    for (int button = GLFW_MOUSE_BUTTON_LEFT; button <= GLFW_MOUSE_BUTTON_MIDDLE; ++button) {
      if (glfwGetMouseButton(window, button) == GLFW_PRESS) of(window).input_ = true;  // a drag goes on
    }
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int, int, int) { of(window).input_ = true; });
  glfwSetScrollCallback(window_, [](GLFWwindow* window, double, double) { of(window).input_ = true; });
  glfwSetWindowCloseCallback(window_, [](GLFWwindow* window) { of(window).input_ = true; });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* window, int, int) { of(window).input_ = true; });
  glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
    of(window).dropped_.insert(of(window).dropped_.end(), paths, paths + count);
    of(window).input_ = true;
  });
  mouse_ = pointer(window_);
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

WindowNeeds Window::needs() const {
  WindowNeeds needs;
  uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  needs.instance_extensions.assign(names, names + count);
  needs.can_present = [](VkInstance instance, VkPhysicalDevice physical, uint32_t family) {
    return glfwGetPhysicalDevicePresentationSupport(instance, physical, family) == GLFW_TRUE;
  };
  return needs;
}

VkSurfaceKHR Window::make_surface(VkInstance instance) const {
  VkSurfaceKHR surface = VK_NULL_HANDLE;
  vk_check(glfwCreateWindowSurface(instance, window_, nullptr, &surface), "glfwCreateWindowSurface");
  return surface;
}

uvec2 Window::size() const {
  if (glfwGetWindowAttrib(window_, GLFW_ICONIFIED)) return uvec2(0);
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return {static_cast<uint32_t>(width), static_cast<uint32_t>(height)};
}

void Window::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }
float Window::interface_scale() const {
  float x = 1.0f, y = 1.0f;
  glfwGetWindowContentScale(window_, &x, &y);
  int width = 0, height = 0, width_px = 0, height_px = 0;
  glfwGetWindowSize(window_, &width, &height);
  glfwGetFramebufferSize(window_, &width_px, &height_px);
  // Where a unit of the window is several pixels already, the interface is drawn larger without this.
  const float unit_px = width > 0 ? static_cast<float>(width_px) / static_cast<float>(width) : 1.0f;
  return std::clamp(x / unit_px, 0.5f, 4.0f);
}

bool Window::closing() const { return glfwWindowShouldClose(window_); }
void Window::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }

Window& Window::of(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

bool Window::has_input() {
  if (!std::exchange(looked_ahead_, true)) pressed_.clear(), dropped_.clear();
  glfwPollEvents();
  return input_;
}

void Window::poll(bool wait) {
  // What has_input took is of this frame.
  if (!std::exchange(looked_ahead_, false)) pressed_.clear(), dropped_.clear();
  wait ? glfwWaitEventsTimeout(0.1) : glfwPollEvents();
  input_ = closing();  // what was taken now is none that comes
  const vec2 now = pointer(window_);
  motion_ = now - mouse_;
  mouse_ = now;
}

bool Window::pressed(int key) const { return std::find(pressed_.begin(), pressed_.end(), key) != pressed_.end(); }
bool Window::held(int key) const { return pressed(key) || glfwGetKey(window_, key) == GLFW_PRESS; }
bool Window::control_held() const { return held(GLFW_KEY_LEFT_CONTROL) || held(GLFW_KEY_RIGHT_CONTROL); }
bool Window::right_button() const { return glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS; }

void Window::capture_mouse(bool on) {
  if (on == captured_) return;
  captured_ = on;
  glfwSetInputMode(window_, GLFW_CURSOR, on ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
  mouse_ = pointer(window_);  // hiding the pointer may move it
}

}  // namespace gnomon::viewer
