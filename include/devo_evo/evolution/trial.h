#pragma once

#include "devo_evo/evolution/individual.h"
#include "devo_evo/evolution/settings.h"

#include <cstdint>
#include <vector>

namespace devo_evo
{
/// What one generation did to a trial; complete enough to go on from.
struct GenerationRecord
{
  int64_t trial = 0;
  int64_t generation = 0;
  std::vector<Individual> newcomers;  ///< born in this generation, evaluated, by id
  std::vector<int64_t> survivors;     ///< ids of the next population, in ranking order; the champion is first
  int64_t champion = 0;               ///< id of the best valid survivor; of the first survivor if none is valid
  double best_fitness = 0.0;          ///< [in the unit of the body's fitness]; NaN if no survivor is valid
  double median_fitness = 0.0;  ///< of the valid survivors [in the unit of the body's fitness]; NaN if there is none
};

/// One evolutionary trial: a pure state machine without clocks, files or threads.
///
///   Trial trial(settings, body, number);
///   for (;;) {
///     for (id : trial.awaiting()) trial.setEvaluation(id, ...);   // in any order
///     record = trial.select();
///     trial.breed();
///   }
///
/// The same settings, seed and number give the same records, whatever the order of evaluations.
class Trial
{
public:
  /// Generation 0: random founders awaiting evaluation.
  Trial(const EvolutionSettings& settings, const Body& body, int64_t number);

  /// Goes on after generation `generation` was selected and recorded: the next call is breed().
  /// @param survivors evaluated, in the order of GenerationRecord::survivors, with their ages in that generation.
  /// @param next_id   the lowest id never given.
  /// @throw std::invalid_argument if there are no survivors, one has no evaluation, or one's id is not below next_id.
  Trial(const EvolutionSettings& settings, const Body& body, int64_t number, int64_t generation,
        std::vector<Individual> survivors, int64_t next_id);

  int64_t number() const { return number_; }
  int64_t generation() const { return generation_; }
  int64_t nextId() const { return next_id_; }

  /// Everybody alive: survivors first, then the newcomers of this generation, if bred.
  const std::vector<Individual>& individuals() const { return individuals_; }

  /// @throw std::out_of_range if nobody alive has this id.
  const Individual& individual(int64_t id) const { return individuals_[indexOf(id)]; }

  /// Ids of those without an evaluation, ascending.
  std::vector<int64_t> awaiting() const;

  /// The same evaluation may come twice.
  /// @throw std::out_of_range if nobody alive has this id; std::logic_error if it has another evaluation already;
  ///        InvalidInput if a valid evaluation has no finite fitness.
  void setEvaluation(int64_t id, const Evaluation& evaluation);

  /// Reduces everybody to the next population. @throw std::logic_error unless awaiting() is empty and this generation
  /// has not been selected yet.
  GenerationRecord select();

  /// Starts the next generation: all age by one, each survivor has one mutated child (under random search a random
  /// individual joins in its place), random individuals of age 0 join.
  /// @throw std::logic_error unless the generation has been selected.
  void breed();

private:
  size_t indexOf(int64_t id) const;

  /// Lets the individual with the next id join.
  void addNewborn(const Individual* parent);

  EvolutionSettings settings_;
  GenomeLayout layout_;
  int64_t number_;
  int64_t generation_ = 0;
  int64_t next_id_ = 0;
  bool selected_ = false;
  std::vector<Individual> individuals_;
};
}  // namespace devo_evo
