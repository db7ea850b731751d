// Number types for the kernel: double for one robot, packs of doubles for several in lock-step, with the same
// operations. Every operation is an IEEE-754 one or works on bits, so results are the same in each type. All intrinsics
// stand here. Included once by each kernel_*.cpp; internal linkage keeps code for one instruction set out of the
// others' objects.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace devo_evo
{
namespace
{
// Begins to bring an object into the second-level cache.
template <class Object>
inline void prefetch(const Object& object)
{
  constexpr size_t LINE = 64;  // [bytes]
#pragma GCC unroll 32
  for (size_t offset = 0; offset < sizeof object; offset += LINE)
  {
    __builtin_prefetch(reinterpret_cast<const char*>(&object) + offset, 0, 2);
  }
}

// -a. Fused multiplications and additions take the sign in for nothing; elsewhere it is a pack like others.
template <class Pack>
struct Negated
{
  Pack a;
  operator Pack() const { return flipSign(a); }
};

// ---- double: one robot -------------------------------------------------------------------------------------------
template <class Real>
struct PackTraits;

template <>
struct PackTraits<double>
{
  using Mask = bool;
  static constexpr int LANES = 1;
  static double broadcast(double value) { return value; }
  static Mask maskFromBits(uint32_t bits) { return (bits & 1u) != 0; }
};

inline double multiplyAdd(double a, double b, double c)
{
  return std::fma(a, b, c);
}
inline double squareRoot(double a)
{
  return std::sqrt(a);
}
inline double absolute(double a)
{
  return std::fabs(a);
}
inline double select(bool mask, double if_true, double if_false)
{
  return mask ? if_true : if_false;
}
// Where the comparison is false, also for NaN, the second is taken: the same in each type.
inline double minimum(double a, double b)
{
  return a < b ? a : b;
}
inline double maximum(double a, double b)
{
  return b < a ? a : b;
}
inline uint32_t bits(bool mask)
{
  return mask ? 1u : 0u;
}
inline uint64_t asInteger(double a)
{
  uint64_t integer;
  std::memcpy(&integer, &a, sizeof integer);
  return integer;
}
inline double asReal(uint64_t integer)
{
  double a;
  std::memcpy(&a, &integer, sizeof a);
  return a;
}
// First guess of 1 / sqrt(a), within 3.5 %, from the halved exponent.
inline double inverseSquareRootGuess(double a)
{
  return asReal(0x5FE6EB50C7B537A9u - (asInteger(a) >> 1));
}
// `value` with its sign flipped where the lowest bit of `integer`'s representation is set.
inline double flipSignWhereOdd(double value, double integer)
{
  return asReal(asInteger(value) ^ (asInteger(integer) << 63));
}

#if defined(__AVX512F__)
// ---- eight doubles -----------------------------------------------------------------------------------------------
struct Pack8
{
  __m512d v;
};

struct Mask8
{
  __mmask8 v;
};

template <>
struct PackTraits<Pack8>
{
  using Mask = Mask8;
  static constexpr int LANES = 8;
  static Pack8 broadcast(double value) { return { _mm512_set1_pd(value) }; }
  static Mask maskFromBits(uint32_t bits) { return { static_cast<__mmask8>(bits) }; }
};

inline Pack8 operator+(Pack8 a, Pack8 b)
{
  return { _mm512_add_pd(a.v, b.v) };
}
inline Pack8 operator-(Pack8 a, Pack8 b)
{
  return { _mm512_sub_pd(a.v, b.v) };
}
inline Pack8 operator*(Pack8 a, Pack8 b)
{
  return { _mm512_mul_pd(a.v, b.v) };
}
inline Pack8 operator/(Pack8 a, Pack8 b)
{
  return { _mm512_div_pd(a.v, b.v) };
}
inline Pack8 flipSign(Pack8 a)
{
  return { -a.v };
}
inline Negated<Pack8> operator-(Pack8 a)
{
  return { a };
}
inline Mask8 operator<(Pack8 a, Pack8 b)
{
  return { _mm512_cmp_pd_mask(a.v, b.v, _CMP_LT_OQ) };
}
inline Mask8 operator<=(Pack8 a, Pack8 b)
{
  return { _mm512_cmp_pd_mask(a.v, b.v, _CMP_LE_OQ) };
}
inline Mask8 operator==(Pack8 a, Pack8 b)
{
  return { _mm512_cmp_pd_mask(a.v, b.v, _CMP_EQ_OQ) };
}
inline Mask8 operator&(Mask8 a, Mask8 b)
{
  return { static_cast<__mmask8>(a.v & b.v) };
}
inline Mask8 operator|(Mask8 a, Mask8 b)
{
  return { static_cast<__mmask8>(a.v | b.v) };
}
inline Mask8 operator!(Mask8 a)
{
  return { static_cast<__mmask8>(~a.v) };
}
inline Pack8 multiplyAdd(Pack8 a, Pack8 b, Pack8 c)
{
  return { _mm512_fmadd_pd(a.v, b.v, c.v) };
}
inline Pack8 multiplyAdd(Negated<Pack8> a, Pack8 b, Pack8 c)
{
  return { _mm512_fnmadd_pd(a.a.v, b.v, c.v) };
}
inline Pack8 multiplyAdd(Pack8 a, Pack8 b, Negated<Pack8> c)
{
  return { _mm512_fmsub_pd(a.v, b.v, c.a.v) };
}
inline Pack8 multiplyAdd(Negated<Pack8> a, Pack8 b, Negated<Pack8> c)
{
  return { _mm512_fnmsub_pd(a.a.v, b.v, c.a.v) };
}
inline Pack8 squareRoot(Pack8 a)
{
  return { _mm512_sqrt_pd(a.v) };
}
inline Pack8 absolute(Pack8 a)
{
  return { _mm512_abs_pd(a.v) };
}
inline Pack8 select(Mask8 mask, Pack8 if_true, Pack8 if_false)
{
  return { _mm512_mask_blend_pd(mask.v, if_false.v, if_true.v) };
}
inline Pack8 minimum(Pack8 a, Pack8 b)
{
  return { _mm512_min_pd(a.v, b.v) };
}
inline Pack8 maximum(Pack8 a, Pack8 b)
{
  return { _mm512_max_pd(a.v, b.v) };
}
inline uint32_t bits(Mask8 mask)
{
  return mask.v;
}
inline Pack8 inverseSquareRootGuess(Pack8 a)
{
  const __m512i magic = _mm512_set1_epi64(0x5FE6EB50C7B537A9);
  return { _mm512_castsi512_pd(_mm512_sub_epi64(magic, _mm512_srli_epi64(_mm512_castpd_si512(a.v), 1))) };
}
inline Pack8 flipSignWhereOdd(Pack8 value, Pack8 integer)
{
  const __m512i sign = _mm512_slli_epi64(_mm512_castpd_si512(integer.v), 63);
  return { _mm512_castsi512_pd(_mm512_xor_epi64(_mm512_castpd_si512(value.v), sign)) };
}

#elif defined(__AVX2__)
// ---- four doubles ------------------------------------------------------------------------------------------------
struct Pack4
{
  __m256d v;
};

struct Mask4
{
  __m256d v;  // all bits of a lane set: true
};

template <>
struct PackTraits<Pack4>
{
  using Mask = Mask4;
  static constexpr int LANES = 4;
  static Pack4 broadcast(double value) { return { _mm256_set1_pd(value) }; }
  static Mask maskFromBits(uint32_t bits)
  {
    const __m256i lane_bits = _mm256_set_epi64x(8, 4, 2, 1);
    const __m256i set = _mm256_and_si256(_mm256_set1_epi64x(bits), lane_bits);
    return { _mm256_castsi256_pd(_mm256_cmpeq_epi64(set, lane_bits)) };
  }
};

inline Pack4 operator+(Pack4 a, Pack4 b)
{
  return { _mm256_add_pd(a.v, b.v) };
}
inline Pack4 operator-(Pack4 a, Pack4 b)
{
  return { _mm256_sub_pd(a.v, b.v) };
}
inline Pack4 operator*(Pack4 a, Pack4 b)
{
  return { _mm256_mul_pd(a.v, b.v) };
}
inline Pack4 operator/(Pack4 a, Pack4 b)
{
  return { _mm256_div_pd(a.v, b.v) };
}
inline Pack4 flipSign(Pack4 a)
{
  return { -a.v };
}
inline Negated<Pack4> operator-(Pack4 a)
{
  return { a };
}
inline Mask4 operator<(Pack4 a, Pack4 b)
{
  return { _mm256_cmp_pd(a.v, b.v, _CMP_LT_OQ) };
}
inline Mask4 operator<=(Pack4 a, Pack4 b)
{
  return { _mm256_cmp_pd(a.v, b.v, _CMP_LE_OQ) };
}
inline Mask4 operator==(Pack4 a, Pack4 b)
{
  return { _mm256_cmp_pd(a.v, b.v, _CMP_EQ_OQ) };
}
inline Mask4 operator&(Mask4 a, Mask4 b)
{
  return { _mm256_and_pd(a.v, b.v) };
}
inline Mask4 operator|(Mask4 a, Mask4 b)
{
  return { _mm256_or_pd(a.v, b.v) };
}
inline Mask4 operator!(Mask4 a)
{
  return { _mm256_xor_pd(a.v, _mm256_castsi256_pd(_mm256_set1_epi64x(-1))) };
}
inline Pack4 multiplyAdd(Pack4 a, Pack4 b, Pack4 c)
{
  return { _mm256_fmadd_pd(a.v, b.v, c.v) };
}
inline Pack4 multiplyAdd(Negated<Pack4> a, Pack4 b, Pack4 c)
{
  return { _mm256_fnmadd_pd(a.a.v, b.v, c.v) };
}
inline Pack4 multiplyAdd(Pack4 a, Pack4 b, Negated<Pack4> c)
{
  return { _mm256_fmsub_pd(a.v, b.v, c.a.v) };
}
inline Pack4 multiplyAdd(Negated<Pack4> a, Pack4 b, Negated<Pack4> c)
{
  return { _mm256_fnmsub_pd(a.a.v, b.v, c.a.v) };
}
inline Pack4 squareRoot(Pack4 a)
{
  return { _mm256_sqrt_pd(a.v) };
}
inline Pack4 absolute(Pack4 a)
{
  return { _mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v) };
}
inline Pack4 select(Mask4 mask, Pack4 if_true, Pack4 if_false)
{
  return { _mm256_blendv_pd(if_false.v, if_true.v, mask.v) };
}
inline Pack4 minimum(Pack4 a, Pack4 b)
{
  return { _mm256_min_pd(a.v, b.v) };
}
inline Pack4 maximum(Pack4 a, Pack4 b)
{
  return { _mm256_max_pd(a.v, b.v) };
}
inline uint32_t bits(Mask4 mask)
{
  return static_cast<uint32_t>(_mm256_movemask_pd(mask.v));
}
inline Pack4 inverseSquareRootGuess(Pack4 a)
{
  const __m256i magic = _mm256_set1_epi64x(0x5FE6EB50C7B537A9);
  return { _mm256_castsi256_pd(_mm256_sub_epi64(magic, _mm256_srli_epi64(_mm256_castpd_si256(a.v), 1))) };
}
inline Pack4 flipSignWhereOdd(Pack4 value, Pack4 integer)
{
  const __m256i sign = _mm256_slli_epi64(_mm256_castpd_si256(integer.v), 63);
  return { _mm256_castsi256_pd(_mm256_xor_si256(_mm256_castpd_si256(value.v), sign)) };
}
#endif

// ---- nothing -----------------------------------------------------------------------------------------------------
// A number that is known to be 0, which takes no operations.
struct Nothing
{
};

inline Nothing operator-(Nothing)
{
  return {};
}
template <class Real>
inline auto operator-(Nothing, Real b)
{
  return -b;
}
template <class Real>
inline Real operator-(Real a, Nothing)
{
  return a;
}
template <class Real>
inline Real operator+(Nothing, Real b)
{
  return b;
}
template <class Real>
inline Real operator+(Real a, Nothing)
{
  return a;
}
template <class Mask>
inline Nothing select(Mask, Nothing, Nothing)
{
  return {};
}
template <class Real>
inline Nothing operator*(Real, Nothing)
{
  return {};
}
template <class Real, class Addend>
inline Addend multiplyAdd(Real, Nothing, Addend c)
{
  return c;
}

// ---- for every type ----------------------------------------------------------------------------------------------
template <class Real>
using MaskOf = typename PackTraits<Real>::Mask;

template <class Real>
inline Real constant(double value)
{
  return PackTraits<Real>::broadcast(value);
}

template <class Mask>
inline bool any(Mask mask)
{
  return bits(mask) != 0;
}

template <class Pack>
inline Pack operator-(Negated<Pack> a)
{
  return a.a;
}

template <class Pack, class Addend>
inline Pack multiplyAdd(Pack a, Negated<Pack> b, Addend c)
{
  return multiplyAdd(Negated<Pack>{ a }, b.a, c);
}
}  // namespace
}  // namespace devo_evo
