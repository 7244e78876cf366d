#pragma once

#include <stdexcept>
#include <string>

namespace kerf {

/// Bytes with content that no Kerf writes. Most are of recordings, and the message says so.
class Damage : public std::runtime_error {
 public:
  /// `fault` ends the sentence.
  explicit Damage(const std::string& fault)
      : std::runtime_error("the recording is damaged: " + fault), fault_(fault) {}
  [[nodiscard]] const std::string& fault() const { return fault_; }

 private:
  std::string fault_;
};

[[noreturn]] inline void fail_damaged(const std::string& fault) { throw Damage(fault); }

}  // namespace kerf
