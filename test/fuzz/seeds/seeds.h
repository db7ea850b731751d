#pragma once

#include <string>
#include <vector>

namespace devo_evo::fuzz
{
/// One input of a corpus.
struct Seed
{
  std::string target;  ///< name of the fuzz target
  bool valid;          ///< whether the target must accept it, or refuse it
  std::string name;    ///< of the file, says what is special
  std::string bytes;

  /// Within the corpus: "evaluate_request/valid/rigid".
  std::string path() const { return target + (valid ? "/valid/" : "/invalid/") + name; }
};

// For each target by whose layout of bytes a change of messages or parameters is not seen.
std::vector<Seed> evaluateRequestSeeds();
std::vector<Seed> evaluateResponseSeeds();
std::vector<Seed> evolvedRobotSeeds();
std::vector<Seed> announcementSeeds();
std::vector<Seed> archiveRequestSeeds();
std::vector<Seed> parameterValueSeeds();

/// Archives; their bytes depend on the version of SQLite, too.
std::vector<Seed> archiveSeeds();
}  // namespace devo_evo::fuzz
