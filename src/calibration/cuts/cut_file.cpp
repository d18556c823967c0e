#include "calibration/cuts/cut_file.hpp"

#include <H5public.h>
#include <fmt/format.h>
#include <netcdf.h>

#include <array>
#include <functional>
#include <utility>

#include "core/error.hpp"
#include "core/netcdf_lock.hpp"
#include "core/plain_path.hpp"
#include "core/program_file.hpp"
#include "core/provenance.hpp"
#include "core/seal.hpp"
#include "core/whole_file.hpp"

namespace tdbd::calibration {
namespace {

using simulation::CutOfPart;

/// A column of a file: a member of a cut with its name and unit.
struct Column {
  const char* name;
  const char* units;
  const char* long_name;
  std::function<double&(CutOfPart&)> of;
};

const std::vector<Column>& columns() {
  static const std::vector<Column> all{
      {"face_area", "m2", "mean area that the face cuts, in its plane",
       [](CutOfPart& c) -> double& { return c.face_area; }},
      {"contact_area", "m2", "mean area on which the part presses",
       [](CutOfPart& c) -> double& { return c.cut.contact_area; }},
      {"engaged_edge", "m", "mean length of the face's edge in rock",
       [](CutOfPart& c) -> double& { return c.cut.engaged_edge; }},
      {"removed_volume", "m3", "mean volume removed in a step",
       [](CutOfPart& c) -> double& { return c.cut.removed_volume; }},
      {"diameter", "m", "of the cutter", [](CutOfPart& c) -> double& { return c.cut.diameter; }}};
  return all;
}

struct VectorColumn {
  const char* name;
  const char* units;
  const char* long_name;
  std::function<Vec3&(CutOfPart&)> of;
};

const std::vector<VectorColumn>& vector_columns() {
  static const std::vector<VectorColumn> all{
      {"point_B", "m", "mean point of the contact, bit frame",
       [](CutOfPart& c) -> Vec3& { return c.cut.point; }},
      {"normal_B", "1", "from the bit into the rock, bit frame",
       [](CutOfPart& c) -> Vec3& { return c.cut.normal; }},
      {"forward_B", "1", "normal of the face, bit frame",
       [](CutOfPart& c) -> Vec3& { return c.forward_W; }}};
  return all;
}

/// An open file; closed by the destructor.
struct Nc {
  std::filesystem::path path;
  int id = -1;
  ~Nc() {
    if (id >= 0) nc_close(id);
  }
  void require(int status) const {
    if (status != NC_NOERR)
      throw RunError(fmt::format("cannot use {}: {}", path.string(), nc_strerror(status)));
  }
};

void describe(const Nc& nc, int variable, const std::string& units, const std::string& text) {
  nc.require(nc_put_att_text(nc.id, variable, "units", units.size(), units.c_str()));
  nc.require(nc_put_att_text(nc.id, variable, "long_name", text.size(), text.c_str()));
}

int define(const Nc& nc, const char* name, nc_type type, const std::vector<int>& dims) {
  int variable = -1;
  nc.require(nc_def_var(nc.id, name, type, static_cast<int>(dims.size()), dims.data(), &variable));
  return variable;
}

void write_rows(const Nc& nc, CutRun run, const std::vector<std::string>& names) {
  int part = -1, xyz = -1;
  nc.require(nc_def_dim(nc.id, "part", run.cuts.size(), &part));
  nc.require(nc_def_dim(nc.id, "xyz", 3, &xyz));
  nc.require(nc_put_att_double(nc.id, NC_GLOBAL, "depth_m", NC_DOUBLE, 1, &run.depth));
  const std::string commit = provenance().commit;
  nc.require(nc_put_att_text(nc.id, NC_GLOBAL, "commit", commit.size(), commit.c_str()));
  const int name = define(nc, "part_name", NC_STRING, {part});
  const int index = define(nc, "part_index", NC_INT, {part});
  const int kind = define(nc, "part_kind", NC_INT, {part});
  std::vector<int> scalars, vectors;
  for (const Column& c : columns())
    describe(nc, scalars.emplace_back(define(nc, c.name, NC_DOUBLE, {part})), c.units, c.long_name);
  for (const VectorColumn& c : vector_columns())
    describe(nc, vectors.emplace_back(define(nc, c.name, NC_DOUBLE, {part, xyz})), c.units,
             c.long_name);
  nc.require(nc_enddef(nc.id));
  for (std::size_t i = 0; i < run.cuts.size(); ++i) {
    CutOfPart& cut = run.cuts[i];
    const char* text = names[at(cut.part)].c_str();
    const int kind_number = static_cast<int>(cut.cut.kind);
    nc.require(nc_put_var1_string(nc.id, name, &i, &text));
    nc.require(nc_put_var1_int(nc.id, index, &i, &cut.part));
    nc.require(nc_put_var1_int(nc.id, kind, &i, &kind_number));
    for (std::size_t k = 0; k < scalars.size(); ++k)
      nc.require(nc_put_var1_double(nc.id, scalars[k], &i, &columns()[k].of(cut)));
    const std::array<std::size_t, 2> from{i, 0}, count{1, 3};
    for (std::size_t k = 0; k < vectors.size(); ++k)
      nc.require(nc_put_vara_double(nc.id, vectors[k], from.data(), count.data(),
                                    vector_columns()[k].of(cut).data()));
  }
}

/// Reads all values of a variable. Returns false if it does not exist.
template <class T, class Get>
bool read_all(const Nc& nc, const char* name, std::size_t count, std::vector<T>& values, Get get) {
  int variable = -1;
  values.assign(count, T{});
  return nc_inq_varid(nc.id, name, &variable) == NC_NOERR &&
         get(nc.id, variable, values.data()) == NC_NOERR;
}

bool is_of_this_commit(const Nc& nc) {
  std::size_t length = 0;
  if (nc_inq_attlen(nc.id, NC_GLOBAL, "commit", &length) != NC_NOERR) return false;
  std::string commit(length, ' ');
  return nc_get_att_text(nc.id, NC_GLOBAL, "commit", commit.data()) == NC_NOERR &&
         commit == provenance().commit;
}

/// Whether the file is newer than the program: a program that was built later may compute other
/// cuts. If the file of the program is unknown, only the commit is compared.
bool is_newer_than_the_program(const std::filesystem::path& file) {
  std::error_code error;
  const auto built = std::filesystem::last_write_time(program_file(), error);
  return error || std::filesystem::last_write_time(file) >= built;
}

bool is_whole(const std::filesystem::path& file) {
  try {
    require_seal(file);
    return true;
  } catch (const RunError&) {
    return false;
  }
}

bool read_rows(const Nc& nc, CutRun& run) {
  int part = -1;
  std::size_t n = 0;
  if (nc_get_att_double(nc.id, NC_GLOBAL, "depth_m", &run.depth) != NC_NOERR ||
      nc_inq_dimid(nc.id, "part", &part) != NC_NOERR || nc_inq_dimlen(nc.id, part, &n) != NC_NOERR)
    return false;
  run.cuts.assign(n, {});
  std::vector<int> index, kind;
  if (!read_all(nc, "part_index", n, index, nc_get_var_int) ||
      !read_all(nc, "part_kind", n, kind, nc_get_var_int))
    return false;
  for (std::size_t i = 0; i < n; ++i) {
    if (kind[i] < 0 || at(kind[i]) >= bit::part_kinds.size()) return false;
    run.cuts[i].part = index[i];
    run.cuts[i].cut.kind = static_cast<bit::PartKind>(kind[i]);
  }
  std::vector<double> values;
  for (const Column& c : columns()) {
    if (!read_all(nc, c.name, n, values, nc_get_var_double)) return false;
    for (std::size_t i = 0; i < n; ++i) c.of(run.cuts[i]) = values[i];
  }
  for (const VectorColumn& c : vector_columns()) {
    if (!read_all(nc, c.name, 3 * n, values, nc_get_var_double)) return false;
    for (std::size_t i = 0; i < n; ++i) c.of(run.cuts[i]) = Eigen::Map<Vec3>(&values[3 * i]);
  }
  return true;
}

}  // namespace

void write_cut_run(const std::filesystem::path& file, const CutRun& run,
                   const std::vector<std::string>& names) {
  {
    const NetcdfLock lock(netcdf_mutex());
    H5dont_atexit();
    Nc nc{partial_path(file)};
    nc.require(nc_create(PlainPath(nc.path).c_str(), NC_NETCDF4 | NC_CLOBBER, &nc.id));
    write_rows(nc, run, names);
    nc.require(nc_sync(nc.id));
    put_on_disk(nc.path);
    nc.require(nc_close(std::exchange(nc.id, -1)));
    seal_file(nc.path);
    put_on_disk(nc.path);
  }
  rename_partial(file);
}

std::optional<CutRun> read_cut_run(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file) || !is_newer_than_the_program(file) ||
      !is_whole(file))
    return std::nullopt;
  const NetcdfLock lock(netcdf_mutex());
  Nc nc{file};
  if (nc_open(PlainPath(file).c_str(), NC_NOWRITE, &nc.id) != NC_NOERR) return std::nullopt;
  CutRun run;
  if (!is_of_this_commit(nc) || !read_rows(nc, run)) return std::nullopt;
  return run;
}

}  // namespace tdbd::calibration
