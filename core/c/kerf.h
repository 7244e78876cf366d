/* Kerf's C interface: a broad phase. C11 and C++98.
 *
 * A world holds objects, each with a box, and reports in each step which boxes overlap (closed intervals:
 * boxes that touch overlap), which pairs begin and which end (docs/EMBEDDING.md has examples).
 *
 * Boxes are rows of floats: the minimum on each axis, then the maximum on each axis; 4 floats in 2D, 6 in 3D.
 *
 * Errors: KERF_OK and KERF_CLAMPED mean done; any other status says what is wrong, and nothing was done.
 * Nothing aborts, and no exception leaves the library. Requests of a batch are independent: those that can be
 * met are, statuses (or NULL) gets the status of each, and the function returns the first failure, else
 * KERF_CLAMPED if any is, else KERF_OK. NULL where data is needed is KERF_NULL_ARGUMENT, but for empty lists;
 * that, KERF_BAD_LENGTH, KERF_BAD_SIZE and KERF_BUSY refuse a call as a whole, which then writes no statuses.
 *
 * A struct that has a kerf_..._init() begins with its size, so that later versions can have more members; the
 * call sets the size, and defaults. Reserved members must be 0, and so must those that the library does not
 * know; no struct will ever be larger than 4096 bytes. kerf_pair, kerf_hit and kerf_neighbour never change.
 *
 * Threads: functions that take a const kerf_world may be called at the same time; no other may be meanwhile.
 * Each world has its own oneTBB task arena; the worker threads belong to the process. Two threads may use two
 * worlds at the same time.
 *
 * Memory follows the most objects that lived at a time. If it runs out, KERF_OUT_OF_MEMORY is returned and
 * the world stays usable; of a batch objects with that status were taken or were not. */
#ifndef KERF_H
#define KERF_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define KERF_API __attribute__((visibility("default")))
#else
#define KERF_API
#endif

/* NOLINTBEGIN(readability-identifier-naming,modernize-*): names and idioms of C */
#ifdef __cplusplus
extern "C" {
#endif

typedef struct kerf_world kerf_world;

/* Names one object of a world for as long as it lives; never one that lives later. 0 names nothing. */
typedef uint64_t kerf_handle;

typedef int32_t kerf_status;
enum kerf_status_code {
  KERF_OK = 0,
  KERF_CLAMPED = 1,      /* done; infinite bounds of the box were replaced by the largest finite ones */
  KERF_STALE_HANDLE = 2, /* names no object of this world: removed, of a world with another tag, or none */
  KERF_BAD_BOX = 3,      /* NaN, or a minimum above its maximum: the object stays where it was */
  KERF_BAD_VALUE = 4,    /* an unknown kind, a margin that is no length, or a vector that is not finite */
  KERF_BAD_LENGTH = 5,   /* lists of lengths that do not fit together */
  KERF_FULL = 6,         /* no index is free: a step frees those of removed objects */
  KERF_UNSTEPPED = 7,    /* there are requests since the last step: step first */
  KERF_DAMAGED = 8,      /* the bytes are no state that a world of this version and dimension wrote */
  KERF_NULL_ARGUMENT = 64,
  KERF_BAD_SIZE = 65,     /* a struct's size is none, or members that this version does not know are not 0 */
  KERF_BAD_OPTION = 66,   /* an option cannot work: kerf_error, if the call takes one, says which */
  KERF_SMALL_BUFFER = 67, /* the caller's memory is too small: the size that is needed was written */
  KERF_BUSY = 68, /* called by a callback of the world, which may only call functions of a const world */
  KERF_OUT_OF_MEMORY = 69,
  KERF_INTERNAL_ERROR = 70, /* a fault of Kerf's: please report it */
  KERF_BAD_QUERY = 71,      /* a query with NaN, an infinite place, min > max or a negative length */
  KERF_CALLBACK_THREW = 72  /* a callback of the caller's threw a C++ exception: a step is to be made again */
};

/* What an object is to the program. Pairs are reported if at least one object is moving or a sensor. */
enum kerf_kind {
  KERF_FIXED = 0,     /* static: part of the level */
  KERF_KINEMATIC = 1, /* moved by the program and by nothing else */
  KERF_MOVING = 2,    /* dynamic: moved by contacts */
  KERF_SENSOR = 3     /* notices objects of every kind; its pairs are flagged */
};

/* Whose overlap makes a pair; they differ only for objects with a margin. */
enum kerf_pairs_of {
  KERF_PAIRS_OF_FAT_BOXES = 0,  /* pairs begin before the boxes touch and end after they part */
  KERF_PAIRS_OF_EXACT_BOXES = 1 /* pairs of the boxes as given */
};

enum kerf_pair_flag { KERF_PAIR_OF_SENSOR = 1 }; /* flag of a pair: one of both is a sensor, or both are */

typedef struct kerf_world_options {
  uint32_t size;
  uint32_t pairs_of;  /* KERF_PAIRS_OF_FAT_BOXES */
  uint32_t threads;   /* that may share a step, if that is faster; at most 256; 1. Never part of a result. */
  uint32_t tag;       /* 0 to 255. Handles of worlds with different tags are never mistaken for each other. */
  const char* config; /* "NAME=VALUE,...": changes to the tuned tree (core/base/config.h); or NULL */
} kerf_world_options;

/* Everything of an object but its box. */
typedef struct kerf_object {
  uint32_t size;
  uint32_t kind;      /* KERF_MOVING */
  uint64_t category;  /* 1 */
  uint64_t mask;      /* all bits. A pair needs a bit of each one's category in the other's mask ... */
  uint64_t user_data; /* 0; the world only keeps it */
  int32_t group; /* 0. ... unless both have one group other than 0: a pair if positive, none if negative. */
  float margin;  /* 0. In units of length, on each side; a fat box is made anew when the box leaves it. */
} kerf_object;

/* A pair of a report. a is the object with the smaller index. */
typedef struct kerf_pair {
  kerf_handle a;
  kerf_handle b;
  uint32_t flags;
  uint32_t reserved;
} kerf_pair;

/* How a call ended, as a sentence, good or bad; one that is too long ends with " ...". Give NULL if only the
 * status matters. */
typedef struct kerf_error {
  uint32_t size;
  kerf_status status;
  char text[248];
} kerf_error;

/* "0.2.0" */
KERF_API const char* kerf_version(void);
/* A sentence for any number. */
KERF_API const char* kerf_status_text(kerf_status status);

/* Set defaults. size: sizeof of the struct. */
KERF_API kerf_status kerf_world_options_init(kerf_world_options* options, size_t size);
KERF_API kerf_status kerf_object_init(kerf_object* object, size_t size);
KERF_API kerf_status kerf_error_init(kerf_error* error, size_t size);

/* dimension: 2 or 3. options: NULL for the defaults. */
KERF_API kerf_status kerf_world_create(uint32_t dimension, const kerf_world_options* options,
                                       kerf_world** world, kerf_error* error);
/* NULL is taken. Never call it in a callback. */
KERF_API void kerf_world_destroy(kerf_world* world);

/* objects: NULL for the defaults, or object_count of them: one for all boxes, or one for each. handles gets
 * one for each box, 0 for those that failed. KERF_CLAMPED, KERF_BAD_BOX, KERF_BAD_VALUE, KERF_FULL. */
KERF_API kerf_status kerf_world_insert(kerf_world* world, const float* boxes, const kerf_object* objects,
                                       size_t object_count, size_t count, kerf_handle* handles,
                                       kerf_status* statuses);
/* In order; the last move of an object counts. KERF_CLAMPED, KERF_STALE_HANDLE, KERF_BAD_BOX. */
KERF_API kerf_status kerf_world_move(kerf_world* world, const kerf_handle* handles, const float* boxes,
                                     size_t count, kerf_status* statuses);
/* Moves every object by a vector of as many floats as dimensions, for a floating origin; all or none. */
KERF_API kerf_status kerf_world_shift_origin(kerf_world* world, const float* by);
/* The handles are stale at once. Pairs of the last step are reported as ended in the next one, with these
 * handles. KERF_STALE_HANDLE. */
KERF_API kerf_status kerf_world_remove(kerf_world* world, const kerf_handle* handles, size_t count,
                                       kerf_status* statuses);
/* KERF_STALE_HANDLE; of a kind and a margin also KERF_BAD_VALUE. */
KERF_API kerf_status kerf_world_set_kind(kerf_world* world, kerf_handle handle, uint32_t kind);
KERF_API kerf_status kerf_world_set_filter(kerf_world* world, kerf_handle handle, uint64_t category,
                                           uint64_t mask, int32_t group);
KERF_API kerf_status kerf_world_set_user_data(kerf_world* world, kerf_handle handle, uint64_t user_data);
KERF_API kerf_status kerf_world_set_margin(kerf_world* world, kerf_handle handle, float margin);

/* Asked in each step about each pair that kinds and filters allow, in the order of the report, on the thread
 * of kerf_world_step; a result other than 0 reports the pair. A callback of NULL: no pair is asked about. */
typedef int (*kerf_pair_callback)(void* context, const kerf_pair* pair);
KERF_API kerf_status kerf_world_set_callback(kerf_world* world, kerf_pair_callback callback, void* context);
/* KERF_BAD_OPTION for 0 and for more than 256. */
KERF_API kerf_status kerf_world_set_threads(kerf_world* world, uint32_t threads);

/* Meets all requests and makes the reports. */
KERF_API kerf_status kerf_world_step(kerf_world* world);
/* All pairs of the last step; those that the one before did not have; those that only the one before had.
 * Ordered by the indices of the handles. Valid until the next step or restore. */
KERF_API kerf_status kerf_world_pairs(const kerf_world* world, const kerf_pair** pairs, size_t* count);
KERF_API kerf_status kerf_world_begun(const kerf_world* world, const kerf_pair** pairs, size_t* count);
KERF_API kerf_status kerf_world_ended(const kerf_world* world, const kerf_pair** pairs, size_t* count);

KERF_API uint32_t kerf_world_dimension(const kerf_world* world); /* 2 or 3; 0 for NULL */
KERF_API size_t kerf_world_size(const kerf_world* world);        /* how many objects there are; 0 for NULL */
KERF_API size_t kerf_world_bound(const kerf_world* world);       /* above each handle's index; 0 for NULL */
/* For arrays of the caller's, one element an object: indices are dense, and used again; one that a step has
 * seen, only after the next step: read the pairs that ended before you insert. */
KERF_API uint32_t kerf_handle_index(kerf_handle handle);
/* KERF_OK or KERF_STALE_HANDLE. */
KERF_API kerf_status kerf_world_contains(const kerf_world* world, kerf_handle handle);
/* The size of object must be set. */
KERF_API kerf_status kerf_world_get_object(const kerf_world* world, kerf_handle handle, kerf_object* object);
/* 2 * dimension floats: the box as it was given last, or clamped; the fat box, which has its margin. */
KERF_API kerf_status kerf_world_get_box(const kerf_world* world, kerf_handle handle, float* box);
KERF_API kerf_status kerf_world_get_fat_box(const kerf_world* world, kerf_handle handle, float* box);
/* All handles, by index. capacity: of handles. count gets how many there are. */
KERF_API kerf_status kerf_world_get_handles(const kerf_world* world, kerf_handle* handles, size_t capacity,
                                            size_t* count);

/* The world as bytes with a version and a checksum, without callback and threads. size gets how many there
 * are; with a capacity of 0, nothing else is done. KERF_UNSTEPPED between a request and the next step. */
KERF_API kerf_status kerf_world_save(const kerf_world* world, void* bytes, size_t capacity, size_t* size);
/* Becomes the world that was saved, and goes on exactly as it. Bytes that no world wrote are refused. */
KERF_API kerf_status kerf_world_restore(kerf_world* world, const void* bytes, size_t size, kerf_error* error);

#ifdef __cplusplus
}
#endif

#include <kerf_queries.h>
/* NOLINTEND(readability-identifier-naming,modernize-*) */
#endif
