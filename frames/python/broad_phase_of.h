#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/broad_phase/pair_changes.h"
#include "frames/python/broad_phase.h"
#include "frames/python/id_pool.h"
#include "frames/python/pair_lists.h"
#include "frames/python/queries_of.h"
#include "frames/python/run.h"

namespace kerf::python {

/// `kerf.BroadPhase` of one dimension.
template <int D>
class BroadPhaseOf final : public PythonBroadPhase {
 public:
  explicit BroadPhaseOf(const BroadPhaseOptions& options);
  ~BroadPhaseOf() override;
  BroadPhaseOf(const BroadPhaseOf&) = delete;
  BroadPhaseOf& operator=(const BroadPhaseOf&) = delete;

  [[nodiscard]] int dimension() const override { return D; }
  pybind11::array insert(const pybind11::handle& boxes, const pybind11::handle& ids,
                         const pybind11::handle& fixed) override;
  void move(const pybind11::handle& boxes, const pybind11::handle& ids) override;
  void remove(const pybind11::handle& ids) override;
  pybind11::array step(const pybind11::handle& boxes) override;

  [[nodiscard]] pybind11::array pairs() override;
  [[nodiscard]] pybind11::array begun() const override;
  [[nodiscard]] pybind11::array ended() const override;
  [[nodiscard]] pybind11::array ids() const override;
  [[nodiscard]] pybind11::array boxes() const override;
  [[nodiscard]] pybind11::array fixed() const override;
  [[nodiscard]] std::size_t size() const override { return ids_.size(); }
  [[nodiscard]] std::uint32_t steps() const override { return run_.steps(); }
  [[nodiscard]] pybind11::dict statistics() const override;
  [[nodiscard]] const Config& config() const override { return config_; }
  [[nodiscard]] pybind11::object ask(const Question& question) override;
  [[nodiscard]] pybind11::array picture(const PictureOptions& options) const override;
  void close() override;

 private:
  [[nodiscard]] std::vector<ObjectId> new_ids(const pybind11::handle& given, std::size_t rows) const;
  [[nodiscard]] std::vector<ObjectId> present_ids(const pybind11::handle& given, std::size_t rows) const;
  [[nodiscard]] const PairChanges& changes() const;

  Config config_;
  Run<D> run_;
  IdPool ids_;
  std::optional<PairChanges> changes_;  ///< none: they were not asked for
  unsigned threads_;
  std::unique_ptr<QueriesOf<D>> queries_;  ///< null: nothing was asked so far
  bool moved_ = true;                      ///< the queries do not know all boxes
  AppendBuffer<Box<D>> rounded_;           ///< the boxes of a move
  PairLists lists_;
  pybind11::object pairs_;  ///< the latest list, as an array; null until it is asked for
  mutable bool in_use_ = false;
};

}  // namespace kerf::python
