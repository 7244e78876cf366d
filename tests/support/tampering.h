#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/random.h"
#include "core/bsp/bsp_state.h"

namespace kerf::test {

/// A value in an SQLite file: a column of the n-th row of a table.
struct StoredValue {
  std::string table;
  std::string column;
  std::uint32_t row = 0;
};

std::string to_string(const StoredValue& value);

/// All tables of the file, and how many rows each has.
std::vector<std::string> tables_of(const std::filesystem::path& file);
std::vector<std::string> columns_of(const std::filesystem::path& file, const std::string& table);
std::uint32_t rows_of(const std::filesystem::path& file, const std::string& table);

/// Gives it another value of its type: one bit or letter is another one; what was NULL is a number.
void change_value(const std::filesystem::path& file, const StoredValue& value, Random& random);

/// Makes all hashes of a recording right again, as a forger would: earlier changes are then found only in the
/// data itself. Throws std::runtime_error where its rows do not fit together.
void reseal(const std::filesystem::path& recording);

/// Puts other bytes in place of a block or a keyframe and reseals.
void forge_block(const std::filesystem::path& recording, std::uint32_t first_step, const Bytes& data);
void forge_keyframe(const std::filesystem::path& recording, std::uint32_t step, const Bytes& data);
/// Likewise for how its objects look.
void forge_keyframe_looks(const std::filesystem::path& recording, std::uint32_t step, const Bytes& looks);
/// The same with a state that was changed.
template <int D>
void forge_keyframe(const std::filesystem::path& recording, std::uint32_t step,
                    const std::function<void(BspState<D>&)>& change);

/// A block in place of the recording's first one, in the first step of which one object is inserted, with
/// this number.
template <int D>
Bytes first_block_with_object(const std::filesystem::path& recording, std::uint32_t number);

}  // namespace kerf::test
