#include "bodies/checked_evaluation.h"
#include "devo_evo/bodies/bodies.h"
#include "devo_evo/soft_body/lattice.h"
#include "devo_evo/soft_body/text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace devo_evo
{
namespace
{
constexpr double ANY = std::numeric_limits<double>::infinity();

/// A moment that may never have come.
template <std::optional<double> Evaluation::*field>
Measure moment(const char* name, const char* meaning, double latest)
{
  return { name,
           "s",
           meaning,
           [](const Evaluation& evaluation) { return (evaluation.*field).value_or(Evaluation::NONE); },
           [](Evaluation& evaluation, double value)
           { evaluation.*field = std::isnan(value) ? std::nullopt : std::optional<double>(value); },
           0.0,
           latest,
           false,
           true };
}

template <double Evaluation::*field>
Measure number(const char* name, const char* unit, const char* meaning, double minimum, double maximum)
{
  return { name,
           unit,
           meaning,
           [](const Evaluation& evaluation) { return evaluation.*field; },
           [](Evaluation& evaluation, double value) { evaluation.*field = value; },
           minimum,
           maximum };
}

/// @param field of Divergence; a whole number is always known.
template <class Value, Value Divergence::*field>
Measure ofDivergence(const char* name, const char* unit, const char* meaning, double minimum, double maximum)
{
  const bool whole = std::is_integral_v<Value>;
  return { name,
           unit,
           meaning,
           [](const Evaluation& evaluation)
           { return evaluation.divergence ? static_cast<double>((*evaluation.divergence).*field) : Evaluation::NONE; },
           [](Evaluation& evaluation, double value)
           {
             Divergence divergence = evaluation.divergence.value_or(Divergence());
             divergence.*field = static_cast<Value>(value);
             evaluation.divergence = divergence;
           },
           minimum,
           maximum,
           whole,
           !whole };
}

class SoftBody : public Body
{
public:
  explicit SoftBody(const SoftBodySettings& settings) : settings_(settings), lattice_((settings.validate(), settings))
  {
    const double latest = settings.lifetime + 2.0 * settings.timeStep();
    const double last_step = (SETTLING_TIME + settings.lifetime) / settings.timeStep() + 2.0;
    const auto bonds = static_cast<double>(lattice_.bonds().size());
    measures_ = {
      number<&Evaluation::displacement_y_voxels>("displacement_y_voxels", "voxels", "the same", -ANY, ANY),
      number<&Evaluation::displacement_xy_voxels>("displacement_xy_voxels", "voxels",
                                                  "distance in the horizontal plane", -ANY, ANY),
      moment<&Evaluation::first_top_contact_since_birth_s>("first_top_contact_since_birth_s",
                                                           "first touch of the floor by the top layer", latest),
      moment<&Evaluation::fell_over_since_birth_s>("fell_over_since_birth_s",
                                                   "first time that more top voxels touch than others", latest),
      number<&Evaluation::turns>("turns", "full turns", "about the lateral axis +x", -ANY, ANY),
      number<&Evaluation::airborne_fraction>("airborne_fraction", "1",
                                             "share of the lifetime without touching the floor", 0.0, 1.0),
    };
    failure_measures_ = {
      ofDivergence<int64_t, &Divergence::step>("divergence_step", "1", "at which it was found, from 1", 1.0, last_step),
      ofDivergence<int, &Divergence::bond>("divergence_bond", "1", "in the order of docs/physics.md", 0.0, bonds - 1.0),
      ofDivergence<double, &Divergence::strain>("divergence_strain", "1", "of that bond", 100.0, ANY),
    };
  }

  std::string kind() const override { return "soft"; }

  GenomeLayout layout(const EvolutionSettings& settings) const override
  {
    const TreatmentSpec& treatment = specOf(settings.treatment);
    const auto voxels = static_cast<size_t>(lattice_.voxelCount());
    const double phase_limit = settings.phaseLimit();
    GenomeLayout layout;
    layout.arm = settings.arm();
    layout.carrier = "a grid of " + toText(settings_.grid_x) + "x" + toText(settings_.grid_y) + "x" +
                     toText(settings_.grid_z) + " voxels";
    layout.grid = { settings_.grid_x, settings_.grid_y, settings_.grid_z };
    layout.morphology = { "size_gene",
                          "",
                          "1",
                          "voxel",
                          voxels,
                          -1.0,
                          1.0,
                          -1.0,
                          1.0,
                          settings.size_mutation_sigma,
                          treatment.body_develops,
                          {} };
    for (int voxel = 0; voxel < lattice_.voxelCount(); ++voxel)
    {
      layout.morphology.image.push_back(lattice_.mirrored(voxel));
    }
    layout.control = { "phase",
                       "_cycles",
                       "cycles",
                       "voxel",
                       voxels,
                       -1.0,
                       1.0,
                       -phase_limit,
                       phase_limit,
                       phase_limit,
                       treatment.control_develops,
                       {} };
    layout.self_adaptive = !settings.mutation_rate;
    return layout;
  }

  const std::vector<Measure>& measures() const override { return measures_; }
  const std::vector<Measure>& failureMeasures() const override { return failure_measures_; }

  void validate(const DevelopmentalProgram& program) const override { devo_evo::validate(program, settings_); }

  void validate(const Evaluation& evaluation) const override
  {
    checkEvaluation(*this, evaluation);
    const double travelled = evaluation.fitness * settings_.grid_y;
    if (evaluation.valid && !(std::abs(travelled - evaluation.displacement_y_voxels) <= 1e-15 * std::abs(travelled)))
    {
      throw InvalidInput("fitness is " + toText(evaluation.fitness) + ", and displacement_y_voxels " +
                         toText(evaluation.displacement_y_voxels) + "; they contradict each other");
    }
    if (evaluation.divergence && evaluation.divergence->strain <= 100.0)
    {
      throw InvalidInput("divergence_strain is " + toText(evaluation.divergence->strain) +
                         "; it must not be at most 100");
    }
  }

  int laneCount(InstructionSet instruction_set) const override { return devo_evo::laneCount(instruction_set); }

  std::vector<Evaluation> evaluate(const std::vector<DevelopmentalProgram>& programs, InstructionSet instruction_set,
                                   const std::atomic<bool>* stop) const override
  {
    return devo_evo::evaluate(settings_, programs, instruction_set, stop);
  }

  uint64_t engineFingerprint(InstructionSet instruction_set) const override
  {
    return devo_evo::engineFingerprint(instruction_set);
  }

  double lifetime() const override { return settings_.lifetime; }

  double relativeCost() const override
  {
    const auto cost = [](const SoftBodySettings& settings)
    { return settings.voxelCount() * (SETTLING_TIME + settings.lifetime) / settings.timeStep(); };
    return std::max(1.0, cost(settings_) / cost(SoftBodySettings()));
  }

  std::string fitnessUnit() const override { return "body lengths"; }
  std::string fitnessText(double fitness) const override { return fixedText(fitness, 3); }

  double meanVelocity(const Evaluation& evaluation) const override
  {
    return evaluation.valid ? evaluation.fitness / settings_.lifetime : Evaluation::NONE;
  }

  std::string describe(const Evaluation& evaluation) const override
  {
    const std::string fall = evaluation.fell_over_since_birth_s
                                 ? "fell over " + fixedText(*evaluation.fell_over_since_birth_s, 2) + " s after birth"
                                 : "never fell over";
    return "travelled " + fixedText(evaluation.fitness, 3) + " body lengths in " + toText(settings_.lifetime) +
           " s, made " + fixedText(evaluation.turns, 2) + " turns, " + fall;
  }

  double failureTime(const Evaluation& evaluation) const override
  {
    return static_cast<double>(evaluation.divergence.value_or(Divergence()).step) * settings_.timeStep();
  }

  std::string describeFailure(const Evaluation& evaluation) const override
  {
    return evaluation.divergence.value_or(Divergence()).describe(settings_.timeStep());
  }

private:
  const SoftBodySettings settings_;
  const Lattice lattice_;
  std::vector<Measure> measures_;
  std::vector<Measure> failure_measures_;
};
}  // namespace

std::shared_ptr<const Body> makeSoftBody(const SoftBodySettings& settings)
{
  return std::make_shared<SoftBody>(settings);
}
}  // namespace devo_evo
