#include "devo_evo/experiment/build_info.h"

#include "devo_evo/soft_body/simulation.h"

#include <fstream>

#include <sys/utsname.h>

namespace devo_evo
{
namespace
{
/// The processor's name as Linux tells it; empty where it does not, as on some ARM systems.
std::string processorName()
{
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
  {
    const size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos)
    {
      return line.substr(colon + 2);
    }
  }
  return "";
}
}  // namespace

std::string versionText()
{
  const BuildInfo& info = buildInfo();
  return info.commit.empty() ? info.version : info.version + " (" + info.commit + ")";
}

Provenance localProvenance(const std::string& instruction_set, const Body& body)
{
  Provenance provenance;
  provenance.version = versionText();
  provenance.compiler = buildInfo().compiler;
  provenance.processor = processorName();
  provenance.instruction_set = instruction_set;
  provenance.engine_fingerprint = body.engineFingerprint(parseInstructionSet(instruction_set));

  utsname system{};
  if (uname(&system) == 0)
  {
    provenance.host = system.nodename;
    if (provenance.processor.empty())
    {
      provenance.processor = system.machine;
    }
  }
  return provenance;
}
}  // namespace devo_evo
