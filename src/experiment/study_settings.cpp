#include "devo_evo/experiment/study_settings.h"

#include "devo_evo/soft_body/settings.h"

#include <algorithm>
#include <iterator>

namespace devo_evo
{
namespace
{
struct NamedPart
{
  StudyPart part;
  const char* name;
};

// In the order in which they run: what evolves champions goes before what is about them, and the longest last.
constexpr NamedPart PARTS[] = {
  { StudyPart::MAIN, "main" },
  { StudyPart::PARTIAL, "partial" },
  { StudyPart::REMOVED, "removed" },
  { StudyPart::WALKS, "walks" },
  { StudyPart::LINEAGES, "lineages" },
  { StudyPart::TRACES, "traces" },
  { StudyPart::ROBUSTNESS, "robustness" },
  { StudyPart::IMPACT, "impact" },
  { StudyPart::BASELINES, "baselines" },
  { StudyPart::SWEEP, "sweep" },
  { StudyPart::RIGID, "rigid" },
};

StudyPart parsePart(const std::string& name)
{
  for (const NamedPart& each : PARTS)
  {
    if (name == each.name)
    {
      return each.part;
    }
  }
  throw InvalidInput("a study has no part \"" + name + "\"; its parts are " + toString(studyParts()));
}
}  // namespace

std::string toString(Scale scale)
{
  return scale == Scale::QUICK ? "quick" : scale == Scale::OVERNIGHT ? "overnight" : "paper";
}

Scale parseScale(const std::string& name)
{
  for (const Scale scale : { Scale::QUICK, Scale::OVERNIGHT, Scale::PAPER })
  {
    if (name == toString(scale))
    {
      return scale;
    }
  }
  throw InvalidInput("scale is \"" + name + "\"; it must be quick, overnight or paper");
}

const std::vector<StudyPart>& studyParts()
{
  static const std::vector<StudyPart> parts = []
  {
    std::vector<StudyPart> all;
    for (const NamedPart& each : PARTS)
    {
      all.push_back(each.part);
    }
    return all;
  }();
  return parts;
}

std::string toString(StudyPart part)
{
  return std::find_if(std::begin(PARTS), std::end(PARTS), [=](const NamedPart& each) { return each.part == part; })
      ->name;
}

std::vector<StudyPart> parseStudyParts(const std::string& names)
{
  std::vector<StudyPart> named;
  for (size_t begin = 0, end = 0; !names.empty() && end != std::string::npos; begin = end + 1)
  {
    end = names.find(',', begin);
    named.push_back(parsePart(names.substr(begin, end - begin)));
  }
  std::vector<StudyPart> parts;
  std::copy_if(studyParts().begin(), studyParts().end(), std::back_inserter(parts),
               [&](StudyPart part) { return std::find(named.begin(), named.end(), part) != named.end(); });
  return parts;
}

std::string toString(const std::vector<StudyPart>& parts)
{
  std::string names;
  for (const StudyPart part : parts)
  {
    names += (names.empty() ? "" : ",") + toString(part);
  }
  return names;
}

std::vector<StudyPart> partsOf(const StudySettings& settings)
{
  std::vector<StudyPart> parts = settings.only.empty() ? studyParts() : settings.only;
  if (settings.only.empty())
  {
    parts.erase(std::remove(parts.begin(), parts.end(), StudyPart::PARTIAL), parts.end());
  }
  return parts;
}
}  // namespace devo_evo
