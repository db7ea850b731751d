#include "picture/child_process.h"

#include "devo_evo/picture/image.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace devo_evo
{
namespace
{
std::vector<char*> argumentArray(const std::string& program, const std::vector<std::string>& arguments)
{
  std::vector<char*> array{ const_cast<char*>(program.c_str()) };
  for (const std::string& argument : arguments)
  {
    array.push_back(const_cast<char*>(argument.c_str()));
  }
  array.push_back(nullptr);
  return array;
}
}  // namespace

ChildProcess::ChildProcess(const std::string& program, const std::vector<std::string>& arguments)
{
  int ends[2];  // a socket, since writing to one whose reader is gone need not raise SIGPIPE
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
  {
    throw PictureError(program + " cannot be started: " + std::strerror(errno));
  }
  input_ = ends[0];
  errors_ = memfd_create("errors", MFD_CLOEXEC);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, errors_, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  const int error =
      posix_spawnp(&pid_, program.c_str(), &actions, &attributes, argumentArray(program, arguments).data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  if (error != 0)
  {
    pid_ = -1;
    closeInput();
    close(errors_);
    throw PictureError(program + " cannot be started: " + std::strerror(error));
  }
}

ChildProcess::~ChildProcess()
{
  kill();
  close(errors_);
}

bool ChildProcess::write(const void* data, size_t size)
{
  const char* next = static_cast<const char*>(data);
  while (size > 0)
  {
    const ssize_t written = send(input_, next, size, MSG_NOSIGNAL);
    if (written < 0 && errno != EINTR)
    {
      return false;
    }
    if (written > 0)
    {
      next += written;
      size -= static_cast<size_t>(written);
    }
  }
  return true;
}

int ChildProcess::finish()
{
  closeInput();
  if (pid_ > 0)
  {
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR)
    {
    }
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    pid_ = -1;
  }
  return status_;
}

void ChildProcess::kill()
{
  if (pid_ > 0)
  {
    ::kill(pid_, SIGKILL);
  }
  finish();
}

std::string ChildProcess::complaints() const
{
  char text[1000];
  const ssize_t length = pread(errors_, text, sizeof text, 0);
  return length > 0 ? std::string(text, static_cast<size_t>(length)) : "it did not say why";
}

void ChildProcess::closeInput()
{
  if (input_ >= 0)
  {
    close(input_);
    input_ = -1;
  }
}

bool isInstalled(const std::string& program)
{
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
  {
    if (access((folder + "/" + program).c_str(), X_OK) == 0)
    {
      return true;
    }
  }
  return false;
}

bool canWriteInto(const std::string& folder)
{
  return access(folder.c_str(), W_OK | X_OK) == 0;
}
}  // namespace devo_evo
