#pragma once

#include <devo_evo/GetIndividual.h>
#include <devo_evo/GetLineage.h>

#include <ros/node_handle.h>

#include <string>
#include <vector>

namespace devo_evo
{
/// Services `individual` (GetIndividual) and `lineage` (GetLineage) on the archive in a folder. Every call opens it for
/// reading, so they may be served by any thread while an experiment writes.
class ArchiveServices
{
public:
  ArchiveServices(ros::NodeHandle node, const std::string& output);

  /// Resolved names of the services.
  std::vector<std::string> names() const { return { individual_.getService(), lineage_.getService() }; }

private:
  bool individual(GetIndividual::Request& request, GetIndividual::Response& response);
  bool lineage(GetLineage::Request& request, GetLineage::Response& response);

  const std::string output_;
  ros::ServiceServer individual_;
  ros::ServiceServer lineage_;
};
}  // namespace devo_evo
