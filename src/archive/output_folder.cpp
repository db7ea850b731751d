#include "archive/output_folder.h"

#include "devo_evo/archive/archive.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <system_error>

namespace devo_evo
{
namespace
{
std::string errorText(int error)
{
  return std::generic_category().message(error);
}

/// File systems by the number that statfs() gives (linux/magic.h and the file systems' own sources).
const std::map<uint32_t, std::string> NETWORK_FILE_SYSTEMS = {
  { 0x00006969, "nfs" },    { 0xff534d42, "cifs" },     { 0xfe534d42, "smb2" },   { 0x0000517b, "smbfs" },
  { 0x5346414f, "afs" },    { 0x6b414653, "kafs" },     { 0x00c36400, "ceph" },   { 0x73757245, "coda" },
  { 0x0bd00bd0, "lustre" }, { 0x47504653, "gpfs" },     { 0x19830326, "beegfs" }, { 0xaad7aaea, "panfs" },
  { 0x0000564c, "ncpfs" },  { 0x20030528, "orangefs" },
};
constexpr uint32_t FUSE = 0x65735546;

/// FUSE mounts that lead to other machines; the others (fuseblk, fuse-overlayfs, ...) are local.
const std::set<std::string> FUSE_NETWORK_FILE_SYSTEMS = {
  "fuse.sshfs",   "fuse.glusterfs",  "fuse.ceph",     "fuse.ceph-fuse",     "fuse.rclone",   "fuse.s3fs",
  "fuse.gcsfuse", "fuse.davfs",      "fuse.smbnetfs", "fuse.curlftpfs",     "fuse.juicefs",  "fuse.moosefs",
  "fuse.mfs",     "fuse.gvfsd-fuse", "fuse.cvmfs2",   "fuse.beegfs",        "fuse.lizardfs", "fuse.seaweedfs",
  "fuse.goofys",  "fuse.JuiceFS",    "fuse.weedfs",   "fuse.mountpoint-s3",
};

/// mountinfo writes blank, tab, newline and backslash as \ and three octal digits.
std::string unescaped(const std::string& text)
{
  std::string result;
  for (size_t i = 0; i < text.size(); ++i)
  {
    if (text[i] == '\\' && i + 3 < text.size())
    {
      result += static_cast<char>((text[i + 1] - '0') * 64 + (text[i + 2] - '0') * 8 + (text[i + 3] - '0'));
      i += 3;
    }
    else
    {
      result += text[i];
    }
  }
  return result;
}

bool liesUnder(const std::string& path, const std::string& folder)
{
  return folder == "/" || path == folder || path.compare(0, folder.size() + 1, folder + "/") == 0;
}

/// The path itself or the lowest folder above it that exists.
std::string nearestExisting(const std::string& path)
{
  std::error_code error;
  std::filesystem::path existing = path;
  while (!std::filesystem::exists(existing, error) && existing.has_relative_path())
  {
    existing = existing.parent_path();
  }
  return existing.string();
}

std::string holderOf(int file)
{
  std::array<char, 256> text;
  const ssize_t size = pread(file, text.data(), text.size(), 0);
  const std::string holder(text.data(), size > 0 ? static_cast<size_t>(size) : 0);
  return holder.substr(0, holder.find('\n'));
}
}  // namespace

std::string fuseNetworkFileSystem(const std::string& mounts, const std::string& path)
{
  std::istringstream lines(mounts);
  std::string best_folder;
  std::string best_type;
  for (std::string line; std::getline(lines, line);)
  {
    // 36 35 98:0 /root /mount/point options [optional fields] - type source options
    std::istringstream fields(line.substr(0, line.find(" - ")));
    std::string id, parent, device, root, folder;
    fields >> id >> parent >> device >> root >> folder;
    folder = unescaped(folder);
    const size_t separator = line.find(" - ");
    if (folder.empty() || separator == std::string::npos || !liesUnder(path, folder) ||
        folder.size() < best_folder.size())
    {
      continue;
    }
    best_folder = folder;
    best_type = line.substr(separator + 3, line.find(' ', separator + 3) - separator - 3);
  }
  return FUSE_NETWORK_FILE_SYSTEMS.count(best_type) != 0 ? best_type : "";
}

std::string networkFileSystem(const std::string& path)
{
  const std::string existing = nearestExisting(path);
  struct statfs information;
  if (statfs(existing.c_str(), &information) != 0)
  {
    return "";
  }
  const auto type = static_cast<uint32_t>(information.f_type);
  if (type == FUSE)
  {
    std::stringstream mounts;
    mounts << std::ifstream("/proc/self/mountinfo").rdbuf();
    std::error_code error;
    return fuseNetworkFileSystem(mounts.str(), std::filesystem::canonical(existing, error).string());
  }
  const auto found = NETWORK_FILE_SYSTEMS.find(type);
  return found != NETWORK_FILE_SYSTEMS.end() ? found->second : "";
}

void makeOutputFolder(const std::string& output)
{
  const std::string network = networkFileSystem(output);
  if (!network.empty())
  {
    throw ArchiveError("output folder " + output + " lies on a network file system (" + network +
                       "), on which an archive is not safe; choose a folder on a local disk and copy it when finished");
  }
  std::error_code error;
  std::filesystem::create_directories(output, error);
  if (error || !std::filesystem::is_directory(output, error))
  {
    throw ArchiveError("output folder " + output +
                       " cannot be made: " + (error ? error.message() : "there is a file of that name"));
  }
  if (access(output.c_str(), W_OK | X_OK) != 0)
  {
    throw ArchiveError("output folder " + output + " cannot be written: " + errorText(errno));
  }
}

std::pair<uint64_t, uint64_t> fileIdentity(const std::string& path)
{
  struct stat information
  {
  };
  return stat(path.c_str(), &information) == 0 ? std::pair<uint64_t, uint64_t>(information.st_dev, information.st_ino)
                                               : std::pair<uint64_t, uint64_t>(0, 0);
}

WriterLock::WriterLock(const std::string& output)
{
  const std::string path = output + "/experiment.lock";
  file_ = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0)
  {
    throw ArchiveError("lock file " + path + " cannot be written: " + errorText(errno));
  }
  if (flock(file_, LOCK_EX | LOCK_NB) != 0)
  {
    const int error = errno;
    const std::string holder = holderOf(file_);
    close(file_);
    throw ArchiveError(error == EWOULDBLOCK ? "output folder " + output +
                                                  " is in use: " + (holder.empty() ? "another process" : holder) +
                                                  " writes to it; stop that one or choose another output"
                                            : "lock file " + path + " cannot be locked: " + errorText(error));
  }
  std::array<char, HOST_NAME_MAX + 1> host{};
  gethostname(host.data(), host.size() - 1);
  const std::string holder = "process " + std::to_string(getpid()) + " on host " + host.data() + "\n";
  // Only for the message above: on a full disk the file stays empty, and the lock holds all the same.
  if (ftruncate(file_, 0) == 0)
  {
    [[maybe_unused]] const ssize_t written = pwrite(file_, holder.data(), holder.size(), 0);
  }
}

WriterLock::~WriterLock()
{
  close(file_);
}
}  // namespace devo_evo
