#include "devo_evo/evolution/random.h"

#include "evolution/portable_math.h"
#include "soft_body/sha256.h"

#include <Random123/philox.h>

#include <algorithm>
#include <cmath>

namespace devo_evo
{
namespace
{
/// First eight bytes of SHA-256 of the text, as a little-endian integer.
uint64_t hashOf(const std::string& text)
{
  const std::array<uint8_t, 32> bytes = Sha256().add(text).finish();
  uint64_t hash = 0;
  for (int i = 7; i >= 0; --i)
  {
    hash = hash << 8 | bytes[static_cast<size_t>(i)];
  }
  return hash;
}
}  // namespace

RandomStream::RandomStream(int64_t seed, const std::string& arm, int64_t trial, int64_t generation, int64_t individual,
                           RandomPurpose purpose)
  : key_{ static_cast<uint64_t>(seed), hashOf(arm) }
  , counter_{ static_cast<uint64_t>(trial), static_cast<uint64_t>(generation), static_cast<uint64_t>(individual),
              static_cast<uint64_t>(purpose) << 32 }
{
}

uint64_t RandomStream::bits()
{
  if (used_ == BLOCK_SIZE)
  {
    const r123::Philox4x64::ctr_type counter = { { counter_[0], counter_[1], counter_[2], counter_[3] } };
    const r123::Philox4x64::key_type key = { { key_[0], key_[1] } };
    const r123::Philox4x64::ctr_type block = r123::Philox4x64()(counter, key);
    std::copy(block.begin(), block.end(), block_.begin());
    ++counter_[BLOCK_SIZE - 1];
    used_ = 0;
  }
  return block_[used_++];
}

double RandomStream::uniform()
{
  return static_cast<double>(bits() >> 11) * 0x1p-53;
}

double RandomStream::uniform(double low, double high)
{
  const double value = low + (high - low) * uniform();
  return value < high ? value : std::nextafter(high, low);  // rounding may reach the bound
}

double RandomStream::normal()
{
  // The lowest bit is the sign, the upper 52 are a probability in (0, 1/2): symmetric, and with fine tails.
  const uint64_t random_bits = bits();
  const double p = (static_cast<double>(random_bits >> 12) + 0.5) * 0x1p-53;
  const double z = lowerNormalQuantile(p);
  return random_bits & 1 ? -z : z;
}

uint64_t RandomStream::below(uint64_t bound)
{
  // 2^64 mod bound values too many for each remainder to be equally frequent are drawn again.
  const uint64_t surplus = -bound % bound;
  uint64_t random_bits = bits();
  while (random_bits < surplus)
  {
    random_bits = bits();
  }
  return random_bits % bound;
}
}  // namespace devo_evo
