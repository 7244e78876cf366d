// Lets each allocation of a run fail once, and looks whether the world stays usable: the call says so, every
// object was taken or was not, the next step reports exactly the pairs of the boxes that are there, and
// queries find them.

#include <kerf.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <vector>

namespace {

long left = -1;  ///< allocations until one fails; negative: none does
bool failed = false;

bool is_denied() {
  if (left < 0 || left-- > 0) return false;
  failed = true;
  return true;
}

void* allocate(std::size_t size) {
  void* const memory = is_denied() ? nullptr : std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void* allocate(std::size_t size, std::align_val_t alignment) {
  const auto unit = static_cast<std::size_t>(alignment);
  void* const memory = is_denied() ? nullptr : std::aligned_alloc(unit, (size + unit - 1) / unit * unit);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void* operator new(std::size_t size, std::align_val_t alignment) { return allocate(size, alignment); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

// Long buffers are moved by realloc; the linker replaces its calls by these.
extern "C" {
void* __real_realloc(void* memory, std::size_t size);   // NOLINT: the linker's names
void* __wrap_realloc(void* memory, std::size_t size) {  // NOLINT
  return is_denied() ? nullptr : __real_realloc(memory, size);
}
}

namespace {

constexpr std::size_t kObjects = 70;
constexpr std::size_t kMostObjects = 600;  ///< more than a call takes at once while pairs are kept

[[noreturn]] void fail(const char* what, long allocation) {
  std::fprintf(stderr, "allocation %ld: %s\n", allocation, what);
  std::exit(1);
}

/// What a call may answer: that all is well, or that memory ended, if it did.
void expect(kerf_status status, long allocation) {
  if (status == KERF_OK || (status == KERF_OUT_OF_MEMORY && failed) ||
      (status == KERF_STALE_HANDLE && failed))
    return;
  fail(kerf_status_text(status), allocation);
}

std::vector<float> boxes_of(int step, std::size_t objects = kObjects) {
  std::vector<float> boxes;
  for (std::size_t k = 0; k < objects; ++k) {
    const auto x =
        static_cast<float>(k * 37 % 50) + 0.3F * static_cast<float>(step) * static_cast<float>(k % 3);
    const auto y = static_cast<float>(k * 11 % 23);
    boxes.insert(boxes.end(), {x, y, x + 3, y + 3});
  }
  return boxes;
}

/// How many pairs the boxes have that are there; all objects are of the moving kind.
std::size_t true_pairs(const kerf_world* world) {
  std::vector<kerf_handle> handles(kMostObjects);
  std::size_t count = 0;
  if (kerf_world_get_handles(world, handles.data(), handles.size(), &count) != KERF_OK) return 0;
  std::size_t pairs = 0;
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t i = 0; i < k; ++i) {
      float a[4];
      float b[4];
      (void)kerf_world_get_box(world, handles[k], a);
      (void)kerf_world_get_box(world, handles[i], b);
      pairs += a[0] <= b[2] && b[0] <= a[2] && a[1] <= b[3] && b[1] <= a[3] ? 1 : 0;
    }
  return pairs;
}

bool is_found(const kerf_world* world, const float* box, kerf_handle object) {
  std::vector<kerf_handle> found(2 * kObjects);
  std::size_t count = 0;
  if (kerf_world_overlap_box(world, box, nullptr, found.data(), found.size(), &count) != KERF_OK)
    return false;
  return std::find(found.begin(), found.end(), object) != found.end();
}

/// Whether the index, which is updated, has each object where it is.
bool are_all_found(kerf_world* world) {
  std::vector<kerf_handle> handles(kMostObjects);
  std::size_t count = 0;
  if (kerf_world_update_index(world) != KERF_OK) return false;
  if (kerf_world_get_handles(world, handles.data(), handles.size(), &count) != KERF_OK) return false;
  handles.resize(count);
  return std::all_of(handles.begin(), handles.end(), [world](kerf_handle handle) {
    float box[4];
    return kerf_world_get_box(world, handle, box) == KERF_OK && is_found(world, box, handle);
  });
}

/// A state that is saved is one that can be restored, also after memory ended and a bad request was refused.
void judge_saved(kerf_world* world, long allocation) {
  const long rest = left;
  left = -1;
  const float nan[4] = {0, 0, -1, 0};
  kerf_handle none = 0;
  if (kerf_world_insert(world, nan, nullptr, 0, 1, &none, nullptr) != KERF_BAD_BOX)
    fail("a bad box is taken", allocation);
  std::size_t size = 0;
  if (kerf_world_save(world, nullptr, 0, &size) == KERF_OK) {
    std::vector<unsigned char> bytes(size);
    if (kerf_world_save(world, bytes.data(), size, &size) != KERF_OK ||
        kerf_world_restore(world, bytes.data(), size, nullptr) != KERF_OK)
      fail("a state is saved that cannot be restored", allocation);
  }
  left = rest;
}

/// A batch of moves: also where memory ends, each object has a status.
void move_all(kerf_world* world, const std::vector<kerf_handle>& handles, const std::vector<float>& boxes,
              long allocation) {
  kerf_status statuses[kObjects];
  std::fill(statuses, statuses + kObjects, -1);
  expect(kerf_world_move(world, handles.data(), boxes.data(), kObjects, statuses), allocation);
  for (const kerf_status status : statuses) expect(status, allocation);
}

/// A run in which the allocation of that number fails. False if it has fewer.
bool run(long allocation) {
  failed = false;
  kerf_world_options options;
  expect(kerf_world_options_init(&options, sizeof options), allocation);
  options.config = "min_threshold=4,max_threshold=8,schedule_interval=2";
  options.pairs_of = KERF_PAIRS_OF_EXACT_BOXES;
  left = allocation;
  kerf_world* world = nullptr;
  expect(kerf_world_create(2, &options, &world, nullptr), allocation);
  std::vector<kerf_handle> handles;
  const long rest = left;
  left = -1;  // our own lists are allowed to be there
  handles.resize(kObjects);
  std::vector<std::vector<float>> boxes;
  for (int step = 0; step < 6; ++step) boxes.push_back(boxes_of(step));
  left = rest;
  if (world == nullptr) return true;
  expect(kerf_world_insert(world, boxes[0].data(), nullptr, 0, kObjects, handles.data(), nullptr),
         allocation);
  for (std::size_t step = 1; step < 6; ++step) {
    expect(kerf_world_step(world), allocation);
    move_all(world, handles, boxes[step], allocation);
    judge_saved(world, allocation);
    expect(kerf_world_set_margin(world, handles[step], 0.5F), allocation);
    expect(kerf_world_shift_origin(world, boxes[step].data()), allocation);
    expect(kerf_world_set_kind(world, handles[step], KERF_FIXED), allocation);
    expect(kerf_world_set_kind(world, handles[step], KERF_MOVING), allocation);
    expect(kerf_world_remove(world, &handles[20 + step], 1, nullptr), allocation);
    expect(kerf_world_insert(world, boxes[step].data(), nullptr, 0, 1, &handles[20 + step], nullptr),
           allocation);
    judge_saved(world, allocation);
    expect(kerf_world_update_index(world), allocation);
    std::size_t found = 0;
    expect(kerf_world_overlap_box(world, boxes[step].data(), nullptr, nullptr, 0, &found), allocation);
  }
  left = -1;
  for (std::size_t step = 1; step < 6; ++step)  // what a failed set_kind left
    (void)kerf_world_set_kind(world, handles[step], KERF_MOVING);
  if (kerf_world_step(world) != KERF_OK) fail("the world is of no more use", allocation);
  const kerf_pair* pairs = nullptr;
  std::size_t count = 0;
  if (kerf_world_pairs(world, &pairs, &count) != KERF_OK || count != true_pairs(world))
    fail("the pairs are not those of the boxes", allocation);
  if (!are_all_found(world)) fail("a query does not find what is there", allocation);
  kerf_world_destroy(world);
  return failed;
}

/// An update of an index in which the allocation of that number fails, after an object came, one went and all
/// moved far. False if it has fewer.
bool run_update(long allocation) {
  failed = false;
  kerf_world* world = nullptr;
  expect(kerf_world_create(2, nullptr, &world, nullptr), allocation);
  std::vector<kerf_handle> handles(kObjects);
  const std::vector<float> before = boxes_of(0);
  std::vector<float> after = before;
  for (std::size_t k = 0; k < after.size(); k += 2) after[k] += 1000;
  expect(kerf_world_insert(world, before.data(), nullptr, 0, kObjects, handles.data(), nullptr), allocation);
  expect(kerf_world_step(world), allocation);
  expect(kerf_world_update_index(world), allocation);
  expect(kerf_world_remove(world, handles.data(), 1, nullptr), allocation);
  expect(kerf_world_insert(world, before.data(), nullptr, 0, 1, handles.data(), nullptr), allocation);
  expect(kerf_world_move(world, handles.data(), after.data(), kObjects, nullptr), allocation);
  left = allocation;
  expect(kerf_world_update_index(world), allocation);
  left = -1;
  for (std::size_t k = 1; k < kObjects; ++k)
    if (!is_found(world, &before[4 * k], handles[k]) && !is_found(world, &after[4 * k], handles[k]))
      fail("an object is neither found where it was nor where it is", allocation);
  if (!are_all_found(world)) fail("the index is of no more use", allocation);
  kerf_world_destroy(world);
  return failed;
}

/// The boxes of all objects, in the order of their handles.
std::vector<float> boxes_in(const kerf_world* world) {
  std::vector<kerf_handle> handles(kMostObjects);
  std::size_t count = 0;
  if (kerf_world_get_handles(world, handles.data(), handles.size(), &count) != KERF_OK) return {};
  std::vector<float> boxes(4 * count);
  for (std::size_t k = 0; k < count; ++k) (void)kerf_world_get_box(world, handles[k], &boxes[4 * k]);
  return boxes;
}

/// A shift in which the allocation of that number fails, of objects that came one a step: no list has room
/// for all. None of them is shifted then. False if it has fewer.
bool run_shift(long allocation, std::size_t objects, float margin) {
  failed = false;
  kerf_world* world = nullptr;
  expect(kerf_world_create(2, nullptr, &world, nullptr), allocation);
  kerf_object object;
  expect(kerf_object_init(&object, sizeof object), allocation);
  object.margin = margin;
  const std::vector<float> given = boxes_of(0, objects);
  for (std::size_t k = 0; k < objects; ++k) {
    kerf_handle handle = 0;
    expect(kerf_world_insert(world, &given[4 * k], &object, 1, 1, &handle, nullptr), allocation);
    expect(kerf_world_step(world), allocation);
  }
  for (int step = 0; step < 20; ++step) expect(kerf_world_step(world), allocation);
  std::vector<float> boxes = boxes_in(world);
  const float by[2] = {128, -64};
  left = allocation;
  const kerf_status status = kerf_world_shift_origin(world, by);
  left = -1;
  expect(status, allocation);
  if (status == KERF_OK)
    for (std::size_t k = 0; k < boxes.size(); ++k) boxes[k] += by[k % 2];
  if (boxes_in(world) != boxes) fail("a shift is neither made nor left", allocation);
  if (!are_all_found(world)) fail("a shift leaves what is not found", allocation);
  kerf_world_destroy(world);
  return failed;
}

/// A world that has one object, of a high index, is built anew after its memory ended.
void keep_a_far_object() {
  constexpr std::size_t kMany = (std::size_t{1} << 22U) + 1;
  constexpr std::size_t kAtOnce = std::size_t{1} << 16U;
  kerf_world* world = nullptr;
  expect(kerf_world_create(2, nullptr, &world, nullptr), 0);
  std::vector<kerf_handle> handles(kMany);
  const std::vector<float> points(4 * kAtOnce);
  for (std::size_t k = 0; k < kMany; k += kAtOnce)
    expect(kerf_world_insert(world, points.data(), nullptr, 0, std::min(kAtOnce, kMany - k), &handles[k],
                             nullptr),
           0);
  expect(kerf_world_remove(world, handles.data(), kMany - 1, nullptr), 0);
  left = 0;
  if (kerf_world_step(world) != KERF_OUT_OF_MEMORY) fail("a step took no memory", 0);
  left = -1;
  expect(kerf_world_insert(world, points.data(), nullptr, 0, 1, handles.data(), nullptr), 0);
  const kerf_pair* pairs = nullptr;
  std::size_t count = 0;
  if (kerf_world_step(world) != KERF_OK || kerf_world_pairs(world, &pairs, &count) != KERF_OK || count != 1)
    fail("an object of a high index is lost", 0);
  kerf_world_destroy(world);
}

}  // namespace

int main() {
  long allocation = 0;
  while (run(allocation)) ++allocation;
  long update = 0;
  while (run_update(update)) ++update;
  for (const std::size_t objects : {kObjects, kMostObjects})
    for (const float margin : {0.0F, 0.5F}) {
      long shift = 0;
      while (run_shift(shift, objects, margin)) ++shift;
    }
  keep_a_far_object();
  std::printf("each of %ld allocations failed once\n", allocation);
  return allocation > 100 ? 0 : 1;
}
