#include "ros/simulator_processes.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <set>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

namespace devo_evo
{
namespace
{
using namespace std::chrono_literals;

template <class Condition>
bool eventually(Condition condition)
{
  const auto end = std::chrono::steady_clock::now() + 20s;
  while (!condition())
  {
    if (std::chrono::steady_clock::now() > end)
    {
      return false;
    }
    std::this_thread::sleep_for(5ms);
  }
  return true;
}

/// Processes whose parent is `parent`.
std::set<pid_t> childrenOf(pid_t parent)
{
  std::set<pid_t> children;
  std::ifstream list("/proc/" + std::to_string(parent) + "/task/" + std::to_string(parent) + "/children");
  for (pid_t child = 0; list >> child;)
  {
    children.insert(child);
  }
  return children;
}

/// Zombies that nobody has fetched yet do not count.
bool alive(pid_t pid)
{
  std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
  std::string number, name, state;
  return (stat >> number >> name >> state) && state != "Z";
}

/// Runs runProcesses() in a process of its own.
class Supervisor
{
public:
  Supervisor(const std::vector<std::string>& arguments, int count) : pid_(fork())
  {
    if (pid_ == 0)
    {
      _exit(runProcesses("/bin/sh", arguments, count));
    }
  }
  ~Supervisor()
  {
    if (pid_ > 0 && !ended_)
    {
      kill(pid_, SIGTERM);
      wait();
    }
  }

  pid_t pid() const { return pid_; }

  int wait()
  {
    int status = 0;
    waitpid(pid_, &status, 0);
    ended_ = true;
    return status;
  }

private:
  pid_t pid_;
  bool ended_ = false;
};

const std::vector<std::string> SLEEP = { "-c", "exec sleep 60" };

TEST(SimulatorProcesses, AsManyRunAsWereAskedFor)
{
  const Supervisor supervisor(SLEEP, 3);
  EXPECT_TRUE(eventually([&] { return childrenOf(supervisor.pid()).size() == 3; }));
}

TEST(SimulatorProcesses, OneThatIsKilledIsStartedAgainAndTheOthersRunOn)
{
  const Supervisor supervisor(SLEEP, 3);
  ASSERT_TRUE(eventually([&] { return childrenOf(supervisor.pid()).size() == 3; }));
  const auto before = childrenOf(supervisor.pid());
  kill(*before.begin(), SIGKILL);
  ASSERT_TRUE(eventually([&] { return childrenOf(supervisor.pid()).count(*before.begin()) == 0; }));
  ASSERT_TRUE(eventually([&] { return childrenOf(supervisor.pid()).size() == 3; }));
  for (auto other = std::next(before.begin()); other != before.end(); ++other)
  {
    EXPECT_EQ(childrenOf(supervisor.pid()).count(*other), 1u);
  }
}

TEST(SimulatorProcesses, ASignalEndsThemAll)
{
  for (const int signal : { SIGINT, SIGTERM, SIGHUP })
  {
    Supervisor supervisor(SLEEP, 2);
    ASSERT_TRUE(eventually([&] { return childrenOf(supervisor.pid()).size() == 2; }));
    const auto children = childrenOf(supervisor.pid());
    kill(supervisor.pid(), signal);
    const int status = supervisor.wait();
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    for (const pid_t child : children)
    {
      EXPECT_TRUE(eventually([&] { return !alive(child); }));
    }
  }
}

TEST(SimulatorProcesses, TheyEndWhenTheirSupervisorIsKilled)
{
  Supervisor supervisor(SLEEP, 2);
  ASSERT_TRUE(eventually([&] { return childrenOf(supervisor.pid()).size() == 2; }));
  const auto children = childrenOf(supervisor.pid());
  std::this_thread::sleep_for(50ms);  // until they have asked to be told of their parent's end
  kill(supervisor.pid(), SIGKILL);
  supervisor.wait();
  for (const pid_t child : children)
  {
    EXPECT_TRUE(eventually([&] { return !alive(child); }));
  }
}

TEST(SimulatorProcesses, ThoseThatEndByThemselvesAreNotStartedAgain)
{
  Supervisor content({ "-c", "exit 0" }, 2);
  int status = content.wait();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  Supervisor failing({ "-c", "exit 3" }, 2);
  status = failing.wait();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1);
}

TEST(SimulatorProcesses, RemappingsAreInheritedButNamesAndParametersAreNot)
{
  const char* const arguments[] = { "simulators",      "__name:=simulators", "__log:=/tmp/log",
                                    "velocity:=speed", "_simulators:=4",     "__master:=http://localhost:1",
                                    "something" };
  EXPECT_EQ(inheritedArguments(7, arguments),
            (std::vector<std::string>{ "velocity:=speed", "__master:=http://localhost:1" }));
}

TEST(SimulatorProcesses, AtLeastOneCoreIsThere)
{
  EXPECT_GE(coreCount(), 1);
}
}  // namespace
}  // namespace devo_evo
