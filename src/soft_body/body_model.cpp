#include "body_model.h"

#include <algorithm>
#include <cmath>

namespace devo_evo
{
namespace
{
DampedSpring dampedSpring(double stiffness, double damping)
{
  return { stiffness + damping, damping };
}
}  // namespace

BodyConstants::BodyConstants(const SoftBodySettings& settings, const Lattice& lattice)
  : upper_neighbours_(static_cast<size_t>(lattice.voxelCount()), 0)
  , in_top_layer_(static_cast<size_t>(lattice.voxelCount()), 0)
{
  for (const Lattice::Bond& bond : lattice.bonds())
  {
    upper_neighbours_[static_cast<size_t>(bond.voxel_1)] |= static_cast<uint8_t>(1u << bond.axis);
  }
  for (int voxel = 0; voxel < lattice.voxelCount(); ++voxel)
  {
    in_top_layer_[static_cast<size_t>(voxel)] = lattice.coordinates(voxel)[2] == settings.grid_z - 1 ? 1 : 0;
  }

  // physics.md 1 and 2, in its symbols
  const double L = settings.voxel_size;
  const double E = settings.youngs_modulus;
  const double G = E / (2.0 * (1.0 + settings.poissons_ratio));
  const double A = L * L;
  const double J2 = L * L * L * L / 12.0;
  const double J = L * L * L * L / 6.0;
  const double m = settings.density * L * L * L;
  const double I = m * L * L / 6.0;
  const double S = m * L / 2.0;
  const double a1 = E * A / L;
  const double a2 = G * J / L;
  const double b1 = 12.0 * E * J2 / (L * L * L);
  const double b2 = 6.0 * E * J2 / (L * L);
  const double b3 = 2.0 * E * J2 / L;
  const double dt = settings.timeStep();
  const double half_damping = 0.5 * settings.bond_damping / dt;
  const double quarter_damping = 0.25 * settings.bond_damping / dt;

  model_.voxel_count = lattice.voxelCount();
  model_.bond_count = static_cast<int>(lattice.bonds().size());
  model_.stride[0] = lattice.index(1, 0, 0);
  model_.stride[1] = lattice.index(0, 1, 0);
  model_.stride[2] = lattice.index(0, 0, 1);
  model_.upper_neighbours = upper_neighbours_.data();
  model_.in_top_layer = in_top_layer_.data();
  model_.dt = dt;
  model_.nominal_size = L;
  model_.inverse_mass = 1.0 / m;
  model_.inverse_inertia = 1.0 / I;
  const double cosine = 1.0 / std::sqrt(1.0 + settings.slope * settings.slope);
  model_.weight = m * settings.gravity * cosine;
  model_.weight_along_slope = m * settings.gravity * (settings.slope * cosine) + 0.0;
  model_.axial_stiffness = a1;
  model_.tension = dampedSpring(a1, half_damping * 2.0 * std::sqrt(a1 * m));
  model_.torsion = dampedSpring(a2, quarter_damping * 2.0 * std::sqrt(a2 * I));
  model_.shear = dampedSpring(b1, half_damping * 2.0 * std::sqrt(b1 * m));
  model_.coupling = dampedSpring(b2, half_damping * 2.0 * std::sqrt(b2 * S));
  model_.coupling_of_moments = dampedSpring(b2, quarter_damping * 2.0 * std::sqrt(b2 * S));
  model_.bending = dampedSpring(b3, quarter_damping * 2.0 * std::sqrt(b3 * I));
  model_.translation_drag = settings.global_damping * 2.0 * std::sqrt(m * E * L);
  model_.rotation_decay = 1.0 - 10.0 * settings.global_damping * 2.0 * std::sqrt(I * E * L * L * L) * dt / I;
  model_.floor_stiffness = 2.0 * E * L;
  model_.floor_damping = settings.contact_damping * 2.0 * std::sqrt(m * E * L);
  model_.static_friction = settings.static_friction;
  model_.dynamic_friction = settings.dynamic_friction;
  model_.actuation_amplitude = settings.actuation_amplitude * L;
  model_.sideways_bend_test = settings.sideways_bend_test;
}

StepClock clockOf(const SoftBodySettings& settings, int64_t completed_steps, double time)
{
  StepClock clock;
  clock.first_step = completed_steps == 0;
  clock.born = time >= SETTLING_TIME;
  clock.prenatal_growth = std::min(1.0, 2.0 * time / SETTLING_TIME);
  clock.life_fraction = std::min((time - SETTLING_TIME) / settings.lifetime, 1.0);
  clock.cycles = settings.actuation_frequency * time;
  return clock;
}
}  // namespace devo_evo
