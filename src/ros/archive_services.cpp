#include "ros/archive_services.h"

#include "devo_evo/archive/archive.h"
#include "ros/conversions.h"

namespace devo_evo
{
namespace
{
/// Calls `read` with an archive, its settings and the id that the request means; turns what it throws into a message.
template <class Request, class Response, class Read>
bool answer(const std::string& output, const Request& request, Response& response, Read read)
{
  try
  {
    const std::unique_ptr<Archive> archive = openArchiveForReading(output);
    const int64_t id = request.id == Request::CHAMPION ? archive->championOf(request.trial) : request.id;
    read(*archive, archive->settings(), id);
    response.success = true;
  }
  catch (const std::exception& e)
  {
    response = Response();
    response.message = e.what();
  }
  return true;
}
}  // namespace

ArchiveServices::ArchiveServices(ros::NodeHandle node, const std::string& output)
  : output_(output)
  , individual_(node.advertiseService("individual", &ArchiveServices::individual, this))
  , lineage_(node.advertiseService("lineage", &ArchiveServices::lineage, this))
{
}

bool ArchiveServices::individual(GetIndividual::Request& request, GetIndividual::Response& response)
{
  return answer(output_, request, response,
                [&](const Archive& archive, const ExperimentSettings& settings, int64_t id)
                { response.individual = toMsg(archive.readIndividual(request.trial, id), settings); });
}

bool ArchiveServices::lineage(GetLineage::Request& request, GetLineage::Response& response)
{
  return answer(output_, request, response,
                [&](const Archive& archive, const ExperimentSettings& settings, int64_t id)
                {
                  for (const ArchivedIndividual& ancestor : archive.readLineage(request.trial, id))
                  {
                    response.individuals.push_back(toMsg(ancestor, settings));
                  }
                });
}
}  // namespace devo_evo
