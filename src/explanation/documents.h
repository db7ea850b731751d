#pragma once

#include <string>
#include <vector>

namespace devo_evo
{
/// A file of the repository as it was when this program was built.
struct Document
{
  std::string path;
  std::string content;
};

/// Those that explain names: pages of docs/, definitions of messages and services.
const std::vector<Document>& documents();
}  // namespace devo_evo
