#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/query/search.h"
#include "core/replay/cursor.h"
#include "frames/python/recording.h"
#include "frames/python/use_once.h"

namespace kerf::python {

/// `kerf.Recording` of one dimension.
template <int D>
class RecordingOf final : public PythonRecording {
 public:
  explicit RecordingOf(const std::filesystem::path& path);

  [[nodiscard]] int dimension() const override { return D; }
  [[nodiscard]] std::filesystem::path path() const override { return path_; }
  [[nodiscard]] std::uint32_t steps() const override { return reader_->steps(); }
  [[nodiscard]] const RecordingInfo& info() const override { return reader_->info(); }
  [[nodiscard]] pybind11::array rows() const override;
  [[nodiscard]] pybind11::array events(std::uint32_t first, std::uint32_t last) override;
  [[nodiscard]] pybind11::array pairs(std::uint32_t step) override;
  [[nodiscard]] pybind11::array their_pairs(std::uint32_t step) override;
  [[nodiscard]] pybind11::array ids(std::uint32_t step) override;
  [[nodiscard]] pybind11::array boxes(std::uint32_t step) override;
  [[nodiscard]] pybind11::array fixed(std::uint32_t step) override;
  [[nodiscard]] std::string describe(std::uint64_t event) override;

  [[nodiscard]] std::optional<Position> find(const std::string& condition, const Position& from,
                                             bool backward) override;
  [[nodiscard]] pybind11::array values(const std::string& text) override;
  [[nodiscard]] PairWhy why(std::uint32_t a, std::uint32_t b, std::uint32_t step) override;
  [[nodiscard]] std::string why_event(std::uint64_t event) override;
  [[nodiscard]] std::string why_node(std::uint32_t node, std::uint32_t step) override;
  void what_if(const WhatIf& change, const std::filesystem::path& out, bool overwrite) override;
  void minimize(const StillHolds& holds, std::uint32_t last, const std::filesystem::path& out,
                bool overwrite) override;
  [[nodiscard]] RecordingComparison compare(PythonRecording& other) override;
  [[nodiscard]] pybind11::array picture(const Position& at, const PictureOptions& options) override;
  [[nodiscard]] Position position_of(std::uint64_t event) const override;

 private:
  [[nodiscard]] const ObjectTable<D>& objects_at(std::uint32_t step);
  [[nodiscard]] std::vector<ObjectId> ids_at(std::uint32_t step);
  void check_step(std::uint32_t step) const;
  template <class Work>
  auto undisturbed(Work work);

  std::filesystem::path path_;
  std::shared_ptr<RecordingReader<D>> reader_;
  std::optional<Replayer<D>> replayer_;  ///< none: not needed so far
  std::optional<Search<D>> search_;
  bool in_use_ = false;
};

}  // namespace kerf::python
