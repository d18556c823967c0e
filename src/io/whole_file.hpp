#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace tdbd {

/// `path.partial`: where a file is written until it is complete.
std::filesystem::path partial_path(const std::filesystem::path& path);

/// Renames `path.partial` to `path`. Throws RunError.
void rename_partial(const std::filesystem::path& path);

/// Forces a file, or the names in a folder, to the disk. Throws RunError with the error of any write
/// since it was opened.
void put_on_disk(const std::filesystem::path& path);

/// A file that appears complete or not at all: bytes go to `path.partial`, which commit() renames to
/// `path`. Without commit() nothing is left behind, and an older file at `path` is untouched.
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
  void close();
  friend void write_sealed(const std::filesystem::path& path, const std::string& bytes);

  std::filesystem::path path_, partial_;
  std::ofstream stream_;
  bool committed_ = false;
};

/// Writes a text file, complete or not at all. Throws RunError.
void write_text(const std::filesystem::path& path, const std::string& text);

/// Appends a seal, a hash of all bytes of the file. Readers of the formats that are sealed (NetCDF)
/// do not look beyond their own data. Throws RunError.
void seal_file(const std::filesystem::path& path);

/// Throws RunError unless the file ends with the hash of what precedes it: it was not sealed, is
/// torn, or was changed. NetCDF trusts what it reads (of a header with one wrong byte it requests
/// a terabyte) and is given sealed files only.
void require_seal(const std::filesystem::path& path);

/// Writes bytes and their seal, complete and forced to the disk, or not at all. Throws RunError.
void write_sealed(const std::filesystem::path& path, const std::string& bytes);

/// The bytes of a sealed file. Throws RunError as require_seal does.
std::string read_sealed(const std::filesystem::path& path);

}  // namespace tdbd
