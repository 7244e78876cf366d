#include "tests/viz/debugger/x_display.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>

namespace kerf::test {
namespace {

/// What the server says of itself once it can be used, such as "7\n".
std::string number_of_display(int from) {
  std::string text;
  for (char c = 0; read(from, &c, 1) == 1 && c != '\n';) text += c;
  return text;
}

pid_t start_server(std::string& name) {
  std::array<int, 2> pipe_ends{};
  if (pipe(pipe_ends.data()) != 0) throw std::runtime_error("there is no pipe to be had");
  const std::string end = std::to_string(pipe_ends[1]);
  const std::array<const char*, 9> words{"Xvfb",        "-displayfd", end.c_str(), "-screen", "0",
                                         "1400x900x24", "-nolisten",  "tcp",       nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addclose(&actions, pipe_ends[0]);
  pid_t id = -1;
  const int error = posix_spawnp(&id, words[0], &actions, nullptr, const_cast<char**>(words.data()), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(pipe_ends[1]);
  name = error == 0 ? ":" + number_of_display(pipe_ends[0]) : "";
  close(pipe_ends[0]);
  if (name.size() < 2) throw std::runtime_error("Xvfb does not start");
  return id;
}

}  // namespace

XDisplay::XDisplay() {
  std::string name;
  server_ = start_server(name);
  setenv("DISPLAY", name.c_str(), 1);
  display_ = XOpenDisplay(name.c_str());
  if (display_ == nullptr) throw std::runtime_error("the display " + name + " cannot be opened");
}

XDisplay::~XDisplay() {
  XCloseDisplay(display_);
  unsetenv("DISPLAY");
  kill(server_, SIGTERM);
  waitpid(server_, nullptr, 0);
}

/// Nothing manages windows there, so that they lie directly on the root; of those that are seen there is one.
unsigned long XDisplay::find_window() const {
  Window root = 0;
  Window parent = 0;
  Window* children = nullptr;
  unsigned count = 0;
  XQueryTree(display_, DefaultRootWindow(display_), &root, &parent, &children, &count);
  Window found = 0;
  for (unsigned k = 0; k < count; ++k) {
    XWindowAttributes attributes;
    XGetWindowAttributes(display_, children[k], &attributes);
    if (attributes.map_state == IsViewable) found = children[k];
  }
  if (children != nullptr) XFree(children);
  return found;
}

void XDisplay::wait_for_window() const {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (find_window() == 0) {
    if (std::chrono::steady_clock::now() > end) throw std::runtime_error("there is no window");
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

void XDisplay::send(int type, unsigned detail) {
  if (window_ == 0) window_ = find_window();
  if (window_ == 0) throw std::runtime_error("there is no window");
  XEvent event{};
  // Buttons, keys and motions lie alike in it but for what follows the place.
  event.xbutton.type = type;
  event.xbutton.window = window_;
  event.xbutton.time = time_++;
  event.xbutton.x = x_;
  event.xbutton.y = y_;
  event.xbutton.same_screen = True;
  if (type == MotionNotify) event.xmotion.same_screen = True;
  if (type == ButtonPress || type == ButtonRelease) event.xbutton.button = detail;
  if (type == KeyPress || type == KeyRelease) event.xkey.keycode = detail;
  XSendEvent(display_, window_, True, NoEventMask, &event);
}

void XDisplay::move(float x, float y) {
  x_ = static_cast<int>(x);
  y_ = static_cast<int>(y);
  send(MotionNotify, 0);
}

void XDisplay::press(unsigned button) { send(ButtonPress, button); }

void XDisplay::release(unsigned button) { send(ButtonRelease, button); }

void XDisplay::click(unsigned button) {
  press(button);
  release(button);
}

unsigned XDisplay::code_of(const std::string& key) const {
  return XKeysymToKeycode(display_, XStringToKeysym(key.c_str()));
}

void XDisplay::tap(const std::string& key) {
  hold(key);
  let_go(key);
}

void XDisplay::hold(const std::string& key) { send(KeyPress, code_of(key)); }

void XDisplay::let_go(const std::string& key) { send(KeyRelease, code_of(key)); }

void XDisplay::set_dots_per_inch(int dots) {
  const std::string text = "Xft.dpi:\t" + std::to_string(dots) + "\n";
  XChangeProperty(display_, DefaultRootWindow(display_), XA_RESOURCE_MANAGER, XA_STRING, 8, PropModeReplace,
                  reinterpret_cast<const unsigned char*>(text.data()), static_cast<int>(text.size()));
  flush();
}

void XDisplay::flush() { XSync(display_, False); }

}  // namespace kerf::test
