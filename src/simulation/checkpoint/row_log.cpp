#include "simulation/checkpoint/row_log.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace tdbd::simulation {

RowLog::RowLog(std::filesystem::path path, std::size_t width, long kept)
    : path_(std::move(path)), width_(width), rows_(kept) {
  file_.reset(std::fopen(path_.c_str(), kept > 0 ? "r+b" : "w+b"));
  require(file_ != nullptr);
  const auto end = static_cast<off_t>(static_cast<std::size_t>(kept) * width * sizeof(double));
  require(fseeko(file_.get(), 0, SEEK_END) == 0);
  if (ftello(file_.get()) < end)
    throw RunError(fmt::format("{}: holds fewer than {} rows", path_.string(), kept));
  require(ftruncate(fileno(file_.get()), end) == 0);
  require(fseeko(file_.get(), end, SEEK_SET) == 0);
}

void RowLog::replay(const std::function<void(std::span<const double>)>& visit) {
  std::vector<double> row(width_);
  require(fseeko(file_.get(), 0, SEEK_SET) == 0);
  for (long i = 0; i < rows_; ++i) {
    require(std::fread(row.data(), sizeof(double), width_, file_.get()) == width_);
    visit(row);
  }
  require(fseeko(file_.get(), 0, SEEK_CUR) == 0);  // between reading and writing, as C asks
}

void RowLog::append(std::span<const double> row) {
  require(std::fwrite(row.data(), sizeof(double), row.size(), file_.get()) == row.size());
  ++rows_;
}

void RowLog::sync() {
  require(std::fflush(file_.get()) == 0);
  require(fsync(fileno(file_.get())) == 0);
}

void RowLog::require(bool is_done) const {
  if (is_done) return;
  throw RunError(fmt::format("cannot write {}: {}", path_.string(), std::strerror(errno)));
}

}  // namespace tdbd::simulation
