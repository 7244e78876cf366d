#include "frames/report/volumes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/random.h"
#include "core/bsp/bsp.h"
#include "core/scene/bounding.h"
#include "frames/report/figures.h"
#include "frames/rivals/step_timer.h"
#include "sims3d/geoms.h"

namespace kerf {
namespace {

/// The bricks' share of the world's volume, as of boxes poured into a container.
constexpr double kDensity = 0.6;

template <int D>
struct PosedBrick {
  Brick<D> brick;
  PrecisePose<D> pose;
};

void turn(PrecisePose<2>& pose, Random& random) {
  const double angle = random.uniform(0, 3.14159265358979);
  pose.axes = {{{std::cos(angle), std::sin(angle)}, {-std::sin(angle), std::cos(angle)}}};
}

/// A uniform rotation (Shoemake 1992, by rejection).
void turn(PrecisePose<3>& pose, Random& random) {
  std::array<double, 4> q;
  double size = 0;
  do {
    size = 0;
    for (double& x : q) {
      x = random.uniform(-1, 1);
      size += x * x;
    }
  } while (size > 1 || size < 1e-3);
  for (double& x : q) x /= std::sqrt(size);
  const auto [w, x, y, z] = q;
  pose.axes = {{{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
                {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
                {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}}};
}

template <int D>
std::vector<PosedBrick<D>> scatter(std::uint32_t count, double slenderness, Random& random) {
  const double thickness = std::pow(slenderness, -1.0 / D);
  const double world = std::pow(count / kDensity, 1.0 / D);
  std::vector<PosedBrick<D>> bricks(count);
  for (PosedBrick<D>& b : bricks) {
    for (int i = 0; i < D; ++i)
      b.brick.half[i] = static_cast<Scalar>(thickness * (i == 0 ? slenderness : 1) / 2);
    for (double& x : b.pose.position) x = random.uniform(0, world);
    turn(b.pose, random);
  }
  return bricks;
}

/// Whether the projections of both on an axis of one of them are apart.
bool apart_along(const std::array<double, 2>& axis, const PosedBrick<2>& a, const PosedBrick<2>& b) {
  double distance = 0;
  double reach = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    distance += axis[i] * (b.pose.position[i] - a.pose.position[i]);
    for (const PosedBrick<2>* brick : {&a, &b}) {
      const std::array<double, 2>& own = brick->pose.axes[i];
      reach +=
          static_cast<double>(brick->brick.half.value[i]) * std::abs(own[0] * axis[0] + own[1] * axis[1]);
    }
  }
  return std::abs(distance) > reach;
}

/// The truth in 2D.
class NarrowPhase2 {
 public:
  explicit NarrowPhase2(const std::vector<PosedBrick<2>>& bricks) : bricks_(bricks) {}
  [[nodiscard]] bool touch(std::uint32_t i, std::uint32_t j) const {
    const PosedBrick<2>& a = bricks_[i];
    const PosedBrick<2>& b = bricks_[j];
    return !apart_along(a.pose.axes[0], a, b) && !apart_along(a.pose.axes[1], a, b) &&
           !apart_along(b.pose.axes[0], a, b) && !apart_along(b.pose.axes[1], a, b);
  }

 private:
  const std::vector<PosedBrick<2>>& bricks_;
};

/// The truth in 3D: ODE's collider of boxes.
class NarrowPhase3 {
 public:
  explicit NarrowPhase3(const std::vector<PosedBrick<3>>& bricks) {
    const auto lock = library_.enter();
    for (const PosedBrick<3>& b : bricks) {
      geoms_.push_back(make_geom(b.brick));
      const auto& p = b.pose.position;
      const auto& u = b.pose.axes;
      dMatrix3 rotation{u[0][0], u[1][0], u[2][0], 0,       u[0][1], u[1][1],
                        u[2][1], 0,       u[0][2], u[1][2], u[2][2], 0};
      dGeomSetPosition(geoms_.back().geom.get(), p[0], p[1], p[2]);
      dGeomSetRotation(geoms_.back().geom.get(), rotation);
    }
  }
  [[nodiscard]] bool touch(std::uint32_t i, std::uint32_t j) const {
    const auto lock = library_.enter();
    dContactGeom contact;
    return dCollide(geoms_[i].geom.get(), geoms_[j].geom.get(), 1, &contact, sizeof contact) > 0;
  }

 private:
  OdeLibrary library_;  // first: the geoms end before it does
  std::vector<Geom> geoms_;
};

template <int D>
using NarrowPhaseOf = std::conditional_t<D == 2, NarrowPhase2, NarrowPhase3>;

/// All contacts, in order. The bricks' bounding spheres decide which pairs to test; nothing of ours does.
template <int D>
std::vector<Pair> find_contacts(const std::vector<PosedBrick<D>>& bricks) {
  const NarrowPhaseOf<D> narrow_phase(bricks);
  double diagonal2 = 0;
  for (const Scalar h : bricks.front().brick.half.value)
    diagonal2 += 4 * static_cast<double>(h) * static_cast<double>(h);
  std::vector<Pair> contacts;
  for (std::uint32_t i = 0; i < bricks.size(); ++i) {
    for (std::uint32_t j = i + 1; j < bricks.size(); ++j) {
      double apart2 = 0;
      for (std::size_t k = 0; k < D; ++k) {
        const double apart = bricks[i].pose.position[k] - bricks[j].pose.position[k];
        apart2 += apart * apart;
      }
      if (apart2 <= diagonal2 * 1.001 && narrow_phase.touch(i, j)) contacts.push_back({{i}, {j}});
    }
  }
  return contacts;
}

/// Each brick drifts by up to a twentieth of its volume's side and turns by up to 0.05 about one of its axes.
template <int D>
void stir(std::vector<PosedBrick<D>>& bricks, Random& random) {
  constexpr double kDrift = 0.05;
  constexpr double kTurn = 0.05;
  for (PosedBrick<D>& b : bricks) {
    for (double& x : b.pose.position) x += random.uniform(-kDrift, kDrift);
    const std::size_t first = D == 2 ? 0 : random.below(D);
    const double angle = random.uniform(-kTurn, kTurn);
    auto& u = b.pose.axes[first];
    auto& v = b.pose.axes[(first + 1) % D];
    for (std::size_t i = 0; i < D; ++i) {
      const double along = u[i];
      u[i] = std::cos(angle) * along + std::sin(angle) * v[i];
      v[i] = std::cos(angle) * v[i] - std::sin(angle) * along;
    }
  }
}

template <int D>
std::vector<Volume<D>> bound_all(const std::vector<PosedBrick<D>>& bricks, VolumeKind kind) {
  std::vector<Volume<D>> volumes;
  for (const PosedBrick<D>& b : bricks) volumes.push_back(bound<D>(kind, b.brick, b.pose));
  return volumes;
}

/// The times of steps, in all rounds.
struct Clocks {
  StepTimes bounding;
  StepTimes tree;
};

/// A tree of one kind of volume around the bricks.
template <int D>
class Subject {
 public:
  Subject(const std::vector<PosedBrick<D>>& bricks, VolumeKind kind) : kind_(kind), bsp_({}, kind) {
    constexpr int kGrowingSteps = 200;  // until the tree has its final depth
    const std::vector<Volume<D>> volumes = bound_all(bricks, kind);
    for (std::uint32_t k = 0; k < volumes.size(); ++k)
      static_cast<void>(bsp_.insert({k}, volumes[k], Mobility::moving));
    for (int step = 0; step < kGrowingSteps; ++step) bsp_.step();
  }

  void step(const std::vector<PosedBrick<D>>& bricks, Clocks& clocks) {
    const StepTimer bounding(true);
    const std::vector<Volume<D>> volumes = bound_all(bricks, kind_);
    clocks.bounding.add(static_cast<double>(bounding.nanoseconds()));
    const StepTimer tree(true);
    for (std::uint32_t k = 0; k < volumes.size(); ++k) static_cast<void>(bsp_.move({k}, volumes[k]));
    bsp_.step();
    clocks.tree.add(static_cast<double>(tree.nanoseconds()));
  }

  /// Of the last step.
  void count(const std::vector<Pair>& contacts, VolumeFigure& figure) const {
    figure.candidates = bsp_.pairs().size();
    figure.contacts = contacts.size();
    std::vector<Pair> candidates(bsp_.pairs().begin(), bsp_.pairs().end());
    std::sort(candidates.begin(), candidates.end());
    for (const Pair& contact : contacts)
      if (!std::binary_search(candidates.begin(), candidates.end(), contact)) ++figure.missed;
  }

 private:
  VolumeKind kind_;
  Bsp<D> bsp_;
};

void note_times(const Clocks& clocks, double bricks, VolumeFigure& figure) {
  const Times tree = clocks.tree.over(bricks);
  figure.bound_ns = clocks.bounding.over(bricks).mean;
  figure.mean_ns = tree.mean;
  figure.median_ns = tree.median;
  figure.p99_ns = tree.p99;
  figure.max_ns = tree.max;
  figure.low_ns = tree.round_low;
  figure.high_ns = tree.round_high;
}

template <int D>
VolumeFigure measure(const std::vector<PosedBrick<D>>& start, double slenderness, VolumeKind kind,
                     std::vector<Pair>& contacts, const std::function<void()>& poll) {
  constexpr int kTimedSteps = 20;
  constexpr int kRounds = 3;
  Clocks clocks;
  VolumeFigure figure{.dimension = D, .slenderness = slenderness, .kind = kind};
  for (int round = 0; round < kRounds; ++round) {
    auto bricks = start;
    Random stirring(18);
    Subject<D> subject(bricks, kind);
    clocks.bounding.restart();
    clocks.tree.restart();
    for (int step = 0; step < kTimedSteps; ++step) {
      if (poll) poll();
      stir(bricks, stirring);
      subject.step(bricks, clocks);
    }
    if (round > 0) continue;
    if (contacts.empty()) contacts = find_contacts<D>(bricks);
    subject.count(contacts, figure);
  }
  note_times(clocks, static_cast<double>(start.size()), figure);
  return figure;
}

template <int D>
std::vector<VolumeFigure> measure_all(double slenderness, std::uint32_t count,
                                      const std::function<void()>& poll) {
  Random random(17);
  const auto bricks = scatter<D>(count, slenderness, random);
  std::vector<Pair> contacts;  // at the end of the motion, which is the same for all kinds
  std::vector<VolumeFigure> figures;
  for (const VolumeKind kind : volume_kinds<D>())
    figures.push_back(measure(bricks, slenderness, kind, contacts, poll));
  return figures;
}

}  // namespace

std::vector<double> slendernesses() { return {1, 4, 16}; }

std::vector<VolumeFigure> measure_volumes(int dimension, double slenderness, std::uint32_t bricks,
                                          const std::function<void()>& poll) {
  return dimension == 2 ? measure_all<2>(slenderness, bricks, poll)
                        : measure_all<3>(slenderness, bricks, poll);
}

}  // namespace kerf
