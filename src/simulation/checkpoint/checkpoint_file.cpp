#include "simulation/checkpoint/checkpoint_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <netcdf.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <span>
#include <string_view>
#include <system_error>

#include "core/error.hpp"
#include "core/memory_left.hpp"
#include "core/netcdf_lock.hpp"
#include "core/plain_path.hpp"
#include "core/seal.hpp"
#include "core/whole_file.hpp"
#include "simulation/checkpoint/hdf5_at_exit.hpp"

namespace tdbd::simulation {
namespace {

namespace fs = std::filesystem;

constexpr char kind[] = "tdbd checkpoint 2";

/// What NetCDF may need besides, bytes: where it gets none it crashes.
constexpr std::size_t memory_of_netcdf = 4'000'000;

/// An open NetCDF file; every call that fails is a RunError.
class Netcdf {
 public:
  explicit Netcdf(fs::path path) : path_(std::move(path)) { leave_files_alone_at_exit(); }
  Netcdf(const Netcdf&) = delete;
  Netcdf& operator=(const Netcdf&) = delete;
  ~Netcdf() {
    if (id >= 0) nc_close(id);
  }

  void require(int status) const {
    if (status == NC_NOERR) return;
    const std::string reason = status > 0 ? std::strerror(status) : nc_strerror(status);
    throw RunError(fmt::format("checkpoint {}: {}", path_.string(), reason));
  }
  void close() {
    const int open = id;
    id = -1;
    require(nc_close(open));
  }

  int id = -1;

 private:
  fs::path path_;
};

/// A column of the file. NetCDF has no fixed dimension of length 0: an empty column is left out.
template <class T>
void define(const Netcdf& nc, const char* name, nc_type type, const std::vector<T>& column) {
  if (column.empty()) return;
  int dimension = -1, variable = -1;
  nc.require(nc_def_dim(nc.id, name, column.size(), &dimension));
  nc.require(nc_def_var(nc.id, name, type, 1, &dimension, &variable));
}

template <class T>
void put(const Netcdf& nc, const char* name, const std::vector<T>& column) {
  if (column.empty()) return;
  int variable = -1;
  nc.require(nc_inq_varid(nc.id, name, &variable));
  nc.require(nc_put_var(nc.id, variable, column.data()));
}

template <class T>
void get(const Netcdf& nc, const char* name, nc_type type, std::vector<T>& column) {
  int variable = -1, rank = 0, dimension = -1;
  nc_type found = NC_NAT;
  if (nc_inq_varid(nc.id, name, &variable) != NC_NOERR) return;
  nc.require(nc_inq_var(nc.id, variable, nullptr, &found, &rank, nullptr, nullptr));
  if (found != type || rank != 1) nc.require(NC_EBADTYPE);
  nc.require(nc_inq_vardimid(nc.id, variable, &dimension));
  std::size_t n = 0;
  nc.require(nc_inq_dimlen(nc.id, dimension, &n));
  column.resize(n);
  nc.require(nc_get_var(nc.id, variable, column.data()));
}

void put_text(const Netcdf& nc, const char* name, const std::string& text) {
  nc.require(nc_put_att_text(nc.id, NC_GLOBAL, name, text.size(), text.data()));
}

std::string text_of(const Netcdf& nc, const char* name) {
  std::size_t n = 0;
  nc.require(nc_inq_attlen(nc.id, NC_GLOBAL, name, &n));
  std::string text(n, '\0');
  nc.require(nc_get_att_text(nc.id, NC_GLOBAL, name, text.data()));
  return text;
}

/// Both are told by name, in this order.
template <class File, class Visit>
void visit_columns(File& f, Visit&& visit) {
  visit("reals", NC_DOUBLE, f.tape.reals);
  visit("wholes", NC_INT64, f.tape.wholes);
  visit("ints", NC_INT, f.tape.ints);
  visit("bytes", NC_UBYTE, f.tape.bytes);
}

void write_netcdf(const fs::path& path, const CheckpointFile& f) {
  const NetcdfLock lock(netcdf_mutex());
  demand_memory(memory_of_netcdf);
  Netcdf nc(path);
  nc.require(nc_create(PlainPath(path).c_str(), NC_CLOBBER | NC_64BIT_DATA, &nc.id));
  nc.require(nc_set_fill(nc.id, NC_NOFILL, nullptr));
  put_text(nc, "kind", kind);
  put_text(nc, "version", f.version);
  put_text(nc, "case_hash", f.case_hash);
  put_text(nc, "case", f.case_text);
  put_text(nc, "names", f.tape.names);
  visit_columns(f,
                [&](const char* name, nc_type type, const auto& x) { define(nc, name, type, x); });
  nc.require(nc_enddef(nc.id));
  visit_columns(f, [&](const char* name, nc_type, const auto& x) { put(nc, name, x); });
  nc.close();
}

/// A file, or the names in a folder, forced to the disk.
void sync(const fs::path& path) {
  const int fd = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool is_done = fd >= 0 && fsync(fd) == 0;
  const int error = errno;
  if (fd >= 0) close(fd);
  if (!is_done)
    throw RunError(fmt::format("cannot write {}: {}", path.string(), std::strerror(error)));
}

}  // namespace

void write_checkpoint_file(const fs::path& path, const CheckpointFile& file) {
  const fs::path partial = partial_path(path);
  try {
    write_netcdf(partial, file);
    seal_file(partial);
    sync(partial);
    rename_partial(path);
  } catch (...) {
    std::error_code ignored;
    fs::remove(partial, ignored);
    throw;
  }
  sync(path.parent_path().empty() ? "." : path.parent_path());
}

CheckpointFile read_checkpoint_file(const fs::path& path) {
  demand_memory(memory_of_netcdf);
  require_seal(path);
  const NetcdfLock lock(netcdf_mutex());
  Netcdf nc(path);
  nc.require(nc_open(PlainPath(path).c_str(), NC_NOWRITE, &nc.id));
  if (text_of(nc, "kind") != kind)
    throw RunError(fmt::format("checkpoint {}: it is no checkpoint", path.string()));
  CheckpointFile f{text_of(nc, "version"), text_of(nc, "case_hash"), text_of(nc, "case"), {}};
  f.tape.names = text_of(nc, "names");
  visit_columns(f, [&](const char* name, nc_type type, auto& x) { get(nc, name, type, x); });
  return f;
}

}  // namespace tdbd::simulation
