// Files of parameters.

#include "devo_evo/experiment/parameters.h"

#include "fuzz/input.h"

devo_evo::fuzz::Refusal devo_evo::fuzz::handle(const uint8_t* data, size_t size)
{
  static const ScratchFolder folder;
  const std::string path = folder.write("experiment.yaml", data, size);
  Parameters parameters;
  try
  {
    loadParameters(parameters, path);
  }
  catch (const InvalidInput& e)
  {
    return e.what();
  }
  // Whatever is accepted can be written down, and reads back as the same.
  Parameters back;
  for (const ParameterSpec& spec : parameterSpecs())
  {
    const std::string text = spec.get(parameters);
    if (text != spec.get(back))
    {
      spec.set(back, text);
      require(spec.get(back) == text);
    }
  }
  return std::nullopt;
}
