#include "bodies/checked_evaluation.h"
#include "devo_evo/bodies/bodies.h"
#include "devo_evo/bodies/rigid.h"
#include "devo_evo/evolution/genome.h"
#include "devo_evo/rigid_body/quadruped.h"
#include "devo_evo/soft_body/text.h"
#include "soft_body/scrambled_genes.h"
#include "soft_body/state_hash.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace devo_evo
{
namespace
{
constexpr double ANY = std::numeric_limits<double>::infinity();

/// Places in Evaluation::body_measures.
enum : size_t
{
  DESCENT,
  SIDEWAYS,
  ABDOMEN_CONTACT,
  LEG_CONTACT,
  FIRST_ABDOMEN_CONTACT,
  FIRST_ROLL,
  BODY_MEASURES
};

template <size_t place>
double getOwn(const Evaluation& evaluation)
{
  return place < evaluation.body_measures.size() ? evaluation.body_measures[place] : Evaluation::NONE;
}

template <size_t place>
void setOwn(Evaluation& evaluation, double value)
{
  evaluation.body_measures.resize(BODY_MEASURES, Evaluation::NONE);
  evaluation.body_measures[place] = value;
}

std::vector<Measure> measuresOf(const RigidBodySettings& settings)
{
  const auto share = [](const char* name, const char* meaning, auto get, auto set)
  { return Measure{ name, "1", meaning, get, set, 0.0, 1.0 }; };
  return {
    { "descent", "m", "displacement of the abdomen down the slope", getOwn<DESCENT>, setOwn<DESCENT>, -ANY, ANY },
    { "sideways", "m", "displacement of the abdomen along +x, to the right", getOwn<SIDEWAYS>, setOwn<SIDEWAYS>, -ANY,
      ANY },
    { "turns", "full turns", "of the abdomen about the lateral axis; positive: rolling downhill",
      [](const Evaluation& evaluation) { return evaluation.turns; },
      [](Evaluation& evaluation, double value) { evaluation.turns = value; }, -ANY, ANY },
    share(
        "airborne_fraction", "share of the lifetime without touching the floor",
        [](const Evaluation& evaluation) { return evaluation.airborne_fraction; },
        [](Evaluation& evaluation, double value) { evaluation.airborne_fraction = value; }),
    share("abdomen_contact", "share of the lifetime in which the abdomen touches the floor", getOwn<ABDOMEN_CONTACT>,
          setOwn<ABDOMEN_CONTACT>),
    share("leg_contact", "share of the lifetime in which a leg touches the floor", getOwn<LEG_CONTACT>,
          setOwn<LEG_CONTACT>),
    { "first_abdomen_contact_since_birth_s", "s", "first touch of the floor by the abdomen",
      getOwn<FIRST_ABDOMEN_CONTACT>, setOwn<FIRST_ABDOMEN_CONTACT>, 0.0, settings.lifetime + settings.time_step, false,
      true },
    { "first_roll_since_birth_s", "s", "first time that it had turned downhill by half a turn", getOwn<FIRST_ROLL>,
      setOwn<FIRST_ROLL>, 0.0, settings.lifetime + settings.time_step, false, true },
  };
}

std::vector<Measure> failureMeasuresOf(const RigidBodySettings& settings)
{
  return { { "divergence_step", "1", "at which the simulation was given up, from 1",
             [](const Evaluation& evaluation)
             { return evaluation.divergence ? static_cast<double>(evaluation.divergence->step) : Evaluation::NONE; },
             [](Evaluation& evaluation, double value) {
               evaluation.divergence = Divergence{ static_cast<int64_t>(value), 0, Evaluation::NONE };
             },
             1.0, static_cast<double>(settings.stepCount()), true } };
}

template <size_t N>
std::array<double, N> arrayOf(const std::vector<double>& values)
{
  std::array<double, N> array = {};
  std::copy_n(values.begin(), N, array.begin());
  return array;
}

double bodyLength(const RigidBodySettings& settings)
{
  return 2.0 * settings.abdomen_radius;
}

class RigidBody : public Body
{
public:
  explicit RigidBody(const RigidBodySettings& settings) : settings_(settings)
  {
    settings.validate();
    measures_ = measuresOf(settings);
    failure_measures_ = failureMeasuresOf(settings);
  }

  std::string kind() const override { return "rigid"; }

  GenomeLayout layout(const EvolutionSettings& settings) const override
  {
    const TreatmentSpec& treatment = specOf(settings.treatment);
    const double sigma = settings.rigid_mutation_sigma;
    GenomeLayout layout;
    layout.arm = "rigid/" + toString(settings.treatment) +
                 (settings.selection == Selection::AFPO ? "" : "/" + toString(settings.selection));
    layout.carrier = "a rigid quadruped";
    layout.morphology = {
      "leg_length", "", "1", "leg", LEG_COUNT, 0.0, 1.0, 0.0, 1.0, sigma, treatment.body_develops, {}
    };
    layout.control = {
      "weight", "", "1", "synapse", SYNAPSE_COUNT, -1.0, 1.0, -1.0, 1.0, 2.0 * sigma, treatment.control_develops, {}
    };
    layout.mutation = MutationOperator::EVERY_PART;
    return layout;
  }

  const std::vector<Measure>& measures() const override { return measures_; }
  const std::vector<Measure>& failureMeasures() const override { return failure_measures_; }

  void validate(const DevelopmentalProgram& program) const override
  {
    devo_evo::validate(program, layout(EvolutionSettings()));
  }

  void validate(const Evaluation& evaluation) const override
  {
    checkEvaluation(*this, evaluation);
    if (evaluation.valid && evaluation.fitness < 0.0)
    {
      throw InvalidInput("fitness is " + toText(evaluation.fitness) + "; an intensity cannot be negative");
    }
  }

  int laneCount(InstructionSet /*instruction_set*/) const override { return 1; }

  std::vector<Evaluation> evaluate(const std::vector<DevelopmentalProgram>& programs,
                                   InstructionSet /*instruction_set*/, const std::atomic<bool>* stop) const override
  {
    for (const DevelopmentalProgram& program : programs)
    {
      validate(program);
    }
    std::vector<Evaluation> evaluations;
    for (const DevelopmentalProgram& program : programs)
    {
      evaluations.push_back(toEvaluation(evaluateQuadruped(settings_, toQuadruped(program), stop), settings_));
    }
    return evaluations;
  }

  uint64_t engineFingerprint(InstructionSet instruction_set) const override;

  double lifetime() const override { return settings_.lifetime; }

  double relativeCost() const override
  {
    return std::max(1.0,
                    static_cast<double>(settings_.stepCount()) / static_cast<double>(RigidBodySettings().stepCount()));
  }

  std::string fitnessUnit() const override { return "1/m^2"; }
  std::string fitnessText(double fitness) const override { return fixedText(fitness, 6); }

  double meanVelocity(const Evaluation& evaluation) const override
  {
    return getOwn<DESCENT>(evaluation) / bodyLength(settings_) / settings_.lifetime;
  }

  std::string describe(const Evaluation& evaluation) const override
  {
    const double first = getOwn<FIRST_ABDOMEN_CONTACT>(evaluation);
    return "saw light of " + fitnessText(evaluation.fitness) + " 1/m^2 on average, came " +
           fixedText(getOwn<DESCENT>(evaluation), 2) + " m down the slope in " + toText(settings_.lifetime) +
           " s, made " + fixedText(evaluation.turns, 2) + " turns, " +
           (std::isnan(first) ? "never touched the floor with its abdomen"
                              : "touched the floor with its abdomen " + fixedText(first, 2) + " s after birth");
  }

  double failureTime(const Evaluation& evaluation) const override
  {
    return static_cast<double>(evaluation.divergence.value_or(Divergence()).step) * settings_.time_step;
  }

  std::string describeFailure(const Evaluation& evaluation) const override
  {
    return "ran out of all bounds at step " + toText(evaluation.divergence.value_or(Divergence()).step) + " (" +
           toText(failureTime(evaluation)) + " s)";
  }

private:
  const RigidBodySettings settings_;
  std::vector<Measure> measures_;
  std::vector<Measure> failure_measures_;
};

/// Eight quadrupeds that hardly fall alike, for as long as it takes their bits to spread.
uint64_t RigidBody::engineFingerprint(InstructionSet instruction_set) const
{
  constexpr int robots = 8;
  RigidBodySettings settings;
  settings.lifetime = 1.0;
  const RigidBody body(settings);
  uint64_t state = 0;
  std::vector<DevelopmentalProgram> programs(robots);
  for (DevelopmentalProgram& program : programs)
  {
    const auto lengths = [&state]
    {
      std::vector<double> values = scrambledGenes(state, LEG_COUNT);
      std::transform(values.begin(), values.end(), values.begin(), [](double value) { return 0.5 * (value + 1.0); });
      return values;
    };
    program.morphology_initial = lengths();
    program.morphology_final = lengths();
    program.control_initial = scrambledGenes(state, SYNAPSE_COUNT);
    program.control_final = scrambledGenes(state, SYNAPSE_COUNT);
  }
  StateHash hash;
  for (const Evaluation& evaluation : body.evaluate(programs, instruction_set, nullptr))
  {
    hash.add(evaluation.fitness);
    hash.add(evaluation.state_hash);
  }
  return hash.finish();
}
}  // namespace

QuadrupedProgram toQuadruped(const DevelopmentalProgram& program)
{
  return { arrayOf<LEG_COUNT>(program.morphology_initial), arrayOf<LEG_COUNT>(program.morphology_final),
           arrayOf<SYNAPSE_COUNT>(program.control_initial), arrayOf<SYNAPSE_COUNT>(program.control_final) };
}

Evaluation toEvaluation(const QuadrupedEvaluation& life, const RigidBodySettings& settings)
{
  Evaluation evaluation;
  if (!life.valid)
  {
    evaluation.divergence = Divergence{ life.failed_step.value_or(1), 0, Evaluation::NONE };
    return evaluation;
  }
  evaluation.valid = true;
  evaluation.fitness = life.fitness;
  evaluation.turns = life.turns;
  evaluation.airborne_fraction = life.airborne_fraction;
  evaluation.body_measures.resize(BODY_MEASURES);
  evaluation.body_measures[DESCENT] = life.descent;
  evaluation.body_measures[SIDEWAYS] = life.sideways;
  evaluation.body_measures[ABDOMEN_CONTACT] = life.abdomen_contact;
  evaluation.body_measures[LEG_CONTACT] = life.leg_contact;
  evaluation.body_measures[FIRST_ABDOMEN_CONTACT] = life.first_abdomen_contact_s.value_or(Evaluation::NONE);
  evaluation.body_measures[FIRST_ROLL] = life.first_roll_s.value_or(Evaluation::NONE);
  for (const double velocity : life.velocity)
  {
    evaluation.velocity_body_lengths_per_s.push_back(velocity / bodyLength(settings));
  }
  evaluation.state_hash = life.state_hash;
  return evaluation;
}

std::shared_ptr<const Body> makeRigidBody(const RigidBodySettings& settings)
{
  return std::make_shared<RigidBody>(settings);
}
}  // namespace devo_evo
