#include "calibration/cuts/cut_file.hpp"

#include <functional>

#include "core/error.hpp"
#include "core/program_file.hpp"
#include "core/provenance.hpp"
#include "io/netcdf_file.hpp"
#include "io/whole_file.hpp"

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

/// One value of each cut.
template <class T, class Of>
std::vector<T> values_of(std::vector<CutOfPart>& cuts, Of&& of) {
  std::vector<T> values;
  for (CutOfPart& cut : cuts) values.push_back(of(cut));
  return values;
}

void write_rows(NetcdfFile& nc, CutRun run, const std::vector<std::string>& names) {
  const int part = nc.dimension("part", run.cuts.size()), xyz = nc.dimension("xyz", 3);
  nc.attribute(NetcdfFile::global, "depth_m", run.depth);
  nc.attribute(NetcdfFile::global, "commit", provenance().commit);
  nc.put(nc.variable({"part_name", NetcdfType::text, {part}, "", ""}),
         values_of<std::string>(run.cuts, [&](CutOfPart& c) { return names[at(c.part)]; }));
  nc.put(nc.variable({"part_index", NetcdfType::whole, {part}, "", ""}),
         values_of<int>(run.cuts, [](CutOfPart& c) { return c.part; }));
  nc.put(nc.variable({"part_kind", NetcdfType::whole, {part}, "", ""}),
         values_of<int>(run.cuts, [](CutOfPart& c) { return static_cast<int>(c.cut.kind); }));
  for (const Column& c : columns())
    nc.put(nc.variable({c.name, NetcdfType::real, {part}, c.units, c.long_name}),
           values_of<double>(run.cuts, c.of));
  for (const VectorColumn& c : vector_columns()) {
    std::vector<double> values;
    for (CutOfPart& cut : run.cuts) {
      const Vec3& v = c.of(cut);
      values.insert(values.end(), {v.x(), v.y(), v.z()});
    }
    nc.put(nc.variable({c.name, NetcdfType::real, {part, xyz}, c.units, c.long_name}), values);
  }
}

/// A program that was built after the file may cut otherwise. Where the program's file is unknown,
/// the commit alone decides.
bool is_newer_than_the_program(const std::filesystem::path& file) {
  std::error_code error;
  const auto built = std::filesystem::last_write_time(program_file(), error);
  return error || std::filesystem::last_write_time(file) >= built;
}

/// Throws RunError for a file without all of these, or with a kind of part that is none.
CutRun read_rows(const NetcdfFile& nc) {
  const std::size_t n = nc.length("part");
  CutRun run;
  run.depth = nc.number("depth_m");
  run.cuts.assign(n, {});
  const std::vector<int> index = nc.wholes("part_index", n), kind = nc.wholes("part_kind", n);
  for (std::size_t i = 0; i < n; ++i) {
    if (kind[i] < 0 || at(kind[i]) >= bit::part_kinds.size()) throw RunError("no kind of part");
    run.cuts[i].part = index[i];
    run.cuts[i].cut.kind = static_cast<bit::PartKind>(kind[i]);
  }
  for (const Column& c : columns()) {
    const std::vector<double> values = nc.reals(c.name, n);
    for (std::size_t i = 0; i < n; ++i) c.of(run.cuts[i]) = values[i];
  }
  for (const VectorColumn& c : vector_columns()) {
    const std::vector<double> values = nc.reals(c.name, 3 * n);
    for (std::size_t i = 0; i < n; ++i) c.of(run.cuts[i]) = Eigen::Map<const Vec3>(&values[3 * i]);
  }
  return run;
}

}  // namespace

void write_cut_run(const std::filesystem::path& file, const CutRun& run,
                   const std::vector<std::string>& names) {
  const std::filesystem::path partial = partial_path(file);
  NetcdfFile nc(partial, NetcdfFile::Use::create);
  write_rows(nc, run, names);
  nc.close();
  seal_file(partial);
  put_on_disk(partial);
  rename_partial(file);
}

std::optional<CutRun> read_cut_run(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file) || !is_newer_than_the_program(file))
    return std::nullopt;
  try {
    require_seal(file);
    const NetcdfFile nc(file, NetcdfFile::Use::read);
    if (nc.text("commit") != provenance().commit) return std::nullopt;
    return read_rows(nc);
  } catch (const RunError&) {
    return std::nullopt;
  }
}

}  // namespace tdbd::calibration
