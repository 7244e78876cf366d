#define GLFW_INCLUDE_NONE
#include "viz/debugger/gui/glfw_window.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace kerf {
namespace {

std::string last_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text == nullptr ? "no reason given" : text;
}

std::optional<Key> key_of(int key) {
  if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return key_of_digit(key - GLFW_KEY_0);
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
                                        {GLFW_KEY_C, Key::c},
                                        {GLFW_KEY_S, Key::s},
                                        {GLFW_KEY_E, Key::e},
                                        {GLFW_KEY_L, Key::l},
                                        {GLFW_KEY_K, Key::k},
                                        {GLFW_KEY_M, Key::m},
                                        {GLFW_KEY_N, Key::n},
                                        {GLFW_KEY_R, Key::r},
                                        {GLFW_KEY_A, Key::a},
                                        {GLFW_KEY_U, Key::u},
                                        {GLFW_KEY_D, Key::d},
                                        {GLFW_KEY_Q, Key::q},
                                        {GLFW_KEY_X, Key::x},
                                        {GLFW_KEY_T, Key::t},
                                        {GLFW_KEY_J, Key::j},
                                        {GLFW_KEY_G, Key::g},
                                        {GLFW_KEY_P, Key::p},
                                        {GLFW_KEY_W, Key::w},
                                        {GLFW_KEY_V, Key::v},
                                        {GLFW_KEY_Y, Key::y},
                                        {GLFW_KEY_Z, Key::z},
                                        {GLFW_KEY_ESCAPE, Key::escape},
                                        {GLFW_KEY_ENTER, Key::enter},
                                        {GLFW_KEY_KP_ENTER, Key::enter},
                                        {GLFW_KEY_BACKSPACE, Key::backspace},
                                        {GLFW_KEY_DELETE, Key::del},
                                        {GLFW_KEY_LEFT, Key::left},
                                        {GLFW_KEY_RIGHT, Key::right},
                                        {GLFW_KEY_TAB, Key::tab},
                                        {GLFW_KEY_UP, Key::up},
                                        {GLFW_KEY_DOWN, Key::down},
                                        {GLFW_KEY_F1, Key::f1},
                                        {GLFW_KEY_F5, Key::f5},
                                        {GLFW_KEY_F9, Key::f9},
                                        {GLFW_KEY_F10, Key::f10},
                                        {GLFW_KEY_F12, Key::f12}};
  const auto found = kKeys.find(key);
  return found == kKeys.end() ? std::nullopt : std::optional(found->second);
}

bool is_held(GLFWwindow* window, int left, int right) {
  return glfwGetKey(window, left) == GLFW_PRESS || glfwGetKey(window, right) == GLFW_PRESS;
}

/// Reads modifiers from the keys themselves: X11 reports them as they were before the event.
template <class What>
void note(GLFWwindow* window, What what) {
  static_cast<InputQueue*>(glfwGetWindowUserPointer(window))
      ->add({glfwGetTime(), is_held(window, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
             is_held(window, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL), std::move(what)});
}

/// With Ctrl no letter is written, so that these are found by what stands on the key.
std::optional<Key> sign_of(int key, int scancode) {
  if (key == GLFW_KEY_KP_ADD) return Key::plus;
  if (key == GLFW_KEY_KP_SUBTRACT) return Key::minus;
  const char* const name = glfwGetKeyName(key, scancode);
  const std::string_view sign = name == nullptr ? "" : name;
  if (sign == "+" || sign == "=") return Key::plus;
  return sign == "-" ? std::optional(Key::minus) : std::nullopt;
}

void note_key(GLFWwindow* window, int key, int scancode, int action, int /*mods*/) {
  auto known = key_of(key);
  if (!known && is_held(window, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL))
    known = sign_of(key, scancode);
  if (!known || action == GLFW_RELEASE) return note(window, NothingElse{});
  note(window, KeyTap{*known, action == GLFW_REPEAT});
}

std::string utf8_of(unsigned code) {
  const auto byte = [](unsigned value) { return static_cast<char>(static_cast<unsigned char>(value)); };
  const auto six_bits = [&](unsigned shift) { return byte(0x80U | ((code >> shift) & 0x3FU)); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xC0U | (code >> 6U)), six_bits(0)};
  if (code < 0x10000) return {byte(0xE0U | (code >> 12U)), six_bits(6), six_bits(0)};
  return {byte(0xF0U | (code >> 18U)), six_bits(12), six_bits(6), six_bits(0)};
}

/// These lie elsewhere on every keyboard, so they are recognised by their letters.
void note_letter(GLFWwindow* window, unsigned code) {
  if (is_held(window, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL)) return;  // it was taken as a key
  if (code == '?') note(window, KeyTap{Key::question, false});
  if (code == '+') note(window, KeyTap{Key::plus, false});
  if (code == '-') note(window, KeyTap{Key::minus, false});
  note(window, TypedText{utf8_of(code)});
}

void note_wheel(GLFWwindow* window, double x, double y) {
  note(window, WheelTurn{static_cast<float>(y), static_cast<float>(x)});
}

void note_button(GLFWwindow* window, int button, int action, int /*mods*/) {
  const auto number = static_cast<std::size_t>(button);
  if (number < DebuggerInput{}.buttons.size()) note(window, ButtonChange{number, action == GLFW_PRESS});
}

/// On some displays a screen coordinate has several pixels.
void note_place(GLFWwindow* window, double x, double y) {
  int pixels = 0;
  int places = 0;
  glfwGetFramebufferSize(window, &pixels, nullptr);
  glfwGetWindowSize(window, &places, nullptr);
  const double scale = places > 0 ? static_cast<double>(pixels) / places : 1;
  note(window, MouseMove{static_cast<float>(x * scale), static_cast<float>(y * scale)});
}

/// Of several files the first one.
void note_drop(GLFWwindow* window, int count, const char** paths) {
  if (count > 0) note(window, DroppedFile{paths[0]});
}

void note_size(GLFWwindow* window, int /*width*/, int /*height*/) { note(window, NothingElse{}); }

void note_scale(GLFWwindow* window, float /*x*/, float /*y*/) { note(window, NothingElse{}); }

void note_damage(GLFWwindow* window) { note(window, NothingElse{}); }

GlProcedure find_function(const char* name) { return glfwGetProcAddress(name); }

}  // namespace

GlfwWindow::Library::Library() {
#ifdef GLFW_PLATFORM
  // GLFW from 3.4 on asks for Wayland first, whose library complains where there cannot be any.
  const auto is_empty = [](const char* text) { return text == nullptr || *text == '\0'; };
  const bool no_wayland =
      is_empty(std::getenv("WAYLAND_DISPLAY")) && is_empty(std::getenv("XDG_RUNTIME_DIR"));
  if (no_wayland && glfwPlatformSupported(GLFW_PLATFORM_X11) == GLFW_TRUE)
    glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
  if (glfwInit() != GLFW_TRUE)
    throw std::runtime_error("a window cannot be opened (" + last_error() +
                             "); without a display, use --headless with a --script");
}

GlfwWindow::Library::~Library() { glfwTerminate(); }

void GlfwWindow::Close::operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }

GLFWwindow* GlfwWindow::make_window(const std::string& title, int width, int height, bool grows) {
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, grows ? GLFW_TRUE : GLFW_FALSE);
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

GlfwWindow::GlfwWindow(const std::string& title, int width, int height, bool grows)
    : window_(make_window(title, width, height, grows)), title_(title) {
  make_current();
  functions_ = load_gl_functions(&find_function);
  glfwSwapInterval(1);
  constexpr std::array kShapes{GLFW_ARROW_CURSOR, GLFW_IBEAM_CURSOR, GLFW_HRESIZE_CURSOR, GLFW_VRESIZE_CURSOR,
                               GLFW_HAND_CURSOR};
  std::ranges::transform(kShapes, cursors_.begin(), glfwCreateStandardCursor);
  listen();
}

GlfwWindow::~GlfwWindow() = default;

std::string GlfwWindow::try_out() {
  const Library library;  // hints last as long as the library
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  return GlfwWindow("kerf", 64, 64).description();
}

void GlfwWindow::listen() {
  glfwSetWindowUserPointer(window_.get(), &queue_);
  glfwSetKeyCallback(window_.get(), note_key);
  glfwSetCharCallback(window_.get(), note_letter);
  glfwSetScrollCallback(window_.get(), note_wheel);
  glfwSetMouseButtonCallback(window_.get(), note_button);
  glfwSetCursorPosCallback(window_.get(), note_place);
  glfwSetDropCallback(window_.get(), note_drop);
  glfwSetFramebufferSizeCallback(window_.get(), note_size);
  glfwSetWindowContentScaleCallback(window_.get(), note_scale);
  glfwSetWindowRefreshCallback(window_.get(), note_damage);
  double x = 0;
  double y = 0;
  glfwGetCursorPos(window_.get(), &x, &y);
  note_place(window_.get(), x, y);
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

double GlfwWindow::content_scale() const {
  float across = 1;
  float down = 1;
  glfwGetWindowContentScale(window_.get(), &across, &down);
  return double{std::max(across, down)};
}

bool GlfwWindow::should_close() const { return glfwWindowShouldClose(window_.get()) == GLFW_TRUE; }

void GlfwWindow::swap() { glfwSwapBuffers(window_.get()); }

bool GlfwWindow::goes_on(const std::string& progress) {
  glfwSetWindowTitle(window_.get(), progress.c_str());
  is_busy_ = true;
  glfwPollEvents();
  return !queue_.take_tap(Key::escape) && !should_close();
}

void GlfwWindow::set_title(const std::string& title) {
  if (std::exchange(title_, title) != title) glfwSetWindowTitle(window_.get(), title_.c_str());
}

void GlfwWindow::set_pointer(Pointer pointer) {
  if (std::exchange(pointer_, pointer) != pointer)
    glfwSetCursor(window_.get(), cursors_[static_cast<std::size_t>(pointer)]);
}

void GlfwWindow::copy(const std::string& text) { glfwSetClipboardString(window_.get(), text.c_str()); }

std::string GlfwWindow::clipboard() const {
  const char* const text = glfwGetClipboardString(window_.get());
  return text == nullptr ? "" : text;
}

double GlfwWindow::seconds() { return glfwGetTime(); }

bool GlfwWindow::wait(double seconds) const {
  if (!has_input() && seconds > 0) {
    glfwWaitEventsTimeout(seconds);
  } else {
    glfwPollEvents();
  }
  return has_input();
}

DebuggerInput GlfwWindow::take_input() {
  if (std::exchange(is_busy_, false)) glfwSetWindowTitle(window_.get(), title_.c_str());
  DebuggerInput input = queue_.take(seconds());
  if (input.control && input.key == Key::v) paste(input);
  return input;
}

/// As if it were typed, without what ends a line: fields have one.
void GlfwWindow::paste(DebuggerInput& input) const {
  input.text = clipboard();
  std::erase_if(input.text, [](char c) { return c == '\n' || c == '\r'; });
  input.key.reset();
  input.control = false;
}

}  // namespace kerf
