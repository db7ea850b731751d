#include "cli/interruption.h"

#include <csignal>

namespace devo_evo
{
namespace
{
volatile std::sig_atomic_t noted_signal = 0;

void note(int signal)
{
  noted_signal = signal;
}
}  // namespace

void noteInterruptions()
{
  struct sigaction action = {};
  action.sa_handler = note;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  for (const int signal : { SIGINT, SIGTERM, SIGHUP })
  {
    struct sigaction present = {};
    sigaction(signal, nullptr, &present);
    if (present.sa_handler != SIG_IGN)  // as under nohup
    {
      sigaction(signal, &action, nullptr);
    }
  }
}

int interruption()
{
  return noted_signal;
}

std::string signalName(int signal)
{
  return signal == SIGINT ? "SIGINT" : signal == SIGTERM ? "SIGTERM" : "SIGHUP";
}
}  // namespace devo_evo
