#pragma once

#include "devo_evo/archive/archive.h"

#include <cstdint>
#include <string>
#include <vector>

namespace devo_evo
{
/// One thing that is not the same in two archives.
struct FieldDifference
{
  std::string field;  ///< name of the parameter, column or array
  std::string a;
  std::string b;
};

/// Where a trial of two experiments parts.
struct TrialDifference
{
  int64_t trial = 0;
  int64_t generation = 0;
  int64_t id = -1;  ///< of the first individual that differs; -1: the newcomers are the same, the selection is not
  std::vector<FieldDifference> fields;
};

/// How far both have come, where one has come further.
struct ExtentDifference
{
  int64_t trial = 0;
  int64_t generations_a = 0;  ///< finished; 0: the trial is not there
  int64_t generations_b = 0;
};

/// What two experiments differ in.
struct ArchiveComparison
{
  std::vector<FieldDifference> parameters;
  std::vector<FieldDifference> provenance;  ///< of the last start of each; does not decide results
  std::vector<TrialDifference> trials;      ///< the first difference of each trial that both have begun
  std::vector<ExtentDifference> extents;
  int64_t equal_generations = 0;  ///< in all trials, before they part

  /// Whether both hold the same evolution of the same experiment. Provenance does not matter.
  bool equal() const { return parameters.empty() && trials.empty() && extents.empty(); }
};

/// @throw ArchiveError if one of them cannot be read.
ArchiveComparison compareArchives(const Archive& a, const Archive& b);
}  // namespace devo_evo
