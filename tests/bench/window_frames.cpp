#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "viz/debugger/debugger.h"
#include "viz/debugger/gui/glfw_window.h"

// kerf_window_frames RECORDING: prints, as Markdown, how long a frame of the debugger's window takes, from
// what the user did until it is shown: the table of docs/RENDERING.md. Without a display:
//   xvfb-run -s "-screen 0 1400x900x24" kerf_window_frames RECORDING
namespace kerf {
namespace {

constexpr int kFrames = 50;
constexpr int kUncounted = 5;  ///< in which caches fill and the scene follows what was done before

using Clock = std::chrono::steady_clock;

class WindowFrames {
 public:
  explicit WindowFrames(const std::string& file)
      : window_(file, 1280, 720), debugger_(window_, open_run(file)) {
    const std::uint32_t steps = debugger_.model().run().steps();
    const std::uint32_t ahead = kFrames + kUncounted;
    debugger_.model().go(Position::end_of(steps > ahead ? steps - ahead : 0));
    debugger_.frame({}, window_.width(), window_.height());
  }

  enum class Until { shown, drawn };

  /// `act` says what the user does in frame k.
  void measure(const std::string& what, const std::function<void(int, DebuggerInput&)>& act,
               Until until = Until::shown) {
    std::vector<double> times;
    DebuggerInput input;
    for (int k = 0; k < kFrames + kUncounted; ++k) {
      (void)window_.take_input();
      const auto start = Clock::now();
      act(k, input);
      debugger_.frame(input, window_.width(), window_.height());
      const auto drawn = Clock::now();
      debugger_.show_in_window(window_.width(), window_.height());
      window_.swap();
      const auto end = until == Until::drawn ? drawn : Clock::now();
      if (k >= kUncounted) times.push_back(std::chrono::duration<double, std::milli>(end - start).count());
      input.end_frame();
      input.shift = false;
    }
    std::ranges::sort(times);
    const auto at = [&](double share) {
      return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
    };
    std::printf("| %s | %.1f | %.1f | %.1f |\n", what.c_str(), at(0.5), at(0.95), at(1));
  }

  void measure_all() {
    const Run& run = debugger_.model().run();
    std::printf("%u objects, %zu partitioners, %zu pairs, %dx%d\n\n", run.objects(),
                debugger_.view().counts().partitioners, run.pairs().size(), window_.width(),
                window_.height());
    std::printf("| what happens | median ms | 95 %% | worst |\n|---|---:|---:|---:|\n");
    const auto nothing = [](int, DebuggerInput&) {};
    measure("nothing", nothing);
    measure("nothing: the panels alone, without bringing them to the display", nothing, Until::drawn);
    measure("the mouse goes over the scene", [](int k, DebuggerInput& input) {
      input.mouse_x = 400.0F + 2.0F * static_cast<float>(k);
      input.mouse_y = 300;
    });
    measure("the camera turns", [](int k, DebuggerInput& input) {
      input.buttons[0] = k > 0;
      input.mouse_x = 400.0F + 2.0F * static_cast<float>(k);
      input.mouse_y = 300;
    });
    measure("a step forward", [](int, DebuggerInput& input) {
      input.key = Key::period;
      input.shift = true;
    });
    Random random(1);
    measure("a random place, where the oracle is asked", [&](int, DebuggerInput&) {
      debugger_.model().go(Position::end_of(1 + random.below(run.steps())));
    });
  }

 private:
  GlfwWindow window_;
  Debugger debugger_;
};

}  // namespace
}  // namespace kerf

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: kerf_window_frames RECORDING\n");
    return 2;
  }
  try {
    kerf::tune_allocator_for_rendering();
    kerf::WindowFrames(argv[1]).measure_all();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
