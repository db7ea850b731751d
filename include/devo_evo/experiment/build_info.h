#pragma once

#include "devo_evo/archive/archive.h"

#include <string>

namespace devo_evo
{
/// What this program was built from and with. For provenance and messages; no result depends on it.
struct BuildInfo
{
  std::string version;   ///< of the package, as in package.xml: "0.1.0"
  std::string commit;    ///< abbreviated, with "-dirty" if the sources differed from it; "" if built without git
  std::string compiler;  ///< name, version and optimisation: "GNU 12.2.0, -O3 -DNDEBUG, Release"
};

const BuildInfo& buildInfo();

/// Version and commit for people: "0.1.0 (3f2c19a04b1d)", or "0.1.0" without a commit.
std::string versionText();

/// The processor's name as Linux tells it, or else its kind of machine: at most 255 printable ASCII characters.
std::string processorName();

/// Provenance of what is computed on this machine with an instruction set ("scalar", "avx2" or "avx512"). Takes the
/// fraction of a second that the engine fingerprint takes.
Provenance localProvenance(const std::string& instruction_set, const Body& body);
}  // namespace devo_evo
