/* Part of kerf.h: queries about the boxes of a world's objects. Boxes are those that were given, with a
 * margin or not; all are closed, and answers are exact.
 *
 * Answers are those for the boxes as they were in the last kerf_world_update_index(); an object that was
 * removed since is not found. Before the first one, and after a restore until the next one, nothing is found.
 * Kinds and filters are those of the moment. A world that is never asked pays nothing.
 *
 * Lists: count gets how many were found. The first ones are written, as many as capacity allows; if that is
 * not all of them, the status is KERF_SMALL_BUFFER, or KERF_OK with a capacity of 0. */
#ifndef KERF_QUERIES_H
#define KERF_QUERIES_H

#include <kerf.h>

/* NOLINTBEGIN(readability-identifier-naming,modernize-*): names and idioms of C */
#ifdef __cplusplus
extern "C" {
#endif

/* Which objects take part: NULL, or as kerf_query_filter_init() makes it, all of them. */
typedef struct kerf_query_filter {
  uint32_t size;
  uint32_t kinds; /* bit k: those of kind k; all */
  /* As if the query were an object with these; a category or mask of 0 has all bits. All three 0: whatever
   * the category, mask and group of an object, it takes part. */
  uint64_t category; /* 0 */
  uint64_t mask;     /* 0 */
  int32_t group;     /* 0 */
  uint32_t reserved; /* 0 */
  /* Asked last, for objects that would be reported, by kerf_world_cast_first and kerf_world_nearest also for
   * some that are not in the end, since others are nearer; a result other than 0 accepts. NULL: accepts all.
   * It may only call functions of a const world: others answer KERF_BUSY. */
  int (*accepts)(void* context, kerf_handle handle);
  void* context;
} kerf_query_filter;

/* Where a cast first touches an object's box: at its start + t * direction; t is 0 if it touches there. */
typedef struct kerf_hit {
  kerf_handle object;
  float t;
  uint32_t reserved;
} kerf_hit;

typedef struct kerf_neighbour {
  kerf_handle object;
  double squared_distance;
} kerf_neighbour;

KERF_API kerf_status kerf_query_filter_init(kerf_query_filter* filter, size_t size);

/* Takes the boxes as they are, requests since the last step included. */
KERF_API kerf_status kerf_world_update_index(kerf_world* world);

/* Objects whose boxes overlap a box (2 * dimension floats; minimum = maximum: a point), by index. */
KERF_API kerf_status kerf_world_overlap_box(const kerf_world* world, const float* box,
                                            const kerf_query_filter* filter, kerf_handle* found,
                                            size_t capacity, size_t* count);
/* The same for a sphere, in 2D a disc. center: dimension floats. */
KERF_API kerf_status kerf_world_overlap_sphere(const kerf_world* world, const float* center, float radius,
                                               const kerf_query_filter* filter, kerf_handle* found,
                                               size_t capacity, size_t* count);
/* What a box hits on its way from its place to max_t times direction, ordered by t. A box of no extent is a
 * ray. direction: dimension floats of any length; max_t may be infinite. */
KERF_API kerf_status kerf_world_cast(const kerf_world* world, const float* box, const float* direction,
                                     float max_t, const kerf_query_filter* filter, kerf_hit* found,
                                     size_t capacity, size_t* count);
/* The first of them; of object 0 if nothing is hit. */
KERF_API kerf_status kerf_world_cast_first(const kerf_world* world, const float* box, const float* direction,
                                           float max_t, const kerf_query_filter* filter, kerf_hit* first);
/* The nearest objects to a point (dimension floats), at most capacity of them and no farther than
 * max_distance, which may be infinite; ordered by distance. count gets how many were written. */
KERF_API kerf_status kerf_world_nearest(const kerf_world* world, const float* point, float max_distance,
                                        const kerf_query_filter* filter, kerf_neighbour* found,
                                        size_t capacity, size_t* count);

#ifdef __cplusplus
}
#endif

/* NOLINTEND(readability-identifier-naming,modernize-*) */
#endif
