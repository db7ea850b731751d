#pragma once

#include "devo_evo/evolution/trial.h"
#include "devo_evo/experiment/settings.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace devo_evo
{
/// Thrown when the archive cannot be written or read; says which file, why, and what would help. The archive stays
/// valid.
class ArchiveError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Where results are made; noted at each start, never part of a digest.
struct Provenance
{
  std::string version;  ///< of devo_evo, with the commit if known
  std::string compiler;
  std::string processor;
  std::string instruction_set;
  std::string host;
  uint64_t engine_fingerprint = 0;  ///< engineFingerprint() of the kernel; 0: not known
  std::string ros = "";             ///< version of roscpp; empty for a program without ROS
};

/// A machine, and a program on it, that evaluated robots for an experiment's evolver.
struct Evaluator
{
  std::string host;
  std::string processor;
  std::string instruction_set;
  std::string version;      ///< of devo_evo
  int64_t evaluations = 0;  ///< since the start, used for generations that are committed or under way
};

/// One stretch of work on an archive.
struct Start
{
  int64_t number = 0;  ///< counts up from 1
  std::string time_utc;
  Provenance provenance;
  std::optional<std::string> stop_utc;  ///< none: it still runs, or ended without a word (killed, power cut)
  int64_t generations_at_stop = 0;      ///< finished in all trials by then; 0 if there is no stop_utc
  std::vector<Evaluator> evaluators;    ///< simulators; none if the evolver simulated all robots itself
};

/// Where to go on with a trial: the arguments of Trial's second constructor.
struct TrialState
{
  int64_t generation = 0;
  std::vector<Individual> survivors;
  int64_t next_id = 0;
};

/// One individual as the archive knows it. Velocity windows are not archived (they can be simulated again): evaluations
/// that come from an archive have none.
struct ArchivedIndividual
{
  Individual individual;           ///< age: at birth; genome: empty arrays unless has_genome
  bool has_genome = false;         ///< whether the genome was kept, or replaying mutations gave one of the right hash
  double morphology_window = 0.0;  ///< W_L
  double control_window = 0.0;     ///< W_Phi
  Hash128 phenotype_hash = {};     ///< as noted at birth
  Hash128 genome_hash = {};        ///< as noted at birth
};

/// What a finished generation left to the next.
struct ArchivedSelection
{
  int64_t champion = 0;
  double best_fitness = 0.0;       ///< [body lengths]; NaN if no survivor is valid
  double median_fitness = 0.0;     ///< of the valid survivors [body lengths]; NaN if there is none
  std::vector<int64_t> survivors;  ///< ids in ranking order
};

/// Something in an archive that cannot be so.
struct Offence
{
  int64_t trial = 0;       ///< 0: it concerns the whole archive
  int64_t generation = 0;  ///< of birth, if it concerns an individual; -1: not known
  int64_t id = -1;         ///< of the individual; -1: it concerns a whole generation or trial
  std::string what;        ///< a sentence for people

  /// "1/17", "trial 1, generation 3", "archive".
  std::string place() const;
};

/// How much there is of a trial.
struct TrialExtent
{
  int64_t last_generation = 0;
  int64_t individuals = 0;
  int64_t survivors = 0;  ///< rows, over all generations
  int64_t next_id = 0;    ///< the lowest id never given
};

/// An experiment's record: one SQLite file, `experiment.db` in the output folder, one transaction per
/// generation, or for several trials' that end at the same time.
/// Schema and example queries: docs/archive.md. Many may read while one writes; a second writer is refused. Not
/// thread-safe: one object per thread.
class Archive
{
public:
  virtual ~Archive() = default;

  /// Everything about finished generations, each of another trial, in one transaction that survives a crash once this
  /// returns.
  /// @throw ArchiveError if it cannot be written (disk full, file locked); nothing of any of them is kept then, and
  ///        they may be committed again. std::logic_error if one is not the one after its trial's last, if a newcomer
  ///        lacks its evaluation, or if the archive was opened for reading.
  virtual void commitGenerations(const std::vector<GenerationRecord>& records) = 0;

  /// The same for one.
  void commitGeneration(const GenerationRecord& record) { commitGenerations({ record }); }

  /// Takes down who has evaluated robots since the archive was opened. Written with the next commit, and at the end.
  virtual void noteEvaluators(std::vector<Evaluator> evaluators) = 0;

  /// The evaluation (without velocity windows) of an individual with this phenotype, if one was committed in any trial.
  virtual std::optional<Evaluation> findEvaluation(const Hash128& phenotype_hash) const = 0;

  /// The last committed generation of each trial that has one. Survivors have the ages they had in that generation.
  virtual std::map<int64_t, TrialState> trialStates() const = 0;

  /// @throw InvalidInput if there is no such individual.
  virtual ArchivedIndividual readIndividual(int64_t trial, int64_t id) const = 0;

  /// An individual and its ancestors, oldest first. @throw InvalidInput if there is no such individual.
  virtual std::vector<ArchivedIndividual> readLineage(int64_t trial, int64_t id) const = 0;

  /// Id of the champion of a trial's last committed generation. @throw InvalidInput if the trial has none.
  virtual int64_t championOf(int64_t trial) const = 0;

  /// Numbers of the trials with at least one committed generation, ascending.
  virtual std::vector<int64_t> trials() const = 0;

  /// @throw InvalidInput if the trial has no committed generation.
  virtual TrialExtent extentOf(int64_t trial) const = 0;

  /// Those individuals whose ids lie in [first_id, first_id + count), ascending. Genomes are not made again: has_genome
  /// tells whether it is stored, whatever its hash.
  virtual std::vector<ArchivedIndividual> readIndividuals(int64_t trial, int64_t first_id, int64_t count) const = 0;

  /// None if there is no such generation.
  virtual std::optional<ArchivedSelection> readSelection(int64_t trial, int64_t generation) const = 0;

  /// Every start of an evolver on this archive, in their order.
  virtual std::vector<Start> starts() const = 0;

  /// Looks for damage to the file itself, for rows that are missing, and for those that belong to nothing.
  /// @return what is wrong first; none if nothing is.
  virtual std::optional<Offence> findDamage() const = 0;

  /// Of the experiment; trials and generations as the last start asked for, or as committed if that is more.
  virtual ExperimentSettings settings() const = 0;

  /// SHA-256, 64 hexadecimal digits, over all that evolution decided (docs/archive.md, "Digest"): equal for equal
  /// evolution.
  virtual std::string digest() const = 0;
};

/// The fittest of the trials' champions; of equals the one of the first trial. None if none is valid.
std::optional<ArchivedIndividual> bestChampion(const Archive& archive);

/// Path of the archive in an output folder.
std::string archivePath(const std::string& output);

/// Opens the archive in settings.output for writing; makes folder and archive if there is none.
/// An existing one is resumed if every parameter of body, physics and evolution agrees. Trials and generations may
/// grow, and may shrink: what is beyond them stays, and is not continued.
/// @param maximum_size beyond which the file does not grow, as if the disk were full then [bytes]; 0: no limit.
/// @throw ArchiveError if parameters differ (naming each difference), if the engine fingerprint differs, if another
/// process
///        writes to it (naming that), if the folder lies on a network file system or cannot be written, or if there is
///        an experiment.db that is damaged, not ours, or of a newer version. The file stays as it was then.
std::unique_ptr<Archive> openArchiveForWriting(const ExperimentSettings& settings, const Provenance& provenance,
                                               int64_t maximum_size = 0);

/// Whether there is an archive that can be opened for reading. An evolver that is killed between making the file and
/// its first commit leaves an empty one, which is as good as none.
/// @throw ArchiveError if there is a file that cannot be looked into.
bool archiveHasBegun(const std::string& output);

/// Opens an existing archive for reading, also while an evolver writes to it, after one was killed, and in a folder
/// that must not be written.
/// @throw ArchiveError if there is none, or if it is empty, damaged, not ours, or of a newer version.
std::unique_ptr<Archive> openArchiveForReading(const std::string& output);
}  // namespace devo_evo
