#include "core/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/error.hpp"

namespace tdbd {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : folder_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (folder_ < 0)
    throw RunError(
        fmt::format("output folder {}: cannot open: {}", folder.string(), std::strerror(errno)));
  if (flock(folder_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(folder_);
  throw FolderError(
      fmt::format("output folder {}: in use: another command writes to it; wait until it ends "
                  "or choose another folder",
                  folder.string()));
}

FolderLock::~FolderLock() { close(folder_); }

}  // namespace tdbd
