#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <string>

/// For LD_PRELOAD: closing a history.nc fails as on a network file system that could not store what was written.
extern "C" int close(int file) {
  std::array<char, PATH_MAX> name{};
  const std::string link = "/proc/self/fd/" + std::to_string(file);
  const ssize_t length = readlink(link.c_str(), name.data(), name.size() - 1);
  const bool is_history =
      length > 0 && std::string(name.data()).find("history.nc") != std::string::npos;
  const auto number = static_cast<unsigned>(file);
  const int closed = close_range(number, number, 0);
  if (!is_history) return closed;
  errno = EIO;
  return -1;
}
