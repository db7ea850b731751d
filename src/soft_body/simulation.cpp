#include "devo_evo/soft_body/simulation.h"

#include "batch_memory.h"
#include "body_model.h"
#include "collision_list.h"
#include "kernel.h"
#include "life_record.h"
#include "state_hash.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace devo_evo
{
namespace
{
constexpr double SIZE_RANGE = 0.75;  // resting length = L (1 + 0.75 gene)

class BatchSimulation : public Simulation
{
public:
  BatchSimulation(const SoftBodySettings& settings, const std::vector<DevelopmentalProgram>& programs,
                  const Kernel& kernel)
    : settings_(settings)
    , kernel_(kernel)
    , lattice_(settings)
    , constants_(settings, lattice_)
    , robots_(static_cast<int>(programs.size()))
    , memory_(constants_.model(), kernel.lanes)
    , collisions_(lattice_, settings.voxel_size, kernel.lanes, robots_)
    , lives_(programs.size())
  {
    memory_.lendTo(state_);
    for (int lane = 0; lane < kernel_.lanes; ++lane)
    {
      placeRobot(lane, lane < robots_ ? programs[static_cast<size_t>(lane)] : programs.front());
    }
  }

  int robotCount() const override { return robots_; }
  int64_t stepCount() const override { return step_count_; }
  double time() const override { return time_; }
  bool diverged(int robot) const override { return lives_[static_cast<size_t>(robot)].diverged(); }

  bool finished() const override
  {
    const bool lifetime_over = time_ > SETTLING_TIME + settings_.lifetime;
    return lifetime_over || std::all_of(lives_.begin(), lives_.end(), [](const LifeRecord& l) { return l.diverged(); });
  }

  void step() override
  {
    if (settings_.self_collision)
    {
      collisions_.update(state_.voxels, state_.max_speed_squared, constants_.model().dt);
      state_.collision_pairs = collisions_.pairs().data();
      state_.collision_pair_count = static_cast<int>(collisions_.pairs().size());
    }
    kernel_.step(constants_.model(), clock(), state_);
    const bool was_born = time_ > SETTLING_TIME;
    time_ += constants_.model().dt;
    ++step_count_;
    if (state_.diverged != 0)
    {
      recordDivergence();
    }
    if (time_ > SETTLING_TIME)
    {
      record(!was_born);
    }
  }

  VoxelState voxel(int robot, int voxel) const override
  {
    VoxelState result;
    result.position = vectorAt(robot, voxel, POSITION);
    result.orientation = orientationAt(robot, voxel);
    result.velocity = constants_.model().inverse_mass * vectorAt(robot, voxel, MOMENTUM);
    result.angular_velocity = constants_.model().inverse_inertia * vectorAt(robot, voxel, ANGULAR_MOMENTUM);
    result.scale = at(robot, voxel, SCALE);
    result.static_friction = staticFriction(robot, voxel);
    return result;
  }

  Eigen::Vector3d centerOfMass(int robot) const override
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int voxel = 0; voxel < lattice_.voxelCount(); ++voxel)
    {
      sum += vectorAt(robot, voxel, POSITION);
    }
    return sum / lattice_.voxelCount();
  }

  Eigen::Quaterniond meanOrientation(int robot) const override
  {
    const Eigen::Vector4d first = orientationAt(robot, 0).coeffs();
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (int voxel = 0; voxel < lattice_.voxelCount(); ++voxel)
    {
      const Eigen::Vector4d q = orientationAt(robot, voxel).coeffs();
      const double cosine = q[0] * first[0] + q[1] * first[1] + q[2] * first[2] + q[3] * first[3];
      sum += cosine < 0.0 ? Eigen::Vector4d(-q) : q;
    }
    const double square = sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2] + sum[3] * sum[3];
    return Eigen::Quaterniond(Eigen::Vector4d(sum / std::sqrt(square)));
  }

  double restingLength(int robot, int voxel) const override
  {
    const StepClock now = clock();
    const double at_birth = at(robot, voxel, SIZE_AT_BIRTH);
    return now.born ? at_birth + now.life_fraction * at(robot, voxel, SIZE_CHANGE)
                    : settings_.voxel_size + now.prenatal_growth * (at_birth - settings_.voxel_size);
  }

  Evaluation evaluation(int robot) const override
  {
    LifeRecord life = lives_[static_cast<size_t>(robot)];
    if (!life.diverged())
    {
      completeRecord(robot, life);
    }
    return life.evaluation(settings_, centerOfMass(robot), stateHash(robot));
  }

private:
  double& at(int lane, int voxel, int field) const
  {
    return state_.voxels[(voxel * VOXEL_FIELDS + field) * kernel_.lanes + lane];
  }

  Eigen::Vector3d vectorAt(int lane, int voxel, int field) const
  {
    return { at(lane, voxel, field), at(lane, voxel, field + 1), at(lane, voxel, field + 2) };
  }

  Eigen::Quaterniond orientationAt(int lane, int voxel) const
  {
    return { at(lane, voxel, ORIENTATION), at(lane, voxel, ORIENTATION + 1), at(lane, voxel, ORIENTATION + 2),
             at(lane, voxel, ORIENTATION + 3) };
  }

  bool staticFriction(int lane, int voxel) const
  {
    return (memory_.static_friction[static_cast<size_t>(voxel)] >> lane & 1) != 0;
  }

  /// At rest on its lattice place, unrotated, at nominal size.
  void placeRobot(int lane, const DevelopmentalProgram& program)
  {
    const double L = settings_.voxel_size;
    for (int voxel = 0; voxel < lattice_.voxelCount(); ++voxel)
    {
      const size_t i = static_cast<size_t>(voxel);
      const std::array<int, 3> place = lattice_.coordinates(voxel);
      for (int axis = 0; axis < 3; ++axis)
      {
        at(lane, voxel, POSITION + axis) = (place[static_cast<size_t>(axis)] + 0.5) * L;
      }
      for (int field = ORIENTATION; field < VOXEL_FIELDS; ++field)
      {
        at(lane, voxel, field) = 0.0;
      }
      at(lane, voxel, ORIENTATION) = 1.0;
      at(lane, voxel, SCALE) = L;
      const double size_at_birth = L * (1.0 + SIZE_RANGE * program.morphology_initial[i]);
      at(lane, voxel, SIZE_AT_BIRTH) = size_at_birth;
      at(lane, voxel, SIZE_CHANGE) = L * (1.0 + SIZE_RANGE * program.morphology_final[i]) - size_at_birth;
      at(lane, voxel, PHASE_AT_BIRTH) = program.control_initial[i];
      at(lane, voxel, PHASE_CHANGE) = program.control_final[i] - program.control_initial[i];
    }
  }

  StepClock clock() const { return clockOf(settings_, step_count_, time_); }

  void record(bool first_step_of_life)
  {
    for (int robot = 0; robot < robots_; ++robot)
    {
      LifeRecord& life = lives_[static_cast<size_t>(robot)];
      if (life.diverged())
      {
        continue;
      }
      if (first_step_of_life)
      {
        life.beginLife(time_, centerOfMass(robot), meanOrientation(robot));
      }
      life.recordContacts(time_, static_cast<int>(state_.top_contacts[robot]),
                          static_cast<int>(state_.other_contacts[robot]));
      if (step_count_ % LifeRecord::ORIENTATION_INTERVAL == 0)
      {
        life.recordOrientation(meanOrientation(robot));
      }
      if (life.windowEnds(time_))
      {
        life.endWindow(time_, centerOfMass(robot));
      }
    }
  }

  /// Adds what has happened since the last regular record.
  void completeRecord(int robot, LifeRecord& life) const
  {
    if (time_ > SETTLING_TIME)
    {
      life.recordOrientation(meanOrientation(robot));
      if (life.windowOpen(time_))
      {
        life.endWindow(time_, centerOfMass(robot));
      }
    }
  }

  /// Notes the verdicts, and puts bodies at rest into those lanes so that they cost nothing unusual from here on.
  void recordDivergence()
  {
    for (int lane = 0; lane < kernel_.lanes; ++lane)
    {
      if ((state_.diverged >> lane & 1) == 0)
      {
        continue;
      }
      if (lane < robots_ && !lives_[static_cast<size_t>(lane)].diverged())
      {
        lives_[static_cast<size_t>(lane)].setDivergence(
            { step_count_, state_.diverged_bond[lane], state_.diverged_strain[lane] });
      }
      const std::vector<double> zeros(static_cast<size_t>(lattice_.voxelCount()), 0.0);
      placeRobot(lane, { zeros, zeros, zeros, zeros });
      clearBonds(lane);
    }
    state_.diverged = 0;
  }

  void clearBonds(int lane)
  {
    const auto clear = [&](double* numbers, size_t bond, int fields)
    {
      for (int field = 0; field < fields; ++field)
      {
        numbers[(static_cast<int>(bond) * fields + field) * kernel_.lanes + lane] = 0.0;
      }
    };
    const unsigned bit = 1u << lane;
    for (size_t bond = 0; bond < lattice_.bonds().size(); ++bond)
    {
      clear(state_.bonds, bond, BOND_FIELDS);
      clear(state_.sideways, bond, SIDEWAYS_FIELDS);
      memory_.small_angle[bond] = static_cast<uint8_t>(memory_.small_angle[bond] | bit);
      memory_.was_sideways[bond] = static_cast<uint8_t>(memory_.was_sideways[bond] & ~bit);
    }
  }

  uint64_t stateHash(int robot) const
  {
    StateHash hash;
    for (int voxel = 0; voxel < lattice_.voxelCount(); ++voxel)
    {
      for (int field = POSITION; field <= SCALE; ++field)
      {
        hash.add(at(robot, voxel, field));
      }
      hash.add(staticFriction(robot, voxel));
    }
    return hash.finish();
  }

  const SoftBodySettings settings_;
  const Kernel& kernel_;
  const Lattice lattice_;
  const BodyConstants constants_;
  const int robots_;
  BatchMemory memory_;
  CollisionList collisions_;
  std::vector<LifeRecord> lives_;
  BatchState state_{};
  int64_t step_count_ = 0;
  double time_ = 0.0;
};

const Kernel* fastestScalarKernel()
{
#if defined(__x86_64__)
  if (scalarFmaKernel() != nullptr && __builtin_cpu_supports("fma"))
  {
    return scalarFmaKernel();
  }
#endif
  return scalarKernel();
}

const Kernel* kernelFor(InstructionSet instruction_set)
{
  switch (instruction_set)
  {
    case InstructionSet::AVX512:
      return avx512Kernel();
    case InstructionSet::AVX2:
      return avx2Kernel();
    case InstructionSet::SCALAR:
      break;
  }
  return fastestScalarKernel();
}
}  // namespace

std::unique_ptr<Simulation> makeSimulation(const SoftBodySettings& settings,
                                           const std::vector<DevelopmentalProgram>& programs,
                                           InstructionSet instruction_set)
{
  settings.validate();
  if (!isSupported(instruction_set))
  {
    throw InvalidInput("instruction set " + toString(instruction_set) + " is not supported by this processor");
  }
  const Kernel& kernel = *kernelFor(instruction_set);
  if (programs.empty() || programs.size() > static_cast<size_t>(kernel.lanes))
  {
    throw InvalidInput("a simulation by " + toString(instruction_set) + " takes 1 to " + toText(kernel.lanes) +
                       " robots, not " + toText(static_cast<int64_t>(programs.size())));
  }
  for (const DevelopmentalProgram& program : programs)
  {
    validate(program, settings);
  }
  return std::make_unique<BatchSimulation>(settings, programs, kernel);
}

std::vector<Evaluation> evaluate(const SoftBodySettings& settings, const std::vector<DevelopmentalProgram>& programs,
                                 InstructionSet instruction_set, const std::atomic<bool>* stop)
{
  constexpr int64_t steps_between_looks = 64;
  const size_t lanes = static_cast<size_t>(laneCount(instruction_set));
  std::vector<Evaluation> evaluations;
  evaluations.reserve(programs.size());
  for (size_t first = 0; first < programs.size(); first += lanes)
  {
    const size_t last = std::min(first + lanes, programs.size());
    const std::vector<DevelopmentalProgram> group(programs.begin() + static_cast<std::ptrdiff_t>(first),
                                                  programs.begin() + static_cast<std::ptrdiff_t>(last));
    const std::unique_ptr<Simulation> simulation = makeSimulation(settings, group, instruction_set);
    while (!simulation->finished())
    {
      if (stop != nullptr && simulation->stepCount() % steps_between_looks == 0 && *stop)
      {
        throw EvaluationAbandoned();
      }
      simulation->step();
    }
    for (int robot = 0; robot < simulation->robotCount(); ++robot)
    {
      evaluations.push_back(simulation->evaluation(robot));
    }
  }
  return evaluations;
}
}  // namespace devo_evo
