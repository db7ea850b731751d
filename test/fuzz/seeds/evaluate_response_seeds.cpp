#include "fuzz/ros/asked_robots.h"
#include "fuzz/seeds/message_bytes.h"
#include "fuzz/seeds/seeds.h"
#include "ros/conversions.h"
#include "ros/message_fields.h"

#include <limits>

namespace devo_evo::fuzz
{
namespace
{
using Response = EvaluateGenomes::Response;

/// On the first robot that it lived, on the second that its simulation failed.
Response responseFor(uint8_t choice)
{
  const std::shared_ptr<const Body> body = makeBody(askedBody(choice));
  const std::vector<EvaluationRequest> robots = askedRobots();
  Response response;
  response.evaluations.push_back(toMsg(soundEvaluation(*body), robots[0].trial, robots[0].id, *body));
  response.evaluations.push_back(toMsg(failedEvaluation(), robots[1].trial, robots[1].id, *body));
  if ((choice & SHORT_LIFE) != 0)
  {
    response.evaluations.front().velocity.clear();
  }
  return response;
}

std::string inputOf(uint8_t choice, const std::string& bytes)
{
  return static_cast<char>(choice) + bytes;
}

Response refused()
{
  Response response;
  response.error = "no engine has this fingerprint";
  return response;
}
}  // namespace

std::vector<Seed> evaluateResponseSeeds()
{
  std::vector<Seed> seeds;
  const auto add = [&seeds](bool valid, const std::string& name, const std::string& input) {
    seeds.push_back({ "evaluate_response", valid, name, input });
  };
  const auto change = [&add](const std::string& name, uint8_t choice, const std::function<void(Response&)>& changed)
  { add(false, name, inputOf(choice, bytesOf(with(responseFor(choice), changed)))); };

  add(true, "two", inputOf(LONG_LIFE, bytesOf(responseFor(LONG_LIFE))));
  add(true, "short_life", inputOf(SHORT_LIFE, bytesOf(responseFor(SHORT_LIFE))));
  add(true, "rigid", inputOf(RIGID_BODY, bytesOf(responseFor(RIGID_BODY))));

  add(false, "refused", inputOf(LONG_LIFE, bytesOf(refused())));
  add(false, "cut_short", inputOf(LONG_LIFE, cutShort(bytesOf(responseFor(LONG_LIFE)), 9)));
  // Evaluations and error are empty: two lengths.
  add(false, "endless_evaluations", inputOf(LONG_LIFE, withEndlessArray(bytesOf(Response()), 2 * sizeof(uint32_t))));
  add(false, "another_body", inputOf(RIGID_BODY, bytesOf(responseFor(LONG_LIFE))));
  change("one_missing", LONG_LIFE, [](Response& response) { response.evaluations.pop_back(); });
  change("another_robot", LONG_LIFE, [](Response& response) { response.evaluations[1].id = 8; });
  change("not_finite", LONG_LIFE,
         [](Response& response) { response.evaluations[0].fitness = std::numeric_limits<double>::infinity(); });
  change("without_velocities", LONG_LIFE, [](Response& response) { response.evaluations[0].velocity.clear(); });
  change("too_many_velocities", LONG_LIFE, [](Response& response) { response.evaluations[0].velocity.resize(9); });
  change("measure_unknown", LONG_LIFE,
         [](Response& response) { response.evaluations[0].measures[1].name = "leg_contact"; });
  change("measure_missing", LONG_LIFE, [](Response& response) { response.evaluations[0].measures.pop_back(); });
  change("airborne_for_longer_than_life", LONG_LIFE,
         [](Response& response) { test::valueOf(response.evaluations[0].measures, "airborne_fraction") = 1.5; });
  change("valid_failure", LONG_LIFE, [](Response& response) { response.evaluations[1].valid = true; });
  change("failed_between_steps", LONG_LIFE,
         [](Response& response) { test::valueOf(response.evaluations[1].failure, "divergence_step") = 1.5; });
  change("failed_with_hash", LONG_LIFE, [](Response& response) { response.evaluations[1].state_hash = 1; });
  change("rigid_fitness_negative", RIGID_BODY, [](Response& response) { response.evaluations[0].fitness = -1.0; });
  change("rigid_failed_after_life", RIGID_BODY,
         [](Response& response) { test::valueOf(response.evaluations[1].failure, "divergence_step") = 1e9; });
  return seeds;
}
}  // namespace devo_evo::fuzz
