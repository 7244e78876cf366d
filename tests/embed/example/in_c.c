/* A lift meets a crate, and leaves it. C11. */

#include <kerf.h>
#include <stdio.h>
#include <stdlib.h>

static void check(kerf_status status) {
  if (status == KERF_OK) return;
  fprintf(stderr, "kerf: %s\n", kerf_status_text(status));
  exit(1);
}

static void print(const char *what, const kerf_pair *pairs, size_t count) {
  size_t k;
  for (k = 0; k < count; ++k)
    printf(" %s %u and %u", what, kerf_handle_index(pairs[k].a), kerf_handle_index(pairs[k].b));
}

int main(void) {
  float boxes[2][4] = {{0, 0, 2, 1}, {0, 3, 1, 4}}; /* of lift and crate: minimum, maximum */
  kerf_object objects[2];
  kerf_handle handles[2];
  kerf_world *world = NULL;
  int step;

  check(kerf_object_init(&objects[0], sizeof objects[0]));
  objects[1] = objects[0];
  objects[0].kind = KERF_KINEMATIC;
  check(kerf_world_create(2, NULL, &world, NULL));
  check(kerf_world_insert(world, boxes[0], objects, 2, 2, handles, NULL));

  for (step = 1; step <= 6; ++step) {
    const kerf_pair *pairs = NULL;
    size_t count = 0;
    boxes[0][1] += 1; /* the lift goes up */
    boxes[0][3] += 1;
    check(kerf_world_move(world, handles, boxes[0], 1, NULL));
    check(kerf_world_step(world));
    printf("step %d:", step);
    check(kerf_world_begun(world, &pairs, &count));
    print("begun", pairs, count);
    check(kerf_world_ended(world, &pairs, &count));
    print("ended", pairs, count);
    printf("\n");
  }
  kerf_world_destroy(world);
  return 0;
}
