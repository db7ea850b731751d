#include "ros/simulator_processes.h"

#include <ros/console.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <climits>
#include <csignal>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <utility>

#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace devo_evo
{
namespace
{
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds SHORTEST_RESTART_DELAY{ 1 };
constexpr std::chrono::seconds LONGEST_RESTART_DELAY{ 60 };
constexpr std::chrono::seconds HEALTHY_LIFE{ 60 };  // one that lived so long may be started again at once
constexpr std::chrono::seconds STOP_TIMEOUT{ 5 };   // for processes that were told to end

struct Process
{
  pid_t pid = 0;  // 0: does not run
  Clock::time_point started;
  std::chrono::seconds restart_delay = SHORTEST_RESTART_DELAY;
  std::optional<Clock::time_point> restart_at;
};

class Processes
{
public:
  Processes(const std::string& program, const std::vector<std::string>& arguments, int count)
    : program_(program), arguments_(arguments), processes_(static_cast<size_t>(count))
  {
    sigemptyset(&signals_);
    for (const int signal : { SIGCHLD, SIGINT, SIGTERM, SIGHUP })
    {
      sigaddset(&signals_, signal);
    }
    sigprocmask(SIG_BLOCK, &signals_, &original_signals_);
  }

  int run()
  {
    for (Process& process : processes_)
    {
      start(process);
    }
    while (std::any_of(processes_.begin(), processes_.end(), wanted))
    {
      const int signal = waitForSignal();
      reap();
      if (signal == SIGINT || signal == SIGTERM || signal == SIGHUP)
      {
        stopAll();
        return 0;
      }
      restartDue();
    }
    return failed_ ? 1 : 0;
  }

private:
  static bool wanted(const Process& process) { return process.pid != 0 || process.restart_at; }
  static bool running(const Process& process) { return process.pid != 0; }

  void start(Process& process)
  {
    std::vector<char*> argv = { const_cast<char*>(program_.c_str()) };
    for (const std::string& argument : arguments_)
    {
      argv.push_back(const_cast<char*>(argument.c_str()));
    }
    argv.push_back(nullptr);
    process.restart_at.reset();
    process.started = Clock::now();
    const pid_t parent = getpid();
    process.pid = fork();
    if (process.pid < 0)
    {
      throw std::runtime_error(std::string("cannot start a process: ") + std::strerror(errno));
    }
    if (process.pid == 0)
    {
      prctl(PR_SET_PDEATHSIG, SIGTERM);  // end when the parent does, however it does
      if (getppid() == parent)
      {
        sigprocmask(SIG_SETMASK, &original_signals_, nullptr);
        execv(program_.c_str(), argv.data());
      }
      _exit(127);
    }
  }

  /// @return a signal, or 0 if it is time to look after restarts.
  int waitForSignal() const
  {
    const timespec a_while = { 0, 200'000'000 };
    return std::max(0, sigtimedwait(&signals_, nullptr, &a_while));
  }

  void reap()
  {
    int status = 0;
    for (pid_t pid = waitpid(-1, &status, WNOHANG); pid > 0; pid = waitpid(-1, &status, WNOHANG))
    {
      const auto process =
          std::find_if(processes_.begin(), processes_.end(), [pid](const Process& each) { return each.pid == pid; });
      if (process != processes_.end())
      {
        ended(*process, status);
      }
    }
  }

  void ended(Process& process, int status)
  {
    const pid_t pid = std::exchange(process.pid, 0);
    if (!WIFSIGNALED(status))
    {
      failed_ = failed_ || WEXITSTATUS(status) != 0;
      ROS_WARN_STREAM("process " << pid << " ended by itself with status " << WEXITSTATUS(status));
      return;
    }
    const bool healthy = Clock::now() - process.started > HEALTHY_LIFE;
    const std::chrono::seconds delay = healthy ? SHORTEST_RESTART_DELAY : process.restart_delay;
    process.restart_delay = std::min(2 * delay, LONGEST_RESTART_DELAY);
    process.restart_at = Clock::now() + delay;
    ROS_WARN_STREAM("process " << pid << " was killed by signal " << WTERMSIG(status) << "; starting another in "
                               << delay.count() << " s");
  }

  void restartDue()
  {
    for (Process& process : processes_)
    {
      if (process.restart_at && Clock::now() >= *process.restart_at)
      {
        start(process);
        ROS_INFO_STREAM("started process " << process.pid);
      }
    }
  }

  void signalAll(int signal) const
  {
    for (const Process& process : processes_)
    {
      if (running(process))
      {
        kill(process.pid, signal);
      }
    }
  }

  void stopAll()
  {
    signalAll(SIGTERM);
    const Clock::time_point end = Clock::now() + STOP_TIMEOUT;
    while (std::any_of(processes_.begin(), processes_.end(), running) && Clock::now() < end)
    {
      waitForSignal();
      int status = 0;
      for (Process& process : processes_)
      {
        if (running(process) && waitpid(process.pid, &status, WNOHANG) == process.pid)
        {
          process.pid = 0;
        }
      }
    }
    signalAll(SIGKILL);
  }

  const std::string program_;
  const std::vector<std::string> arguments_;
  std::vector<Process> processes_;
  sigset_t signals_;
  sigset_t original_signals_;
  bool failed_ = false;
};
}  // namespace

int coreCount()
{
  cpu_set_t cores;
  return sched_getaffinity(0, sizeof(cores), &cores) == 0 ? CPU_COUNT(&cores) : 1;
}

std::string siblingProgram(const std::string& name)
{
  char path[PATH_MAX] = {};
  if (readlink("/proc/self/exe", path, sizeof(path) - 1) < 0)
  {
    throw std::runtime_error(std::string("cannot find out where this program lies: ") + std::strerror(errno));
  }
  const std::string own(path);
  const std::string sibling = own.substr(0, own.rfind('/') + 1) + name;
  if (access(sibling.c_str(), X_OK) != 0)
  {
    throw std::runtime_error("there is no program " + sibling);
  }
  return sibling;
}

std::vector<std::string> inheritedArguments(int argc, const char* const* argv)
{
  std::vector<std::string> inherited;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument(argv[i]);
    const bool own = argument.rfind("__name:=", 0) == 0 || argument.rfind("__log:=", 0) == 0;
    const bool parameter = argument[0] == '_' && argument.rfind("__", 0) != 0;
    if (argument.find(":=") != std::string::npos && !own && !parameter)
    {
      inherited.push_back(argument);
    }
  }
  return inherited;
}

int runProcesses(const std::string& program, const std::vector<std::string>& arguments, int count)
{
  return Processes(program, arguments, count).run();
}
}  // namespace devo_evo
