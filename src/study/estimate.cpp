#include "devo_evo/study/study.h"

#include "devo_evo/experiment/report_text.h"
#include "devo_evo/soft_body/text.h"
#include "study/speed.h"
#include "study/workload.h"

namespace devo_evo
{
namespace
{
std::string padded(const std::string& text, size_t width, bool right)
{
  const std::string spaces(width > text.size() ? width - text.size() : 0, ' ');
  return right ? spaces + text : text + spaces;
}

std::string row(const std::string& part, const std::string& evaluations, const std::string& left,
                const std::string& time)
{
  return padded(part, 12, false) + padded(evaluations, 13, true) + padded(left, 13, true) + "   " + time + "\n";
}
}  // namespace

std::string estimateText(const Parameters& parameters, int threads, InstructionSet instruction_set)
{
  validateStudy(parameters);
  const double rate = evaluationsPerSecond(parameters.experiment.body.soft, threads, instruction_set);
  const auto rate_of = [&](StudyPart part)
  { return part == StudyPart::RIGID ? quadrupedsPerSecond(parameters.experiment.body.rigid, threads) : rate; };
  std::string text = row("part", "evaluations", "left", "time");
  Workload sum = {};
  double seconds = 0.0;
  for (const Workload& load : workloads(parameters))
  {
    const double own = load.left > 0 ? static_cast<double>(load.left) / rate_of(load.part) : 0.0;
    text += row(toString(load.part), toText(load.evaluations), toText(load.left), durationText(own));
    sum.evaluations += load.evaluations;
    sum.left += load.left;
    seconds += own;
  }
  return text + row("all", toText(sum.evaluations), toText(sum.left), durationText(seconds)) + "at " +
         fixedText(rate, 1) + " evaluations/s, measured on this machine with " + toText(threads) +
         (threads == 1 ? " worker" : " workers");
}
}  // namespace devo_evo
