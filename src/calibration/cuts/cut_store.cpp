#include "calibration/cuts/cut_store.hpp"

#include <fmt/format.h>

#include <mutex>

#include "calibration/cuts/cut_file.hpp"
#include "calibration/cuts/groove_cut.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/parallel.hpp"

namespace tdbd::calibration {
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
