#pragma once

#include "devo_evo/bodies/bodies.h"
#include "devo_evo/evolution/genome.h"

#include <ros/serialization.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>

namespace devo_evo::fuzz
{
/// A message as it goes over the network.
template <class Message>
std::string bytesOf(const Message& message)
{
  std::string bytes(ros::serialization::serializationLength(message), '\0');
  ros::serialization::OStream stream(reinterpret_cast<uint8_t*>(bytes.data()), static_cast<uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

/// A copy of a message with something changed.
template <class Message>
Message with(Message message, const std::function<void(Message&)>& change)
{
  change(message);
  return message;
}

/// The bytes with the length of an array replaced by the largest there is. @param from_end where it stands.
inline std::string withEndlessArray(std::string bytes, size_t from_end)
{
  return bytes.replace(bytes.size() - from_end, sizeof(uint32_t), sizeof(uint32_t), '\xff');
}

/// Bytes without the last of them.
inline std::string cutShort(const std::string& bytes, size_t count)
{
  return bytes.substr(0, bytes.size() - count);
}

/// Every number differs from its neighbours; some lie at the ends of their range.
inline DevelopmentalProgram programFor(const Body& body)
{
  const GenomeLayout layout = body.layout(EvolutionSettings());
  const auto fill = [](const GenomePart& part, double share_of_range)
  {
    std::vector<double> values;
    for (size_t i = 0; i < part.size; ++i)
    {
      const double share = share_of_range * static_cast<double>(i + 1) / static_cast<double>(part.size);
      values.push_back(part.lowest + share * (part.highest - part.lowest));
    }
    return values;
  };
  return { fill(layout.morphology, 1.0), fill(layout.morphology, 0.5), fill(layout.control, 0.75),
           fill(layout.control, 0.25) };
}

/// What programFor() gives: of a soft body its life, which is the same everywhere; of a rigid one, whose life depends
/// on the build of ODE, numbers within their ranges.
inline Evaluation soundEvaluation(const Body& body)
{
  if (body.kind() == "soft")
  {
    return body.evaluate({ programFor(body) }, InstructionSet::SCALAR).front();
  }
  Evaluation evaluation;
  evaluation.valid = true;
  evaluation.fitness = 0.125;
  for (const Measure& measure : body.measures())
  {
    measure.set(evaluation, std::clamp(0.125, measure.minimum, measure.maximum));
  }
  evaluation.velocity_body_lengths_per_s.assign(3, -0.25);
  evaluation.state_hash = 0x0123456789abcdef;
  return evaluation;
}

/// A simulation that was given up.
inline Evaluation failedEvaluation()
{
  Evaluation evaluation;
  evaluation.divergence = Divergence{ 1, 0, 101.0 };
  return evaluation;
}
}  // namespace devo_evo::fuzz
