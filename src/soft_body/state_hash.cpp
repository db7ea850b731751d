#include "state_hash.h"

namespace devo_evo
{
void StateHash::add(bool flag)
{
  const uint8_t byte = flag ? 1 : 0;
  sha_.add(&byte, 1);
}

uint64_t StateHash::finish()
{
  const std::array<uint8_t, 32> hash = sha_.finish();
  uint64_t value = 0;
  for (size_t i = 0; i < 8; ++i)
  {
    value = value << 8 | hash[i];
  }
  return value;
}
}  // namespace devo_evo
