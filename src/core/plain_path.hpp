#pragma once

#include <filesystem>
#include <string>

namespace tdbd {

/// Another name of a file, by the number of its open folder: "/proc/self/fd/7/history.nc". For libraries that read paths
/// in their own way: NetCDF takes blanks, backslashes and colons in the names of folders for something else. The name
/// holds as long as the object. Where there is no such name, it is the path itself.
class PlainPath {
 public:
  explicit PlainPath(const std::filesystem::path& file);
  ~PlainPath();
  PlainPath(const PlainPath&) = delete;
  PlainPath& operator=(const PlainPath&) = delete;

  const char* c_str() const { return name_.c_str(); }

 private:
  int folder_ = -1;
  std::string name_;
};

}  // namespace tdbd
