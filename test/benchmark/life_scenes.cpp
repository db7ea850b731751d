#include "benchmark/life_scenes.h"

#include "devo_evo/bodies/bodies.h"
#include "devo_evo/evolution/genome.h"

#include "soft_body/reference_data.h"

#include <stdexcept>

namespace devo_evo
{
namespace
{
constexpr int ROBOTS = 16;       // two groups of the widest kernel
constexpr int FULL_LANES = 8;    // one group of it
constexpr double BRIEFLY = 0.5;  // [s], for scenes that compare times per step

/// Founders of an experiment with this treatment and profile.
std::vector<DevelopmentalProgram> randomRobots(const SoftBodySettings& body, Treatment treatment, Profile profile,
                                               int count)
{
  EvolutionSettings evolution;
  evolution.treatment = treatment;
  evolution.profile = profile;
  const GenomeLayout layout = makeSoftBody(body)->layout(evolution);
  std::vector<DevelopmentalProgram> robots;
  for (int id = 0; id < count; ++id)
  {
    robots.push_back(bornGenome(evolution, layout, 1, 0, id, nullptr).program);
  }
  return robots;
}

std::vector<DevelopmentalProgram> randomEvoDevo(const SoftBodySettings& body, int count)
{
  return randomRobots(body, Treatment::EVO_DEVO, Profile::PAPER, count);
}

/// The last eight of an evolved lineage, which roll.
std::vector<DevelopmentalProgram> rollers()
{
  std::vector<DevelopmentalProgram> robots;
  for (const ReferenceGenome& genome : referenceGenomes())
  {
    if (genome.id >= "roller-04" && genome.id <= "roller-11")
    {
      robots.push_back(genome.program);
    }
  }
  return robots;
}

LifeScene lifetimeScene(const std::string& name, double lifetime)
{
  SoftBodySettings settings;
  settings.lifetime = lifetime;
  return { name, settings, randomEvoDevo(settings, FULL_LANES) };
}

LifeScene bodyScene(const std::string& name, int grid_x, int grid_y, int grid_z)
{
  SoftBodySettings settings;
  settings.grid_x = grid_x;
  settings.grid_y = grid_y;
  settings.grid_z = grid_z;
  settings.lifetime = BRIEFLY;
  return { name, settings, randomEvoDevo(settings, FULL_LANES) };
}
}  // namespace

std::vector<LifeScene> lifeScenes()
{
  const SoftBodySettings body;
  return {
    { "evo_devo_paper", body, randomEvoDevo(body, ROBOTS) },
    { "evo_devo_released_code", body, randomRobots(body, Treatment::EVO_DEVO, Profile::RELEASED_CODE, ROBOTS) },
    { "evo_paper", body, randomRobots(body, Treatment::EVO, Profile::PAPER, ROBOTS) },
    { "rollers", body, rollers() },
    { "one_robot", body, randomEvoDevo(body, 1) },
    lifetimeScene("lifetime_1_s", 1.0),
    lifetimeScene("lifetime_10_s", 10.0),
    lifetimeScene("lifetime_20_s", 20.0),
    bodyScene("body_4x4x3", 4, 4, 3),
    bodyScene("body_6x6x4", 6, 6, 4),
    bodyScene("body_8x8x8", 8, 8, 8),
    bodyScene("body_12x12x12", 12, 12, 12),
  };
}

LifeScene lifeScene(const std::string& name)
{
  for (LifeScene& scene : lifeScenes())
  {
    if (scene.name == name)
    {
      return std::move(scene);
    }
  }
  throw std::out_of_range("there is no scene " + name);
}
}  // namespace devo_evo
