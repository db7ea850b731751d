// One value of one parameter, as launch files, command lines and the parameter server give it: the first byte chooses
// the parameter, the second the type of the value, the rest is the value. A first byte of 255 makes the rest a name.

#include "devo_evo/experiment/parameters.h"
#include "fuzz/input.h"

#include <algorithm>
#include <cstring>

namespace
{
using namespace devo_evo;

template <class Number>
Number numberFrom(const uint8_t* data, size_t size)
{
  Number number{};
  std::memcpy(&number, data, std::min(size, sizeof(number)));
  return number;
}

ParameterValue valueFrom(uint8_t type, const uint8_t* data, size_t size)
{
  switch (type % 5)
  {
    case 0:
      return std::string(reinterpret_cast<const char*>(data), size);
    case 1:
      return size > 0 && data[0] % 2 == 1;
    case 2:
      return numberFrom<int64_t>(data, size);
    case 3:
      return numberFrom<double>(data, size);
    default:
      std::vector<int64_t> list;
      for (; size >= sizeof(int64_t); data += sizeof(int64_t), size -= sizeof(int64_t))
      {
        list.push_back(numberFrom<int64_t>(data, size));
      }
      return list;
  }
}

void setOne(const ParameterSpec& spec, const ParameterValue& value)
{
  Parameters parameters;
  spec.set(parameters, value);
  // Whatever is accepted can be written down, and reads back as the same.
  const std::string text = spec.get(parameters);
  Parameters back;
  if (text != spec.get(back))
  {
    spec.set(back, text);
  }
  fuzz::require(spec.get(back) == text);
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  constexpr uint8_t NAME = 255;
  if (size < 2)
  {
    return 0;
  }
  const auto& specs = parameterSpecs();
  try
  {
    if (data[0] == NAME)
    {
      parameterSpec(std::string(reinterpret_cast<const char*>(data + 1), size - 1));
    }
    else
    {
      setOne(specs[data[0] % specs.size()], valueFrom(data[1], data + 2, size - 2));
    }
  }
  catch (const InvalidInput&)
  {
  }
  return 0;
}
