#include "calibration/cuts/cut_store.hpp"

#include <fmt/format.h>

#include <mutex>

#include "core/error.hpp"
#include "core/parallel.hpp"
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
  flush_to_disk(partial);
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

namespace {

namespace fs = std::filesystem;
using Key = std::pair<std::string, double>;

/// A cut run of a bit that is required.
struct Job {
  Key key;
  fs::path file;
  std::optional<CutRun> cuts;
  std::optional<simulation::Case> run;  ///< case of a run that is not available yet
};

/// A hash that identifies the content of a bit and the grid of its cut runs: the hash of one of
/// these. Computed once per bit, because reading a bit takes longer than reading its cuts.
std::string bit_hash(const CalibrationCase& c, const Tool& bit) {
  constexpr double any_depth = 1e-3;  // m
  return cut_case(c, bit, any_depth).hash;
}

std::vector<Key> keys_of(const CalibrationCase& c) {
  std::map<Key, int> keys;
  for (const Record& r : c.records.rows) keys[{r.tool, depth_of_run(r)}] = 0;
  std::vector<Key> list;
  list.reserve(keys.size());
  for (const auto& [key, unused] : keys) list.push_back(key);
  return list;
}

Job job_of(const CalibrationCase& c, const Key& key, const std::string& hash,
           const fs::path& folder) {
  const std::string content = fmt::format("{} {}", hash, key.second);
  Job job{key, folder / fmt::format("cuts-{}.nc", fnv1a_hex(content)), {}, {}};
  job.cuts = read_cut_run(job.file);
  if (!job.cuts) job.run = cut_case(c, tool_named(c, key.first), key.second);
  return job;
}

std::vector<std::string> part_names(const bit::Bit& bit) {
  std::vector<std::string> names;
  for (const bit::Part& p : bit.parts) names.push_back(p.name);
  return names;
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw InputError(fmt::format("folder of cuts {}: {}", folder.string(), error.message()));
}

/// Performs the missing runs. If one fails, the others are still stored; its message is thrown
/// afterwards.
void make_missing(const CalibrationCase& c, std::vector<Job>& jobs,
                  const std::function<void(long, long)>& progress) {
  std::vector<Job*> missing;
  for (Job& job : jobs)
    if (!job.cuts) missing.push_back(&job);
  std::vector<std::string> failures(missing.size());
  std::mutex telling;
  long done = 0;
  parallel_for(static_cast<int>(missing.size()), [&](int i) {
    Job& job = *missing[at(i)];
    try {
      job.cuts = make_cut_run(*job.run, job.key.second, c.grid.steps_per_revolution);
    } catch (const std::exception& e) {
      failures[at(i)] = fmt::format("cut run of {} at {:.4g} mm a revolution: {}", job.key.first,
                                    1e3 * job.key.second, e.what());
    }
    const std::lock_guard lock(telling);
    if (job.cuts) write_cut_run(job.file, *job.cuts, part_names(job.run->bit));
    if (progress) progress(++done, static_cast<long>(missing.size()));
  });
  for (const std::string& failure : failures)
    if (!failure.empty()) throw RunError(failure);
}

}  // namespace

const CutRun& cut_run_of(const CutStore& store, const Record& record) {
  return store.runs.at({record.tool, depth_of_run(record)});
}

CutStore find_cuts(const CalibrationCase& c, const fs::path& folder,
                   const std::function<void(long, long)>& progress) {
  CutStore store;
  std::vector<Job> jobs;
  std::map<std::string, std::string> hashes;
  for (const Key& key : keys_of(c)) {
    const Tool& tool = tool_named(c, key.first);
    if (tool.kind == ToolKind::cutter) {
      store.runs[key] =
          groove_cut(tool.cutter, key.second, c.grid.breakout ? c.grid.breakout->ahead_share : 0.0);
      continue;
    }
    if (!hashes.contains(tool.name)) hashes[tool.name] = bit_hash(c, tool);
    jobs.push_back(job_of(c, key, hashes[tool.name], folder));
  }
  if (!jobs.empty()) make_folder(folder);
  for (const Job& job : jobs) ++(job.cuts ? store.found : store.made);
  make_missing(c, jobs, progress);
  for (Job& job : jobs) {
    store.runs[job.key] = std::move(*job.cuts);
    store.files.push_back(job.file);
  }
  return store;
}

}  // namespace tdbd::calibration
