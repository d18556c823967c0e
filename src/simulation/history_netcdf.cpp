#include "simulation/history_netcdf.hpp"

#include <H5public.h>
#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/error.hpp"

namespace tdbd::simulation {
namespace {

constexpr HistoryColumn by_part_about{"removed_volume_by_part", "m3",
                                      "rock removed by the part in the step", nullptr};

}  // namespace

HistoryNetcdf::HistoryNetcdf(const std::filesystem::path& file,
                             const std::vector<HistoryPart>& parts)
    : file_(file), part_count_(parts.size()) {
  H5dont_atexit();  // at exit HDF5 would touch files again that it could not close on a full disk
  require(nc_create(file.c_str(), NC_NETCDF4 | NC_CLOBBER, &nc_));
  define(parts);
}

HistoryNetcdf::~HistoryNetcdf() {
  if (nc_ >= 0) nc_close(nc_);
}

void HistoryNetcdf::require(int status) const {
  if (status == NC_NOERR) return;
  std::string reason = nc_strerror(status);
  if (status == NC_EHDFERR && errno != 0) reason += fmt::format(" ({})", std::strerror(errno));
  throw RunError(fmt::format("cannot write {}: {}", file_.string(), reason));
}

void HistoryNetcdf::define(const std::vector<HistoryPart>& parts) {
  int time_dim = -1, part_dim = -1;
  require(nc_def_dim(nc_, "time", NC_UNLIMITED, &time_dim));
  require(nc_def_dim(nc_, "part", std::max<std::size_t>(1, part_count_), &part_dim));
  for (std::size_t c = 0; c < history_columns.size(); ++c)
    variables_[c] = define_number(history_columns[c], {time_dim});
  by_part_variable_ = define_number(by_part_about, {time_dim, part_dim});
  const int names = define_text("part_name", "name of the part", part_dim);
  const int kinds = define_text("part_kind", "kind of the part", part_dim);
  require(nc_enddef(nc_));
  for (std::size_t p = 0; p < part_count_; ++p) {
    write_text(names, p, parts[p].name);
    write_text(kinds, p, parts[p].kind);
  }
}

int HistoryNetcdf::define_text(const char* name, const char* long_name, int part_dim) {
  int variable = -1;
  require(nc_def_var(nc_, name, NC_STRING, 1, &part_dim, &variable));
  require(nc_put_att_text(nc_, variable, "units", 1, "1"));
  require(nc_put_att_text(nc_, variable, "long_name", std::strlen(long_name), long_name));
  return variable;
}

int HistoryNetcdf::define_number(const HistoryColumn& about, const std::vector<int>& dims) {
  int variable = -1;
  const int rank = static_cast<int>(dims.size());
  require(nc_def_var(nc_, about.name, NC_DOUBLE, rank, dims.data(), &variable));
  const std::size_t chunk[2] = {history_block, std::max<std::size_t>(1, part_count_)};
  require(nc_def_var_chunking(nc_, variable, NC_CHUNKED, chunk));
  require(nc_def_var_deflate(nc_, variable, 1, 1, 1));
  require(nc_put_att_text(nc_, variable, "units", std::strlen(about.units), about.units));
  require(
      nc_put_att_text(nc_, variable, "long_name", std::strlen(about.long_name), about.long_name));
  return variable;
}

void HistoryNetcdf::write_text(int variable, std::size_t part, const std::string& text) {
  const char* bytes = text.c_str();
  require(nc_put_var1_string(nc_, variable, &part, &bytes));
}

void HistoryNetcdf::append(const HistoryRow& row) {
  if (row.removed_volume_by_part.size() != part_count_)
    throw RunError(fmt::format("{}: a row for {} parts in the history of {}", file_.string(),
                               row.removed_volume_by_part.size(), part_count_));
  for (std::size_t c = 0; c < history_columns.size(); ++c)
    columns_[c].push_back(history_columns[c].value(row));
  by_part_.insert(by_part_.end(), row.removed_volume_by_part.begin(),
                  row.removed_volume_by_part.end());
  if (++waiting_ == history_block) write_block();
}

void HistoryNetcdf::write_block() {
  if (waiting_ == 0) return;
  errno = 0;
  const std::size_t start[2] = {written_, 0}, count[2] = {waiting_, part_count_};
  for (std::size_t c = 0; c < history_columns.size(); ++c) {
    require(nc_put_vara_double(nc_, variables_[c], start, count, columns_[c].data()));
    columns_[c].clear();
  }
  require(nc_put_vara_double(nc_, by_part_variable_, start, count, by_part_.data()));
  by_part_.clear();
  written_ += waiting_;
  waiting_ = 0;
}

void HistoryNetcdf::close() {
  write_block();
  const int nc = nc_;
  nc_ = -1;
  errno = 0;
  require(nc_close(nc));
}

}  // namespace tdbd::simulation
