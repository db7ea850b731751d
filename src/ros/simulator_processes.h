#pragma once

#include <string>
#include <vector>

namespace devo_evo
{
/// How many cores this process may use.
int coreCount();

/// Path of a program that lies beside this one. @throw std::runtime_error if it does not.
std::string siblingProgram(const std::string& name);

/// Those of a node's arguments that other nodes started by it should have too: remappings, but neither its name and log
/// file nor its private parameters.
std::vector<std::string> inheritedArguments(int argc, const char* const* argv);

/// Starts `count` processes and keeps them running until this process gets SIGINT, SIGTERM or SIGHUP, which then ends
/// them all; if it is killed, they end as well. One that is killed by a signal is started again after a second (longer
/// if it keeps happening), and the log says so; one that ends by itself is not.
/// @return exit status: 0, or 1 if every process has ended by itself and one of them in failure.
int runProcesses(const std::string& program, const std::vector<std::string>& arguments, int count);
}  // namespace devo_evo
