#include "core/plain_path.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <system_error>

namespace tdbd {

PlainPath::PlainPath(const std::filesystem::path& file) : name_(file.string()) {
  const std::filesystem::path parent = file.parent_path();
  folder_ = open(parent.empty() ? "." : parent.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
  if (folder_ < 0) return;
  const std::string folder = fmt::format("/proc/self/fd/{}", folder_);
  std::error_code unknown;
  if (std::filesystem::is_directory(folder, unknown))
    name_ = fmt::format("{}/{}", folder, file.filename().string());
}

PlainPath::~PlainPath() {
  if (folder_ >= 0) close(folder_);
}

}  // namespace tdbd
