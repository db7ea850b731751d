// Requests to the evolver's services individual and lineage, whose requests are alike, on a small archive.

#include "archive/test_tools.h"
#include "fuzz/input.h"
#include "fuzz/ros/received.h"
#include "ros/conversions.h"

#include <devo_evo/GetIndividual.h>

namespace devo_evo::fuzz
{
namespace
{
std::unique_ptr<Archive> makeArchive(const std::string& output)
{
  const ExperimentSettings settings = test::smallExperiment(output);
  test::evolve(*openArchiveForWriting(settings, test::someProvenance()), settings, 1, settings.generations);
  return openArchiveForReading(output);
}
}  // namespace

Refusal handle(const uint8_t* data, size_t size)
{
  static const ScratchFolder folder;
  static const std::unique_ptr<Archive> archive = makeArchive(folder.path());
  try
  {
    const auto request = readMessage<GetIndividual::Request>(received(data, size));
    const int64_t id = request.id == request.CHAMPION ? archive->championOf(request.trial) : request.id;
    const ExperimentSettings settings = archive->settings();
    for (const ArchivedIndividual& ancestor : archive->readLineage(request.trial, id))
    {
      require(toMsg(ancestor, settings).id <= id);
    }
    require(toMsg(archive->readIndividual(request.trial, id), settings).id == id);
  }
  catch (const InvalidInput& e)
  {
    return e.what();
  }
  return std::nullopt;
}
}  // namespace devo_evo::fuzz
