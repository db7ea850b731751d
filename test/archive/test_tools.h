#pragma once

#include "devo_evo/archive/archive.h"
#include "devo_evo/evolution/trial.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <numeric>
#include <string>

namespace devo_evo::test
{
/// A folder of its own for a test, gone afterwards.
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "devo_evo_XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }

private:
  std::string path_;
};

/// A small experiment: 2 x 2 x 1 voxels, eight robots.
inline ExperimentSettings smallExperiment(const std::string& output)
{
  ExperimentSettings settings;
  settings.body.soft.grid_x = 2;
  settings.body.soft.grid_y = 2;
  settings.body.soft.grid_z = 1;
  settings.evolution.population = 8;
  settings.generations = 10;
  settings.output = output;
  return settings;
}

inline Provenance someProvenance()
{
  return { "1.2.3 (0123abc)", "GNU 12", "Analytical Engine", "scalar", "laboratory", 0x1234 };
}

/// A made-up evaluation, which takes no time: bodies that grow large move far; some diverge.
inline Evaluation madeUpEvaluation(const DevelopmentalProgram& program)
{
  Evaluation evaluation;
  const auto& final_sizes = program.morphology_final;
  const double sum = std::accumulate(final_sizes.begin(), final_sizes.end(), 0.0);
  evaluation.valid = program.control_initial.front() < 0.24;
  if (!evaluation.valid)
  {
    evaluation.divergence = Divergence{ 1234, 2, 1.0 + 100.0 * program.control_initial.front() };
    return evaluation;
  }
  evaluation.fitness = sum / static_cast<double>(final_sizes.size());
  evaluation.displacement_y_voxels = 4.0 * evaluation.fitness;
  evaluation.displacement_xy_voxels = 5.0 * evaluation.fitness;
  if (sum > 0.0)
  {
    evaluation.first_top_contact_since_birth_s = sum;
  }
  evaluation.turns = program.morphology_initial.front();
  evaluation.airborne_fraction = 0.1;
  evaluation.velocity_body_lengths_per_s = { 0.5, 0.25 };
  const Hash128 hash = phenotypeHash(program);
  for (size_t i = 0; i < sizeof(uint64_t); ++i)
  {
    evaluation.state_hash = evaluation.state_hash << 8 | hash[i];
  }
  return evaluation;
}

inline void evaluateAll(Trial& trial)
{
  for (const int64_t id : trial.awaiting())
  {
    trial.setEvaluation(id, madeUpEvaluation(trial.individual(id).genome.program));
  }
}

/// Begins a trial, or goes on with it where the archive ends.
inline Trial beginOrResume(const Archive& archive, const ExperimentSettings& settings, int64_t number)
{
  const std::shared_ptr<const Body> body = makeBody(settings.body);
  auto states = archive.trialStates();
  const auto state = states.find(number);
  if (state == states.end())
  {
    return Trial(settings.evolution, *body, number);
  }
  Trial trial(settings.evolution, *body, number, state->second.generation, std::move(state->second.survivors),
              state->second.next_id);
  trial.breed();
  return trial;
}

/// Evolves a trial up to and with a generation. @param committed called after each commit with the record.
template <class Callback>
void evolve(Archive& archive, const ExperimentSettings& settings, int64_t number, int64_t last_generation,
            Callback committed)
{
  for (Trial trial = beginOrResume(archive, settings, number); trial.generation() <= last_generation; trial.breed())
  {
    evaluateAll(trial);
    const GenerationRecord record = trial.select();
    archive.commitGeneration(record);
    committed(record, trial);
  }
}

inline void evolve(Archive& archive, const ExperimentSettings& settings, int64_t number, int64_t last_generation)
{
  evolve(archive, settings, number, last_generation, [](const GenerationRecord&, const Trial&) {});
}

/// The archive's file as somebody else sees it.
inline SQLite::Database openFile(const std::string& output, int flags = SQLite::OPEN_READONLY)
{
  return SQLite::Database(archivePath(output), flags, 5000);
}

inline int64_t countRows(const std::string& output, const std::string& table_and_condition)
{
  return openFile(output).execAndGet("SELECT count(*) FROM " + table_and_condition).getInt64();
}

/// Runs something as a user who is not root, to whom permissions apply; in a process of its own.
inline bool succeedsAsOrdinaryUser(const std::function<bool()>& operation)
{
  const pid_t child = fork();
  if (child == 0)
  {
    constexpr uid_t NOBODY = 65534;
    const bool ordinary = getuid() != 0 || (setgid(NOBODY) == 0 && setuid(NOBODY) == 0);
    _exit(ordinary && operation() ? 0 : 1);
  }
  int status = 1;
  waitpid(child, &status, 0);
  return status == 0;
}

/// Does something in a process of its own, which is killed when it is done: no destructor runs, nothing is closed.
inline void doAndBeKilled(const std::function<void()>& operation)
{
  const pid_t child = fork();
  if (child == 0)
  {
    operation();
    raise(SIGKILL);
  }
  waitpid(child, nullptr, 0);
}

/// What an operation throws, or "" if nothing.
template <class Error, class Operation>
std::string messageOf(Operation operation)
{
  try
  {
    operation();
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "";
}
}  // namespace devo_evo::test
