#pragma once

#include <array>
#include <cstddef>

namespace devo_evo
{
constexpr size_t LEG_COUNT = 4;        ///< front left, front right, hind left, hind right; front is +y, right is +x
constexpr size_t GENERATOR_COUNT = 2;  ///< central pattern generators
constexpr size_t SYNAPSE_COUNT = LEG_COUNT * GENERATOR_COUNT;

/// What a quadruped's genome says about its legs and its neural network: values at birth and at the end of life,
/// between which they change linearly (paper, Supplementary Methods). Without development the final arrays equal the
/// initial ones.
struct QuadrupedProgram
{
  std::array<double, LEG_COUNT> leg_length_initial = {};  ///< [1, 0 to 1]; 0: the leg is drawn in, 1: it is out
  std::array<double, LEG_COUNT> leg_length_final = {};    ///< like leg_length_initial

  /// Weight of the synapse from generator g to the motor neuron of leg l, at GENERATOR_COUNT * l + g [1, -1 to 1].
  std::array<double, SYNAPSE_COUNT> weight_initial = {};
  std::array<double, SYNAPSE_COUNT> weight_final = {};  ///< like weight_initial

  // What it says at an age: 0 is birth, 1 the end of life.
  double legLength(size_t leg, double age) const;
  double weight(size_t leg, size_t generator, double age) const;
};

/// @throw InvalidInput naming array, index, value and what is allowed.
void validate(const QuadrupedProgram& program);
}  // namespace devo_evo
