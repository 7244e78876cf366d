#pragma once

#include "frames/story/story_request.h"

namespace CLI {
class App;
}

namespace kerf {

/// `kerf film`: a run as a short film to share.
class FilmCommand {
 public:
  explicit FilmCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws UsageError, Interrupted (no film is made), and std::runtime_error if there can be no film.
  void run() const;

 private:
  CLI::App* command_;
  StoryTexts texts_;
};

}  // namespace kerf
