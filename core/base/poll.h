#pragma once

#include <functional>
#include <utility>

namespace kerf {

/// What `ask` throws where work that is given up is no error.
struct Stopped {};

/// Long work calls this often, for each line or row for example, where nothing is lost if it throws.
inline void poll();

/// While it lives, long work of this thread asks `ask` again and again, also within a step. `ask` throws to
/// have the work given up. Of several the one made last is asked.
class Polling {
 public:
  explicit Polling(std::function<void()> ask)
      : ask_(std::move(ask)), before_(std::exchange(latest(), this)) {}
  ~Polling() { latest() = before_; }
  Polling(const Polling&) = delete;
  Polling& operator=(const Polling&) = delete;

 private:
  friend void poll();

  static const Polling*& latest() {
    static thread_local const Polling* polling = nullptr;
    return polling;
  }

  std::function<void()> ask_;
  const Polling* before_;
};

inline void poll() {
  if (const Polling* const polling = Polling::latest(); polling != nullptr) polling->ask_();
}

}  // namespace kerf
