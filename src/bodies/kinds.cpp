#include "devo_evo/bodies/bodies.h"

namespace devo_evo
{
namespace
{
/// What there is to know of a kind before one has its settings.
struct Kind
{
  BodyKind kind;
  const char* name;
  std::shared_ptr<const Body> (*make)(const BodySettings& settings);
};

const Kind KINDS[] = {
  { BodyKind::SOFT, "soft", [](const BodySettings& settings) { return makeSoftBody(settings.soft); } },
  { BodyKind::RIGID, "rigid", [](const BodySettings& settings) { return makeRigidBody(settings.rigid); } },
};

const Kind& find(BodyKind kind)
{
  for (const Kind& each : KINDS)
  {
    if (each.kind == kind)
    {
      return each;
    }
  }
  throw InvalidInput("there is no such kind of body");
}
}  // namespace

std::string toString(BodyKind kind)
{
  return find(kind).name;
}

BodyKind parseBodyKind(const std::string& name)
{
  for (const Kind& each : KINDS)
  {
    if (each.name == name)
    {
      return each.kind;
    }
  }
  throw InvalidInput("body is \"" + name + "\"; it must be " + bodyKindNames());
}

std::string bodyKindNames()
{
  std::string names;
  for (const Kind& each : KINDS)
  {
    names += (names.empty() ? "" : " or ") + std::string(each.name);
  }
  return names;
}

void BodySettings::validate() const
{
  makeBody(*this);
}

std::shared_ptr<const Body> makeBody(const BodySettings& settings)
{
  return find(settings.kind).make(settings);
}

std::map<std::string, uint64_t> engineFingerprints(InstructionSet instruction_set)
{
  std::map<std::string, uint64_t> fingerprints;
  for (const Kind& each : KINDS)
  {
    fingerprints[each.name] = each.make(BodySettings())->engineFingerprint(instruction_set);
  }
  return fingerprints;
}

std::optional<BodyKind> kindWithArray(const std::string& name)
{
  for (const Kind& each : KINDS)
  {
    const GenomeLayout layout = each.make(BodySettings())->layout(EvolutionSettings());
    for (const GenomePart& part : { layout.morphology, layout.control })
    {
      if (name == part.initialName() + part.file_suffix || name == part.finalName() + part.file_suffix)
      {
        return each.kind;
      }
    }
  }
  return std::nullopt;
}

const SoftBodySettings& softSettings(const BodySettings& settings, const std::string& purpose)
{
  if (settings.kind != BodyKind::SOFT)
  {
    throw InvalidInput(purpose + " can have soft bodies only; body is " + toString(settings.kind));
  }
  return settings.soft;
}
}  // namespace devo_evo
