#pragma once

#include "devo_evo/archive/archive.h"
#include "devo_evo/evolution/genome.h"
#include "devo_evo/experiment/experiment.h"
#include "devo_evo/farm/farm.h"
#include "devo_evo/soft_body/evaluation.h"
#include "devo_evo/soft_body/settings.h"

#include <devo_evo/EvaluateGenomes.h>
#include <devo_evo/EvaluationSettings.h>
#include <devo_evo/EvolvedRobot.h>
#include <devo_evo/GenerationSummary.h>
#include <devo_evo/RobotEvaluation.h>
#include <devo_evo/RobotGenome.h>
#include <devo_evo/SimulatorAnnouncement.h>
#include <devo_evo/VelocityTelemetry.h>

#include <ros/time.h>

#include <optional>
#include <string>
#include <vector>

namespace devo_evo
{
// Between the library's types and messages. Messages come from the network and are not trusted: every function that
// reads one checks it, and throws InvalidInput that says what is wrong with it.

/// Wall-clock time for stamps, also where ROS time is simulated.
ros::Time wallStamp();

EvaluationSettings toMsg(const SoftBodySettings& settings);
RobotGenome toMsg(const Genome& genome);
RobotEvaluation toMsg(const Evaluation& evaluation, int64_t trial, int64_t id);

/// @param settings of the experiment that the individual is from.
EvolvedRobot toMsg(const ArchivedIndividual& individual, const EvolutionSettings& settings);

/// @param generation in which the champion leads.
EvolvedRobot toMsg(const Individual& champion, int64_t generation, const EvolutionSettings& settings);

GenerationSummary toMsg(const GenerationReport& report, const ExperimentSettings& settings);

/// @throw InvalidInput if a value is out of range.
SoftBodySettings fromMsg(const EvaluationSettings& message);

/// @throw InvalidInput unless every array of the program fits the grid, with finite values in range, and the mutation
/// rates
///        are none or one per voxel within 0 to 1.
Genome fromMsg(const RobotGenome& message, const SoftBodySettings& settings);

/// @throw InvalidInput unless the numbers are such as an evaluation with these settings can have.
Evaluation fromMsg(const RobotEvaluation& message, const SoftBodySettings& settings);

/// A request to simulate.
EvaluateGenomes::Request toRequest(const std::vector<EvaluationRequest>& robots, const SoftBodySettings& settings,
                                   uint64_t engine_fingerprint);

/// Why the simulator that is asked is quarantined; nothing if it is not. @throw InvalidInput unless it is a text for
/// people, at most 255 printable ASCII characters, in a request without robots.
std::optional<std::string> quarantineOf(const EvaluateGenomes::Request& request);

/// The robots of a request to simulate. @throw InvalidInput if there are more than MAX_GENOMES, if the arrays differ in
/// size, or if a genome is not one.
std::vector<EvaluationRequest> robotsOf(const EvaluateGenomes::Request& request, const SoftBodySettings& settings);

/// The evaluations of an answer, in the order of the robots asked for.
/// @throw InvalidInput if the request was refused, or unless the answer has exactly these robots, each soundly
/// evaluated.
std::vector<Evaluation> evaluationsOf(const EvaluateGenomes::Response& response,
                                      const std::vector<EvaluationRequest>& robots, const SoftBodySettings& settings);

VelocityTelemetry telemetryOf(const EvaluationRequest& robot, const Evaluation& evaluation,
                              const SoftBodySettings& settings, const std::string& simulator);

/// @throw InvalidInput unless names are valid and bounded in length, and numbers lie in their ranges.
void validate(const SimulatorAnnouncement& announcement);
}  // namespace devo_evo
