#pragma once

#include "devo_evo/evolution/settings.h"
#include "devo_evo/soft_body/developmental_program.h"
#include "devo_evo/soft_body/evaluation.h"
#include "devo_evo/soft_body/simulation.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace devo_evo
{
/// Morphology or control: what the two arrays of one part of a DevelopmentalProgram hold in a kind of body, and how
/// they evolve.
struct GenomePart
{
  std::string name;  ///< of one number, like "size_gene"; the arrays are "size_gene_initial" and "size_gene_final"
  std::string file_suffix;  ///< that the arrays' names have in JSON lines besides
  std::string unit;         ///< "1" if it has none
  std::string place;        ///< what has one number in each array, for messages: "voxel"
  size_t size = 0;          ///< of each array
  double lowest = 0.0;      ///< that can be simulated
  double highest = 0.0;
  double minimum = 0.0;  ///< that evolves; founders are uniform between the two, mutants are clipped to them
  double maximum = 0.0;
  double mutation_sigma = 0.0;  ///< standard deviation of a mutation
  bool develops = false;        ///< else the final array equals the initial one
  std::vector<int> image;       ///< of each number the index of the one that must equal it; empty: all are free

  std::string initialName() const { return name + "_initial"; }
  std::string finalName() const { return name + "_final"; }
};

/// How a reproduction chooses what it mutates. An array here is one that evolves: without development, the initial one.
enum class MutationOperator
{
  CHOSEN_ARRAYS,  ///< each array with probability 1 / count, at least one; each of its numbers with its mutation rate
  EVERY_PART      ///< one number of each part on average: each with probability 1 / count of the part's that evolve
};

/// All that evolution has to know of a kind of body.
struct GenomeLayout
{
  std::string arm;        ///< names what decides random numbers besides the seed, like "evo_devo/paper/self_adaptive"
  std::string carrier;    ///< what has so many numbers, for messages: "a grid of 4x4x3 voxels"
  std::vector<int> grid;  ///< on which the numbers stand, along x, y and z; empty: on none
  GenomePart morphology;
  GenomePart control;
  MutationOperator mutation = MutationOperator::CHOSEN_ARRAYS;
  bool self_adaptive = false;  ///< whether genomes have a mutation rate for each number of a part
};

/// What a kind of body measures of a life besides valid, fitness, velocity and state hash; or of a simulation that
/// failed.
struct Measure
{
  std::string name;  ///< as in archives, files and messages; times end in "_s", failures begin with "divergence_"
  std::string unit;
  std::string meaning;                          ///< one phrase
  double (*get)(const Evaluation& evaluation);  ///< NaN: it never came to that
  void (*set)(Evaluation& evaluation, double value);
  double minimum;  ///< inclusive
  double maximum;  ///< inclusive
  bool whole = false;
  bool may_lack = false;  ///< whether NaN is allowed
};

/// A kind of body with its world: the only thing that evolver, farm, archive, messages and files know of one. To add a
/// kind: implement this, and give it a row in bodies/kinds.cpp and a member of BodySettings (docs/bodies.md).
/// Immutable; every function may be called by many threads at once.
class Body
{
public:
  virtual ~Body() = default;

  /// "soft" or "rigid".
  virtual std::string kind() const = 0;

  virtual GenomeLayout layout(const EvolutionSettings& settings) const = 0;

  /// Of valid evaluations, and of invalid ones; each in the order of tables.
  virtual const std::vector<Measure>& measures() const = 0;
  virtual const std::vector<Measure>& failureMeasures() const = 0;

  /// @throw InvalidInput unless the program can be simulated; the message names array, index and value.
  virtual void validate(const DevelopmentalProgram& program) const = 0;

  /// Evaluations come from networks and files. @throw InvalidInput naming what no life of this body can have had.
  /// Velocities are not looked at if there are none.
  virtual void validate(const Evaluation& evaluation) const = 0;

  /// How many robots are simulated in lock-step: groups of so many are fastest.
  virtual int laneCount(InstructionSet instruction_set) const = 0;

  /// Simulates whole lives on the calling thread. @return one evaluation per program, in their order.
  /// @param stop if given, looked at every few milliseconds; once true, EvaluationAbandoned is thrown.
  /// @throw InvalidInput if a program is invalid.
  virtual std::vector<Evaluation> evaluate(const std::vector<DevelopmentalProgram>& programs,
                                           InstructionSet instruction_set,
                                           const std::atomic<bool>* stop = nullptr) const = 0;

  /// Hash of the evaluations of a fixed set of robots in a fixed world: equal for equal engines. Never 0.
  virtual uint64_t engineFingerprint(InstructionSet instruction_set) const = 0;

  /// Time from birth to the end of life [s].
  virtual double lifetime() const = 0;

  /// How much longer a batch takes than one of the paper's soft robots, at least 1.
  virtual double relativeCost() const = 0;

  /// Of fitness: "body lengths"; and a fitness as people read it, without unit.
  virtual std::string fitnessUnit() const = 0;
  virtual std::string fitnessText(double fitness) const = 0;

  /// Over the whole life, in the direction of travel [body lengths / s]; NaN if the evaluation is invalid.
  virtual double meanVelocity(const Evaluation& evaluation) const = 0;

  /// What a robot did in its life, for people: "travelled 2.255 body lengths in 10 s, made ...".
  virtual std::string describe(const Evaluation& evaluation) const = 0;

  /// When a simulation failed, from its start [s], and why, in one sentence for people. @pre the evaluation is invalid
  virtual double failureTime(const Evaluation& evaluation) const = 0;
  virtual std::string describeFailure(const Evaluation& evaluation) const = 0;
};

/// Developmental windows: how much of all possible change a genome uses, as mean over a part's numbers [1, 0 to 1]. For
/// soft robots: W_L and W_Phi of the paper, Eq. 5 and 6.
double morphologyWindow(const DevelopmentalProgram& program, const GenomeLayout& layout);
double controlWindow(const DevelopmentalProgram& program, const GenomeLayout& layout);
}  // namespace devo_evo
