#include "ros/node_main.h"

#include "devo_evo/soft_body/text.h"

#include <ros/console.h>
#include <ros/init.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <unistd.h>

namespace devo_evo
{
namespace
{
std::atomic<bool> interrupted{ false };

void requestShutdown(int /*signal*/)
{
  interrupted = true;
  ros::requestShutdown();  // sets a flag
}

void noteInterruption(int /*signal*/)
{
  interrupted = true;
}

void goOn(int /*signal*/)
{
}

void onInterruption(void (*handler)(int))
{
  for (const int signal : { SIGINT, SIGTERM, SIGHUP })
  {
    std::signal(signal, handler);
  }
}
}  // namespace

void say(const std::string& text)
{
  if (ros::ok())
  {
    ROS_INFO_STREAM(text);
  }
  else
  {
    std::cout << text << std::endl;
  }
}

ScopedInterruption::ScopedInterruption()
{
  onInterruption(noteInterruption);
}

ScopedInterruption::~ScopedInterruption()
{
  onInterruption(requestShutdown);
}

bool ScopedInterruption::happened()
{
  return interrupted;
}

void surviveAssertions()
{
  std::signal(SIGTRAP, goOn);
}

int runNode(const std::function<int()>& body)
{
  onInterruption(requestShutdown);
  surviveAssertions();
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // so that messages come in time through pipes, too
  try
  {
    return body();
  }
  catch (const std::exception& e)
  {
    if (ros::ok())
    {
      ROS_FATAL_STREAM(e.what());
    }
    else
    {
      std::cerr << "[FATAL] " << e.what() << std::endl;
    }
    return 1;
  }
}

void leaveStatus(int status)
{
  if (const char* const file = std::getenv("DEVO_EVO_STATUS_FILE"))
  {
    std::ofstream(file) << toText(status) << std::endl;
  }
}

std::string hostName()
{
  char name[256] = {};
  gethostname(name, sizeof(name) - 1);
  return name;
}

std::string nodeNameOnHost(const std::string& kind)
{
  std::string name = kind + "_" + hostName();
  for (char& letter : name)
  {
    const bool plain =
        (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9');
    letter = plain ? letter : '_';
  }
  return name;
}
}  // namespace devo_evo
