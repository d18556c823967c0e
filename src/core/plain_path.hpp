#pragma once

#include <filesystem>
#include <string>

namespace tdbd {

/// An alternative name of a file through the descriptor of its open folder:
/// "/proc/self/fd/7/history.nc". It is for libraries that interpret paths: NetCDF gives blanks,
/// backslashes and colons in folder names a special meaning. The name is valid during the lifetime
/// of the object. If there is no such name, it is the path itself.
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
