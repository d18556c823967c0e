#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace tdbd {

/// `path.partial`: where a file is written until it is complete.
std::filesystem::path partial_path(const std::filesystem::path& path);

/// Renames `path.partial` to `path`. Throws RunError.
void rename_partial(const std::filesystem::path& path);

/// Has the kernel put a file on its disk. Throws RunError with what went wrong since it was written.
void put_on_disk(const std::filesystem::path& path);

/// A file that appears complete or not at all: bytes go to `path.partial`, which commit() renames to `path`. Without
/// commit() nothing is left behind, and an older file at `path` is untouched.
class WholeFile {
 public:
  /// Throws RunError if the file cannot be created.
  explicit WholeFile(std::filesystem::path path);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  std::ostream& stream() { return stream_; }

  /// Closes and renames. Throws RunError if any write failed (full disk).
  void commit();

 private:
  std::filesystem::path path_, partial_;
  std::ofstream stream_;
  bool committed_ = false;
};

/// Writes a text file, complete or not at all. Throws RunError.
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace tdbd
