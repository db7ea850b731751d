#pragma once

#include "devo_evo/archive/archive.h"
#include "devo_evo/bodies/bodies.h"
#include "devo_evo/evolution/genome.h"
#include "devo_evo/experiment/experiment.h"
#include "devo_evo/farm/farm.h"

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

EvaluationSettings toMsg(const BodySettings& settings);
RobotGenome toMsg(const Genome& genome, const Body& body);
RobotEvaluation toMsg(const Evaluation& evaluation, int64_t trial, int64_t id, const Body& body);

/// @param settings of the experiment that the individual is from.
EvolvedRobot toMsg(const ArchivedIndividual& individual, const ExperimentSettings& settings);

/// @param generation in which the champion leads.
EvolvedRobot toMsg(const Individual& champion, int64_t generation, const ExperimentSettings& settings);

GenerationSummary toMsg(const GenerationReport& report, const ExperimentSettings& settings);

/// @throw InvalidInput if a parameter is missing, unknown, given twice or out of range.
BodySettings fromMsg(const EvaluationSettings& message);

/// @throw InvalidInput unless it is of this kind of body, has its arrays, each with finite values in range, and the
/// mutation rates are none or one for each of them within 0 to 1.
Genome fromMsg(const RobotGenome& message, const Body& body);

/// @throw InvalidInput unless the numbers are such as an evaluation of this body can have.
Evaluation fromMsg(const RobotEvaluation& message, const Body& body);

/// A request to simulate.
EvaluateGenomes::Request toRequest(const std::vector<EvaluationRequest>& robots, const BodySettings& settings,
                                   const Body& body, uint64_t engine_fingerprint);

/// Why the simulator that is asked is quarantined; nothing if it is not. @throw InvalidInput unless it is a text for
/// people, at most 255 printable ASCII characters, in a request without robots.
std::optional<std::string> quarantineOf(const EvaluateGenomes::Request& request);

/// The robots of a request to simulate. @throw InvalidInput if there are more than MAX_GENOMES, if the arrays differ in
/// size, or if a genome is not one.
std::vector<EvaluationRequest> robotsOf(const EvaluateGenomes::Request& request, const Body& body);

/// The evaluations of an answer, in the order of the robots asked for.
/// @throw InvalidInput if the request was refused, or unless the answer has exactly these robots, each soundly
/// evaluated, with velocities.
std::vector<Evaluation> evaluationsOf(const EvaluateGenomes::Response& response,
                                      const std::vector<EvaluationRequest>& robots, const Body& body);

VelocityTelemetry telemetryOf(const EvaluationRequest& robot, const Evaluation& evaluation, const Body& body,
                              const std::string& simulator);

/// The simulator's engine for a kind of body; 0: it has none.
uint64_t fingerprintFor(const std::string& kind, const SimulatorAnnouncement& announcement);

/// @throw InvalidInput unless names are valid and bounded in length, and numbers lie in their ranges.
void validate(const SimulatorAnnouncement& announcement);
}  // namespace devo_evo
