#include "sweep/sweep.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <set>
#include <thread>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/provenance.hpp"
#include "core/read_file.hpp"

namespace tdbd::sweep {
namespace {

namespace fs = std::filesystem;

/// The inputs of those cases that can be read.
struct Seen {
  std::set<std::string> files, doubts;
  bool any = false;           ///< a case could be read
  std::string first_problem;  ///< the mistakes of the first case that could not
};

void look_at(const Design& d, const std::vector<std::string>& overrides, Seen& seen) {
  try {
    const PointInputs inputs = inputs_of(d, overrides);
    seen.files.insert(inputs.files.begin(), inputs.files.end());
    seen.doubts.insert(inputs.doubts.begin(), inputs.doubts.end());
    seen.any = true;
  } catch (const InputError& e) {
    if (seen.first_problem.empty()) seen.first_problem = e.what();
  }
}

/// Returns a hash of the contents of these files and of the case.
std::string hash_of(const Design& d, const std::set<std::string>& files) {
  std::string all = read_file(d.case_file, "a TOML file");
  for (const std::string& file : files) all += fnv1a_hex(read_file(file, "a file of the case"));
  return fnv1a_hex(all);
}

/// Passes on the first doubts, each of them once.
void warn_of(const Seen& seen, const SweepOptions& options) {
  constexpr long most = 8;
  if (!options.warn) return;
  long told = 0;
  for (const std::string& doubt : seen.doubts)
    if (told++ < most) options.warn(doubt);
  if (told > most) options.warn(fmt::format("... and {} more doubts of this kind", told - most));
}

/// Returns the inputs of the points. Only levels that are texts can name files. Each of them is read
/// once, with the first levels of all other factors, and so is the last level of the others: the
/// levels of a factor share their unit. If none of these cases can be read, nor some points in
/// between, the design itself is wrong.
Seen inputs_of_points(const Design& d, const Points& points) {
  constexpr long others = 8;
  Seen seen;
  const std::vector<std::string> first = overrides_at(d, points, 0);
  look_at(d, first, seen);
  for (std::size_t k = 0; k < d.factors.size(); ++k)
    for (const Level& level : d.factors[k].levels)
      if (!level.number || &level == &d.factors[k].levels.back()) {
        std::vector<std::string> overrides = first;
        overrides[d.fixed.size() + k] = d.factors[k].key + "=" + level.word.toml;
        look_at(d, overrides, seen);
      }
  for (long k = 1; k <= others && !seen.any; ++k)
    look_at(d, overrides_at(d, points, k * (points.count - 1) / others), seen);
  if (!seen.any) throw InputError(seen.first_problem);
  look_at(d, d.fixed, seen);  // the unchanged case of a filter
  return seen;
}

/// Returns the key of a point. `content`: a hash of the files that points read.
std::string key_of(const Design& d, const std::string& content,
                   const std::vector<std::string>& overrides) {
  const Provenance& p = provenance();
  const std::string same = fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n", p.version, p.commit,
                                       p.flags, name_of(d.command), d.penetration, d.normal_ratio,
                                       content, fmt::join(d.figures, "\n"));
  return fnv1a_hex(same + fmt::format("{}", fmt::join(overrides, "\n")));
}

/// Points that can be run: the overrides and the key of each. The unchanged case of a filter comes
/// after the points of the design.
struct PointList {
  std::function<std::vector<std::string>(long)> overrides;
  std::vector<std::string> keys;
};

/// The points of a design, followed by the unchanged case. `content`: hash_of what they read.
PointList list_of(const Design& d, const Points& points, const std::string& content) {
  PointList list;
  list.overrides = [&d, &points](long i) {
    return i < points.count ? overrides_at(d, points, i) : d.fixed;
  };
  for (long i = 0; i <= points.count; ++i)
    list.keys.push_back(key_of(d, content, list.overrides(i)));
  return list;
}

/// Distributes the points over threads and collects the results.
class Workers {
 public:
  Workers(const Design& d, const PointList& list, std::vector<long> todo, Journal& journal,
          const SweepOptions& options, long found)
      : design_(d),
        list_(list),
        todo_(std::move(todo)),
        journal_(journal),
        options_(options),
        starts_(options.keeping),
        found_(found) {}

  /// Rethrows errors of the journal. The threads end after their current points.
  void work() {
    const auto threads = std::min(static_cast<std::size_t>(options_.threads), todo_.size());
    {
      std::vector<std::jthread> running;
      for (std::size_t t = 0; t < threads; ++t) running.emplace_back([this] { take_points(); });
    }
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void take_points() {
    try {
      PointSurroundings around{points_folder(options_.table) / "cuts", options_.interrupted,
                               starts_};
      for (std::size_t k = next_++; k < todo_.size(); k = next_++) take(todo_[k], around);
    } catch (const Interrupted&) {
      next_ = todo_.size();
    } catch (...) {
      const std::lock_guard hold(mutex_);
      if (!failure_) failure_ = std::current_exception();
      next_ = todo_.size();
    }
  }

  void take(long index, PointSurroundings& around) {
    if (options_.interrupted != nullptr && *options_.interrupted) throw Interrupted{};
    const auto begun = std::chrono::steady_clock::now();
    PointRecord record;
    record.outcome = run_point(design_, list_.overrides(index), around);
    record.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    const std::lock_guard hold(mutex_);
    if (record.outcome.lacks_figures && found_ + done_ == 0)
      throw InputError(fmt::format("{}: {}", design_.file, record.outcome.message));
    journal_.add(list_.keys[static_cast<std::size_t>(index)], record);
    ++done_;
    if (options_.progress)
      options_.progress(found_ + done_, found_ + static_cast<long>(todo_.size()));
  }

  const Design& design_;
  const PointList& list_;
  std::vector<long> todo_;
  Journal& journal_;
  const SweepOptions& options_;
  Starts starts_;
  long found_, done_ = 0;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::exception_ptr failure_;
};

/// Returns the points of the shard that are to be run and are in no journal. `runs`: whether a point
/// of the list is run at all.
std::vector<long> points_to_do(const Shard& shard, const PointList& list,
                               const PointRecords& records,
                               const std::function<bool(std::size_t)>& runs, SweepResult& result) {
  std::vector<long> todo;
  long run = 0;
  for (std::size_t i = 0; i < list.keys.size(); ++i) {
    if (!runs(i) || run++ % shard.n != shard.i - 1) continue;
    ++result.of_shard;
    if (records.contains(list.keys[i]))
      ++result.found;
    else
      todo.push_back(static_cast<long>(i));
  }
  return todo;
}

/// Evaluates the filter at every point and for the unchanged case. Each shard needs the values of
/// all points, and uses those that other shards have already computed.
Judged judge_points(const Design& d, const Points& points, Journal& journal, SweepOptions options) {
  const Design planar = planar_design(d);
  const PointList list =
      list_of(planar, points, hash_of(planar, inputs_of_points(planar, points).files));
  const fs::path folder = points_folder(options.table);
  SweepResult all;
  options.progress = {};
  std::vector<long> todo = points_to_do(
      {}, list, read_journals(folder), [](std::size_t) { return true; }, all);
  Workers(planar, list, std::move(todo), journal, options, all.found).work();
  const PointRecords records = read_journals(folder);
  std::vector<double> figure;
  for (const std::string& key : list.keys) {
    const auto found = records.find(key);
    figure.push_back(found == records.end() ? std::numeric_limits<double>::quiet_NaN()
                                            : found->second.outcome.figures.front());
  }
  const double unchanged = figure.back();
  figure.pop_back();
  Judged judged = judged_by(*d.filter, std::move(figure));
  judged.unchanged = unchanged;
  return judged;
}

void count(const Table& t, SweepResult& result) {
  result.points = points_to_run(t);
  result.done = done_points(t);
  result.on_front = std::ranges::count(t.on_front, 1);
  for (const PointRecord* point : t.points) {
    if (point == nullptr) continue;
    if (point->outcome.steady == Steady::no) ++result.unsteady;
    if (point->outcome.status == PointStatus::done) {
      const auto is_none = [](double figure) { return std::isnan(figure); };
      if (std::ranges::any_of(point->outcome.figures, is_none)) ++result.without_values;
      continue;
    }
    if (result.failed++ == 0) result.first_failure = point->outcome.message;
  }
}

/// The journal of the process that runs this shard.
fs::path journal_folder(const SweepOptions& options) {
  return points_folder(options.table) / fmt::format("{}-of-{}", options.shard.i, options.shard.n);
}

bool is_interrupted(const SweepOptions& options) {
  return options.interrupted != nullptr && *options.interrupted;
}

}  // namespace

fs::path points_folder(const fs::path& table) {
  fs::path folder = table;
  return folder.replace_extension(".points");
}

std::vector<std::string> point_keys(const Design& d, const Points& points) {
  std::vector<std::string> keys =
      list_of(d, points, hash_of(d, inputs_of_points(d, points).files)).keys;
  keys.pop_back();
  return keys;
}

std::vector<std::optional<PointRecord>> run_listed(
    const Design& d, const std::vector<std::vector<std::string>>& list,
    const SweepOptions& options) {
  const ThreadLimit one(1);
  Seen seen;
  for (const std::vector<std::string>& overrides : list) look_at(d, overrides, seen);
  if (!seen.any) throw InputError(seen.first_problem);
  const std::string content = hash_of(d, seen.files);
  PointList points{[&list](long i) { return list[static_cast<std::size_t>(i)]; }, {}};
  for (const std::vector<std::string>& overrides : list)
    points.keys.push_back(key_of(d, content, overrides));
  const fs::path folder = points_folder(options.table);
  {
    Journal journal(journal_folder(options));
    SweepResult result;
    std::vector<long> todo = points_to_do(
        {}, points, read_journals(folder), [](std::size_t) { return true; }, result);
    Workers(d, points, std::move(todo), journal, options, result.found).work();
  }
  const PointRecords records = read_journals(folder);
  std::vector<std::optional<PointRecord>> found;
  for (const std::string& key : points.keys) {
    const auto record = records.find(key);
    found.push_back(record == records.end() ? std::nullopt : std::optional(record->second));
  }
  return found;
}

SweepResult run_sweep(const Design& d, const SweepOptions& options) {
  const ThreadLimit one(1);
  SweepResult result;
  const Points points = points_of(d);
  const Seen seen = inputs_of_points(d, points);
  warn_of(seen, options);
  PointList list = list_of(d, points, hash_of(d, seen.files));
  if (!d.filter) list.keys.pop_back();
  const fs::path folder = points_folder(options.table);
  Journal journal(journal_folder(options));
  const Judged judged = d.filter ? judge_points(d, points, journal, options) : Judged{};
  if (!is_interrupted(options)) {
    const auto runs = [&](std::size_t i) {
      return static_cast<long>(i) == points.count || judged.keeps(i);
    };
    std::vector<long> todo = points_to_do(options.shard, list, read_journals(folder), runs, result);
    Workers(d, list, std::move(todo), journal, options, result.found).work();
  }
  result.interrupted = is_interrupted(options);
  const PointRecords records = read_journals(folder);
  Table t = table_of(d, points, list.keys, records, judged);
  if (const auto unchanged = records.find(list.keys.back()); d.filter && unchanged != records.end())
    t.unchanged = &unchanged->second;
  count(t, result);
  if (result.interrupted || result.done < result.points) return result;
  write_table(options.table, t, journal.folder());
  result.written = true;
  if (d.filter) result.filter = filter_report(d, judged, t.points, t.unchanged);
  return result;
}

}  // namespace tdbd::sweep
