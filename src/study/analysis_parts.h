#pragma once

#include "devo_evo/soft_body/lattice.h"
#include "study/analyses.h"

#include <vector>

namespace devo_evo
{
/// What analyses need; the database outlives them.
struct StudyContext
{
  const Parameters parameters;
  StudyDatabase& database;

  World world() const { return asEvolved(parameters.experiment.body.soft); }
  std::shared_ptr<const Body> body() const { return makeBody(parameters.experiment.body); }

  /// The only value of a query about a champion, with placeholders for arm, trial and id first.
  template <class... Values>
  int64_t count(const char* sql, const RunChampion& champion, const Values&... values) const
  {
    return database.number(sql, champion.arm, champion.trial(), champion.id(), values...);
  }
};

// The work of each part that is not done yet (docs/study.md, "Parts").
Analysis removedAnalysis(const StudyContext& study, const std::vector<RunChampion>& champions);
Analysis walksAnalysis(const StudyContext& study, const std::vector<RunChampion>& champions);
Analysis lineagesAnalysis(const StudyContext& study, const std::vector<RunChampion>& champions);
Analysis tracesAnalysis(const StudyContext& study, const std::vector<RunChampion>& champions);
std::vector<Analysis> robustnessAnalyses(const StudyContext& study, const std::vector<RunChampion>& champions);
Analysis impactAnalysis(const StudyContext& study);
}  // namespace devo_evo
