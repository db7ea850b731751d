#include "fuzz/bodies.h"
#include "fuzz/seeds/message_bytes.h"
#include "fuzz/seeds/seeds.h"
#include "ros/conversions.h"
#include "ros/message_fields.h"

#include <limits>

namespace devo_evo::fuzz
{
namespace
{
/// A champion of generation 9, born in generation 7 at the age of 5.
EvolvedRobot champion(const BodySettings& settings, const Evaluation& evaluation)
{
  const std::shared_ptr<const Body> body = makeBody(settings);
  ExperimentSettings experiment;
  experiment.body = settings;
  Individual individual;
  individual.trial = 3;
  individual.id = 42;
  individual.parent = 17;
  individual.generation = 7;
  individual.age = 7;
  individual.genome = { programFor(*body), {} };
  individual.evaluation = evaluation;
  return toMsg(individual, 9, experiment);
}

EvolvedRobot champion(const BodySettings& settings)
{
  return champion(settings, soundEvaluation(*makeBody(settings)));
}
}  // namespace

std::vector<Seed> evolvedRobotSeeds()
{
  const BodySettings soft(twoVoxels());
  std::vector<Seed> seeds;
  const auto add = [&seeds](bool valid, const std::string& name, const std::string& bytes) {
    seeds.push_back({ "evolved_robot", valid, name, bytes });
  };
  const auto change = [&](bool valid, const std::string& name, const std::function<void(EvolvedRobot&)>& changed)
  { add(valid, name, bytesOf(with(champion(soft), changed))); };

  add(true, "sound", bytesOf(champion(soft)));
  add(true, "rigid", bytesOf(champion(BodySettings(shortLivedQuadruped()))));
  add(true, "failed", bytesOf(champion(soft, failedEvaluation())));
  change(true, "founder",
         [](EvolvedRobot& robot)
         {
           robot.parent = EvolvedRobot::NO_PARENT;
           robot.born = robot.generation = robot.age = 0;
         });
  change(true, "with_rates", [](EvolvedRobot& robot) { robot.genome.mutation_rate = { 0.0, 1.0 }; });

  add(false, "cut_short", cutShort(bytesOf(champion(soft)), 5));
  // A sound evaluation has no failure, whose length ends the message.
  add(false, "endless_array", withEndlessArray(bytesOf(champion(soft)), sizeof(uint32_t)));
  add(false, "another_grid", bytesOf(champion(BodySettings())));
  change(false, "another_body", [](EvolvedRobot& robot) { robot.genome.body = "rigid"; });
  change(false, "without_genome", [](EvolvedRobot& robot) { robot.genome.arrays.clear(); });
  change(false, "genome_of_empty_arrays",
         [](EvolvedRobot& robot)
         {
           for (NamedArray& array : robot.genome.arrays)
           {
             array.values.clear();
           }
         });
  change(false, "not_finite",
         [](EvolvedRobot& robot)
         { test::valuesOf(robot.genome, "size_gene_initial")[1] = std::numeric_limits<double>::quiet_NaN(); });
  change(false, "unknown_treatment", [](EvolvedRobot& robot) { robot.treatment = "devo_evo"; });
  change(false, "older_than_evolution", [](EvolvedRobot& robot) { robot.age = 10; });
  change(false, "younger_than_its_life", [](EvolvedRobot& robot) { robot.age = 1; });
  change(false, "extreme_ages",
         [](EvolvedRobot& robot)
         {
           robot.born = std::numeric_limits<int64_t>::min();
           robot.age = robot.generation = std::numeric_limits<int64_t>::max();
         });
  change(false, "too_many_velocities", [](EvolvedRobot& robot) { robot.evaluation.velocity.resize(4); });
  return seeds;
}
}  // namespace devo_evo::fuzz
