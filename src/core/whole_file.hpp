#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace tdbd {

/// `path.partial`: where a file's bytes go until it is whole.
std::filesystem::path partial_path(const std::filesystem::path& path);

/// Puts `path.partial` in the place of `path`. Throws RunError.
void rename_partial(const std::filesystem::path& path);

/// A file that appears whole or not at all: bytes go to `path.partial`, which commit() renames to
/// `path`. Without commit() nothing of it stays, and an older file at `path` is untouched.
class WholeFile {
 public:
  /// Throws RunError when the file cannot be created.
  explicit WholeFile(std::filesystem::path path);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  std::ostream& stream() { return stream_; }

  /// Closes and renames. Throws RunError when any write failed (full disk).
  void commit();

 private:
  std::filesystem::path path_;
  std::ofstream stream_;
  bool committed_ = false;
};

/// Writes a text file, whole or not at all. Throws RunError.
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace tdbd
