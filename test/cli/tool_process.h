#pragma once

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace devo_evo
{
/// A folder that is gone when the test is over.
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    std::string pattern = std::filesystem::temp_directory_path().string() + "/devo_evo_XXXXXX";
    if (mkdtemp(pattern.data()) == nullptr)
    {
      throw std::runtime_error("no temporary folder");
    }
    path_ = pattern;
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const std::string& name) const { return path_ + "/" + name; }

private:
  std::string path_;
};

inline std::string contentOf(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

/// One run of the command-line tool, in the background until finish() is called.
class ToolProcess
{
public:
  using Environment = std::vector<std::pair<std::string, std::string>>;

  /// @param input what it reads from standard input.
  explicit ToolProcess(const std::vector<std::string>& arguments, const std::string& input = "",
                       const Environment& environment = {})
  {
    std::ofstream(files_.file("in"), std::ios::binary) << input;
    process_ = fork();
    if (process_ == 0)
    {
      become(arguments, environment);
    }
  }

  ~ToolProcess()
  {
    if (process_ > 0)
    {
      signal(SIGKILL);
      finish();
    }
  }
  ToolProcess(const ToolProcess&) = delete;
  ToolProcess& operator=(const ToolProcess&) = delete;

  void signal(int number) const { kill(process_, number); }

  /// Waits until it handles a signal instead of ending by it; at most half a minute.
  void waitUntilCaught(int signal) const
  {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (!catches(signal) && std::chrono::steady_clock::now() < deadline)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }

  /// Waits for its end. @return its exit status; 1000 + the signal's number if a signal killed it.
  int finish()
  {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
    return WIFSIGNALED(status) ? 1000 + WTERMSIG(status) : WEXITSTATUS(status);
  }

  std::string out() const { return contentOf(files_.file("out")); }
  std::string err() const { return contentOf(files_.file("err")); }

private:
  bool catches(int signal) const
  {
    std::ifstream status("/proc/" + std::to_string(process_) + "/status");
    for (std::string word; status >> word;)
    {
      if (word == "SigCgt:" && status >> word)
      {
        return (std::stoull(word, nullptr, 16) >> (signal - 1) & 1) != 0;
      }
    }
    return false;
  }

  [[noreturn]] void become(const std::vector<std::string>& arguments, const Environment& environment) const
  {
    redirect(files_.file("in"), O_RDONLY, STDIN_FILENO);
    redirect(files_.file("out"), O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
    redirect(files_.file("err"), O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
    for (const auto& [name, value] : environment)
    {
      setenv(name.c_str(), value.c_str(), 1);
    }
    std::vector<std::string> words = arguments;
    words.insert(words.begin(), "devo_evo");
    std::vector<char*> argv;
    for (std::string& word : words)
    {
      argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    execv(DEVO_EVO_TOOL, argv.data());
    _exit(127);
  }

  static void redirect(const std::string& path, int flags, int descriptor)
  {
    const int file = open(path.c_str(), flags, 0600);
    dup2(file, descriptor);
    close(file);
  }

  TemporaryFolder files_;
  pid_t process_ = -1;
};

/// What a run of the tool left.
struct ToolResult
{
  int status;
  std::string out;
  std::string err;
};

inline ToolResult runTool(const std::vector<std::string>& arguments, const std::string& input = "",
                          const ToolProcess::Environment& environment = {})
{
  ToolProcess process(arguments, input, environment);
  const int status = process.finish();
  return { status, process.out(), process.err() };
}
}  // namespace devo_evo
