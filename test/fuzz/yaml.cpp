// Files of parameters.

#include "devo_evo/experiment/parameters.h"

#include "fuzz/input.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  using namespace devo_evo;
  static const fuzz::ScratchFolder folder;
  const std::string path = folder.write("experiment.yaml", data, size);
  Parameters parameters;
  try
  {
    loadParameters(parameters, path);
  }
  catch (const InvalidInput&)
  {
    return 0;
  }
  // Whatever is accepted can be written down, and reads back as the same.
  Parameters back;
  for (const ParameterSpec& spec : parameterSpecs())
  {
    const std::string text = spec.get(parameters);
    if (text != spec.get(back))
    {
      spec.set(back, text);
      fuzz::require(spec.get(back) == text);
    }
  }
  return 0;
}
