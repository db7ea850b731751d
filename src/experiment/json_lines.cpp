#include "devo_evo/experiment/json_lines.h"

#include "devo_evo/bodies/bodies.h"
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

// What bounds the length of a line: its numbers, generously printed, and everything else [bytes].
constexpr size_t BYTES_PER_NUMBER = 64;
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

bool has(const Json& robot, const std::string& name)
{
  const auto field = robot.find(name);
  return field != robot.end() && !field->is_null();
}

std::vector<double> readArray(const Json& robot, const std::string& name, const std::string& place)
{
  const auto field = robot.find(name);
  if (field == robot.end() || !field->is_array())
  {
    throw InvalidInput(name + (field == robot.end() ? " is missing" : " is not a list") +
                       "; it must be a list of one number per " + place);
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

std::vector<double> readArrayOr(const std::vector<double>& absent, const Json& robot, const std::string& name,
                                const std::string& place)
{
  return has(robot, name) ? readArray(robot, name, place) : absent;
}

/// Refuses robots of another kind, whether they say so or have its arrays.
void checkKind(const Json& robot, const std::string& kind)
{
  if (has(robot, "body") && robot["body"] != kind)
  {
    throw InvalidInput("body is " + describe(robot["body"]) + ", and the parameter body is " + kind +
                       "; a robot of that kind of body is needed, or the other parameter");
  }
  for (const auto& [name, value] : robot.items())
  {
    const auto other = kindWithArray(name);
    if (other && toString(*other) != kind)
    {
      throw InvalidInput("it is a robot with a " + toString(*other) + " body, since it has " + name +
                         ", and the parameter body is " + kind +
                         "; a robot of that kind of body is needed, or the other parameter");
    }
  }
}

void checkGrid(const Json& robot, const GenomeLayout& layout)
{
  const Json grid = layout.grid;
  if (has(robot, "grid") && !layout.grid.empty() && robot["grid"] != grid)
  {
    throw InvalidInput("grid does not fit the parameter grid; it must be " + grid.dump());
  }
}

void checkMutationRates(const std::vector<double>& rates, const GenomeLayout& layout)
{
  if (!rates.empty() && rates.size() != layout.morphology.size)
  {
    throw InvalidInput("mutation_rate has " + toText(static_cast<int64_t>(rates.size())) + " values; it must have " +
                       toText(static_cast<int64_t>(layout.morphology.size)) + " or none");
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

std::string initialField(const GenomePart& part)
{
  return part.initialName() + part.file_suffix;
}

std::string finalField(const GenomePart& part)
{
  return part.finalName() + part.file_suffix;
}

Genome readGenome(const Json& robot, const GenomeLayout& layout)
{
  checkGrid(robot, layout);
  Genome genome;
  const auto read = [&robot](const GenomePart& part, std::vector<double>& initial, std::vector<double>& final)
  {
    initial = readArray(robot, initialField(part), part.place);
    final = readArrayOr(initial, robot, finalField(part), part.place);
  };
  read(layout.morphology, genome.program.morphology_initial, genome.program.morphology_final);
  read(layout.control, genome.program.control_initial, genome.program.control_final);
  genome.mutation_rate = readArrayOr({}, robot, "mutation_rate", layout.morphology.place);
  validate(genome.program, layout);
  checkMutationRates(genome.mutation_rate, layout);
  return genome;
}
}  // namespace

RobotReader::RobotReader(std::istream& input, std::string name, const Body& body)
  : input_(input)
  , name_(std::move(name))
  , kind_(body.kind())
  , layout_(body.layout(EvolutionSettings()))
  , longest_line_(NOTE_ALLOWANCE + BYTES_PER_NUMBER * (3 * layout_.morphology.size + 2 * layout_.control.size))
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
    checkKind(robot, kind_);
    return RobotRecord{ line_, id, readGenome(robot, layout_) };
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
                         " bytes, more than any robot of this size needs");
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

std::string robotToJson(const RobotId& id, const Genome& genome, const Body& body)
{
  const GenomeLayout layout = body.layout(EvolutionSettings());
  const DevelopmentalProgram& program = genome.program;
  nlohmann::ordered_json json;
  std::visit([&json](const auto& value) { json["id"] = value; }, id);
  json["body"] = body.kind();
  if (!layout.grid.empty())
  {
    json["grid"] = layout.grid;
  }
  json[initialField(layout.morphology)] = program.morphology_initial;
  json[finalField(layout.morphology)] = program.morphology_final;
  json[initialField(layout.control)] = program.control_initial;
  json[finalField(layout.control)] = program.control_final;
  if (!genome.mutation_rate.empty())
  {
    json["mutation_rate"] = genome.mutation_rate;
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string evaluationToJson(const RobotId& id, const Evaluation& evaluation, const Body& body)
{
  nlohmann::ordered_json json;  // writes what is not a number as null
  std::visit([&json](const auto& value) { json["id"] = value; }, id);
  json["valid"] = evaluation.valid;
  json["fitness"] = evaluation.fitness;
  for (const Measure& measure : body.measures())
  {
    json[measure.name] = measure.get(evaluation);
  }
  json["velocity_body_lengths_per_s"] = evaluation.velocity_body_lengths_per_s;
  json["state_hash"] = evaluation.valid ? nlohmann::ordered_json(hashToString(evaluation.state_hash)) : nullptr;
  if (!evaluation.valid)
  {
    nlohmann::ordered_json verdict = { { "time_s", body.failureTime(evaluation) } };
    for (const Measure& measure : body.failureMeasures())
    {
      const double value = measure.get(evaluation);
      const std::string name = measure.name.substr(std::string("divergence_").size());
      verdict[name] =
          measure.whole ? nlohmann::ordered_json(static_cast<int64_t>(value)) : nlohmann::ordered_json(value);
    }
    verdict["message"] = body.describeFailure(evaluation);
    json["verdict"] = verdict;
  }
  return json.dump();
}

std::string toJson(const RobotId& id)
{
  return std::visit([](const auto& value) { return Json(value).dump(); }, id);
}
}  // namespace devo_evo
