#include "cli/commands.h"

#include "devo_evo/experiment/build_info.h"
#include "devo_evo/explanation/explanation.h"

#include <iostream>
#include <memory>
#include <set>
#include <sstream>
#include <string>

namespace devo_evo
{
namespace
{
/// Text as roff has it.
std::string escaped(const std::string& text)
{
  std::string result;
  bool line_begins = true;
  for (const char character : text)
  {
    if (line_begins && (character == '.' || character == '\''))
    {
      result += "\\&";
    }
    result += character == '\\' ? "\\e" : character == '-' ? "\\-" : std::string(1, character);
    line_begins = character == '\n';
  }
  return result;
}

/// Lines as they are.
std::string verbatim(const std::string& text)
{
  return text.empty() ? "" : ".PP\n.nf\n" + escaped(text) + "\n.fi\n";
}

/// Subcommands in the order of their addition.
std::vector<const CLI::App*> commandsOf(const CLI::App& tool)
{
  return tool.get_subcommands([](const CLI::App*) { return true; });
}

std::string manualOf(const CLI::App& command)
{
  std::string usage, options;
  for (const CLI::Option* option : command.get_options())
  {
    const bool positional = option->get_positional();
    const bool takes_value = option->get_type_size() != 0;
    const std::string name = positional ? option->get_name(true) : option->get_name(false, true);
    if (positional)
    {
      usage += " " + (option->get_required() ? name : "[" + name + "]");
    }
    options += ".TP\n.B " + escaped(name + (takes_value && !positional ? " " + option->get_type_name() : "")) + "\n" +
               escaped(option->get_description()) + "\n";
  }
  return ".SS " + command.get_name() + "\n.B devo_evo " + command.get_name() + "\n[options]" + escaped(usage) +
         "\n.PP\n" + escaped(command.get_description()) + "\n" + options + verbatim(command.get_footer());
}

std::string manual(const CLI::App& tool)
{
  std::string text = ".TH DEVO_EVO 1 \"\" \"devo_evo " + buildInfo().version + "\" \"User Commands\"\n" +
                     ".SH NAME\ndevo_evo \\- evolve soft robots that develop while they live, without ROS\n" +
                     ".SH SYNOPSIS\n.B devo_evo\n.I COMMAND\n[options]\n.SH DESCRIPTION\n" +
                     escaped(tool.get_description()) + "\n" + verbatim(tool.get_footer()) + ".SH COMMANDS\n";
  for (const CLI::App* command : commandsOf(tool))
  {
    text += manualOf(*command);
  }
  return text + ".SH SEE ALSO\nThe pages of docs/ in the repository; \n.BR roslaunch (1),\n.BR sqlite3 (1)\n";
}

std::string bashCompletion(const CLI::App& tool)
{
  std::string names, cases;
  for (const CLI::App* command : commandsOf(tool))
  {
    names += (names.empty() ? "" : " ") + command->get_name();
    std::string words;
    for (const CLI::Option* option : command->get_options())
    {
      for (const std::string& name : option->get_lnames())
      {
        words += (words.empty() ? "--" : " --") + name;
      }
    }
    cases += "    " + command->get_name() + ") options=\"" + words + "\" ;;\n";
  }
  std::set<std::string> explained;
  for (const Explanation& each : explanations())
  {
    explained.insert(each.name);
  }
  std::string topics;
  for (const std::string& name : explained)
  {
    topics += (topics.empty() ? "" : " ") + name;
  }
  return "# Completion of devo_evo for bash. Written by \"devo_evo manual --bash\".\n"
         "_devo_evo()\n"
         "{\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} options=\"\"\n"
         "  COMPREPLY=()\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    COMPREPLY=($(compgen -W \"" +
         names +
         " --help --version\" -- \"$word\"))\n"
         "    return\n"
         "  fi\n"
         "  case ${COMP_WORDS[1]} in\n" +
         cases +
         "  esac\n"
         "  if [[ $word == -* ]]; then\n"
         "    COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n"
         "  elif [ \"${COMP_WORDS[1]}\" = explain ]; then\n"
         "    COMPREPLY=($(compgen -W \"" +
         topics +
         "\" -- \"$word\"))\n"
         "  fi  # else names of files, by -o default\n"
         "}\n"
         "complete -o default -F _devo_evo devo_evo\n";
}
}  // namespace

void addManualCommand(CLI::App& tool, Command& command)
{
  CLI::App* app = tool.add_subcommand("manual", "Print the manual page (roff), or completion for bash.");
  const auto bash = std::make_shared<bool>(false);
  app->add_flag("--bash", *bash, "print completion for bash");
  app->footer(
      "Both are installed. Without installation:\n"
      "  devo_evo manual | man -l -\n"
      "  source <(devo_evo manual --bash)");
  app->callback(
      [=, &tool, &command]
      {
        command = [=, &tool]
        {
          std::cout << (*bash ? bashCompletion(tool) : manual(tool));
          return EXIT_OK;
        };
      });
}
}  // namespace devo_evo
