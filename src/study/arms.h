#pragma once

#include "devo_evo/experiment/parameters.h"

#include <string>
#include <vector>

namespace devo_evo
{
/// One experiment of a study.
struct Arm
{
  std::string name;  ///< "main/evo_devo": also its folder within the study's
  StudyPart part;
  ExperimentSettings settings;
};

/// The kinds of bodies that a study's arms have.
const std::vector<BodyKind>& studiedBodies();

/// A study's settings as an experiment with one kind of body takes them: the other kind's parameters at their defaults.
ExperimentSettings ofBody(BodyKind kind, const ExperimentSettings& settings);

/// The experiments that a part consists of; none for a part that analyses.
std::vector<Arm> armsOf(StudyPart part, const Parameters& parameters);

/// The arms whose run champions are analysed: those of MAIN and, if they have been begun, of PARTIAL.
std::vector<Arm> analysedArms(const Parameters& parameters);

/// Whether the arm's archive can be read.
bool hasBegun(const Arm& arm);
}  // namespace devo_evo
