#define GLFW_INCLUDE_NONE
#include "viz/debugger/gui/glfw_window.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

namespace kerf {
namespace {

std::string last_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text == nullptr ? "no reason given" : text;
}

std::optional<Key> key_of(int key) {
  static const std::map<int, Key> kKeys{{GLFW_KEY_SPACE, Key::space},
                                        {GLFW_KEY_COMMA, Key::comma},
                                        {GLFW_KEY_PERIOD, Key::period},
                                        {GLFW_KEY_HOME, Key::home},
                                        {GLFW_KEY_END, Key::end},
                                        {GLFW_KEY_F, Key::f},
                                        {GLFW_KEY_H, Key::h},
                                        {GLFW_KEY_I, Key::i},
                                        {GLFW_KEY_B, Key::b},
                                        {GLFW_KEY_O, Key::o},
                                        {GLFW_KEY_ESCAPE, Key::escape},
                                        {GLFW_KEY_ENTER, Key::enter},
                                        {GLFW_KEY_KP_ENTER, Key::enter},
                                        {GLFW_KEY_BACKSPACE, Key::backspace},
                                        {GLFW_KEY_DELETE, Key::del},
                                        {GLFW_KEY_LEFT, Key::left},
                                        {GLFW_KEY_RIGHT, Key::right},
                                        {GLFW_KEY_TAB, Key::tab},
                                        {GLFW_KEY_F1, Key::f1},
                                        {GLFW_KEY_F5, Key::f5},
                                        {GLFW_KEY_F9, Key::f9},
                                        {GLFW_KEY_F12, Key::f12}};
  const auto found = kKeys.find(key);
  return found == kKeys.end() ? std::nullopt : std::optional(found->second);
}

DebuggerInput& input_of(GLFWwindow* window) {
  return *static_cast<DebuggerInput*>(glfwGetWindowUserPointer(window));
}

void note_key(GLFWwindow* window, int key, int /*scancode*/, int action, int mods) {
  const auto known = key_of(key);
  if (!known || action == GLFW_RELEASE) return;
  input_of(window).keys.push_back({*known, (mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_CONTROL) != 0});
}

/// '?' lies elsewhere on every keyboard, so that it is known by what it writes.
void note_letter(GLFWwindow* window, unsigned code) {
  DebuggerInput& input = input_of(window);
  if (code == '?') input.keys.push_back({Key::question, false, false});
  if (code < 0x80) {
    input.text += static_cast<char>(code);
  } else if (code < 0x800) {
    input.text += static_cast<char>(0xC0U | (code >> 6U));
    input.text += static_cast<char>(0x80U | (code & 0x3FU));
  }
}

void note_wheel(GLFWwindow* window, double /*x*/, double y) {
  input_of(window).wheel += static_cast<float>(y);
}

GlProcedure find_function(const char* name) { return glfwGetProcAddress(name); }

}  // namespace

GlfwWindow::Library::Library() {
  if (glfwInit() != GLFW_TRUE)
    throw std::runtime_error("a window cannot be opened (" + last_error() +
                             "); without a display, use --headless with a --script");
}

GlfwWindow::Library::~Library() { glfwTerminate(); }

void GlfwWindow::Close::operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }

GLFWwindow* GlfwWindow::make_window(const std::string& title, int width, int height) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  GLFWwindow* const window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (window == nullptr)
    throw std::runtime_error("a window with OpenGL 3.3 cannot be opened (" + last_error() +
                             "); use --headless with a --script");
  return window;
}

GlfwWindow::GlfwWindow(const std::string& title, int width, int height)
    : window_(make_window(title, width, height)), title_(title) {
  make_current();
  functions_ = load_gl_functions(&find_function);
  glfwSwapInterval(1);
  listen();
}

GlfwWindow::~GlfwWindow() = default;

void GlfwWindow::listen() {
  glfwSetWindowUserPointer(window_.get(), &input_);
  glfwSetKeyCallback(window_.get(), note_key);
  glfwSetCharCallback(window_.get(), note_letter);
  glfwSetScrollCallback(window_.get(), note_wheel);
  last_ = glfwGetTime();
}

void GlfwWindow::make_current() { glfwMakeContextCurrent(window_.get()); }

std::string GlfwWindow::description() const {
  const auto text = [this](GLenum what) {
    return std::string(reinterpret_cast<const char*>(functions_.GetString(what)));
  };
  return "window, " + text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

int GlfwWindow::width() const {
  int width = 0;
  glfwGetFramebufferSize(window_.get(), &width, nullptr);
  return width;
}

int GlfwWindow::height() const {
  int height = 0;
  glfwGetFramebufferSize(window_.get(), nullptr, &height);
  return height;
}

bool GlfwWindow::should_close() const { return glfwWindowShouldClose(window_.get()) == GLFW_TRUE; }

void GlfwWindow::swap() { glfwSwapBuffers(window_.get()); }

bool GlfwWindow::goes_on(const std::string& progress) {
  glfwSetWindowTitle(window_.get(), progress.c_str());
  is_busy_ = true;
  glfwPollEvents();
  const auto escape =
      std::ranges::find(input_.keys, Key::escape, [](const auto& press) { return press.key; });
  if (escape == input_.keys.end()) return !should_close();
  input_.keys.erase(escape);
  return false;
}

DebuggerInput GlfwWindow::take_input(bool idle) {
  constexpr double kWait = 0.05;  // seconds: panels move on slowly even if nothing happens
  if (idle) {
    glfwWaitEventsTimeout(kWait);
  } else {
    glfwPollEvents();
  }
  if (std::exchange(is_busy_, false)) glfwSetWindowTitle(window_.get(), title_.c_str());
  DebuggerInput taken = std::exchange(input_, {});
  double x = 0;
  double y = 0;
  int window_width = 0;
  glfwGetCursorPos(window_.get(), &x, &y);
  glfwGetWindowSize(window_.get(), &window_width, nullptr);
  // On some displays a place has several pixels.
  const double scale = window_width > 0 ? static_cast<double>(width()) / window_width : 1;
  taken.mouse_x = static_cast<float>(x * scale);
  taken.mouse_y = static_cast<float>(y * scale);
  for (int k = 0; k < 3; ++k)
    taken.buttons[static_cast<std::size_t>(k)] = glfwGetMouseButton(window_.get(), k) == GLFW_PRESS;
  const auto held = [this](int key) { return glfwGetKey(window_.get(), key) == GLFW_PRESS; };
  taken.shift = held(GLFW_KEY_LEFT_SHIFT) || held(GLFW_KEY_RIGHT_SHIFT);
  taken.control = held(GLFW_KEY_LEFT_CONTROL) || held(GLFW_KEY_RIGHT_CONTROL);
  const double now = glfwGetTime();
  taken.seconds = static_cast<float>(std::clamp(now - std::exchange(last_, now), 1e-4, 0.25));
  return taken;
}

}  // namespace kerf
