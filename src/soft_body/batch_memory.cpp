#include "batch_memory.h"

#include <cstddef>

namespace devo_evo
{
namespace
{
std::vector<BatchMemory::Row> rowsFor(int things, int fields, int lanes)
{
  constexpr size_t per_row = sizeof(BatchMemory::Row) / sizeof(double);
  const size_t numbers = static_cast<size_t>(things) * static_cast<size_t>(fields * lanes);
  return std::vector<BatchMemory::Row>((numbers + per_row - 1) / per_row);
}

double* numbersOf(std::vector<BatchMemory::Row>& rows)
{
  return rows.empty() ? nullptr : rows.front().numbers;
}
}  // namespace

BatchMemory::BatchMemory(const BodyModel& model, int lanes)
  : voxels(rowsFor(model.voxel_count, VOXEL_FIELDS, lanes))
  , bonds(rowsFor(model.bond_count, BOND_FIELDS, lanes))
  , sideways(rowsFor(model.bond_count, SIDEWAYS_FIELDS, lanes))
  , loads(rowsFor(loadWindow(model), LOAD_FIELDS, lanes))
  , collision_forces(rowsFor(model.voxel_count, COLLISION_FIELDS, lanes))
  , collided(static_cast<size_t>(model.voxel_count), 0)
  , small_angle(static_cast<size_t>(model.bond_count), 0xff)
  , was_sideways(static_cast<size_t>(model.bond_count), 0)
  , static_friction(static_cast<size_t>(model.voxel_count), 0)
{
}

void BatchMemory::lendTo(BatchState& state)
{
  state.voxels = numbersOf(voxels);
  state.bonds = numbersOf(bonds);
  state.sideways = numbersOf(sideways);
  state.loads = numbersOf(loads);
  state.collision_forces = numbersOf(collision_forces);
  state.collided = collided.data();
  state.small_angle = small_angle.data();
  state.was_sideways = was_sideways.data();
  state.static_friction = static_friction.data();
}
}  // namespace devo_evo
