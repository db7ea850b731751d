#include "fuzz/seeds/message_bytes.h"
#include "fuzz/seeds/seeds.h"
#include "ros/conversions.h"

#include <limits>

namespace devo_evo::fuzz
{
namespace
{
SimulatorAnnouncement announcement()
{
  SimulatorAnnouncement message;
  message.header.stamp = ros::Time(1500000000, 5);
  message.name = "/devo_evo/simulator_alpha_1";
  message.service = "/devo_evo/simulator_alpha_1/evaluate";
  message.host = "alpha";
  message.pid = 4711;
  message.version = "0.1.0 (0123abc)";
  message.engines.resize(2);
  message.engines[0].body = "soft";
  message.engines[0].fingerprint = 0x0123456789abcdef;
  message.engines[1].body = "rigid";
  message.engines[1].fingerprint = 1;
  message.instruction_set = "avx512";
  message.lanes = 8;
  message.period = 0.5;
  message.processor = "Analytical Engine";
  return message;
}
}  // namespace

std::vector<Seed> announcementSeeds()
{
  std::vector<Seed> seeds;
  const auto change = [&seeds](bool valid, const std::string& name,
                               const std::function<void(SimulatorAnnouncement&)>& changed) {
    seeds.push_back({ "announcement", valid, name, bytesOf(with(announcement(), changed)) });
  };

  change(true, "sound", [](SimulatorAnnouncement&) {});
  change(true, "busy",
         [](SimulatorAnnouncement& message)
         {
           message.busy = true;
           message.evaluations = std::numeric_limits<int64_t>::max();
         });
  change(true, "without_engines", [](SimulatorAnnouncement& message) { message.engines.clear(); });
  change(true, "at_the_limits",
         [](SimulatorAnnouncement& message)
         {
           message.host = std::string(255, 'h');
           message.lanes = EvaluateGenomes::Request::MAX_GENOMES;
           message.period = 60.0;
           message.engines.resize(16);
         });

  seeds.push_back({ "announcement", false, "cut_short", cutShort(bytesOf(announcement()), 3) });
  // The message ends with the processor's name.
  seeds.push_back({ "announcement", false, "endless_processor",
                    withEndlessArray(bytesOf(announcement()), announcement().processor.size() + sizeof(uint32_t)) });
  change(false, "relative_name", [](SimulatorAnnouncement& message) { message.name = "simulator"; });
  change(false, "endless_name", [](SimulatorAnnouncement& message) { message.name = "/" + std::string(255, 'a'); });
  change(false, "no_service", [](SimulatorAnnouncement& message) { message.service.clear(); });
  change(false, "control_characters", [](SimulatorAnnouncement& message) { message.host = "alpha\n[FATAL] beta"; });
  change(false, "not_ascii", [](SimulatorAnnouncement& message) { message.processor = "\xc3\xa4"; });
  change(false, "lanes_out_of_range", [](SimulatorAnnouncement& message) { message.lanes = 65; });
  change(false, "period_of_zero", [](SimulatorAnnouncement& message) { message.period = 0.0; });
  change(false, "period_not_a_number",
         [](SimulatorAnnouncement& message) { message.period = std::numeric_limits<double>::quiet_NaN(); });
  change(false, "evaluations_negative", [](SimulatorAnnouncement& message) { message.evaluations = -1; });
  change(false, "too_many_engines", [](SimulatorAnnouncement& message) { message.engines.resize(17); });
  return seeds;
}
}  // namespace devo_evo::fuzz
