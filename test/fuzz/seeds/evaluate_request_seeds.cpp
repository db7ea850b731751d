#include "fuzz/bodies.h"
#include "fuzz/seeds/message_bytes.h"
#include "fuzz/seeds/seeds.h"
#include "ros/conversions.h"
#include "ros/message_fields.h"

#include <limits>

namespace devo_evo::fuzz
{
namespace
{
using Request = EvaluateGenomes::Request;

Request requestFor(const BodySettings& settings, int64_t robots)
{
  const std::shared_ptr<const Body> body = makeBody(settings);
  std::vector<EvaluationRequest> asked;
  for (int64_t id = 0; id < robots; ++id)
  {
    asked.push_back({ 1, id, programFor(*body) });
  }
  return toRequest(asked, settings, *body, 0x0123456789abcdef);
}

/// A robot's mutation rates end its genome, which goes before the array of trials, that of ids, and quarantine.
std::string withEndlessRates(const Request& of_one_robot)
{
  constexpr size_t after_rates = 2 * (sizeof(uint32_t) + sizeof(int64_t)) + sizeof(uint32_t);
  return withEndlessArray(bytesOf(of_one_robot), after_rates + sizeof(uint32_t));
}

/// Genomes go before the array of trials, that of ids, and quarantine.
std::string withEndlessGenomes(const Request& of_no_robot)
{
  return withEndlessArray(bytesOf(of_no_robot), 4 * sizeof(uint32_t));
}
}  // namespace

std::vector<Seed> evaluateRequestSeeds()
{
  const BodySettings soft(twoVoxels());
  const BodySettings rigid{ RigidBodySettings() };
  const Request none = requestFor(soft, 0);
  const Request one = requestFor(soft, 1);
  const Request two = requestFor(soft, 2);
  std::vector<Seed> seeds;
  const auto add = [&seeds](bool valid, const std::string& name, const std::string& bytes) {
    seeds.push_back({ "evaluate_request", valid, name, bytes });
  };
  const auto change =
      [&add](bool valid, const std::string& name, const Request& request, const std::function<void(Request&)>& changed)
  { add(valid, name, bytesOf(with(request, changed))); };

  add(true, "two_robots", bytesOf(two));
  add(true, "none", bytesOf(none));
  add(true, "rigid", bytesOf(requestFor(rigid, 1)));
  change(true, "with_rates", one, [](Request& request) { request.genomes[0].mutation_rate = { 0.25, 1.0 }; });
  change(true, "quarantine", none, [](Request& request) { request.quarantine = "its state_hash of 3/17 is wrong"; });
  change(true, "names_in_another_order", one,
         [](Request& request) { std::swap(request.genomes[0].arrays[0], request.genomes[0].arrays[3]); });

  add(false, "cut_short", cutShort(bytesOf(two), 13));
  add(false, "longer", bytesOf(two) + '\0');
  add(false, "endless_genomes", withEndlessGenomes(none));
  add(false, "endless_array", withEndlessRates(one));
  change(false, "gene_out_of_range", one,
         [](Request& request) { test::valuesOf(request.genomes[0], "size_gene_final")[1] = 1.5; });
  change(false, "not_finite", one,
         [](Request& request)
         { test::valuesOf(request.genomes[0], "phase_initial")[0] = std::numeric_limits<double>::quiet_NaN(); });
  change(false, "array_unknown", one, [](Request& request) { request.genomes[0].arrays[2].name = "leg_length"; });
  change(false, "array_twice", one,
         [](Request& request) { request.genomes[0].arrays.push_back(request.genomes[0].arrays[0]); });
  change(false, "array_of_another_size", one,
         [](Request& request) { test::valuesOf(request.genomes[0], "size_gene_initial").resize(48); });
  change(false, "rates_for_some", one, [](Request& request) { request.genomes[0].mutation_rate = { 0.25 }; });
  change(false, "another_body", one, [&](Request& request) { request.genomes = requestFor(rigid, 1).genomes; });
  change(false, "settings_out_of_range", none,
         [](Request& request) { test::setValue(request.settings, "gravity", "1e300"); });
  change(false, "settings_of_too_many_voxels", none,
         [](Request& request) { test::setValue(request.settings, "grid", "64x64x64"); });
  change(false, "settings_missing", none, [](Request& request) { request.settings.names.pop_back(); });
  change(false, "settings_twice", none,
         [](Request& request) { request.settings.names[0] = request.settings.names[1]; });
  change(false, "settings_of_no_body", none,
         [](Request& request) { test::setValue(request.settings, "body", "liquid"); });
  change(false, "too_many", none,
         [](Request& request)
         {
           request.genomes.resize(Request::MAX_GENOMES + 1);
           request.trial.resize(request.genomes.size());
           request.id.resize(request.genomes.size());
         });
  change(false, "without_ids", two, [](Request& request) { request.id.clear(); });
  change(false, "quarantine_with_robots", one, [](Request& request) { request.quarantine = "wrong"; });
  change(false, "quarantine_of_control_characters", none, [](Request& request) { request.quarantine = "\x1b[2J"; });
  return seeds;
}
}  // namespace devo_evo::fuzz
