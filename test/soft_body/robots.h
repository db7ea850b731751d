#pragma once

#include "devo_evo/soft_body/simulation.h"

#include "soft_body/reference_data.h"

#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

namespace devo_evo
{
/// A robot whose voxels are all alike.
inline DevelopmentalProgram uniformRobot(const SoftBodySettings& settings, double size_gene, double phase = 0.0)
{
  const size_t count = static_cast<size_t>(settings.voxelCount());
  return { std::vector<double>(count, size_gene), std::vector<double>(count, size_gene),
           std::vector<double>(count, phase), std::vector<double>(count, phase) };
}

/// A robot with scrambled genes, the same for the same seed everywhere; no symmetry.
inline DevelopmentalProgram scrambledRobot(const SoftBodySettings& settings, uint64_t seed)
{
  uint64_t state = seed;
  const auto genes = [&state, &settings]
  {
    std::vector<double> values;
    for (int i = 0; i < settings.voxelCount(); ++i)
    {
      state = state * 6364136223846793005u + 1442695040888963407u;
      values.push_back(static_cast<double>(state >> 33) * 0x1p-30 - 1.0);
    }
    return values;
  };
  DevelopmentalProgram program;
  program.morphology_initial = genes();
  program.morphology_final = genes();
  program.control_initial = genes();
  program.control_final = genes();
  return program;
}

inline std::vector<DevelopmentalProgram> scrambledRobots(const SoftBodySettings& settings, int count)
{
  std::vector<DevelopmentalProgram> robots;
  for (int robot = 0; robot < count; ++robot)
  {
    robots.push_back(scrambledRobot(settings, static_cast<uint64_t>(robot) + 1));
  }
  return robots;
}

/// The instruction sets that this processor can run; those it cannot are named on standard output.
inline std::vector<InstructionSet> supportedInstructionSets()
{
  std::vector<InstructionSet> supported;
  for (const InstructionSet candidate : { InstructionSet::SCALAR, InstructionSet::AVX2, InstructionSet::AVX512 })
  {
    if (isSupported(candidate))
    {
      supported.push_back(candidate);
    }
    else
    {
      std::cout << "not tested, for this machine lacks it: " << toString(candidate) << std::endl;
    }
  }
  return supported;
}
}  // namespace devo_evo
