#include "devo_evo/evolution/individual.h"

#include "devo_evo/soft_body/text.h"

namespace devo_evo
{
std::string individualName(int64_t trial, int64_t id)
{
  return toText(trial) + "/" + toText(id);
}
}  // namespace devo_evo
