// An archive's file, opened for reading, and all that can be read from it.

#include "devo_evo/archive/archive.h"

#include "fuzz/input.h"

namespace devo_evo::fuzz
{
namespace
{
/// Reads one thing after another: damage met by one is no reason not to try the next.
class Reading
{
public:
  template <class Operation>
  void attempt(Operation operation)
  {
    try
    {
      operation();
    }
    catch (const ArchiveError& e)
    {
      note(e.what());
    }
    catch (const InvalidInput& e)
    {
      note(e.what());
    }
  }

  void note(const std::string& damage) { first_damage_ = first_damage_ ? first_damage_ : damage; }

  const Refusal& firstDamage() const { return first_damage_; }

private:
  Refusal first_damage_;
};

void readTrial(const Archive& archive, int64_t trial, Reading& reading)
{
  constexpr int64_t SOME_IDS = 4;
  reading.attempt([&] { archive.readLineage(trial, archive.championOf(trial)); });
  reading.attempt([&] { archive.readSelection(trial, archive.extentOf(trial).last_generation); });
  reading.attempt([&] { archive.readIndividuals(trial, 0, SOME_IDS); });
  for (int64_t id = 0; id < SOME_IDS; ++id)
  {
    reading.attempt([&] { archive.readIndividual(trial, id); });
    reading.attempt([&] { archive.readLineage(trial, id); });
  }
}

void readAll(const Archive& archive, Reading& reading)
{
  reading.attempt([&] { archive.settings().validate(); });
  reading.attempt([&] { archive.digest(); });
  reading.attempt([&] { archive.trialStates(); });
  reading.attempt([&] { archive.starts(); });
  reading.attempt([&] { archive.findEvaluation(Hash128()); });
  reading.attempt([&] { bestChampion(archive); });
  reading.attempt(
      [&]
      {
        for (const int64_t trial : archive.trials())
        {
          readTrial(archive, trial, reading);
        }
      });
  reading.attempt(
      [&]
      {
        if (const auto damage = archive.findDamage())
        {
          reading.note(damage->place() + ": " + damage->what);
        }
      });
}
}  // namespace

Refusal handle(const uint8_t* data, size_t size)
{
  static const ScratchFolder folder;
  folder.write("experiment.db", data, size);
  Reading reading;
  reading.attempt([&] { readAll(*openArchiveForReading(folder.path()), reading); });
  return reading.firstDamage();
}
}  // namespace devo_evo::fuzz
