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

/// A world, and the fittest robot of each gait that a search found there.
struct GaitMapCell
{
  RigidBodySettings world;
  std::optional<LivedQuadruped> walking, rolling;
  int64_t evaluations = 0;  ///< lives that the search took
};

/// How robots are searched for. Both gaits have the same budget in every world.
struct GaitSearch
{
  std::vector<QuadrupedProgram> known;  ///< robots that the search begins with
  int64_t random_robots = 10;           ///< made at random, that it begins with too
  int64_t climbing_steps = 25;          ///< of a hill climb per gait, from the best of these at it
  int64_t seed = 1;

  /// @throw InvalidInput naming the field, its value and its range, or what is wrong with a known robot.
  void validate() const;
};

/// Searches one world. Robots do not develop. A step of a climb changes one leg's length and one weight on average; its
/// outcome is kept if it is no less fit among robots of the gait, or, before there is one, no further from the gait. A
/// pure function of its arguments on one build of ODE.
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
