// Lets libFuzzer drive a fuzz target.

#include "fuzz/input.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  devo_evo::fuzz::handle(data, size);
  return 0;
}
