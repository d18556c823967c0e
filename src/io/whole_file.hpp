#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace tdbd {

/// Returns `path.partial`, where a file is written until it is complete.
std::filesystem::path partial_path(const std::filesystem::path& path);

/// Renames `path.partial` to `path`. Throws RunError.
void rename_partial(const std::filesystem::path& path);

/// Forces a file, or the entries of a folder, to the disk. Throws RunError with the error of any
/// write since it was opened.
void flush_to_disk(const std::filesystem::path& path);

/// A file that is written completely or not at all: bytes are written to `path.partial`, which
/// commit() renames to `path`. Without commit() no file is left, and an older file at `path` is
/// unchanged.
class AtomicFile {
 public:
  /// Throws RunError if the file cannot be created.
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  std::ostream& stream() { return stream_; }

  /// Closes and renames the file. Throws RunError if any write failed (for example on a full disk).
  void commit();

 private:
  void close();
  friend void write_sealed(const std::filesystem::path& path, const std::string& bytes);

  std::filesystem::path path_, partial_;
  std::ofstream stream_;
  bool committed_ = false;
};

/// Writes a text file, or none if writing fails. Throws RunError.
void write_text(const std::filesystem::path& path, const std::string& text);

/// Appends a seal, which is a hash of all bytes of the file. Readers of the sealed format (NetCDF)
/// ignore bytes after their own data. Throws RunError.
void seal_file(const std::filesystem::path& path);

/// Throws RunError unless the file ends with the hash of the preceding bytes, that is, if it was
/// not sealed, is incomplete or was changed. NetCDF does not validate its input (a header with one
/// wrong byte can make it allocate a terabyte), so it may only open sealed files.
void require_seal(const std::filesystem::path& path);

/// Writes bytes and their seal and forces them to the disk, or leaves no file. Throws RunError.
void write_sealed(const std::filesystem::path& path, const std::string& bytes);

/// Returns the bytes of a sealed file without the seal. Throws RunError like require_seal.
std::string read_sealed(const std::filesystem::path& path);

}  // namespace tdbd
