#pragma once

#include <string>

namespace devo_evo
{
/// From now on the first SIGINT, SIGTERM or SIGHUP is only noted; a second one ends the program at once.
void noteInterruptions();

/// The signal that was noted; 0 if none was.
int interruption();

/// The name of one of these: "SIGINT".
std::string signalName(int signal);
}  // namespace devo_evo
