#include "cli/commands.h"

#include "devo_evo/archive/archive.h"

#include <iostream>
#include <memory>
#include <string>

namespace devo_evo
{
void addDigestCommand(CLI::App& tool, Command& command)
{
  CLI::App* app = tool.add_subcommand(
      "digest", "Print the digest of an experiment: equal for equal evolution, whenever and on whatever it ran.");
  const auto output = std::make_shared<std::string>();
  app->add_option("OUTPUT", *output, "the folder that the experiment wrote to")->required();
  app->callback(
      [=, &command]
      {
        command = [output]
        {
          std::cout << openArchiveForReading(*output)->digest() << "\n";
          return EXIT_OK;
        };
      });
}
}  // namespace devo_evo
