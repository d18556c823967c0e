#include "core/whole_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/error.hpp"

namespace tdbd {
namespace {

[[noreturn]] void fail_to_write(const std::filesystem::path& path, const std::string& reason) {
  throw RunError(fmt::format("cannot write {}: {}", path.string(), reason));
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

void put_on_disk(const std::filesystem::path& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) fail_to_write(path, std::strerror(errno));
  const int not_synced = fsync(file) == 0 ? 0 : errno;
  if (close(file) != 0 || not_synced != 0)
    fail_to_write(path, std::strerror(not_synced != 0 ? not_synced : errno));
}

WholeFile::WholeFile(std::filesystem::path path)
    : path_(std::move(path)), partial_(partial_path(path_)) {
  stream_.open(partial_, std::ios::binary | std::ios::trunc);
  if (!stream_) fail_to_write(path_, std::strerror(errno));
}

/// Allocates nothing, because it may run after an allocation failed.
WholeFile::~WholeFile() {
  if (committed_) return;
  std::error_code ignored;
  std::filesystem::remove(partial_, ignored);
}

void WholeFile::commit() {
  errno = 0;
  stream_.close();
  if (!stream_) fail_to_write(path_, errno != 0 ? std::strerror(errno) : "a write failed");
  rename_partial(path_);
  committed_ = true;
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  WholeFile file(path);
  errno = 0;
  file.stream() << text;  // written at once if longer than the buffer of the stream
  if (!file.stream()) fail_to_write(path, errno != 0 ? std::strerror(errno) : "a write failed");
  file.commit();
}

}  // namespace tdbd
