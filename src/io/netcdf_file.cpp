#include "io/netcdf_file.hpp"

#include <H5public.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <netcdf.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <exception>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "io/whole_file.hpp"

namespace tdbd {
namespace {

nc_type type_of(NetcdfType type) {
  switch (type) {
    case NetcdfType::single:
      return NC_FLOAT;
    case NetcdfType::whole:
      return NC_INT;
    case NetcdfType::flag:
      return NC_BYTE;
    case NetcdfType::text:
      return NC_STRING;
    case NetcdfType::real:
      break;
  }
  return NC_DOUBLE;
}

static_assert(NetcdfFile::global == NC_GLOBAL);

}  // namespace

DescriptorPath::DescriptorPath(const std::filesystem::path& file) : name_(file.string()) {
  const std::filesystem::path parent = file.parent_path();
  folder_ = open(parent.empty() ? "." : parent.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
  if (folder_ < 0) return;
  const std::string folder = fmt::format("/proc/self/fd/{}", folder_);
  std::error_code unknown;
  if (std::filesystem::is_directory(folder, unknown))
    name_ = fmt::format("{}/{}", folder, file.filename().string());
}

DescriptorPath::~DescriptorPath() {
  if (folder_ >= 0) close(folder_);
}

NetcdfFile::NetcdfFile(std::filesystem::path path, Use use, std::size_t memory)
    : path_(std::move(path)), use_(use), memory_(memory) {
  const NetcdfLock lock(netcdf_mutex());
  require_allocatable(memory_);
  H5dont_atexit();  // HDF5 would access unclosed files again at exit, and crash
  errno = 0;
  const DescriptorPath plain(path_);
  require(use_ == Use::create ? nc_create(plain.c_str(), NC_NETCDF4 | NC_CLOBBER, &id_)
                              : nc_open(plain.c_str(), NC_NOWRITE, &id_));
}

NetcdfFile::~NetcdfFile() {
  try {
    close();
  } catch (const std::exception&) {  // destructors must not throw; close() reports errors
  }
}

void NetcdfFile::require(int status) const {
  if (status == NC_NOERR) return;
  std::string reason = nc_strerror(status);  // for system errors often not the actual cause
  if (errno != 0)
    reason =
        status > 0 ? std::strerror(errno) : fmt::format("{} ({})", reason, std::strerror(errno));
  throw RunError(fmt::format("cannot {} {}: {}", use_ == Use::create ? "write" : "read",
                             path_.string(), reason));
}

int NetcdfFile::dimension(const std::string& name, std::size_t length) {
  const NetcdfLock lock(netcdf_mutex());
  int dim = -1;
  require(nc_def_dim(id_, name.c_str(), length == 0 ? NC_UNLIMITED : length, &dim));
  return dim;
}

int NetcdfFile::variable(const NetcdfVariable& v) {
  const NetcdfLock lock(netcdf_mutex());
  int id = -1;
  require(nc_def_var(id_, v.name.c_str(), type_of(v.type), static_cast<int>(v.dims.size()),
                     v.dims.data(), &id));
  if (!v.units.empty()) attribute(id, "units", v.units);
  if (!v.long_name.empty()) attribute(id, "long_name", v.long_name);
  return id;
}

void NetcdfFile::set_chunks(int variable, const NetcdfChunks& chunks) {
  const NetcdfLock lock(netcdf_mutex());
  const std::size_t chunk[2] = {chunks.rows, std::max<std::size_t>(1, chunks.width)};
  require(nc_def_var_chunking(id_, variable, NC_CHUNKED, chunk));
  // A block consists of whole chunks, which are not accessed again: a larger cache would waste
  // memory.
  require(nc_set_var_chunk_cache(id_, variable, chunk[0] * chunk[1] * sizeof(double), 1, 1.0));
  constexpr int shuffled = 1, deflated = 1, fast = 1;
  if (chunks.deflated) require(nc_def_var_deflate(id_, variable, shuffled, deflated, fast));
}

void NetcdfFile::attribute(int variable, const std::string& name, const std::string& text) {
  const NetcdfLock lock(netcdf_mutex());
  require(nc_put_att_text(id_, variable, name.c_str(), text.size(), text.c_str()));
}

void NetcdfFile::attribute(int variable, const std::string& name, double value) {
  const NetcdfLock lock(netcdf_mutex());
  require(nc_put_att_double(id_, variable, name.c_str(), NC_DOUBLE, 1, &value));
}

void NetcdfFile::attribute(int variable, const std::string& name,
                           const std::vector<signed char>& values) {
  const NetcdfLock lock(netcdf_mutex());
  require(nc_put_att_schar(id_, variable, name.c_str(), NC_BYTE, values.size(), values.data()));
}

void NetcdfFile::end_definitions() {
  const NetcdfLock lock(netcdf_mutex());
  require(nc_enddef(id_));
}

void NetcdfFile::put(int variable, const std::vector<double>& values) {
  const NetcdfLock lock(netcdf_mutex());
  errno = 0;
  require(nc_put_var_double(id_, variable, values.data()));
}

void NetcdfFile::put(int variable, const std::vector<int>& values) {
  const NetcdfLock lock(netcdf_mutex());
  errno = 0;
  require(nc_put_var_int(id_, variable, values.data()));
}

void NetcdfFile::put(int variable, const std::vector<signed char>& values) {
  const NetcdfLock lock(netcdf_mutex());
  errno = 0;
  require(nc_put_var_schar(id_, variable, values.data()));
}

void NetcdfFile::put(int variable, const std::vector<std::string>& texts) {
  const NetcdfLock lock(netcdf_mutex());
  errno = 0;
  std::vector<const char*> bytes(texts.size());
  std::ranges::transform(texts, bytes.begin(), [](const std::string& s) { return s.c_str(); });
  if (!bytes.empty()) require(nc_put_var_string(id_, variable, bytes.data()));
}

void NetcdfFile::put_rows(int variable, std::size_t first, std::size_t count, std::size_t width,
                          const std::vector<double>& values) {
  const NetcdfLock lock(netcdf_mutex());
  require_allocatable(memory_);
  errno = 0;
  const std::size_t start[2] = {first, 0}, counts[2] = {count, width};
  require(nc_put_vara_double(id_, variable, start, counts, values.data()));
}

std::string NetcdfFile::text(const std::string& attribute) const {
  const NetcdfLock lock(netcdf_mutex());
  std::size_t n = 0;
  require(nc_inq_attlen(id_, NC_GLOBAL, attribute.c_str(), &n));
  std::string text(n, '\0');
  require(nc_get_att_text(id_, NC_GLOBAL, attribute.c_str(), text.data()));
  return text;
}

double NetcdfFile::number(const std::string& attribute) const {
  const NetcdfLock lock(netcdf_mutex());
  double value = 0.0;
  require(nc_get_att_double(id_, NC_GLOBAL, attribute.c_str(), &value));
  return value;
}

std::size_t NetcdfFile::length(const std::string& dimension) const {
  const NetcdfLock lock(netcdf_mutex());
  int dim = -1;
  std::size_t n = 0;
  require(nc_inq_dimid(id_, dimension.c_str(), &dim));
  require(nc_inq_dimlen(id_, dim, &n));
  return n;
}

int NetcdfFile::id_of(const std::string& variable, std::size_t count) const {
  int id = -1, rank = 0;
  require(nc_inq_varid(id_, variable.c_str(), &id));
  require(nc_inq_varndims(id_, id, &rank));
  std::vector<int> dims(static_cast<std::size_t>(rank));
  require(nc_inq_vardimid(id_, id, dims.data()));
  std::size_t found = 1;
  for (const int dim : dims) {
    std::size_t n = 0;
    require(nc_inq_dimlen(id_, dim, &n));
    found *= n;
  }
  if (found != count) require(NC_EVARSIZE);
  return id;
}

std::vector<double> NetcdfFile::reals(const std::string& variable, std::size_t count) const {
  const NetcdfLock lock(netcdf_mutex());
  std::vector<double> values(count);
  require(nc_get_var_double(id_, id_of(variable, count), values.data()));
  return values;
}

std::vector<int> NetcdfFile::wholes(const std::string& variable, std::size_t count) const {
  const NetcdfLock lock(netcdf_mutex());
  std::vector<int> values(count);
  require(nc_get_var_int(id_, id_of(variable, count), values.data()));
  return values;
}

void NetcdfFile::close() {
  if (id_ < 0) return;
  const int id = std::exchange(id_, -1);
  const NetcdfLock lock(netcdf_mutex());
  errno = 0;
  if (use_ == Use::read) return require(nc_close(id));
  require_allocatable(memory_);
  require(nc_sync(id));
  flush_to_disk(path_);  // the library crashes if a close fails, so nothing may be left to write
  require(nc_close(id));
}

}  // namespace tdbd
