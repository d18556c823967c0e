#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace tdbd {

/// The name of a file while it is being written: `path.partial`.
std::filesystem::path partial_path(const std::filesystem::path& path);

/// Renames `path.partial` to `path`. Throws RunError.
void rename_partial(const std::filesystem::path& path);

/// Flushes a file to disk (fsync). Throws RunError if that fails or an earlier write failed.
void put_on_disk(const std::filesystem::path& path);

/// A file that is written completely or not at all. Bytes are written to `path.partial`, which
/// commit() renames to `path`. Without commit() the partial file is removed, and an older file at
/// `path` is unchanged.
class WholeFile {
 public:
  /// Throws RunError if the file cannot be created.
  explicit WholeFile(std::filesystem::path path);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  std::ostream& stream() { return stream_; }

  /// Closes and renames the file. Throws RunError if a write failed (full disk).
  void commit();

 private:
  std::filesystem::path path_, partial_;
  std::ofstream stream_;
  bool committed_ = false;
};

/// Writes a text file, completely or not at all. Throws RunError.
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace tdbd
