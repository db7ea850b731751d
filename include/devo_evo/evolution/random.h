#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace devo_evo
{
/// What a stream of random numbers is for; part of its key, so that streams never overlap. Numbers are part of the
/// format: append only.
enum class RandomPurpose : uint32_t
{
  FOUNDER_GENOME = 1,
  MUTATION = 2,
  PARENT_ORDER = 3,
  SURVIVOR_DRAW = 4,
  WALK_RATES = 16,  // from here on for studies
  WALK_STEP = 17,
  NEUTRAL_LINEAGE = 18,
  MUTATION_COUNT = 19,
  GAIT_MAP_ROBOT = 20,
  GAIT_MAP_STEP = 21
};

/// A stream of random numbers that is a pure function of its key: no draw depends on order, machine or thread, and
/// there is no state to save. Bits come from Random123's Philox 4x64-10, real numbers from them by our own arithmetic,
/// not the C library's (docs/evolution.md, "Random numbers"). A stream has 2^34 draws, far more than anybody can use.
class RandomStream
{
public:
  /// @param arm        GenomeLayout::arm: bodies, treatments, profiles and mutation rates have independent numbers.
  /// @param individual id within the trial; 0 for purposes that concern a whole generation.
  RandomStream(int64_t seed, const std::string& arm, int64_t trial, int64_t generation, int64_t individual,
               RandomPurpose purpose);

  uint64_t bits();                          ///< 64 independent bits
  double uniform();                         ///< in [0, 1), 53 bits
  double uniform(double low, double high);  ///< in [low, high). @pre low < high
  double normal();                          ///< standard normal deviate, by inversion; within +-8.3
  uint64_t below(uint64_t bound);           ///< unbiased integer in [0, bound). @pre bound > 0

private:
  static constexpr size_t BLOCK_SIZE = 4;
  using Block = std::array<uint64_t, BLOCK_SIZE>;

  std::array<uint64_t, 2> key_;
  Block counter_;  // of the next block
  Block block_ = {};
  size_t used_ = BLOCK_SIZE;  // draws taken from block_
};
}  // namespace devo_evo
