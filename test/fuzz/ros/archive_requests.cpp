// Requests to the evolver's services individual and lineage, whose requests are alike, on a small archive.

#include "archive/test_tools.h"
#include "fuzz/input.h"
#include "fuzz/ros/received.h"
#include "ros/conversions.h"

#include <devo_evo/GetIndividual.h>

namespace
{
using namespace devo_evo;

std::unique_ptr<Archive> makeArchive(const std::string& output)
{
  const ExperimentSettings settings = test::smallExperiment(output);
  test::evolve(*openArchiveForWriting(settings, test::someProvenance()), settings, 1, settings.generations);
  return openArchiveForReading(output);
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  static const fuzz::ScratchFolder folder;
  static const std::unique_ptr<Archive> archive = makeArchive(folder.path());
  try
  {
    const auto request = readMessage<GetIndividual::Request>(fuzz::received(data, size));
    const int64_t id = request.id == request.CHAMPION ? archive->championOf(request.trial) : request.id;
    const ExperimentSettings settings = archive->settings();
    for (const ArchivedIndividual& ancestor : archive->readLineage(request.trial, id))
    {
      fuzz::require(toMsg(ancestor, settings).id <= id);
    }
    fuzz::require(toMsg(archive->readIndividual(request.trial, id), settings).id == id);
  }
  catch (const InvalidInput&)
  {
  }
  return 0;
}
