#pragma once

#include <sys/types.h>

#include <string>

struct _XDisplay;

namespace kerf::test {

/// A display of its own without a screen (Xvfb), on which `DISPLAY` points while the object lives, and a hand
/// that does something in the first window there. Events come as from a server: in order, however fast.
class XDisplay {
 public:
  XDisplay();
  ~XDisplay();
  XDisplay(const XDisplay&) = delete;
  XDisplay& operator=(const XDisplay&) = delete;

  /// Of a program that has just been started; throws std::runtime_error if a minute brings none.
  void wait_for_window() const;
  void move(float x, float y);
  /// 1 left, 3 right, 4 and 5 the wheel, 6 and 7 a wheel to the left and right.
  void press(unsigned button);
  void release(unsigned button);
  void click(unsigned button);
  /// A key by the name that X11 has for it, down and up.
  void tap(const std::string& key);
  void hold(const std::string& key);
  void let_go(const std::string& key);
  /// From now on the display says that it has so many pixels an inch; 96 is what programs are used to.
  void set_dots_per_inch(int dots);
  /// Waits until all of it was sent to the window.
  void flush();

 private:
  void send(int type, unsigned detail);
  /// None: 0.
  [[nodiscard]] unsigned code_of(const std::string& key) const;
  [[nodiscard]] unsigned long find_window() const;

  pid_t server_ = -1;
  _XDisplay* display_ = nullptr;
  unsigned long window_ = 0;
  int x_ = 0;
  int y_ = 0;
  unsigned long time_ = 1;  ///< milliseconds of the server; two events never have the same
};

}  // namespace kerf::test
