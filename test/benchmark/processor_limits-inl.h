// How fast a processor can be at best, for every pack type. (The compiler would make packs of single doubles.)
#pragma once

#include "benchmark/kernel_parts.h"

#include "soft_body/pack-inl.h"

namespace devo_evo
{
namespace
{
/// Applies an operation to CHAINS numbers, again and again; returns one lane of their sum.
template <int CHAINS, class Real, class Operation>
inline double repeat(int rounds, Operation operation)
{
  Real numbers[CHAINS];
#pragma GCC unroll 12
  for (int i = 0; i < CHAINS; ++i)
  {
    numbers[i] = constant<Real>(1.0 + 0.1 * i);
  }
  for (int round = 0; round < rounds; ++round)
  {
#pragma GCC unroll 12
    for (int i = 0; i < CHAINS; ++i)
    {
      numbers[i] = operation(numbers[i]);
    }
  }
  Real sum = numbers[0];
  for (int i = 1; i < CHAINS; ++i)
  {
    sum = sum + numbers[i];
  }
  double lanes[PackTraits<Real>::LANES];
  std::memcpy(lanes, &sum, sizeof sum);
  return lanes[0];
}

template <int CHAINS, class Real>
double multiplyAdds(int rounds)
{
  const Real factor = constant<Real>(0.75);
  const Real term = constant<Real>(0.5);
  return repeat<CHAINS, Real>(rounds, [&](Real x) { return multiplyAdd(x, factor, term); });
}

template <int CHAINS, class Real>
double divisions(int rounds)
{
  const Real dividend = constant<Real>(3.7);
  return repeat<CHAINS, Real>(rounds, [&](Real x) { return dividend / x; });
}

template <int CHAINS, class Real>
double squareRoots(int rounds)
{
  const Real factor = constant<Real>(1.7);
  return repeat<CHAINS, Real>(rounds, [&](Real x) { return squareRoot(factor * x); });
}

template <class Real>
constexpr ProcessorLimits processorLimits()
{
  constexpr int chains = ProcessorLimits::INDEPENDENT;
  return { PackTraits<Real>::LANES,
           { multiplyAdds<chains, Real>, divisions<chains, Real>, squareRoots<chains, Real> },
           { multiplyAdds<1, Real>, divisions<1, Real>, squareRoots<1, Real> } };
}
}  // namespace
}  // namespace devo_evo
