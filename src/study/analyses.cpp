#include "study/analyses.h"

#include "study/analysis_parts.h"

namespace devo_evo
{
std::vector<Analysis> analysesOf(StudyPart part, const Parameters& parameters,
                                 const std::vector<RunChampion>& champions, StudyDatabase& database)
{
  const StudyContext study = { parameters, database };
  switch (part)
  {
    case StudyPart::REMOVED:
      return { removedAnalysis(study, champions) };
    case StudyPart::WALKS:
      return { walksAnalysis(study, champions) };
    case StudyPart::LINEAGES:
      return { lineagesAnalysis(study, champions) };
    case StudyPart::TRACES:
      return { tracesAnalysis(study, champions) };
    case StudyPart::ROBUSTNESS:
      return robustnessAnalyses(study, champions);
    case StudyPart::IMPACT:
      return { impactAnalysis(study) };
    default:
      return {};
  }
}
}  // namespace devo_evo
