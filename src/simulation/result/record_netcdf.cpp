#include "simulation/result/record_netcdf.hpp"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/error.hpp"
#include "core/memory_left.hpp"
#include "core/netcdf_lock.hpp"
#include "core/plain_path.hpp"
#include "core/whole_file.hpp"
#include "simulation/checkpoint/hdf5_at_exit.hpp"

namespace tdbd::simulation {
namespace {

/// As the CF conventions name it.
const char* cell_method(Over over) {
  switch (over) {
    case Over::mean:
      return "time: mean";
    case Over::sum:
      return "time: sum";
    case Over::minimum:
      return "time: minimum";
    case Over::maximum:
      return "time: maximum";
    case Over::point:
      break;
  }
  return "";
}

/// What NetCDF and HDF5 may need at a time, bytes: where they get none they crash.
std::size_t memory_for(const RecordLayout& layout) {
  constexpr std::size_t own = 8'000'000, blocks = 4;
  return own + blocks * record_block * layout.row_width() * sizeof(double);
}

}  // namespace

RecordNetcdf::RecordNetcdf(const std::filesystem::path& file, const RecordLayout& layout)
    : file_(file), storage_(layout.storage), memory_(memory_for(layout)) {
  const NetcdfLock lock(netcdf_mutex());
  demand_memory(memory_);
  leave_files_alone_at_exit();
  errno = 0;
  require(nc_create(PlainPath(file).c_str(), NC_NETCDF4 | NC_CLOBBER, &nc_));
  define(layout);
}

RecordNetcdf::~RecordNetcdf() {
  try {
    close_file();
  } catch (const std::exception&) {  // it stays as it is
  }
}

void RecordNetcdf::require(int status) const {
  if (status == NC_NOERR) return;
  std::string reason = nc_strerror(status);  // of a positive one often not what the kernel said
  if (errno != 0)
    reason =
        status > 0 ? std::strerror(errno) : fmt::format("{} ({})", reason, std::strerror(errno));
  throw RunError(fmt::format("cannot write {}: {}", file_.string(), reason));
}

void RecordNetcdf::define(const RecordLayout& layout) {
  int time_dim = -1;
  require(nc_def_dim(nc_, "time", NC_UNLIMITED, &time_dim));
  std::vector<int> dims;  // NetCDF has no dimension of length 0: an empty axis may grow, and stays
  for (const RecordAxis& axis : layout.axes) {
    const std::size_t length = axis.components.empty() ? NC_UNLIMITED : axis.components.size();
    require(nc_def_dim(nc_, axis.name.c_str(), length, &dims.emplace_back()));
  }
  const auto dim_of = [&](int axis) { return dims[static_cast<std::size_t>(axis)]; };
  for (const RecordColumn& c : layout.columns) {
    std::vector<int> of_column{time_dim};
    if (c.axis >= 0) of_column.push_back(dim_of(c.axis));
    columns_.push_back({define_number(c, of_column, layout.width(c)), layout.width(c), {}});
  }
  std::vector<int> variables;
  for (const RecordLabels& l : layout.labels) variables.push_back(define_labels(l, dim_of(l.axis)));
  require(nc_enddef(nc_));
  for (std::size_t i = 0; i < variables.size(); ++i)
    for (std::size_t at = 0; at < layout.labels[i].texts.size(); ++at) {
      const char* bytes = layout.labels[i].texts[at].c_str();
      require(nc_put_var1_string(nc_, variables[i], &at, &bytes));
    }
}

void RecordNetcdf::describe(int variable, const std::string& units, const std::string& long_name) {
  require(nc_put_att_text(nc_, variable, "units", units.size(), units.c_str()));
  require(nc_put_att_text(nc_, variable, "long_name", long_name.size(), long_name.c_str()));
}

int RecordNetcdf::define_labels(const RecordLabels& labels, int dim) {
  int variable = -1;
  require(nc_def_var(nc_, labels.name.c_str(), NC_STRING, 1, &dim, &variable));
  describe(variable, "1", labels.long_name);
  return variable;
}

int RecordNetcdf::define_number(const RecordColumn& column, const std::vector<int>& dims,
                                std::size_t width) {
  int variable = -1;
  const int rank = static_cast<int>(dims.size());
  const nc_type type = column.precision == Precision::single ? NC_FLOAT : NC_DOUBLE;
  require(nc_def_var(nc_, column.name.c_str(), type, rank, dims.data(), &variable));
  const std::size_t chunk[2] = {record_chunk, std::max<std::size_t>(1, width)};
  require(nc_def_var_chunking(nc_, variable, NC_CHUNKED, chunk));
  // A block is whole chunks, never asked for again: to keep them would fill memory in long runs.
  require(nc_set_var_chunk_cache(nc_, variable, chunk[0] * chunk[1] * sizeof(double), 1, 1.0));
  constexpr int shuffled = 1, deflated = 1, fast = 1;
  if (storage_ == Storage::deflated)
    require(nc_def_var_deflate(nc_, variable, shuffled, deflated, fast));
  describe(variable, column.units, column.long_name);
  const std::string method = cell_method(column.over);
  if (!method.empty())
    require(nc_put_att_text(nc_, variable, "cell_methods", method.size(), method.c_str()));
  return variable;
}

void RecordNetcdf::append(std::span<const double> row) {
  for (Column& c : columns_) {
    const std::span<const double> own = row.first(c.width);
    c.waiting.insert(c.waiting.end(), own.begin(), own.end());
    row = row.subspan(c.width);
  }
  if (++waiting_ == record_block) write_block();
}

void RecordNetcdf::write_block() {
  if (waiting_ == 0) return;
  const NetcdfLock lock(netcdf_mutex());
  demand_memory(memory_);
  errno = 0;
  for (Column& c : columns_) {
    const std::size_t start[2] = {written_, 0}, count[2] = {waiting_, c.width};
    require(nc_put_vara_double(nc_, c.variable, start, count, c.waiting.data()));
    c.waiting.clear();
  }
  written_ += waiting_;
  waiting_ = 0;
}

void RecordNetcdf::close() {
  write_block();
  close_file();
}

void RecordNetcdf::close_file() {
  if (nc_ < 0) return;
  const int nc = std::exchange(nc_, -1);
  const NetcdfLock lock(netcdf_mutex());
  demand_memory(memory_);
  errno = 0;
  require(nc_sync(nc));
  put_on_disk(file_);  // the library crashes in a close that fails, so nothing may be left to fail
  require(nc_close(nc));
}

}  // namespace tdbd::simulation
