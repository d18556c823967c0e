#include "io/whole_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/provenance.hpp"
#include "core/read_file.hpp"

namespace tdbd {
namespace {

[[noreturn]] void fail_to_write(const std::filesystem::path& path, const std::string& reason) {
  throw RunError(fmt::format("cannot write {}: {}", path.string(), reason));
}

std::string seal_of(std::string_view bytes) {
  return fmt::format("tdbd seal {}\n", fnv1a_hex(bytes));
}

std::string bytes_of(const std::filesystem::path& path) {
  try {
    return read_file(path, "a file with a seal");
  } catch (const InputError& e) {
    throw RunError(e.what());
  }
}

}  // namespace

std::filesystem::path partial_path(const std::filesystem::path& path) {
  return path.string() + ".partial";
}

void rename_partial(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::rename(partial_path(path), path, error);
  if (error) fail_to_write(path, error.message());
}

void flush_to_disk(const std::filesystem::path& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) fail_to_write(path, std::strerror(errno));
  const int not_synced = fsync(file) == 0 ? 0 : errno;
  if (close(file) != 0 || not_synced != 0)
    fail_to_write(path, std::strerror(not_synced != 0 ? not_synced : errno));
}

AtomicFile::AtomicFile(std::filesystem::path path)
    : path_(std::move(path)), partial_(partial_path(path_)) {
  stream_.open(partial_, std::ios::binary | std::ios::trunc);
  if (!stream_) fail_to_write(path_, std::strerror(errno));
}

/// Allocates nothing, because it may run after an allocation failed.
AtomicFile::~AtomicFile() {
  if (committed_) return;
  std::error_code ignored;
  std::filesystem::remove(partial_, ignored);
}

void AtomicFile::close() {
  if (!stream_.is_open()) return;
  errno = 0;
  stream_.close();
  if (!stream_) fail_to_write(path_, errno != 0 ? std::strerror(errno) : "a write failed");
}

void AtomicFile::commit() {
  close();
  rename_partial(path_);
  committed_ = true;
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  AtomicFile file(path);
  errno = 0;
  file.stream() << text;  // written immediately if it is longer than the buffer of the stream
  if (!file.stream()) fail_to_write(path, errno != 0 ? std::strerror(errno) : "a write failed");
  file.commit();
}

void seal_file(const std::filesystem::path& path) {
  const std::string seal = seal_of(bytes_of(path));
  std::ofstream out(path, std::ios::binary | std::ios::app);
  out << seal << std::flush;
  if (!out) fail_to_write(path, std::strerror(errno));
}

void require_seal(const std::filesystem::path& path) { read_sealed(path); }

void write_sealed(const std::filesystem::path& path, const std::string& bytes) {
  AtomicFile file(path);
  errno = 0;
  file.stream() << bytes << seal_of(bytes);
  if (!file.stream()) fail_to_write(path, errno != 0 ? std::strerror(errno) : "a write failed");
  file.close();
  flush_to_disk(partial_path(path));
  file.commit();
  flush_to_disk(path.parent_path().empty() ? "." : path.parent_path());
}

std::string read_sealed(const std::filesystem::path& path) {
  std::string bytes = bytes_of(path);
  const std::size_t length = seal_of("").size();
  const std::size_t data = bytes.size() < length ? 0 : bytes.size() - length;
  const std::string_view all = bytes;
  if (all.substr(data) != seal_of(all.substr(0, data)))
    throw RunError(fmt::format("{}: the file is incomplete or was changed", path.string()));
  bytes.resize(data);
  return bytes;
}

}  // namespace tdbd
