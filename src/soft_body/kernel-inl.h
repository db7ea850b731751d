// One time step of the soft-body model, written once for every number type of pack-inl.h. Equations: docs/physics.md.
//
//   Symbol           Meaning                                                       Unit    Frame
//   r                from voxel 1 to voxel 2 of a bond                             m       world; r' in the bond frame
//   q                orientation of a voxel, body to world                         1
//   X, Y, Z          axes of voxel 1's body, renamed so that X is the bond's       1       world
//   n                orientation of voxel 2 relative to voxel 1                    1       bond frame
//   u                shortest turn of r' onto the bond's axis                      1       bond frame
//   d, alpha_1/2     what deforms the bond: displacement, rotations of its ends    m, rad  turned bond frame
//   F, M_1, M_2      force on voxel 1, moments of both ends                        N, N m  turned bond frame, then
//   world
//
// The turned bond frame has its x axis along r (large-angle regime) or along X (small-angle regime).
#pragma once

#include "kernel.h"
#include "pack-inl.h"

#include <type_traits>

namespace devo_evo
{
namespace
{
template <class Real>
struct Vector
{
  Real x, y, z;
};

template <class Real>
struct Quaternion
{
  Real w, x, y, z;
};

template <class Real>
inline Vector<Real> operator+(const Vector<Real>& a, const Vector<Real>& b)
{
  return { a.x + b.x, a.y + b.y, a.z + b.z };
}

template <class Real>
inline Vector<Real> operator-(const Vector<Real>& a, const Vector<Real>& b)
{
  return { a.x - b.x, a.y - b.y, a.z - b.z };
}

template <class Real>
inline Vector<Real> operator*(Real a, const Vector<Real>& b)
{
  return { a * b.x, a * b.y, a * b.z };
}

// In whatever form the number type negates, like the numbers themselves: products take it in for nothing.
template <class Real>
inline auto operator-(const Vector<Real>& a) -> Vector<decltype(-a.x)>
{
  return { -a.x, -a.y, -a.z };
}

template <class Real, class Other>
inline Real dot(const Vector<Real>& a, const Vector<Other>& b)
{
  return multiplyAdd(a.z, b.z, multiplyAdd(a.y, b.y, a.x * b.x));
}

template <class Real>
inline Vector<Real> cross(const Vector<Real>& a, const Vector<Real>& b)
{
  return { multiplyAdd(a.y, b.z, -(a.z * b.y)), multiplyAdd(a.z, b.x, -(a.x * b.z)),
           multiplyAdd(a.x, b.y, -(a.y * b.x)) };
}

// a * b + c
template <class Factor, class Other, class Real>
inline auto multiplyAdd(Factor a, const Vector<Other>& b, const Vector<Real>& c)
    -> Vector<decltype(multiplyAdd(a, b.x, c.x))>
{
  return { multiplyAdd(a, b.x, c.x), multiplyAdd(a, b.y, c.y), multiplyAdd(a, b.z, c.z) };
}

template <class Real>
inline Vector<Real> select(MaskOf<Real> mask, const Vector<Real>& if_true, const Vector<Real>& if_false)
{
  return { select(mask, if_true.x, if_false.x), select(mask, if_true.y, if_false.y),
           select(mask, if_true.z, if_false.z) };
}

// The state of a voxel and what a bond remembers, as kernel.h's VoxelField and BondField lay them out.
template <class Real>
struct Voxel
{
  Vector<Real> position;
  Quaternion<Real> orientation;
  Vector<Real> momentum;
  Vector<Real> angular_momentum;
  Real scale;
  Real size_at_birth;
  Real size_change;
  Real phase_at_birth;
  Real phase_change;
};

template <class Real>
struct BondMemory
{
  Real stretch;
  Real twist;
  Real sum_y, sum_z;
  Real angle_1_y, angle_1_z;
};

template <class Real>
struct SidewaysMemory
{
  Real y, z;
};

// What acts on a voxel, as far as it has been added up.
template <class Real>
struct Load
{
  Vector<Real> force;
  Vector<Real> moment;
};

// ---- functions of one number -------------------------------------------------------------------------------------

// The polynomial of x with N terms, from the constant upwards. Neighbouring terms are joined, and the pairs are a
// polynomial of x^2 (Estrin's scheme): a shorter chain of dependent operations than Horner's rule.
template <int N, class Real>
inline Real joinTerms(const Real (&terms)[N], Real x)
{
  if constexpr (N == 1)
  {
    return terms[0];
  }
  else
  {
    Real joined[(N + 1) / 2];
#pragma GCC unroll 8
    for (int i = 0; i < N / 2; ++i)
    {
      joined[i] = multiplyAdd(terms[2 * i + 1], x, terms[2 * i]);
    }
    if constexpr (N % 2 == 1)
    {
      joined[N / 2] = terms[N - 1];
    }
    return joinTerms<(N + 1) / 2>(joined, x * x);
  }
}

template <class Real, class... Coefficients>
inline Real polynomial(Real x, Coefficients... coefficients)
{
  const Real terms[] = { constant<Real>(coefficients)... };
  return joinTerms<sizeof...(coefficients)>(terms, x);
}

// 1 / sqrt(a) for normal a > 0, to within two units in the last place: a guess from the exponent, then two corrections
// by 1 / sqrt(1 - error), a polynomial for the guess's errors, below 0.07, and a binomial series. Much cheaper than a
// square root and a division.
template <class Real>
inline Real inverseSquareRoot(Real a)
{
  const Real one = constant<Real>(1.0);
  const Real guess = inverseSquareRootGuess(a);
  const Real error = multiplyAdd(-(a * guess), guess, one);
  const Real series = polynomial(error, 0.5000008238580428, 0.3760587519451833, 0.3128519513491328);
  const Real better = multiplyAdd(guess * error, series, guess);
  const Real rest = multiplyAdd(-(a * better), better, one);
  return multiplyAdd(better * rest, polynomial(rest, 0.5, 0.375), better);
}

// The same for the square of a length that was 1 and has hardly changed: a binomial series up to 1.0001.
template <class Real>
inline Real inverseSquareRootNearOne(Real a)
{
  Real result = polynomial(constant<Real>(1.0) - a, 1.0, 0.5, 0.375, 0.3125);
  const auto wide = constant<Real>(1.0001) < a;
  if (any(wide))
  {
    result = select(wide, inverseSquareRoot(a), result);
  }
  return result;
}

// 1 / cos(angle / 2), given 1 - cos(angle), the versine: a polynomial up to angles of 37 degrees.
template <class Real>
inline Real inverseHalfAngleCosine(Real versine)
{
  Real result = polynomial(versine, 1.0, 0.2500000000000372, 0.09374999999256141, 0.039062500511397244,
                           0.0170898265596367, 0.007690755365506341, 0.003521074412880395, 0.0016622420443315699,
                           0.0006613564230798821, 0.0005916273966653307);
  const auto wide = constant<Real>(0.2) < versine;
  if (any(wide))
  {
    const Real half_angle_cosine_square = multiplyAdd(constant<Real>(-0.5), versine, constant<Real>(1.0));
    result = select(wide, inverseSquareRoot(half_angle_cosine_square), result);
  }
  return result;
}

// sin(angle) for |angle| < 1e5.
template <class Real>
inline Real sine(Real angle)
{
  const Real round =
      constant<Real>(6755399441055744.0);  // adding 1.5 * 2^52 leaves the nearest integer in the last bits
  const Real shifted = multiplyAdd(angle, constant<Real>(0.3183098861837907), round);
  const Real half_turns = shifted - round;
  Real rest = multiplyAdd(-half_turns, constant<Real>(3.141592653589793), angle);
  rest = multiplyAdd(-half_turns, constant<Real>(1.2246467991473532e-16), rest);
  const Real square = rest * rest;
  const Real series =
      polynomial(square, -0.16666666666666666, 0.008333333333333316, -0.00019841269841254885, 2.7557319219139183e-06,
                 -2.505210761393476e-08, 1.6058977114074673e-10, -7.643963965925357e-13, 2.731365867494017e-15);
  return flipSignWhereOdd(multiplyAdd(rest * square, series, rest), shifted);
}

// 2 acos(w) / sqrt(1 - w^2) for w >= 0.92, as a polynomial of 1 - w.
template <class Real>
inline Real exactRotationFactorOfSmallAngle(Real one_minus_w)
{
  return polynomial(one_minus_w, 2.0, 0.6666666666668197, 0.26666666661791355, 0.11428571953090196,
                    0.050793383780907725, 0.023095269374810327, 0.010548600007417785, 0.005785532478125603);
}

// The same for w >= 0.7.
template <class Real>
inline Real exactRotationFactor(Real one_minus_w)
{
  return polynomial(one_minus_w, 2.0, 0.6666666666666852, 0.26666666666373984, 0.11428571446697104, 0.05079364500961642,
                    0.023088131637814254, 0.010654724698679948, 0.004982773474680468, 0.0022890671466164188,
                    0.0012786552891562919, 0.00017931719426897763, 0.0006311574300998297);
}

// The same for w < 0.7, with acos(w) = 2 acos(h) for h = sqrt((1 + w) / 2), once or twice.
template <class Real>
inline Real exactRotationFactorOfLargeAngle(Real w)
{
  const Real half = constant<Real>(0.5);
  const Real one = constant<Real>(1.0);
  const Real once = squareRoot(multiplyAdd(half, w, half));
  const Real twice = squareRoot(multiplyAdd(half, once, half));
  const auto once_is_enough = constant<Real>(0.7) <= once;
  const Real divisor = select(once_is_enough, once, once * twice);
  return exactRotationFactor(one - select(once_is_enough, once, twice)) / divisor;
}

// What turns a unit quaternion's vector part into its rotation vector, physics.md 2.2, with the reference's
// approximation 2 sqrt(2 / (1 + w)) for w > 0.9988, and its 0 for w^2 >= 1.
template <class Real>
inline Real rotationFactor(Real w)
{
  const Real one = constant<Real>(1.0);
  const Real one_minus_w = one - w;
  const Real approximation =
      polynomial(one_minus_w, 2.0, 0.4999999999999957, 0.18750000002643719, 0.07812494306622025, 0.0342297237319617);
  Real factor = select(constant<Real>(0.9988) < w, approximation, exactRotationFactorOfSmallAngle(one_minus_w));
  const auto wide = w < constant<Real>(0.92);
  if (any(wide))
  {
    factor = select(wide, exactRotationFactor(one_minus_w), factor);
    const auto far = w < constant<Real>(0.7);
    if (any(far))
    {
      const auto turned = constant<Real>(-1.0) < w;
      factor = select(far & turned, exactRotationFactorOfLargeAngle(w), factor);
      factor = select(turned, factor, constant<Real>(0.0));
    }
  }
  return select(w < one, factor, constant<Real>(0.0));
}

// ---- bonds -------------------------------------------------------------------------------------------------------

template <class Real>
struct Axes
{
  Vector<Real> x, y, z;
};

// The body axes in the world: the columns of the rotation matrix of q.
template <class Real>
inline Axes<Real> bodyAxes(const Quaternion<Real>& q)
{
  const Real one = constant<Real>(1.0);
  const Real x2 = q.x + q.x;
  const Real y2 = q.y + q.y;
  const Real z2 = q.z + q.z;
  const Real wx = q.w * x2;
  const Real wy = q.w * y2;
  const Real wz = q.w * z2;
  const Real one_minus_xx = multiplyAdd(-q.x, x2, one);
  const Real one_minus_zz = multiplyAdd(-q.z, z2, one);
  return { { multiplyAdd(-q.y, y2, one_minus_zz), multiplyAdd(q.x, y2, wz), multiplyAdd(q.x, z2, -wy) },
           { multiplyAdd(q.x, y2, -wz), multiplyAdd(-q.x, x2, one_minus_zz), multiplyAdd(q.y, z2, wx) },
           { multiplyAdd(q.x, z2, wy), multiplyAdd(q.y, z2, -wx), multiplyAdd(-q.y, y2, one_minus_xx) } };
}

// The axes of the body, renamed so that X is the bond's (physics.md 2.1).
template <int AXIS, class Real>
inline const Vector<Real>& bondX(const Axes<Real>& body)
{
  return AXIS == 0 ? body.x : AXIS == 1 ? body.y : body.z;
}

template <int AXIS, class Real>
inline decltype(auto) bondY(const Axes<Real>& body)
{
  if constexpr (AXIS == 1)
  {
    return -body.x;
  }
  else
  {
    return (body.y);
  }
}

template <int AXIS, class Real>
inline decltype(auto) bondZ(const Axes<Real>& body)
{
  if constexpr (AXIS == 2)
  {
    return -body.x;
  }
  else
  {
    return (body.z);
  }
}

// Conjugate of a times b, with the vector part in the bond's axes.
template <int AXIS, class Real>
inline Quaternion<Real> relativeOrientation(const Quaternion<Real>& a, const Quaternion<Real>& b)
{
  const Real w = multiplyAdd(a.z, b.z, multiplyAdd(a.y, b.y, multiplyAdd(a.x, b.x, a.w * b.w)));
  const Real x = multiplyAdd(a.z, b.y, multiplyAdd(-a.y, b.z, multiplyAdd(-a.x, b.w, a.w * b.x)));
  const Real y = multiplyAdd(a.x, b.z, multiplyAdd(-a.z, b.x, multiplyAdd(-a.y, b.w, a.w * b.y)));
  const Real z = multiplyAdd(a.y, b.x, multiplyAdd(-a.x, b.y, multiplyAdd(-a.z, b.w, a.w * b.z)));
  if constexpr (AXIS == 0)
  {
    return { w, x, y, z };
  }
  else if constexpr (AXIS == 1)
  {
    return { w, y, -x, z };
  }
  else
  {
    return { w, z, y, -x };
  }
}

// A turn without a component about x.
template <class Real>
struct Turn
{
  Real w, y, z;
};

// The product of a turn and a quaternion.
template <class Real>
inline Quaternion<Real> operator*(const Turn<Real>& u, const Quaternion<Real>& n)
{
  return { multiplyAdd(-u.z, n.z, multiplyAdd(-u.y, n.y, u.w * n.w)),
           multiplyAdd(-u.z, n.y, multiplyAdd(u.y, n.z, u.w * n.x)),
           multiplyAdd(u.z, n.x, multiplyAdd(u.y, n.w, u.w * n.y)),
           multiplyAdd(-u.y, n.x, multiplyAdd(u.z, n.w, u.w * n.z)) };
}

// Remembers each robot's first, that is lowest, diverged bond of this step.
inline void reportDivergence(BatchState& state, uint32_t diverged, int bond, const double* strains)
{
  for (int lane = 0; lane < MAX_LANES; ++lane)
  {
    const uint32_t bit = 1u << lane;
    if ((diverged & ~state.diverged & bit) != 0)
    {
      state.diverged_bond[lane] = bond;
      state.diverged_strain[lane] = strains[lane];
    }
  }
  state.diverged |= diverged;
}

// The turned bond frame: its x and y axes in the world, and the turn of r' onto its x axis.
template <class Real>
struct BondFrame
{
  Turn<Real> u;
  Vector<Real> x;
  Vector<Real> y;
};

template <class Real>
inline BondFrame<Real> select(MaskOf<Real> mask, const BondFrame<Real>& a, const BondFrame<Real>& b)
{
  return { { select(mask, a.u.w, b.u.w), select(mask, a.u.y, b.u.y), select(mask, a.u.z, b.u.z) },
           select<Real>(mask, a.x, b.x),
           select<Real>(mask, a.y, b.y) };
}

// A bond on its way through the stages of a step.
template <class Real>
struct Bond
{
  int number;
  int axis;
  uint32_t switched;  // bit l: lane l's bond changed its regime in this step
  uint32_t small;     // bit l: lane l's bond is in the small-angle regime
  uint32_t sideways;  // bit l: lane l's bond is in the small-angle regime, or remembers that
  BondFrame<Real> frame;
  Quaternion<Real> n;
  Vector<Real> d;
  Real twist;         // alpha_2x
  Real sum_y, sum_z;  // of alpha_1 and alpha_2
  Real a1_y, a1_z;    // alpha_1
};

// Whether the ends are aligned well enough for the small-angle regime.
template <class Real>
inline MaskOf<Real> mayBecomeSmall(Real n_w)
{
  constexpr double enter_cosine = 0.9999625024343469;  // cos(theta_s / 2)
  return constant<Real>(enter_cosine) < n_w;
}

// Which robots' bonds are in the small-angle regime, with hysteresis (2.2).
template <class Real>
inline MaskOf<Real> smallAngleRegime(const BodyModel& model, MaskOf<Real> was_small, const Vector<Real>& r, Real n_w,
                                     Real rest)
{
  using Mask = MaskOf<Real>;
  constexpr double leave_cosine = 0.9999546280051071;  // cos(1.1 theta_s / 2)
  Mask inside = mayBecomeSmall(n_w) & (r.x < constant<Real>(1.3) * rest);
  Mask outside = (n_w <= constant<Real>(leave_cosine)) | (constant<Real>(1.1 * 1.3) * rest < r.x);
  if (model.sideways_bend_test)
  {
    const Real sideways = absolute(r.y) + absolute(r.z);
    inside = inside & (sideways < constant<Real>(0.05) * r.x);
    outside = outside | (constant<Real>(1.1 * 0.05) * r.x < sideways);
  }
  return (was_small & !outside) | ((!was_small) & inside);
}

// The large-angle regime's frame, turned by the shortest arc: half-angle formulas, and Rodrigues' formula for y (7).
template <int AXIS, class Real>
inline BondFrame<Real> shortestTurn(const Axes<Real>& body_axes_1, const Vector<Real>& r_world, const Vector<Real>& r,
                                    Real inverse_length)
{
  const Real one = constant<Real>(1.0);
  const Real half = constant<Real>(0.5);
  const Real versine = multiplyAdd(-r.x, inverse_length, one);  // 1 - cos of the angle
  const Real inverse_half_angle_cosine = inverseHalfAngleCosine(versine);
  const Real scaling = half * inverse_length * inverse_half_angle_cosine;
  const Turn<Real> u = { multiplyAdd(-half, versine, one) * inverse_half_angle_cosine, r.z * scaling,
                         -(r.y * scaling) };
  const Vector<Real> x = inverse_length * r_world;
  const Real tilt = u.z * inverse_half_angle_cosine;
  return { u, x, multiplyAdd(tilt, bondX<AXIS>(body_axes_1) + x, bondY<AXIS>(body_axes_1)) };
}

// The same where the bond is nearly straight: the reference's first-order turn, and the axes that it turns (2.2, 7).
template <int AXIS, class Real>
inline BondFrame<Real> firstOrderTurn(const Axes<Real>& body_axes_1, const Vector<Real>& r_world, const Vector<Real>& r,
                                      Real inverse_length)
{
  const Real one = constant<Real>(1.0);
  const Real half = constant<Real>(0.5);
  const Real cosine = r.x * inverse_length;
  const Real sine_square = multiplyAdd(-cosine, cosine, one);  // so small that a series does for a division
  const Real inverse_x = inverse_length * cosine * polynomial(sine_square, 1.0, 1.0, 1.0, 1.0, 1.0);
  const Real y = r.z * (half * inverse_x);
  const Real z = -(r.y * (half * inverse_x));
  const Real square = multiplyAdd(y, y, z * z);
  const Real w = multiplyAdd(-half, square, one);
  const Vector<Real>& x = bondX<AXIS>(body_axes_1);
  return { { w, y, z },
           multiplyAdd(constant<Real>(-1.5) * square, x, (w * inverse_x) * r_world),
           multiplyAdd(z, multiplyAdd(one - square, x, inverse_x * r_world), bondY<AXIS>(body_axes_1)) };
}

// The small-angle regime's frame: voxel 1's own.
template <int AXIS, class Real>
inline BondFrame<Real> noTurn(const Axes<Real>& body_axes_1)
{
  const auto& y = bondY<AXIS>(body_axes_1);
  return { { constant<Real>(1.0), constant<Real>(0.0), constant<Real>(0.0) },
           bondX<AXIS>(body_axes_1),
           { y.x, y.y, y.z } };
}

// First stage: how the bond is deformed, and the turned frame (2.1, 2.2).
template <int AXIS, class Real>
inline void deform(const BodyModel& model, const Axes<Real>& body_axes_1, const Voxel<Real>& voxel_1,
                   const Voxel<Real>& voxel_2, BatchState& state, Bond<Real>& bond)
{
  using Mask = MaskOf<Real>;
  const Real half = constant<Real>(0.5);
  const Real zero = constant<Real>(0.0);
  constexpr double theta_s = 0.01732;

  const Vector<Real> r_world = voxel_2.position - voxel_1.position;
  const Vector<Real> r = { dot(r_world, bondX<AXIS>(body_axes_1)), dot(r_world, bondY<AXIS>(body_axes_1)),
                           dot(r_world, bondZ<AXIS>(body_axes_1)) };
  const Real rest = half * (voxel_1.scale + voxel_2.scale);
  const Quaternion<Real> n = relativeOrientation<AXIS>(voxel_1.orientation, voxel_2.orientation);
  const uint32_t was_small_bits = state.small_angle[bond.number];
  const uint32_t was_sideways = state.was_sideways[bond.number];
  uint32_t small_bits = 0;
  Mask is_small = PackTraits<Real>::maskFromBits(0);
  if ((bits(mayBecomeSmall(n.w)) | was_small_bits | was_sideways) != 0)
  {
    is_small = smallAngleRegime(model, PackTraits<Real>::maskFromBits(was_small_bits), r, n.w, rest);
    small_bits = bits(is_small);
    state.small_angle[bond.number] = static_cast<uint8_t>(small_bits);
    bond.d.y = select(is_small, r.y, zero);
    bond.d.z = select(is_small, r.z, zero);
  }
  bond.n = n;
  bond.small = small_bits;
  bond.switched = was_small_bits ^ small_bits;
  bond.sideways = was_sideways | small_bits;

  const Real square = dot(r_world, r_world);
  const Real inverse_length = inverseSquareRoot(square);
  Real stretch = multiplyAdd(square, inverse_length, -rest);
  BondFrame<Real> frame = shortestTurn<AXIS>(body_axes_1, r_world, r, inverse_length);
  const Real bound = constant<Real>(theta_s) * absolute(r.x);
  const Mask nearly_straight = (absolute(r.y) < bound) & (absolute(r.z) < bound) & !is_small;
  if (any(nearly_straight))
  {
    frame = select<Real>(nearly_straight, firstOrderTurn<AXIS>(body_axes_1, r_world, r, inverse_length), frame);
  }
  if (small_bits != 0)
  {
    frame = select<Real>(is_small, noTurn<AXIS>(body_axes_1), frame);
    stretch = select(is_small, r.x - rest, stretch);
  }
  bond.d.x = stretch;
  bond.frame = frame;
}

// Second stage: rotation vectors of both ends in the turned frame (2.2); that of end 1 has no x component.
template <class Real>
inline void rotateEnds(Bond<Real>& bond)
{
  const Real factor_1 = rotationFactor(bond.frame.u.w);
  bond.a1_y = bond.frame.u.y * factor_1;
  bond.a1_z = bond.frame.u.z * factor_1;
  const Quaternion<Real> end_2 = bond.frame.u * bond.n;
  const Real factor_2 = rotationFactor(end_2.w);
  bond.twist = end_2.x * factor_2;
  bond.sum_y = multiplyAdd(end_2.y, factor_2, bond.a1_y);
  bond.sum_z = multiplyAdd(end_2.z, factor_2, bond.a1_z);
}

template <class Real>
inline void checkDivergence(const BodyModel& model, const Bond<Real>& bond, BatchState& state)
{
  const MaskOf<Real> diverged = !(bond.d.x <= constant<Real>(100.0 * model.nominal_size));
  if (any(diverged))
  {
    const Real strain = bond.d.x / constant<Real>(model.nominal_size);
    double strains[MAX_LANES] = {};
    std::memcpy(strains, &strain, sizeof strain);
    reportDivergence(state, bits(diverged), bond.number, strains);
  }
}

// How a bond is deformed, as bonds remember it. Sideways displacements are Nothing where no lane has or remembers any.
template <class Real, class Sideways>
struct Deformation
{
  Real d_x;
  Sideways d_y, d_z;
  Real twist;         // alpha_2x
  Real sum_y, sum_z;  // of alpha_1 and alpha_2
  Real a1_y, a1_z;    // alpha_1
};

template <class Real, class Sideways>
inline Deformation<Real, Sideways> select(MaskOf<Real> mask, const Deformation<Real, Sideways>& a,
                                          const Deformation<Real, Sideways>& b)
{
  return { select(mask, a.d_x, b.d_x),     select(mask, a.d_y, b.d_y),     select(mask, a.d_z, b.d_z),
           select(mask, a.twist, b.twist), select(mask, a.sum_y, b.sum_y), select(mask, a.sum_z, b.sum_z),
           select(mask, a.a1_y, b.a1_y),   select(mask, a.a1_z, b.a1_z) };
}

// The bonds' memories.
template <class Real>
struct Memories
{
  BondMemory<Real>* regular;
  SidewaysMemory<Real>* sideways;
  uint8_t* was_sideways;
};

template <class Real>
inline Memories<Real> memoriesOf(const BatchState& state)
{
  return { reinterpret_cast<BondMemory<Real>*>(state.bonds), reinterpret_cast<SidewaysMemory<Real>*>(state.sideways),
           state.was_sideways };
}

template <class Sideways, class Real>
inline Deformation<Real, Sideways> recall(const Memories<Real>& memories, int bond)
{
  const BondMemory<Real>& m = memories.regular[bond];
  if constexpr (std::is_same_v<Sideways, Nothing>)
  {
    return { m.stretch, {}, {}, m.twist, m.sum_y, m.sum_z, m.angle_1_y, m.angle_1_z };
  }
  else
  {
    const SidewaysMemory<Real>& sideways = memories.sideways[bond];
    return { m.stretch, sideways.y, sideways.z, m.twist, m.sum_y, m.sum_z, m.angle_1_y, m.angle_1_z };
  }
}

template <class Real, class Sideways>
inline void remember(const Deformation<Real, Sideways>& now, const Memories<Real>& memories, int bond)
{
  memories.regular[bond] = { now.d_x, now.twist, now.sum_y, now.sum_z, now.a1_y, now.a1_z };
  if constexpr (!std::is_same_v<Sideways, Nothing>)
  {
    memories.sideways[bond] = { now.d_y, now.d_z };
  }
}

// The deformation whose change up to now is damped: that of the last step that was not a switch step, or this one's
// where nothing is damped. Remembers anew.
template <class Real, class Sideways>
inline Deformation<Real, Sideways> dampedSince(bool first_step, const Bond<Real>& bond,
                                               const Deformation<Real, Sideways>& now, const Memories<Real>& memories)
{
  if (first_step)
  {
    remember(now, memories, bond.number);
  }
  Deformation<Real, Sideways> before = recall<Sideways>(memories, bond.number);
  if (bond.switched == 0)
  {
    remember(now, memories, bond.number);
  }
  else
  {
    const MaskOf<Real> switched = PackTraits<Real>::maskFromBits(bond.switched);
    remember(select<Real, Sideways>(switched, before, now), memories, bond.number);
    before = select<Real, Sideways>(switched, now, before);
  }
  return before;
}

// Which lanes' memories are of the small-angle regime after this step.
template <class Real>
inline void rememberRegime(bool first_step, const Bond<Real>& bond, uint8_t& was_sideways)
{
  const uint32_t kept = first_step ? 0u : bond.switched;
  was_sideways = static_cast<uint8_t>((bond.small & ~kept) | (was_sideways & kept));
}

// What a spring with a damper bears (2.3): stiffness times deformation, and damping times its change.
template <class Real, class Length>
inline Length bear(const DampedSpring& spring, Length now, Length before)
{
  return multiplyAdd(constant<Real>(spring.present), now, -(constant<Real>(spring.past) * before));
}

// Third stage: elastic and damping forces and moments (2.3), turned back to the world and onto both voxels.
template <class Sideways, class Real>
inline void applyForces(const BodyModel& model, bool first_step, const Bond<Real>& bond, Sideways d_y, Sideways d_z,
                        const Memories<Real>& memories, Load<Real>& load_1, Load<Real>& load_2)
{
  const Deformation<Real, Sideways> now = {
    bond.d.x, d_y, d_z, bond.twist, bond.sum_y, bond.sum_z, bond.a1_y, bond.a1_z
  };
  const Deformation<Real, Sideways> before = dampedSince(first_step, bond, now, memories);

  const Vector<Real>& x = bond.frame.x;
  const Vector<Real>& y = bond.frame.y;
  const Vector<Real> z = cross(x, y);

  const Real force_x = bear<Real>(model.tension, now.d_x, before.d_x);
  const auto force_y =
      bear<Real>(model.shear, now.d_y, before.d_y) - bear<Real>(model.coupling, now.sum_z, before.sum_z);
  const Real force_z =
      bear<Real>(model.shear, now.d_z, before.d_z) + bear<Real>(model.coupling, now.sum_y, before.sum_y);
  const Vector<Real> force = multiplyAdd(force_z, z, multiplyAdd(force_y, y, force_x * x));
  load_1.force = load_1.force + force;
  load_2.force = load_2.force - force;

  // With alpha_2 = sum - alpha_1: 2 alpha_1 + alpha_2 = sum + alpha_1, and alpha_1 + 2 alpha_2 = 2 sum - alpha_1
  const Real two = constant<Real>(2.0);
  const Real bend_y = bear<Real>(model.bending, now.sum_y, before.sum_y);
  const Real bend_z = bear<Real>(model.bending, now.sum_z, before.sum_z);
  const Real end_y = bear<Real>(model.bending, now.a1_y, before.a1_y);
  const Real end_z = bear<Real>(model.bending, now.a1_z, before.a1_z);
  const Sideways push_y = bear<Real>(model.coupling_of_moments, now.d_z, before.d_z);
  const Sideways push_z = bear<Real>(model.coupling_of_moments, now.d_y, before.d_y);
  const Real m1_y = (bend_y + end_y) + push_y;
  const Real m1_z = (bend_z + end_z) - push_z;
  const Real m2_y = multiplyAdd(two, bend_y, -end_y) + push_y;
  const Real m2_z = multiplyAdd(two, bend_z, -end_z) - push_z;
  const Vector<Real> twist = bear<Real>(model.torsion, now.twist, before.twist) * x;
  const Vector<Real> moment_1 = multiplyAdd(m1_z, z, multiplyAdd(m1_y, y, -twist));
  const Vector<Real> moment_2 = multiplyAdd(m2_z, z, multiplyAdd(m2_y, y, twist));
  load_1.moment = load_1.moment - moment_1;
  load_2.moment = load_2.moment - moment_2;
}

// ---- self-collision, physics.md 3 --------------------------------------------------------------------------------

// The sum of the forces of collisions on a voxel, from 0 in each step.
template <class Real>
inline Vector<Real>& collisionForce(int voxel, const BatchState& state)
{
  Vector<Real>& sum = reinterpret_cast<Vector<Real>*>(state.collision_forces)[voxel];
  if (state.collided[voxel] == 0)
  {
    state.collided[voxel] = 1;
    const Real zero = constant<Real>(0.0);
    sum = { zero, zero, zero };
  }
  return sum;
}

template <class Real>
inline void applyCollisions(const BodyModel& model, const Voxel<Real>* voxels, const BatchState& state)
{
  for (int i = 0; i < state.collision_pair_count; ++i)
  {
    const CollisionPair& pair = state.collision_pairs[i];
    const Voxel<Real>& a = voxels[pair.voxel_a];
    const Voxel<Real>& b = voxels[pair.voxel_b];
    const Vector<Real> apart = b.position - a.position;
    const Real square = dot(apart, apart);
    const Real reach = constant<Real>(0.75) * (a.scale + b.scale);
    const MaskOf<Real> touching = PackTraits<Real>::maskFromBits(pair.robots) & (square < reach * reach);
    if (any(touching))
    {
      const Real distance = squareRoot(square);
      const Real push = constant<Real>(model.axial_stiffness) * (reach - distance) / distance;
      const Vector<Real> force = select(touching, push, constant<Real>(0.0)) * apart;
      Vector<Real>& sum_a = collisionForce<Real>(pair.voxel_a, state);
      sum_a = sum_a - force;
      Vector<Real>& sum_b = collisionForce<Real>(pair.voxel_b, state);
      sum_b = sum_b + force;
    }
  }
}

// What acts on a voxel before bonds do.
template <class Real>
inline void beginLoad(int voxel, const BodyModel& model, const BatchState& state, Load<Real>& load)
{
  const Real zero = constant<Real>(0.0);
  load = { { zero, zero, zero }, { zero, zero, zero } };
  if (voxel < model.voxel_count && state.collided[voxel] != 0)
  {
    load.force = collisionForce<Real>(voxel, state);
    state.collided[voxel] = 0;
  }
}

// ---- voxels, physics.md 4 and 5 ----------------------------------------------------------------------------------

// The resting edge length that development and actuation ask for now, kept within its hard limits (5).
template <class Real>
inline Real nextScale(const BodyModel& model, const StepClock& clock, const Voxel<Real>& voxel)
{
  const Real nominal = constant<Real>(model.nominal_size);
  Real scale;
  if (!clock.born)
  {
    scale = multiplyAdd(constant<Real>(clock.prenatal_growth), voxel.size_at_birth - nominal, nominal);
  }
  else
  {
    const Real age = constant<Real>(clock.life_fraction);
    const Real size = multiplyAdd(age, voxel.size_change, voxel.size_at_birth);
    const Real phase = multiplyAdd(age, voxel.phase_change, voxel.phase_at_birth);
    constexpr double cycle = 6.2831850051879883;  // [rad]
    const Real angle = multiplyAdd(constant<Real>(cycle), phase, constant<Real>(cycle * clock.cycles));
    const Real growth = multiplyAdd(constant<Real>(4.0 / (3.0 * model.nominal_size)), size, constant<Real>(-1.0 / 3.0));
    const Real damping = minimum(growth, constant<Real>(1.0));
    scale = multiplyAdd(constant<Real>(model.actuation_amplitude) * damping, sine(angle), size);
  }
  const Real last = voxel.scale;
  const auto too_small = scale < constant<Real>(0.25 * model.nominal_size);
  const auto too_large = constant<Real>(1.75 * model.nominal_size) < scale;
  if (!any(too_small | too_large))
  {
    return scale;
  }
  return select((too_small & (scale < last)) | (too_large & (last < scale)), last, scale);
}

// How far the voxel's lower face is below the floor; not positive: no contact.
template <class Real>
inline Real penetration(const Voxel<Real>& voxel)
{
  return multiplyAdd(constant<Real>(0.5), voxel.scale, -voxel.position.z);
}

// Floor contact with friction (4.2): adds to the force, and may stop the voxel.
template <class Real>
inline void applyFloor(const BodyModel& model, Real depth, Voxel<Real>& voxel, Vector<Real>& force,
                       uint8_t& static_friction_bits)
{
  using Mask = MaskOf<Real>;
  const Real zero = constant<Real>(0.0);
  const Mask touching = zero < depth;
  if (!any(touching))
  {
    static_friction_bits = 0;
    return;
  }
  const Vector<Real> velocity = constant<Real>(model.inverse_mass) * voxel.momentum;
  const Real normal = constant<Real>(model.floor_stiffness) * depth;
  const Real vertical = multiplyAdd(constant<Real>(-model.floor_damping), velocity.z, normal + force.z);
  force.z = select(touching, vertical, force.z);

  const Real speed_square = multiplyAdd(velocity.y, velocity.y, velocity.x * velocity.x);
  const Real force_square = multiplyAdd(force.y, force.y, force.x * force.x);
  const Real grip = constant<Real>(model.static_friction) * normal;
  const Real sliding_friction = constant<Real>(model.dynamic_friction) * normal;
  const Mask resting = speed_square == zero;
  const Real inverse_speed = inverseSquareRoot(speed_square);
  const Real speed = speed_square * inverse_speed;
  const Mask sliding =
      (!resting) & (sliding_friction * constant<Real>(model.dt * model.inverse_mass) < speed) & touching;
  const Mask held = touching & ((resting & (force_square < grip * grip)) | (!(resting | sliding)));
  const Real friction = select(sliding, sliding_friction * inverse_speed, zero);
  force.x = select(held, zero, multiplyAdd(-friction, velocity.x, force.x));
  force.y = select(held, zero, multiplyAdd(-friction, velocity.y, force.y));
  voxel.momentum.x = select(held, zero, voxel.momentum.x);
  voxel.momentum.y = select(held, zero, voxel.momentum.y);
  static_friction_bits = static_cast<uint8_t>(bits(held));
}

// All that acts on a voxel: bonds and collisions, drag, weight and the floor (4.1, 4.2).
template <class Real>
inline Vector<Real> totalForce(const BodyModel& model, const Load<Real>& load, Voxel<Real>& voxel,
                               uint8_t& static_friction_bits)
{
  const Real drag = constant<Real>(model.translation_drag * model.inverse_mass);
  Vector<Real> force = multiplyAdd(-drag, voxel.momentum, load.force);
  force.y = force.y - constant<Real>(model.weight_along_slope);
  force.z = force.z - constant<Real>(model.weight);
  applyFloor(model, penetration(voxel), voxel, force, static_friction_bits);
  return force;
}

template <class Real>
inline void integrateTranslation(const BodyModel& model, const Vector<Real>& force, Voxel<Real>& voxel)
{
  voxel.momentum = multiplyAdd(constant<Real>(model.dt), force, voxel.momentum);
  voxel.position = multiplyAdd(constant<Real>(model.dt * model.inverse_mass), voxel.momentum, voxel.position);
}

template <class Real>
inline void integrateRotation(const BodyModel& model, const Vector<Real>& moment, Voxel<Real>& voxel)
{
  const Vector<Real> driven = multiplyAdd(constant<Real>(model.dt), moment, voxel.angular_momentum);
  const Vector<Real> h = constant<Real>(model.rotation_decay) * driven;
  voxel.angular_momentum = h;

  const Vector<Real> turn = constant<Real>(0.5 * model.dt * model.inverse_inertia) * h;
  const Quaternion<Real> q = voxel.orientation;
  const Real w = multiplyAdd(-turn.z, q.z, multiplyAdd(-turn.y, q.y, multiplyAdd(-turn.x, q.x, q.w)));
  const Real x = multiplyAdd(-turn.z, q.y, multiplyAdd(turn.y, q.z, multiplyAdd(turn.x, q.w, q.x)));
  const Real y = multiplyAdd(-turn.x, q.z, multiplyAdd(turn.z, q.x, multiplyAdd(turn.y, q.w, q.y)));
  const Real z = multiplyAdd(-turn.y, q.x, multiplyAdd(turn.x, q.y, multiplyAdd(turn.z, q.w, q.z)));
  const Real square = multiplyAdd(z, z, multiplyAdd(y, y, multiplyAdd(x, x, w * w)));
  const Real scaling = inverseSquareRootNearOne(square);
  voxel.orientation = { w * scaling, x * scaling, y * scaling, z * scaling };

  // The reference takes a turn too small to make its w less than 1 for none
  const Real one = constant<Real>(1.0);
  const auto unturned = (one <= w) & (square <= constant<Real>(1.0 + 0x1p-52));
  if (any(unturned))
  {
    const Real zero = constant<Real>(0.0);
    voxel.orientation.w = select(unturned, one, voxel.orientation.w);
    voxel.orientation.x = select(unturned, zero, voxel.orientation.x);
    voxel.orientation.y = select(unturned, zero, voxel.orientation.y);
    voxel.orientation.z = select(unturned, zero, voxel.orientation.z);
  }
}

template <class Real>
struct StepSums
{
  Real max_momentum_square;
  Real top_contacts;
  Real other_contacts;
};

// Takes a voxel at the end of its step into account.
template <class Real>
inline void addUp(const Voxel<Real>& voxel, bool in_top_layer, StepSums<Real>& sums)
{
  const Real zero = constant<Real>(0.0);
  sums.max_momentum_square = maximum(sums.max_momentum_square, dot(voxel.momentum, voxel.momentum));
  const Real contact = select(zero < penetration(voxel), constant<Real>(1.0), zero);
  Real& contacts = in_top_layer ? sums.top_contacts : sums.other_contacts;
  contacts = contacts + contact;
}

// ---- the step ----------------------------------------------------------------------------------------------------

// Voxels that go through the stages together, and their bonds to upper neighbours.
template <class Real>
struct Group
{
  int first;  // voxel
  int end;    // the voxel after the last
  int bond_count;
  Bond<Real> bonds[3 * VOXEL_GROUP];  // voxel by voxel
  int bonds_end[VOXEL_GROUP];         // place after a voxel's last bond
  Load<Real> loads[VOXEL_GROUP];      // what acts on the voxels
};

// First stage of the bonds to a voxel's upper neighbours. Returns how many there are.
template <class Real>
inline int deformBondsOf(int voxel, int first_number, const BodyModel& model, const Voxel<Real>* voxels,
                         BatchState& state, Bond<Real>* bonds)
{
  const Axes<Real> axes = bodyAxes(voxels[voxel].orientation);
  const uint8_t neighbours = model.upper_neighbours[voxel];
  int count = 0;
  const auto begin = [&](int axis) -> Bond<Real>&
  {
    Bond<Real>& bond = bonds[count];
    bond.number = first_number + count;
    bond.axis = axis;
    ++count;
    return bond;
  };
  if ((neighbours & 1) != 0)
  {
    deform<0>(model, axes, voxels[voxel], voxels[voxel + model.stride[0]], state, begin(0));
  }
  if ((neighbours & 2) != 0)
  {
    deform<1>(model, axes, voxels[voxel], voxels[voxel + model.stride[1]], state, begin(1));
  }
  if ((neighbours & 4) != 0)
  {
    deform<2>(model, axes, voxels[voxel], voxels[voxel + model.stride[2]], state, begin(2));
  }
  return count;
}

// Asks for what the next group will be the first to need in this step: its bonds' memories and its upper neighbours
// along z. Bodies of more than a few hundred voxels do not fit into the caches of a core.
template <class Real>
inline void fetchAhead(int first, int first_number, const BodyModel& model, const Voxel<Real>* voxels,
                       const Memories<Real>& memories)
{
  for (int voxel = first + model.stride[2]; voxel < first + model.stride[2] + VOXEL_GROUP && voxel < model.voxel_count;
       ++voxel)
  {
    prefetch(voxels[voxel]);
  }
  for (int number = first_number; number < first_number + 3 * VOXEL_GROUP && number < model.bond_count; ++number)
  {
    prefetch(memories.regular[number]);
  }
}

// The loads of as many voxels as bonds act on at a time, in a ring: a voxel that has been moved makes room for another.
template <class Real>
class LoadRing
{
public:
  LoadRing(const BodyModel& model, const BatchState& state)
    : model_(model), state_(state), loads_(reinterpret_cast<Load<Real>*>(state.loads)), size_(loadWindow(model))
  {
    for (int voxel = 0; voxel < size_; ++voxel)
    {
      beginLoad(voxel, model, state, loads_[voxel]);
    }
  }

  // Of the first voxel that has not been moved.
  const Load<Real>& first() const { return loads_[place_]; }
  // Of the voxel that is so many after it.
  Load<Real>& ahead(int distance) const
  {
    const int place = place_ + distance;
    return loads_[place < size_ ? place : place - size_];
  }
  // The first voxel is going to be moved.
  void advance()
  {
    beginLoad(first_ + size_, model_, state_, loads_[place_]);
    ++first_;
    place_ = place_ + 1 < size_ ? place_ + 1 : 0;
  }

private:
  const BodyModel& model_;
  const BatchState& state_;
  Load<Real>* loads_;
  int size_;
  int first_ = 0;
  int place_ = 0;
};

template <class Real>
inline void deformBonds(int first_number, const BodyModel& model, const Voxel<Real>* voxels, BatchState& state,
                        Group<Real>& group)
{
  group.bond_count = 0;
  for (int voxel = group.first; voxel < group.end; ++voxel)
  {
    const int number = first_number + group.bond_count;
    group.bond_count += deformBondsOf(voxel, number, model, voxels, state, group.bonds + group.bond_count);
    group.bonds_end[voxel - group.first] = group.bond_count;
  }
}

template <class Real>
inline void rotateEndsOfBonds(const BodyModel& model, BatchState& state, Group<Real>& group)
{
  for (int i = 0; i < group.bond_count; ++i)
  {
    rotateEnds(group.bonds[i]);
    checkDivergence(model, group.bonds[i], state);
  }
}

// Third stage of the bonds to upper neighbours, voxel by voxel.
template <class Real>
inline void applyForcesOfBonds(const BodyModel& model, bool first_step, const Memories<Real>& memories,
                               LoadRing<Real>& ring, Group<Real>& group)
{
  int i = 0;
  for (int voxel = 0; voxel < group.end - group.first; ++voxel)
  {
    Load<Real> load = ring.first();
    for (; i < group.bonds_end[voxel]; ++i)
    {
      const Bond<Real>& bond = group.bonds[i];
      Load<Real>& other = ring.ahead(model.stride[bond.axis]);
      if (bond.sideways == 0)
      {
        applyForces(model, first_step, bond, Nothing(), Nothing(), memories, load, other);
      }
      else
      {
        applyForces(model, first_step, bond, bond.d.y, bond.d.z, memories, load, other);
        rememberRegime(first_step, bond, memories.was_sideways[bond.number]);
      }
    }
    ring.advance();
    group.loads[voxel] = load;
  }
}

// In loops of their own, so that each voxel's chains of operations are short enough to overlap with the next one's.
template <class Real>
inline void moveVoxels(const BodyModel& model, const StepClock& clock, const Group<Real>& group, Voxel<Real>* voxels,
                       uint8_t* static_friction, StepSums<Real>& sums)
{
  for (int i = group.first; i < group.end; ++i)
  {
    const Vector<Real> force = totalForce(model, group.loads[i - group.first], voxels[i], static_friction[i]);
    integrateTranslation(model, force, voxels[i]);
  }
  for (int i = group.first; i < group.end; ++i)
  {
    integrateRotation(model, group.loads[i - group.first].moment, voxels[i]);
  }
  for (int i = group.first; i < group.end; ++i)
  {
    voxels[i].scale = nextScale(model, clock, voxels[i]);
    addUp(voxels[i], model.in_top_layer[i] != 0, sums);
  }
}

template <class Real>
inline void report(const BodyModel& model, const StepSums<Real>& sums, BatchState& state)
{
  const Real inverse_mass_square = constant<Real>(model.inverse_mass * model.inverse_mass);
  const Real max_speed_square = inverse_mass_square * sums.max_momentum_square;
  std::memcpy(state.max_speed_squared, &max_speed_square, sizeof max_speed_square);
  std::memcpy(state.top_contacts, &sums.top_contacts, sizeof sums.top_contacts);
  std::memcpy(state.other_contacts, &sums.other_contacts, sizeof sums.other_contacts);
}

// Collisions of all voxels; then, group by group, the bonds to upper neighbours, after which no force on the group's
// voxels is missing and nothing needs their old state any more, and their motion.
template <class Real>
void step(const BodyModel& shared_model, const StepClock& shared_clock, BatchState& state)
{
  const BodyModel model = shared_model;  // copies, which no write to the state can change
  const StepClock clock = shared_clock;
  auto* const voxels = reinterpret_cast<Voxel<Real>*>(state.voxels);
  const Memories<Real> memories = memoriesOf<Real>(state);
  const Real zero = constant<Real>(0.0);
  StepSums<Real> sums = { zero, zero, zero };
  applyCollisions(model, voxels, state);
  LoadRing<Real> ring(model, state);
  Group<Real> group;
  int first_number = 0;
  for (group.first = 0; group.first < model.voxel_count; group.first = group.end)
  {
    group.end = group.first + VOXEL_GROUP < model.voxel_count ? group.first + VOXEL_GROUP : model.voxel_count;
    deformBonds(first_number, model, voxels, state, group);
    first_number += group.bond_count;
    fetchAhead(group.end, first_number, model, voxels, memories);
    rotateEndsOfBonds(model, state, group);
    applyForcesOfBonds(model, clock.first_step, memories, ring, group);
    moveVoxels(model, clock, group, voxels, state.static_friction, sums);
  }
  report(model, sums, state);
}
}  // namespace
}  // namespace devo_evo
