#include "core/c/kerf.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "core/c/call.h"

namespace kerf::c {
namespace {

constexpr kerf_world_options kDefaults{0, KERF_PAIRS_OF_FAT_BOXES, 1, 0, nullptr};

constexpr std::string_view kMore = " ...";

/// How much of a text fits before `kMore`: whole words, if there is a blank.
std::size_t shortened(std::string_view text, std::size_t room) {
  const std::size_t most = room - kMore.size();
  return std::min(text.rfind(' ', most), most);
}

/// How a call ended: `why`, or what the status means.
kerf_status tell(kerf_error* error, kerf_status status, std::string_view why) {
  if (error == nullptr || error->size < kLeastError || error->size > kMostSize) return status;
  const std::string_view text = why.empty() ? kerf_status_text(status) : why;
  error->status = status;
  const std::size_t room =
      std::min<std::size_t>(error->size - offsetof(kerf_error, text), sizeof error->text);
  const bool fits = text.size() < room;
  const std::size_t length = fits ? text.size() : shortened(text, room - 1);
  const std::string_view end = fits ? "" : kMore;
  std::memcpy(error->text, text.data(), length);
  std::memcpy(error->text + length, end.data(), end.size());
  error->text[length + end.size()] = '\0';
  return status;
}

/// Why options of this size are none; empty if that is for the status to say.
std::string why_too_large(std::uint32_t size) {
  if (size <= kMostSize) return {};
  return "the size of kerf_world_options is " + std::to_string(size) + ", but this version's is " +
         std::to_string(sizeof(kerf_world_options)) + " and none is above " + std::to_string(kMostSize) +
         ": use kerf_world_options_init";
}

WorldOptions to_options(const kerf_world_options& given) {
  WorldOptions options;
  if (given.config != nullptr) apply(options.config, given.config);
  if (given.pairs_of > KERF_PAIRS_OF_EXACT_BOXES) throw std::invalid_argument("pairs_of is none of the list");
  if (given.tag > UINT8_MAX) throw std::invalid_argument("tag is above 255");
  options.pairs_of = static_cast<PairsOf>(given.pairs_of);
  options.tag = static_cast<std::uint8_t>(given.tag);
  options.threads = given.threads;
  return options;
}

kerf_status create(std::uint32_t dimension, const WorldOptions& options, kerf_world** world) {
  if (dimension == 2) {
    *world = new kerf_world{World<2>(options), WorldIndex<2>(), false, {}, {}};
  } else if (dimension == 3) {
    *world = new kerf_world{World<3>(options), WorldIndex<3>(), false, {}, {}};
  } else {
    throw std::invalid_argument("dimension is neither 2 nor 3");
  }
  return KERF_OK;
}

}  // namespace
}  // namespace kerf::c

using kerf::c::change_world;
using kerf::c::guarded;
using kerf::c::is_missing;
using kerf::c::kDefaults;
using kerf::c::tell;
using kerf::c::with_world;

const char* kerf_version() { return KERF_VERSION_TEXT; }

const char* kerf_status_text(kerf_status status) {
  switch (status) {
    case KERF_NULL_ARGUMENT:
      return "an argument is NULL that must not be";
    case KERF_BAD_SIZE:
      return "a struct's size is not set, or a reserved member, or one that this version does not know, is "
             "not 0: use its init function";
    case KERF_BAD_OPTION:
      return "an option cannot work: kerf_error, where the call takes one, says which";
    case KERF_SMALL_BUFFER:
      return "the memory for the result is too small: the size that is needed was written";
    case KERF_BUSY:
      return "a callback must not change the world that called it";
    case KERF_OUT_OF_MEMORY:
      return "there is no more memory";
    case KERF_INTERNAL_ERROR:
      return "a fault of Kerf's: please report it";
    case KERF_CALLBACK_THREW:
      return "a callback threw an exception, which ended in Kerf: it must return";
    case KERF_BAD_QUERY:
      return "a query with NaN, an infinite place, a minimum above its maximum, or a negative length";
    default:
      break;
  }
  if (status < 0 || status > KERF_DAMAGED) return "no status of Kerf's";
  return kerf::to_string(static_cast<kerf::WorldStatus>(status)).data();
}

kerf_status kerf_world_options_init(kerf_world_options* options, size_t size) {
  if (options == nullptr) return KERF_NULL_ARGUMENT;
  return kerf::c::write_struct(kDefaults, size, kerf::c::kLeastOptions, options);
}

kerf_status kerf_object_init(kerf_object* object, size_t size) {
  if (object == nullptr) return KERF_NULL_ARGUMENT;
  return kerf::c::write_struct(kerf::c::to_object({}), size, kerf::c::kLeastObject, object);
}

kerf_status kerf_error_init(kerf_error* error, size_t size) {
  if (error == nullptr) return KERF_NULL_ARGUMENT;
  return kerf::c::write_struct(kerf_error{}, size, kerf::c::kLeastError, error);
}

kerf_status kerf_world_create(uint32_t dimension, const kerf_world_options* options, kerf_world** world,
                              kerf_error* error) {
  if (world == nullptr) return tell(error, KERF_NULL_ARGUMENT, {});
  *world = nullptr;
  std::string why;
  const kerf_status created = guarded([&]() -> kerf_status {
    kerf_world_options given = kDefaults;
    if (options != nullptr) {
      const kerf_status status = kerf::c::read_struct(options, kerf::c::kLeastOptions, given);
      if (status == KERF_BAD_SIZE) why = kerf::c::why_too_large(options->size);
      if (status != KERF_OK) return status;
    }
    try {
      return kerf::c::create(dimension, kerf::c::to_options(given), world);
    } catch (const std::invalid_argument& wrong) {
      why = wrong.what();
      return KERF_BAD_OPTION;
    }
  });
  return tell(error, created, why);
}

void kerf_world_destroy(kerf_world* world) { delete world; }

kerf_status kerf_world_save(const kerf_world* world, void* bytes, size_t capacity, size_t* size) {
  if (size == nullptr || is_missing(bytes, capacity)) return KERF_NULL_ARGUMENT;
  return with_world(world, [=](const auto& body) -> kerf_status {
    std::vector<std::uint8_t> saved;
    if (const kerf::WorldStatus status = body.save(saved); is_failure(status)) return kerf::c::to_c(status);
    *size = saved.size();
    if (capacity < saved.size()) return capacity == 0 ? KERF_OK : KERF_SMALL_BUFFER;
    std::memcpy(bytes, saved.data(), saved.size());
    return KERF_OK;
  });
}

kerf_status kerf_world_restore(kerf_world* world, const void* bytes, size_t size, kerf_error* error) {
  if (is_missing(bytes, size)) return tell(error, KERF_NULL_ARGUMENT, {});
  std::string why;
  const kerf_status restored = change_world(world, [&](auto& body) {
    const std::span<const std::uint8_t> view(static_cast<const std::uint8_t*>(bytes), size);
    return kerf::c::to_c(body.restore(view, &why));
  });
  return tell(error, restored, why);
}
