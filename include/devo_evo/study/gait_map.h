#pragma once

#include "devo_evo/rigid_body/quadruped.h"

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

namespace devo_evo
{
/// How a rigid quadruped gets down its slope.
enum class Gait
{
  WALKING,  ///< on its legs, most of the time, without turning over
  ROLLING   ///< by at least one whole turn downhill
};

/// @return none for what is neither: a robot that lies, slides, or tumbles less than once.
std::optional<Gait> gaitOf(const QuadrupedEvaluation& evaluation);

/// A robot and what it did.
struct LivedQuadruped
{
  QuadrupedProgram program;
  QuadrupedEvaluation evaluation;
};

/// A world, and what was found there.
struct GaitMapCell
{
  RigidBodySettings world;
  std::optional<LivedQuadruped> walking, rolling;  ///< the fittest of each gait; none was found if empty
  LivedQuadruped drawing_in;    ///< that turns most of those born with all legs half out, which they draw in over life
  QuadrupedEvaluation passive;  ///< of a robot without a controller that has its legs drawn in
  QuadrupedEvaluation smooth;   ///< of the same if legs drawn in do not protrude
  int64_t evaluations = 0;      ///< lives that the search took
};

/// What the paper says of its world (Fig S5), of one that was searched.
struct PaperObservations
{
  bool walks = false;         ///< the best walker comes down the slope by a body length at least
  bool rolls_better = false;  ///< the best roller sees more than 1.1 times the light that the best walker sees
  /// Legs that protrude even at their shortest stop the passive robot, or take a tenth of its way; the best roller
  /// comes further than it.
  bool protruding_hinders = false;
  /// Drawing legs in starts a roll late: the robot first turns over in the second half of its life, and in its last
  /// half second it is faster than the best walker on average.
  bool drawing_in_rolls = false;

  bool all() const { return walks && rolls_better && protruding_hinders && drawing_in_rolls; }
};

PaperObservations observe(const GaitMapCell& cell);

/// How robots are searched for. Everything has the same budget in every world.
struct GaitSearch
{
  std::vector<QuadrupedProgram> known;  ///< robots that the search begins with
  int64_t random_robots = 10;           ///< made at random, that it begins with too
  int64_t climbing_steps = 25;          ///< of a hill climb per gait, from the best of these; twice for drawing legs in
  int64_t seed = 1;

  /// @throw InvalidInput naming the field, its value and its range, or what is wrong with a known robot.
  void validate() const;
};

/// Searches one world. Robots of a gait do not develop; those that draw their legs in may change their weights. A step
/// of a climb changes one leg's length and one weight of an array on average; its outcome is kept if it is no less fit
/// among robots of the gait, or, before there is one, no further from the gait. A pure function of its arguments on one
/// build of ODE.
/// @throw InvalidInput if the world is invalid; EvaluationAbandoned once `stop` is true.
GaitMapCell searchGaits(const RigidBodySettings& world, const GaitSearch& search,
                        const std::atomic<bool>* stop = nullptr);

/// Somebody who watches a map grow, and can stop it. One call at a time.
class GaitMapObserver
{
public:
  virtual ~GaitMapObserver() = default;

  /// From any thread; may throw to give up.
  virtual void cellDone(const GaitMapCell& cell) = 0;

  /// Asked several times a second: whether to stop at once.
  virtual bool stopRequested() = 0;
};

/// Searches a world for each pair of slope and leg_residual.
/// @param world of which all else is taken. @param slopes [degrees] @param residuals [m] @param threads 1 or more.
/// @return by slope, then by residual, in the order given.
/// @throw InvalidInput if a world is invalid; EvaluationAbandoned if the observer stops it.
std::vector<GaitMapCell> mapGaits(const RigidBodySettings& world, const std::vector<double>& slopes,
                                  const std::vector<double>& residuals, const GaitSearch& search, int threads,
                                  GaitMapObserver& observer);
}  // namespace devo_evo
