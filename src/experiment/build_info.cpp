#include "devo_evo/experiment/build_info.h"

#include "devo_evo/soft_body/simulation.h"

#include <algorithm>
#include <fstream>

#include <sys/utsname.h>

namespace devo_evo
{
namespace
{
/// Empty where Linux does not tell it, as on some ARM systems.
std::string modelName()
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

std::string processorName()
{
  std::string name = modelName();
  utsname system{};
  if (name.empty() && uname(&system) == 0)
  {
    name = system.machine;
  }
  constexpr size_t longest = 255;
  name = name.substr(0, longest);
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c >= 127; }, '?');
  return name;
}

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
  }
  return provenance;
}
}  // namespace devo_evo
