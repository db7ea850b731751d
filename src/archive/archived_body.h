#pragma once

#include "devo_evo/bodies/bodies.h"
#include "devo_evo/experiment/settings.h"

#include <memory>

namespace devo_evo
{
/// The body of an experiment, and what its genomes look like.
struct ArchivedBody
{
  explicit ArchivedBody(const ExperimentSettings& settings)
    : body(makeBody(settings.body)), layout(body->layout(settings.evolution))
  {
  }

  std::shared_ptr<const Body> body;
  GenomeLayout layout;
};
}  // namespace devo_evo
