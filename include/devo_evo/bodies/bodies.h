#pragma once

#include "devo_evo/evolution/body.h"
#include "devo_evo/rigid_body/settings.h"
#include "devo_evo/soft_body/settings.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace devo_evo
{
/// The kinds of bodies there are. To add one, see Body.
enum class BodyKind
{
  SOFT,  ///< voxels: the paper's main experiment
  RIGID  ///< the quadruped of Fig S5
};

std::string toString(BodyKind kind);              ///< "soft" or "rigid"
BodyKind parseBodyKind(const std::string& name);  ///< @throw InvalidInput
std::string bodyKindNames();                      ///< for messages and documentation: "soft or rigid"

/// A kind of body, and everything besides the genome that its evaluations depend on. Settings of other kinds are let
/// be.
struct BodySettings
{
  BodyKind kind = BodyKind::SOFT;
  SoftBodySettings soft;
  RigidBodySettings rigid;

  BodySettings() = default;
  explicit BodySettings(const SoftBodySettings& settings) : soft(settings) {}
  explicit BodySettings(const RigidBodySettings& settings) : kind(BodyKind::RIGID), rigid(settings) {}

  /// Of the kind's settings. @throw InvalidInput naming the field, its value and its range.
  void validate() const;
};

/// @throw InvalidInput if the settings are invalid.
std::shared_ptr<const Body> makeBody(const BodySettings& settings);

/// Body::engineFingerprint() of every kind, by its name.
std::map<std::string, uint64_t> engineFingerprints(InstructionSet instruction_set);

/// The kind whose genomes have an array of this name; none if there is no such kind.
std::optional<BodyKind> kindWithArray(const std::string& name);

/// Those of makeBody().
std::shared_ptr<const Body> makeSoftBody(const SoftBodySettings& settings);
std::shared_ptr<const Body> makeRigidBody(const RigidBodySettings& settings);

/// The settings of a soft body. @throw InvalidInput that says what is for soft bodies only if it is another.
/// @param purpose begins the message: "VXA files", "a study".
const SoftBodySettings& softSettings(const BodySettings& settings, const std::string& purpose);
}  // namespace devo_evo
