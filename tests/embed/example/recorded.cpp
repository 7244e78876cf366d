// Records two steps of two boxes, reads them again and prints how many pairs each step had.

#include <cstdio>

#include "core/recording/recorder.h"
#include "core/recording/recording_reader.h"

int main(int, char** arguments) {
  kerf::Bsp<2, kerf::EventLog> tree;
  kerf::Recorder<2> recorder(tree, arguments[1],
                             {.dimension = 2, .config = tree.config(), .scene = "example"});
  const kerf::Box<2> here{{0, 0}, {2, 2}};
  const kerf::Box<2> there{{5, 5}, {6, 6}};
  if (recorder.insert({0}, here, kerf::Mobility::moving) != kerf::Status::ok) return 1;
  if (recorder.insert({1}, there, kerf::Mobility::moving) != kerf::Status::ok) return 1;
  recorder.step();
  if (recorder.move({1}, here) != kerf::Status::ok) return 1;
  recorder.step();
  recorder.finish();
  const kerf::RecordingReader<2> recording(arguments[1]);
  for (const kerf::StepRow& row : recording.rows()) {
    std::printf("step %u: %llu pairs\n", row.step, static_cast<unsigned long long>(row.pairs));
  }
}
