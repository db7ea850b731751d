#include "cli/robot_source.h"

#include "devo_evo/soft_body/text.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <set>
#include <sstream>

namespace devo_evo
{
namespace
{
std::unique_ptr<std::istream> keepInMemory(std::istream& input)
{
  auto content = std::make_unique<std::stringstream>();
  if (input.peek() != std::char_traits<char>::eof())
  {
    *content << input.rdbuf();
  }
  return content;
}

std::unique_ptr<std::istream> openInput(const std::string& path)
{
  if (path == "-")
  {
    return keepInMemory(std::cin);
  }
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
  {
    throw InvalidInput(path + ": it is a folder; a file of JSON lines is needed");
  }
  auto file = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!*file)
  {
    throw InvalidInput(path + ": it cannot be read: " + std::strerror(errno));
  }
  return std::filesystem::is_regular_file(path, ignored) ? std::move(file) : keepInMemory(*file);
}
}  // namespace

RobotSource::RobotSource(const std::string& path)
  : name_(path == "-" ? "standard input" : path), input_(openInput(path))
{
}

void RobotSource::check(const Body& body)
{
  RobotReader reader = read(body);
  std::set<RobotId> ids;
  std::optional<RobotRecord> repeated;
  while (const auto robot = reader.next())
  {
    if (!ids.insert(robot->id).second && !repeated)
    {
      repeated = robot;
    }
  }
  if (repeated)
  {
    std::cerr << "devo_evo: warning: " << name_ << ", line " << toText(repeated->line)
              << ": an earlier robot is called " << toJson(repeated->id)
              << " too; results come in the order of the robots\n";
  }
  if (ids.empty())
  {
    std::cerr << "devo_evo: warning: " << name_ << ": there is no robot in it\n";
  }
}

RobotReader RobotSource::read(const Body& body)
{
  input_->clear();
  input_->seekg(0);
  return RobotReader(*input_, name_, body);
}
}  // namespace devo_evo
