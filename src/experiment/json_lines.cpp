#include "devo_evo/experiment/json_lines.h"

#include "devo_evo/soft_body/developmental_program.h"
#include "devo_evo/soft_body/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <utility>

namespace devo_evo
{
namespace
{
using Json = nlohmann::json;

// What bounds the length of a line: five arrays of numbers, generously printed, and everything else [bytes].
constexpr size_t BYTES_PER_VOXEL = 5 * 64;
constexpr size_t NOTE_ALLOWANCE = size_t{ 1 } << 20;

/// A value as messages show it: short, however large or deeply nested it is.
std::string describe(const Json& value)
{
  if (value.is_structured())
  {
    return value.is_array() ? "a list of " + toText(static_cast<int64_t>(value.size())) : "an object";
  }
  constexpr size_t longest = 80;
  const std::string text = value.dump();
  return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

/// Parses the object of one line, and follows where it is so that complaints can say so.
class RobotParser
{
public:
  /// @param position of the line, for messages.
  explicit RobotParser(std::string position) : position_(std::move(position)) {}

  /// @throw InvalidInput if the text is not one JSON object, or has a field twice.
  Json parse(const std::string& text)
  {
    try
    {
      Json robot = Json::parse(
          text, [this](int depth, Json::parse_event_t event, Json& parsed) { return follow(depth, event, parsed); });
      if (!robot.is_object())
      {
        throw InvalidInput(position_ + ": it holds " + describe(robot) + "; it must be a JSON object");
      }
      return robot;
    }
    catch (const Json::parse_error& error)
    {
      throw InvalidInput(position_ + ", column " + toText(static_cast<int64_t>(error.byte)) + ": malformed JSON" +
                         place() + ": " + reason(error, text));
    }
    catch (const Json::exception& error)
    {
      throw InvalidInput(position_ + ": malformed JSON" + place() + ": " + after("] ", error.what()));
    }
  }

private:
  bool follow(int depth, Json::parse_event_t event, const Json& parsed)
  {
    if (event == Json::parse_event_t::key && depth == 1)
    {
      field_ = parsed.get<std::string>();
      if (!fields_.insert(field_).second)
      {
        throw InvalidInput(position_ + ": the field " + describe(parsed) + " is given twice");
      }
    }
    else if (event == Json::parse_event_t::value && depth == 1 && field_ == "id")
    {
      robot_ = ", robot " + describe(parsed);
    }
    else if (event == Json::parse_event_t::array_start && depth == 1)
    {
      index_ = 0;
    }
    else if (event == Json::parse_event_t::array_end && depth == 1)
    {
      index_.reset();
    }
    else if (event == Json::parse_event_t::value && depth == 2 && index_)
    {
      ++*index_;
    }
    return true;
  }

  /// ", robot 7, size_gene_initial[17]", as far as known: the value that comes next.
  std::string place() const
  {
    return robot_ + (field_.empty() ? "" : ", " + field_) + (index_ ? "[" + toText(*index_) + "]" : "");
  }

  static std::string reason(const Json::parse_error& error, const std::string& text)
  {
    const size_t begin = std::max<size_t>(error.byte, 2) - 2;  // the error is found at the first or second letter
    for (const std::string word : { "NaN", "nan", "Infinity", "inf" })
    {
      const size_t found = text.find(word, begin);
      if (found != std::string::npos && found <= begin + 1)
      {
        return "it is " + word + "; it must be a finite number";
      }
    }
    return after(": ", error.what());
  }

  /// What comes after a mark; all if the mark does not occur.
  static std::string after(const std::string& mark, const std::string& message)
  {
    const size_t found = message.find(mark);
    return found == std::string::npos ? message : message.substr(found + mark.size());
  }

  const std::string position_;
  std::set<std::string> fields_;
  std::string robot_;
  std::string field_;
  std::optional<int64_t> index_;  ///< in the list that is being read
};

RobotId readId(const Json& robot)
{
  const auto id = robot.find("id");
  if (id != robot.end() && id->is_string())
  {
    return id->get<std::string>();
  }
  if (id != robot.end() && id->is_number_integer() && !(id->is_number_unsigned() && id->get<uint64_t>() > INT64_MAX))
  {
    return id->get<int64_t>();
  }
  throw InvalidInput("id is " + (id == robot.end() ? "missing" : describe(*id)) +
                     "; it must be text or a whole number");
}

bool has(const Json& robot, const char* name)
{
  const auto field = robot.find(name);
  return field != robot.end() && !field->is_null();
}

std::vector<double> readArray(const Json& robot, const std::string& name)
{
  const auto field = robot.find(name);
  if (field == robot.end() || !field->is_array())
  {
    throw InvalidInput(name + (field == robot.end() ? " is missing" : " is not a list") +
                       "; it must be a list of one number per voxel");
  }
  std::vector<double> values;
  values.reserve(field->size());
  for (const Json& value : *field)
  {
    if (!value.is_number())
    {
      throw InvalidInput(name + "[" + toText(static_cast<int64_t>(values.size())) + "] is " + describe(value) +
                         "; it must be a number");
    }
    values.push_back(value.get<double>());
  }
  return values;
}

std::vector<double> readArrayOr(const std::vector<double>& absent, const Json& robot, const char* name)
{
  return has(robot, name) ? readArray(robot, name) : absent;
}

void checkGrid(const Json& robot, const SoftBodySettings& settings)
{
  const Json grid = { settings.grid_x, settings.grid_y, settings.grid_z };
  if (has(robot, "grid") && robot["grid"] != grid)
  {
    throw InvalidInput("grid does not fit the parameter grid; it must be " + grid.dump());
  }
}

void checkMutationRates(const std::vector<double>& rates, const SoftBodySettings& settings)
{
  if (!rates.empty() && rates.size() != static_cast<size_t>(settings.voxelCount()))
  {
    throw InvalidInput("mutation_rate has " + toText(static_cast<int64_t>(rates.size())) + " values; it must have " +
                       toText(settings.voxelCount()) + " or none");
  }
  for (size_t i = 0; i < rates.size(); ++i)
  {
    if (!(rates[i] >= 0.0 && rates[i] <= 1.0))
    {
      throw InvalidInput("mutation_rate[" + toText(static_cast<int64_t>(i)) + "] is " + toText(rates[i]) +
                         "; it must lie within 0 to 1");
    }
  }
}

Genome readGenome(const Json& robot, const SoftBodySettings& settings)
{
  checkGrid(robot, settings);
  Genome genome;
  DevelopmentalProgram& program = genome.program;
  program.size_gene_initial = readArray(robot, "size_gene_initial");
  program.size_gene_final = readArrayOr(program.size_gene_initial, robot, "size_gene_final");
  program.phase_initial = readArray(robot, "phase_initial_cycles");
  program.phase_final = readArrayOr(program.phase_initial, robot, "phase_final_cycles");
  genome.mutation_rate = readArrayOr({}, robot, "mutation_rate");
  validate(program, settings);
  checkMutationRates(genome.mutation_rate, settings);
  return genome;
}

nlohmann::ordered_json toJson(const std::optional<double>& number)
{
  return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json();
}
}  // namespace

RobotReader::RobotReader(std::istream& input, std::string name, const SoftBodySettings& settings)
  : input_(input)
  , name_(std::move(name))
  , settings_(settings)
  , longest_line_(NOTE_ALLOWANCE + BYTES_PER_VOXEL * static_cast<size_t>(settings.voxelCount()))
{
}

std::optional<RobotRecord> RobotReader::next()
{
  do
  {
    if (!readLine())
    {
      return std::nullopt;
    }
  } while (text_.find_first_not_of(" \t\r") == std::string::npos);

  const Json robot = RobotParser(position()).parse(text_);
  std::string place = position();
  try
  {
    const RobotId id = readId(robot);
    place += ", robot " + toJson(id);
    return RobotRecord{ line_, id, readGenome(robot, settings_) };
  }
  catch (const InvalidInput& error)
  {
    throw InvalidInput(place + ": " + error.what());
  }
}

bool RobotReader::readLine()
{
  text_.clear();
  ++line_;
  std::streambuf& buffer = *input_.rdbuf();
  constexpr int END = std::char_traits<char>::eof();
  int character = buffer.sbumpc();
  const bool at_end = character == END;
  for (; character != END && character != '\n'; character = buffer.sbumpc())
  {
    text_ += static_cast<char>(character);
    if (text_.size() > longest_line_)
    {
      throw InvalidInput(position() + ": the line has more than " + toText(static_cast<int64_t>(longest_line_)) +
                         " bytes, more than any robot of this grid needs");
    }
  }
  constexpr char BYTE_ORDER_MARK[] = "\xef\xbb\xbf";
  if (line_ == 1 && text_.compare(0, 3, BYTE_ORDER_MARK) == 0)
  {
    text_.erase(0, 3);
  }
  return !at_end;
}

std::string RobotReader::position() const
{
  return name_ + ", line " + toText(line_);
}

std::string robotToJson(const RobotId& id, const Genome& genome, const SoftBodySettings& settings)
{
  const DevelopmentalProgram& program = genome.program;
  nlohmann::ordered_json json;
  std::visit([&json](const auto& value) { json["id"] = value; }, id);
  json["grid"] = { settings.grid_x, settings.grid_y, settings.grid_z };
  json["size_gene_initial"] = program.size_gene_initial;
  json["size_gene_final"] = program.size_gene_final;
  json["phase_initial_cycles"] = program.phase_initial;
  json["phase_final_cycles"] = program.phase_final;
  if (!genome.mutation_rate.empty())
  {
    json["mutation_rate"] = genome.mutation_rate;
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string evaluationToJson(const RobotId& id, const Evaluation& evaluation, const SoftBodySettings& settings)
{
  nlohmann::ordered_json json;  // writes NaN as null
  std::visit([&json](const auto& value) { json["id"] = value; }, id);
  json["valid"] = evaluation.valid;
  json["displacement_y_voxels"] = evaluation.displacement_y_voxels;
  json["displacement_xy_voxels"] = evaluation.displacement_xy_voxels;
  json["fitness"] = evaluation.fitness;
  json["first_top_contact_since_birth_s"] = toJson(evaluation.first_top_contact_since_birth_s);
  json["fell_over_since_birth_s"] = toJson(evaluation.fell_over_since_birth_s);
  json["turns"] = evaluation.turns;
  json["airborne_fraction"] = evaluation.airborne_fraction;
  json["velocity_body_lengths_per_s"] = evaluation.velocity_body_lengths_per_s;
  json["state_hash"] = evaluation.valid ? nlohmann::ordered_json(hashToString(evaluation.state_hash)) : nullptr;
  if (evaluation.divergence)
  {
    const Divergence& divergence = *evaluation.divergence;
    json["verdict"] = { { "step", divergence.step },
                        { "time_s", static_cast<double>(divergence.step) * settings.timeStep() },
                        { "bond", divergence.bond },
                        { "strain", divergence.strain },
                        { "message", divergence.describe(settings.timeStep()) } };
  }
  return json.dump();
}

std::string toJson(const RobotId& id)
{
  return std::visit([](const auto& value) { return Json(value).dump(); }, id);
}
}  // namespace devo_evo
