#pragma once

#include <cstddef>
#include <cstdint>

namespace kerf::tuning {

// The numbers that are no parameters of `Config`, each beside what it was measured on; those of the sweep by
// bytes are in core/kernels/sweep_tuning.h. This header lies at the bottom, since objects, kernels and tree
// use it as bsp does. "ns" are nanoseconds an object and step; docs/notes and docs/SPEED.md have the tables.
// None of these numbers decides which pairs are reported: a bad one costs time.

// Skins: how thick, and for how long.

/// Thickness levels above the thinnest skin; each is twice as thick as the one below.
inline constexpr std::uint8_t kThickestSkin = 6;
/// Thickness of the thickest skin over the object's second largest extent. Settled pile, 3D: a quarter gives
/// 8.5 candidates a pair and 75 ns, an eighth 46 ns.
inline constexpr float kMostSkin = 1.0F / 8;
/// An object that leaves its fat box within so many steps gets a thicker skin, and one that stays for more
/// than `kLateLeave` steps a thinner one. Settled, falling, and the scenes that hop, shake and drift.
inline constexpr std::uint16_t kSoonLeave = 12;
inline constexpr std::uint16_t kLateLeave = 200;
/// Steps that an object stays in the fat box of a flight before it gets a smaller one: two look-ups in so
/// many steps do not show in any scene.
inline constexpr std::uint32_t kRestSteps = 1024;
/// An object that leaves soon after it got the smaller one doubles that wait, so many times at most.
inline constexpr std::uint8_t kMostWraps = 5;
/// Steps from one look at an object that may rest to the next. Scene `pauses` (flies for 20 steps, rests for
/// 40), 16,000 objects: 16.3 -> 8.7 ns in 2D, 24.2 -> 14.2 in 3D.
inline constexpr std::uint32_t kLookSteps = 64;
/// Slow steps until a restless object is no longer one. Scene `pauses`.
inline constexpr std::uint8_t kRestlessSteps = 8;
/// The least share of the way ahead that a fat box gets. With equal shares all objects that move alike leave
/// in the same step, which then takes ten times the others' time (drifting crowd, 4,250 objects).
inline constexpr float kLeastShareAhead = 1.0F / 3;
/// A fat box whose margin exceeds the thickest skin by this factor was made for a flight: room for rounding.
inline constexpr float kFlightMargin = 1.05F;

// Rows of bits, in worlds of one leaf.

/// The most objects (ids) that have rows: of more, a row of bits each takes too much memory.
inline constexpr std::size_t kMostRows = 512;
/// Comparisons of a step up to which rows are faster than the sweep of the leaf: boxes that are given times
/// those that are there. All 64 of a world move far: 2.2 -> 1.4 us a step in 2D.
inline constexpr std::uint64_t kRowTests = 4096;
/// The same beside kept pairs. One of 154 moves slowly: 990 -> 180 ns a step in 2D; all of 32 do: 380 ns with
/// kept pairs, 550 with rows.
inline constexpr std::uint64_t kFewTests = 1024;
/// Steps in a row that end keeping.
inline constexpr std::uint32_t kRowSteps = 4;

// Worlds that most objects have left.

/// Where there are more ids for each object, the changed ones are copied one by one, and sampled instead of
/// ids. 1,000 of 300,000 are left and fly: 0.6 to 2.2 ms a step -> 0.02 to 0.2.
inline constexpr std::size_t kIdsPerCopy = 8;

// Keep pairs, or sweep leaves. The bench's nine scenes and `pauses`, 4,250 to 64,000 objects. To look one
// object up again costs some thirty times what sweeping costs for an object.

/// Objects in a sample of motions, which shows the share of fast objects to about 6 %.
inline constexpr std::uint32_t kMotionSample = 64;
/// The same where rows of bits are compared, which takes hardly longer than a large sample: 37 boxes in 2D
/// that all move, 12,900 -> 10,400 instructions a step.
inline constexpr std::uint32_t kMotionSampleInRows = 8;
/// The share of a sample that must move alike, and of all that must move, for the tree to come along.
inline constexpr float kLeastShareAlike = 0.75F;
/// The least way that they must go, over an object's size.
inline constexpr float kLeastWay = 0.9F;
/// Two motions are alike if they differ by no more than this share of an object's size, or by its size where
/// the way is so many times as long. A way that long is a shift; a shorter one may be a flow past others.
inline constexpr float kAlike = 1.0F / 8;
inline constexpr float kWayOfShift = 8;
/// Kept pairs are good for so many shifts, or as many as half of the thickest skin allows (ShiftPass).
inline constexpr float kShiftsOfSlack = 32;
/// The share of objects that leave their fat boxes in a step above which sweeping pays.
inline constexpr float kHotShare = 0.03F;
/// The same while skins learn how thick they must be, for the first `kLearningSteps`.
inline constexpr float kHopelessShare = 0.2F;
inline constexpr std::uint32_t kLearningSteps = 24;
/// Hot steps in a row that end keeping.
inline constexpr std::uint32_t kHotSteps = 3;
/// What an object costs that becomes too fast for a skin, over one that gets another fat box: it leaves once.
inline constexpr float kFastCost = 0.25F;
/// The share of fast objects below which keeping pays wherever they lie. Scene `buckets`.
inline constexpr float kFewFast = 0.08F;
/// The share of fast objects above which keeping does not pay. In 3D more of them lie in several leaves:
/// falling in 3D, a third of the objects fast, takes 57 ns with kept pairs and 43 with swept leaves (64,000
/// objects); buckets, a quarter fast, 38 and 39 (64,000), 39 and 31 (16,000).
constexpr float many_fast(int dimension) { return dimension == 2 ? 0.4F : 0.15F; }
/// The cost of a step with kept pairs, over that of sweeping, above which keeping ends: an estimate needs
/// room for its error.
inline constexpr float kCostlyKeeping = 0.85F;
/// The mean speed over size below which a step counts for keeping, and below which the first step does.
inline constexpr float kCoolSpeed = 0.01F;
inline constexpr float kMildSpeed = 0.015F;
/// Cool steps in a row that begin keeping: at first, after keeping has paid well, and at most. Each regret
/// doubles the number.
inline constexpr std::uint32_t kFirstPatience = 4;
inline constexpr std::uint32_t kShortPatience = 8;
inline constexpr std::uint32_t kLongestPatience = 512;
/// Steps after which keeping has paid (to make all fat boxes costs some five steps of sweeping), and paid
/// well.
inline constexpr std::uint32_t kPaidSteps = 24;
inline constexpr std::uint32_t kPaidWellSteps = 100;

// What a step with kept pairs costs, in the time in which one entry is swept: about 11 ns in 2D and 18 in 3D.
// Scenes falling, buckets and mostly-static, 16,000 objects.

inline constexpr float kCostOfPlacing = 0.4F;    ///< an object, when all are placed in one pass
inline constexpr float kCostOfFiltering = 0.3F;  ///< an entry of a leaf that keeps pairs
inline constexpr float kCostOfLookUp = 4;        ///< a restless entry of such a leaf
inline constexpr float kCostOfFollowing = 0.7F;  ///< a restless object that stays in its cell
inline constexpr float kCostOfWalk = 4;          ///< a walk down the tree for one
inline constexpr float kCostOfReplacing = 12;    ///< a restless object that is placed anew

// Leaves that keep pairs. Scenes falling, buckets and mostly-static, 16,000 objects.

/// Nothing is kept of a leaf of which more than one entry in so many is restless; a leaf that is swept
/// already goes on with fewer restless entries.
inline constexpr std::size_t kEntriesPerRestless = 4;
inline constexpr std::size_t kEntriesPerRestlessIfSwept = 6;
/// A leaf with fewer entries for each changed one is swept anew instead of patched.
inline constexpr std::size_t kEntriesPerPatch = 4;
/// More objects than these are taken out of a leaf in one pass over its pairs, fewer four at a time.
inline constexpr std::size_t kFewDropped = 16;
/// Resting pairs are laid out anew when more than one in so many lies out of place. Scene mostly-static:
/// copying all of them in each step was a tenth of it at 64,000 objects.
inline constexpr std::size_t kRestingPerWrong = 8;

// Operators: where a partitioner is sought, and how often.

/// Candidates that look best on a sample and are judged by all objects. Not measured alone.
inline constexpr std::size_t kConfirmed = 4;
/// A node of so many samples takes the sample's offset; in smaller ones the best offset of all objects is
/// sought. Attractors in 3D, 64,000 objects, together with cheaper departures: p99 105 -> 80 ns.
inline constexpr std::size_t kManySamples = 32;
/// Doublings of a refused leaf's wait, at first one scheduling interval. Where all objects coincide, a search
/// in each interval costs more than the sweep.
inline constexpr std::uint32_t kMostWaits = 4;
/// When there are too many entries, nodes with the largest shares of straddlers are merged first; below this
/// share all are. A heap in a fine tree, shed at once: 551 -> 41 ms a step.
inline constexpr float kLeastStraddling = 1.0F / 64;
/// Numbers from which on vectors sort. 256 ends: 8.8 us by std::sort, 1.2 by vectors.
inline constexpr std::size_t kFewToSort = 32;

// Placement.

/// While pairs are kept, all objects are placed in one pass when so many times `stream_share` leave their fat
/// boxes: leaves must then be swept anew, which need not be for a patch.
inline constexpr float kStreamFactorIfKept = 4;
/// Objects of the sample that decides whether most jump, and how many of its sizes an object must have
/// moved to count as jumping. Uniform in 2D with 64,000 objects takes 44 -> 36 ns when stayers are looked for
/// first; in teleport, where most jump, that pass finds few.
inline constexpr std::size_t kJumpSample = 64;
inline constexpr float kJumpSizes = 6;
/// Lists that are so many times too long give their memory back; a division makes them twice too long.
inline constexpr std::size_t kListExcess = 3;
/// In ordered mode a longer leaf is swept by bytes: its list may lie along an axis on which all boxes
/// coincide (HARD_CASES.md, S6).
inline constexpr std::size_t kLongList = 512;
/// Moves an entry that insertion sort may make before it gives up: lists are nearly ordered in all scenes.
inline constexpr std::size_t kMovesPerEntry = 8;
/// Leavers are looked for by their boxes if there is at most one in so many objects below a node; else all
/// entries are looked at. Scene attractors, steps that repair.
inline constexpr std::size_t kObjectsPerLeaver = 32;

// Memory and threads.

/// Lists have room for one element more in so many, and for some more. One in 8: 2 to 6 bytes an object more.
inline constexpr std::size_t kElementsPerSpare = 16;
inline constexpr std::size_t kFewSpare = 8;
/// The same for a leaf that keeps pairs, whose planes of bytes are all copied when it grows.
inline constexpr std::size_t kEntriesPerSpare = 4;
/// How many turns of a loop before its use a value at a random place is prefetched. Falling in 2D, 1,000,000
/// objects: 60 -> 44 ns; twice as far ahead gains nothing more.
inline constexpr std::size_t kPrefetchAhead = 32;
/// What a core's own cache holds beside other things, in bytes. Prefetching costs 2 to 4 % of a step at
/// 4,250 and 16,000 objects and pays from 64,000 on.
inline constexpr std::size_t kOwnCache = std::size_t{3} << 18U;
/// The size of a table whose pages the processor's address cache holds (about 1,500 of 4 KB), with some to
/// spare. Settled pile, 1,000,000 objects: gathered boxes take 53 -> 30 ns in 3D, 25 -> 16 in 2D; at 64,000
/// they gain nothing.
inline constexpr std::size_t kOwnPages = std::size_t{3} << 20U;
/// The least length of a list that threads share, of copies or comparisons, and of walks down a tree. Falling
/// in 2D, 64,000 objects, two threads: walks shared from 64 instead of 512 on, 16.7 -> 15.4 ns, together with
/// leavers taken out in parallel.
inline constexpr std::size_t kFewThings = 512;
inline constexpr std::size_t kFewWalks = 64;
/// Pieces of work for each thread. Falling in 2D, two threads: eight instead of four, 17.1 -> 16.0 ns.
inline constexpr std::size_t kPiecesPerThread = 8;

}  // namespace kerf::tuning
