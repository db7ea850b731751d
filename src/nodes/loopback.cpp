// Preloaded by run.sh (LD_PRELOAD): keeps what would listen on all addresses of this machine to the loopback.
//
// With ROS_HOSTNAME=localhost roscpp and rosmaster bind to the loopback, except for the XML-RPC port of each C++ node,
// which takes commands from everybody who reaches it.

#include <arpa/inet.h>
#include <dlfcn.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cstring>

extern "C" int bind(int socket, const sockaddr* address, socklen_t length) noexcept
{
  using Bind = int (*)(int, const sockaddr*, socklen_t);
  static const auto original = reinterpret_cast<Bind>(dlsym(RTLD_NEXT, "bind"));
  sockaddr_in narrowed = {};
  if (address == nullptr || address->sa_family != AF_INET || length != sizeof narrowed)
  {
    return original(socket, address, length);
  }
  std::memcpy(&narrowed, address, sizeof narrowed);
  if (narrowed.sin_addr.s_addr == htonl(INADDR_ANY))
  {
    narrowed.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  }
  return original(socket, reinterpret_cast<const sockaddr*>(&narrowed), length);
}
