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
  explicit Polling(std::function<void()> ask) : ask_(std::move(ask)), before_(std::exchange(latest_, this)) {}
  ~Polling() { latest_ = before_; }
  Polling(const Polling&) = delete;
  Polling& operator=(const Polling&) = delete;

 private:
  friend void poll();

  static inline thread_local const Polling* latest_ = nullptr;
  std::function<void()> ask_;
  const Polling* before_;
};

inline void poll() {
  if (Polling::latest_ != nullptr) Polling::latest_->ask_();
}

}  // namespace kerf
