#pragma once

#include <cstdint>
#include <memory>

#include "frames/bench/motion.h"

namespace kerf {

/// Random walk by up to 0.75 of a usual extent along each axis and step: no step resembles the next.
template <int D>
std::unique_ptr<Motion<D>> make_brownian(std::uint32_t count, std::uint64_t seed);
/// The same for 20 steps, then all rest for 40, alternately.
template <int D>
std::unique_ptr<Motion<D>> make_pauses(std::uint32_t count, std::uint64_t seed);
/// Straight flight by 0.75 of a usual extent a step, bouncing off the walls of the world.
template <int D>
std::unique_ptr<Motion<D>> make_uniform(std::uint32_t count, std::uint64_t seed);
/// Everything is somewhere else in each step.
template <int D>
std::unique_ptr<Motion<D>> make_teleport(std::uint32_t count, std::uint64_t seed);

/// Eight wandering attractors; everything starts scattered, collapses into swirling clouds of Gaussian
/// density and sometimes changes its attractor. About 4 pairs an object on average, more in the hearts of
/// clouds.
template <int D>
std::unique_ptr<Motion<D>> make_attractors(std::uint32_t count, std::uint64_t seed);

/// A third of the objects falls onto heaps, which trickle down where they are steep. For each object that
/// lands, one is taken from the top and falls again.
template <int D>
std::unique_ptr<Motion<D>> make_falling(std::uint32_t count, std::uint64_t seed);
/// A pile four times as wide as high. Every object stirs by a small part of its size in each step, and one in
/// two thousand slides.
template <int D>
std::unique_ptr<Motion<D>> make_settled(std::uint32_t count, std::uint64_t seed);
/// Four buckets along each horizontal axis, with fixed walls and floors, into which a quarter of the objects
/// falls.
template <int D>
std::unique_ptr<Motion<D>> make_buckets(std::uint32_t count, std::uint64_t seed);

/// One in twenty walks, by up to 0.3 of a usual extent, the others rest; the walkers change slowly. Resting
/// objects are not fixed: their pairs belong to the complete set.
template <int D>
std::unique_ptr<Motion<D>> make_mostly_static(std::uint32_t count, std::uint64_t seed);
/// Mostly static, but the origin is moved by the world's diagonal, there or back, in every tenth step.
template <int D>
std::unique_ptr<Motion<D>> make_shifts(std::uint32_t count, std::uint64_t seed);

/// Needles of length 1 to 8, nearly diagonal, that fly lengthwise and turn. Their boxes are large and differ
/// much in size.
template <int D>
std::unique_ptr<Motion<D>> make_needles(std::uint32_t count, std::uint64_t seed);

/// Straight flight on a plane of the world (in 2D along a line) on which all objects stand: the last axis
/// separates nothing.
template <int D>
std::unique_ptr<Motion<D>> make_flat(std::uint32_t count, std::uint64_t seed);
/// Straight flight at a density of some fifty pairs an object.
template <int D>
std::unique_ptr<Motion<D>> make_dense(std::uint32_t count, std::uint64_t seed);
/// Rods sixty times as long as thick, each along an axis, that fly by most of their thickness in each step.
template <int D>
std::unique_ptr<Motion<D>> make_rods(std::uint32_t count, std::uint64_t seed);

}  // namespace kerf
