#pragma once

#include "benchmark/counted_parts.h"

#include "soft_body/pack-inl.h"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace devo_evo
{
namespace
{
OperationCounts counts;

/// A pack of doubles that counts what is done with it; results are as those of every other number type.
template <int N>
struct CountedPack
{
  double v[N];
};

template <int N>
struct CountedMask
{
  uint32_t bits;
};

template <int N>
struct PackTraits<CountedPack<N>>
{
  using Mask = CountedMask<N>;
  static constexpr int LANES = N;
  static CountedPack<N> broadcast(double value)
  {
    CountedPack<N> pack;
    for (double& lane : pack.v)
    {
      lane = value;
    }
    return pack;
  }
  static Mask maskFromBits(uint32_t bits) { return { bits & ((1u << N) - 1u) }; }
};

template <int N, class Operation>
inline CountedPack<N> mapLanes(double& count, Operation operation)
{
  ++count;
  CountedPack<N> result;
  for (int lane = 0; lane < N; ++lane)
  {
    result.v[lane] = operation(lane);
  }
  return result;
}

template <int N, class Comparison>
inline CountedMask<N> compareLanes(Comparison comparison)
{
  ++counts.selections;
  CountedMask<N> result = { 0 };
  for (int lane = 0; lane < N; ++lane)
  {
    result.bits |= comparison(lane) ? 1u << lane : 0u;
  }
  return result;
}

template <int N>
inline CountedPack<N> operator+(CountedPack<N> a, CountedPack<N> b)
{
  return mapLanes<N>(counts.simple, [&](int lane) { return a.v[lane] + b.v[lane]; });
}
template <int N>
inline CountedPack<N> operator-(CountedPack<N> a, CountedPack<N> b)
{
  return mapLanes<N>(counts.simple, [&](int lane) { return a.v[lane] - b.v[lane]; });
}
template <int N>
inline CountedPack<N> operator*(CountedPack<N> a, CountedPack<N> b)
{
  return mapLanes<N>(counts.simple, [&](int lane) { return a.v[lane] * b.v[lane]; });
}
template <int N>
inline CountedPack<N> operator/(CountedPack<N> a, CountedPack<N> b)
{
  return mapLanes<N>(counts.divisions, [&](int lane) { return a.v[lane] / b.v[lane]; });
}
template <int N>
inline CountedPack<N> operator-(CountedPack<N> a)
{
  double uncounted = 0;
  return mapLanes<N>(uncounted, [&](int lane) { return -a.v[lane]; });
}
template <int N>
inline CountedMask<N> operator<(CountedPack<N> a, CountedPack<N> b)
{
  return compareLanes<N>([&](int lane) { return a.v[lane] < b.v[lane]; });
}
template <int N>
inline CountedMask<N> operator<=(CountedPack<N> a, CountedPack<N> b)
{
  return compareLanes<N>([&](int lane) { return a.v[lane] <= b.v[lane]; });
}
template <int N>
inline CountedMask<N> operator==(CountedPack<N> a, CountedPack<N> b)
{
  return compareLanes<N>([&](int lane) { return a.v[lane] == b.v[lane]; });
}
template <int N>
inline CountedMask<N> operator&(CountedMask<N> a, CountedMask<N> b)
{
  ++counts.selections;
  return { a.bits & b.bits };
}
template <int N>
inline CountedMask<N> operator|(CountedMask<N> a, CountedMask<N> b)
{
  ++counts.selections;
  return { a.bits | b.bits };
}
template <int N>
inline CountedMask<N> operator!(CountedMask<N> a)
{
  ++counts.selections;
  return { ~a.bits & ((1u << N) - 1u) };
}
template <int N>
inline CountedPack<N> multiplyAdd(CountedPack<N> a, CountedPack<N> b, CountedPack<N> c)
{
  return mapLanes<N>(counts.multiply_adds, [&](int lane) { return std::fma(a.v[lane], b.v[lane], c.v[lane]); });
}
template <int N>
inline CountedPack<N> squareRoot(CountedPack<N> a)
{
  return mapLanes<N>(counts.square_roots, [&](int lane) { return std::sqrt(a.v[lane]); });
}
template <int N>
inline CountedPack<N> absolute(CountedPack<N> a)
{
  return mapLanes<N>(counts.selections, [&](int lane) { return std::fabs(a.v[lane]); });
}
template <int N>
inline CountedPack<N> select(CountedMask<N> mask, CountedPack<N> if_true, CountedPack<N> if_false)
{
  return mapLanes<N>(counts.selections,
                     [&](int lane) { return (mask.bits >> lane & 1u) != 0 ? if_true.v[lane] : if_false.v[lane]; });
}
template <int N>
inline CountedPack<N> minimum(CountedPack<N> a, CountedPack<N> b)
{
  return mapLanes<N>(counts.simple, [&](int lane) { return minimum(a.v[lane], b.v[lane]); });
}
template <int N>
inline CountedPack<N> maximum(CountedPack<N> a, CountedPack<N> b)
{
  return mapLanes<N>(counts.simple, [&](int lane) { return maximum(a.v[lane], b.v[lane]); });
}
template <int N>
inline uint32_t bits(CountedMask<N> mask)
{
  return mask.bits;
}
template <int N>
inline CountedPack<N> inverseSquareRootGuess(CountedPack<N> a)
{
  ++counts.selections;  // a shift and a subtraction
  return mapLanes<N>(counts.selections, [&](int lane) { return inverseSquareRootGuess(a.v[lane]); });
}
template <int N>
inline CountedPack<N> flipSignWhereOdd(CountedPack<N> value, CountedPack<N> integer)
{
  ++counts.selections;  // a shift and an exclusive or
  return mapLanes<N>(counts.selections, [&](int lane) { return flipSignWhereOdd(value.v[lane], integer.v[lane]); });
}
}  // namespace
}  // namespace devo_evo
