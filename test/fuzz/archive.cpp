// An archive's file, opened for reading, and all that can be read from it.

#include "devo_evo/archive/archive.h"

#include "fuzz/input.h"

namespace
{
using namespace devo_evo;

constexpr int64_t SOME_IDS = 4;

/// Damage met by one operation is no reason not to try the next.
template <class Operation>
void attempt(Operation operation)
{
  try
  {
    operation();
  }
  catch (const ArchiveError&)
  {
  }
  catch (const InvalidInput&)
  {
  }
}

void readTrial(const Archive& archive, int64_t trial)
{
  attempt([&] { archive.readLineage(trial, archive.championOf(trial)); });
  for (int64_t id = 0; id < SOME_IDS; ++id)
  {
    attempt([&] { archive.readIndividual(trial, id); });
    attempt([&] { archive.readLineage(trial, id); });
  }
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  static const fuzz::ScratchFolder folder;
  folder.write("experiment.db", data, size);
  attempt(
      []
      {
        const auto archive = openArchiveForReading(folder.path());
        attempt([&] { archive->settings().validate(); });
        attempt([&] { archive->digest(); });
        attempt([&] { archive->trialStates(); });
        attempt([&] { archive->findEvaluation(Hash128()); });
        attempt(
            [&]
            {
              for (const int64_t trial : archive->trials())
              {
                readTrial(*archive, trial);
              }
            });
      });
  return 0;
}
