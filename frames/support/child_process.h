#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>

namespace kerf {

/// A forked process that does one kind of work on request, so that a crash or an endless loop of a library
/// does no harm, and its memory can be measured apart from ours.
class ChildProcess {
 public:
  /// The child calls `work(request)`. Throws std::runtime_error if no process can be made.
  explicit ChildProcess(const std::function<void(char)>& work);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Lets the child do its work and waits for it. False if the child died, threw, or was killed here because
  /// it took longer than `limit` or `stop` became true; `trouble` says what happened, and the child no longer
  /// exists.
  bool ask(char request, std::chrono::duration<double> limit, const std::function<bool()>& stop);
  [[nodiscard]] const std::string& trouble() const { return trouble_; }

 private:
  void serve(const std::function<void(char)>& work) const;
  bool end(const std::string& trouble);
  bool bury();

  pid_t process_ = -1;
  int requests_ = -1;
  int replies_ = -1;
  std::string trouble_;
};

}  // namespace kerf
