#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

struct evp_md_ctx_st;

namespace devo_evo
{
/// SHA-256 over a stream of values, each fed in little endian whatever the machine.
class Sha256
{
public:
  Sha256();
  ~Sha256();

  Sha256& add(const void* bytes, size_t count);
  Sha256& add(const std::string& text) { return add(text.data(), text.size()); }
  Sha256& add(uint64_t number);
  Sha256& add(int64_t number) { return add(static_cast<uint64_t>(number)); }
  Sha256& add(double number);

  /// The number of values as a 64-bit integer, then the values.
  Sha256& add(const std::vector<double>& numbers);

  /// The hash. Nothing can be added after it.
  std::array<uint8_t, 32> finish();

private:
  std::unique_ptr<evp_md_ctx_st, void (*)(evp_md_ctx_st*)> context_;
};
}  // namespace devo_evo
