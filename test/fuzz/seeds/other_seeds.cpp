#include "archive/test_tools.h"
#include "fuzz/bodies.h"
#include "fuzz/input.h"
#include "fuzz/seeds/message_bytes.h"
#include "fuzz/seeds/seeds.h"

#include <devo_evo/GetIndividual.h>

#include <SQLiteCpp/SQLiteCpp.h>

#include <iterator>
#include <limits>

namespace devo_evo::fuzz
{
namespace
{
template <class Number>
std::string bytesOfNumber(Number number)
{
  return { reinterpret_cast<const char*>(&number), sizeof number };
}

/// Two trials of four robots, in as few bytes as SQLite can do with.
std::string smallArchive(ExperimentSettings settings)
{
  const test::TemporaryFolder folder;
  settings.output = folder.path();
  settings.evolution.population = 2;
  settings.generations = 3;
  {
    const auto archive = openArchiveForWriting(settings, test::someProvenance());
    test::evolve(*archive, settings, 1, settings.generations);
    test::evolve(*archive, settings, 2, 1);
    archive->noteEvaluators({ { "alpha", "Analytical Engine", "scalar", "0.1.0", 5 } });
  }
  {
    SQLite::Database file(archivePath(folder.path()), SQLite::OPEN_READWRITE);
    file.exec("PRAGMA journal_mode = DELETE; PRAGMA page_size = 512; VACUUM; PRAGMA journal_mode = WAL");
  }
  std::ifstream file(archivePath(folder.path()), std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}
}  // namespace

std::vector<Seed> archiveRequestSeeds()
{
  using Request = GetIndividual::Request;
  std::vector<Seed> seeds;
  const auto add = [&seeds](bool valid, const std::string& name, int64_t trial, int64_t id)
  {
    Request request;
    request.trial = trial;
    request.id = id;
    seeds.push_back({ "archive_requests", valid, name, bytesOf(request) });
  };
  add(true, "champion", 1, Request::CHAMPION);
  add(true, "founder", 1, 0);
  add(true, "individual", 1, 12);
  add(false, "unknown_trial", 2, 0);
  add(false, "negative", 1, -2);
  add(false, "largest_id", 1, std::numeric_limits<int64_t>::max());
  add(false, "extreme", std::numeric_limits<int64_t>::min(), std::numeric_limits<int64_t>::min());
  seeds.push_back({ "archive_requests", false, "cut_short", cutShort(bytesOf(Request()), 1) });
  return seeds;
}

std::vector<Seed> parameterValueSeeds()
{
  std::vector<Seed> seeds;
  const auto add = [&seeds](bool valid, const std::string& name, const std::string& parameter, const std::string& value)
  {
    seeds.push_back({ "parameter_values", valid, name, parameter + "\n" + value });
  };
  add(true, "boolean", "self_collision", "b\1");
  add(true, "integer", "trials", "i" + bytesOfNumber<int64_t>(3));
  add(true, "real", "lifetime", "r" + bytesOfNumber(2.5));
  add(true, "whole_number_for_a_real", "gravity", "i" + bytesOfNumber<int64_t>(9));
  add(true, "list", "grid", "l" + bytesOfNumber<int64_t>(4) + bytesOfNumber<int64_t>(5) + bytesOfNumber<int64_t>(6));
  add(true, "grid", "grid", "t4x4x3");
  add(true, "lifetime", "lifetime", "t10");
  add(true, "mutation_rate", "mutation_rate", "tself_adaptive");
  add(true, "treatment", "treatment", "tevo_devo");
  add(true, "instruction_set", "instruction_set", "tauto");
  add(true, "youngs_modulus", "youngs_modulus", "t5e+06");
  add(true, "self_collision", "self_collision", "ttrue");
  add(true, "negative_zero", "slope", "t-0");
  add(true, "largest_seed", "seed", "t9223372036854775807");
  add(true, "output", "output", "t/tmp/a b");
  add(true, "individual", "individual", "t3/1042");
  add(false, "unknown", "popluation", "t3");
  add(false, "without_value", "population", "");
  add(false, "not_a_number", "lifetime", "r" + bytesOfNumber(std::numeric_limits<double>::quiet_NaN()));
  add(false, "smallest_integer", "trials", "i" + bytesOfNumber(std::numeric_limits<int64_t>::min()));
  add(false, "overflow", "grid", "t4x99999999999999999999x3");
  add(false, "longer_than_a_number", "gravity", "t9.81 m/s^2");
  add(false, "list_too_short", "grid", "l" + bytesOfNumber<int64_t>(4));
  add(false, "list_for_a_number", "trials", "l" + bytesOfNumber<int64_t>(4));
  return seeds;
}

std::vector<Seed> archiveSeeds()
{
  ExperimentSettings soft;
  soft.body.soft = twoVoxels();
  ExperimentSettings fixed_rate = soft;
  fixed_rate.evolution.mutation_rate = 0.5;
  ExperimentSettings rigid;
  rigid.body = BodySettings(RigidBodySettings());
  return { { "archive", true, "self_adaptive", smallArchive(soft) },
           { "archive", true, "fixed_rate", smallArchive(fixed_rate) },
           { "archive", true, "rigid", smallArchive(rigid) } };
}
}  // namespace devo_evo::fuzz
