#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace devo_evo
{
/// Makes the folder and those above it. @throw ArchiveError if it cannot be made, or is no folder, or must not be
/// written, or lies on a network file system.
void makeOutputFolder(const std::string& output);

/// Name of the network file system that holds the path ("nfs", "fuse.sshfs"), or "" if it is a local one. SQLite's
/// write-ahead log needs memory shared by all who use the file, which machines do not have.
/// @param path absolute; need not exist.
std::string networkFileSystem(const std::string& path);

/// The same for a path on a FUSE mount.
/// @param mounts text as in /proc/self/mountinfo.
/// @param path   absolute and free of symbolic links.
std::string fuseNetworkFileSystem(const std::string& mounts, const std::string& path);

/// What tells a file from every other: device and inode. Zeros if there is no such file.
std::pair<uint64_t, uint64_t> fileIdentity(const std::string& path);

/// The right to write to an output folder, held by at most one process. The system takes it back however the process
/// ends.
class WriterLock
{
public:
  /// @throw ArchiveError naming the process and host that hold it, if somebody does.
  explicit WriterLock(const std::string& output);
  ~WriterLock();
  WriterLock(const WriterLock&) = delete;
  WriterLock& operator=(const WriterLock&) = delete;

private:
  int file_ = -1;
};
}  // namespace devo_evo
