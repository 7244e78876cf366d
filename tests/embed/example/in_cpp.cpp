// A sensor notices what comes by. C++17, with the C interface alone.

#include <kerf.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <stdexcept>

namespace {

void check(kerf_status status) {
  if (status != KERF_OK) throw std::runtime_error(kerf_status_text(status));
}

struct Destroy {
  void operator()(kerf_world* world) const { kerf_world_destroy(world); }
};
using World = std::unique_ptr<kerf_world, Destroy>;

World make_world(std::uint32_t dimension) {
  kerf_world* world = nullptr;
  kerf_error error;
  check(kerf_error_init(&error, sizeof error));
  if (kerf_world_create(dimension, nullptr, &world, &error) != KERF_OK) throw std::runtime_error(error.text);
  return World(world);
}

/// Minimum and maximum.
using Box = std::array<float, 6>;

kerf_handle insert(const World& world, const Box& box, std::uint32_t kind) {
  kerf_object object;
  check(kerf_object_init(&object, sizeof object));
  object.kind = kind;
  kerf_handle handle = 0;
  check(kerf_world_insert(world.get(), box.data(), &object, 1, 1, &handle, nullptr));
  return handle;
}

}  // namespace

int main() try {
  const World world = make_world(3);
  insert(world, {4, 0, 0, 6, 2, 2}, KERF_SENSOR);
  Box ball{0, 0, 0, 1, 1, 1};
  const kerf_handle handle = insert(world, ball, KERF_MOVING);
  for (int step = 1; step <= 4; ++step) {
    ball[0] += 2;
    ball[3] += 2;
    check(kerf_world_move(world.get(), &handle, ball.data(), 1, nullptr));
    check(kerf_world_step(world.get()));
    const kerf_pair* pairs = nullptr;
    std::size_t count = 0;
    check(kerf_world_pairs(world.get(), &pairs, &count));
    const bool noticed = count == 1 && pairs[0].flags == KERF_PAIR_OF_SENSOR;
    std::printf("step %d: %s\n", step, noticed ? "noticed" : "nothing");
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
