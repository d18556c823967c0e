#include "sweep/table/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gsl/gsl_statistics_double.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/error.hpp"
#include "core/provenance.hpp"
#include "core/read_file.hpp"

namespace tdbd::sweep {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* file_name = "points.jsonl";
constexpr std::size_t seal_width = 16;  // hexadecimal digits, followed by a blank

Json number_or_null(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

std::string body_of(const std::string& key, const PointRecord& r) {
  Json figures = Json::array();
  for (const double x : r.outcome.figures) figures.push_back(number_or_null(x));
  const Json line{{"key", key},
                  {"failed", r.outcome.status == PointStatus::failed},
                  {"case_hash", r.outcome.case_hash},
                  {"message", r.outcome.message},
                  {"figures", figures},
                  {"steady", static_cast<int>(r.outcome.steady)},
                  {"seconds", r.seconds}};
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

PointRecord record_of(const Json& line) {
  PointRecord r;
  r.outcome.status = line.at("failed").get<bool>() ? PointStatus::failed : PointStatus::done;
  r.outcome.case_hash = line.at("case_hash");
  r.outcome.message = line.at("message");
  for (const Json& x : line.at("figures"))
    r.outcome.figures.push_back(x.is_null() ? std::numeric_limits<double>::quiet_NaN()
                                            : x.get<double>());
  r.outcome.steady = static_cast<Steady>(line.value("steady", static_cast<int>(Steady::unknown)));
  r.seconds = line.at("seconds");
  return r;
}

/// Whether a line is complete and unchanged: its hash, a blank, its body.
bool is_whole(const std::string& line) {
  return line.size() > seal_width && line[seal_width] == ' ' &&
         line.compare(0, seal_width, fnv1a_hex(std::string_view(line).substr(seal_width + 1))) == 0;
}

/// Returns the number of bytes up to the last end of a line.
std::size_t whole_lines(const std::string& text) {
  const std::size_t end = text.rfind('\n');
  return end == std::string::npos ? 0 : end + 1;
}

[[noreturn]] void fail(const fs::path& file) {
  throw RunError(fmt::format("cannot write {}: {}", file.string(), std::strerror(errno)));
}

void read_journal(const fs::path& file, PointRecords& records) {
  const std::string text = read_file(file, "a journal of points");
  std::size_t begin = 0;
  for (long line = 1; begin < whole_lines(text); ++line) {
    const std::size_t end = text.find('\n', begin);
    const std::string one = text.substr(begin, end - begin);
    begin = end + 1;
    if (!is_whole(one))
      throw RunError(fmt::format(
          "{}:{}: found a line that is not as it was written; delete the line, and its point is "
          "run again",
          file.string(), line));
    const Json json = Json::parse(one.substr(seal_width + 1));
    records.emplace(json.at("key"), record_of(json));
  }
}

/// Creates the folder and returns its path.
const fs::path& made(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw RunError(fmt::format("cannot make {}: {}", folder.string(), error.message()));
  return folder;
}

}  // namespace

Journal::Journal(const fs::path& folder)
    : file_(made(folder) / file_name),
      lock_(folder),
      descriptor_(open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_APPEND, 0666)) {
  if (descriptor_ < 0) fail(file_);
  if (ftruncate(descriptor_,
                static_cast<off_t>(whole_lines(read_file(file_, "a journal of points")))) != 0)
    fail(file_);
}

Journal::~Journal() { close(descriptor_); }

void Journal::add(const std::string& key, const PointRecord& record) {
  const std::string body = body_of(key, record);
  const std::string line = fmt::format("{} {}\n", fnv1a_hex(body), body);
  const off_t before = lseek(descriptor_, 0, SEEK_END);
  std::size_t written = 0;
  while (written < line.size()) {
    const ssize_t n = write(descriptor_, line.data() + written, line.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      const int why = errno;
      if (before >= 0 && ftruncate(descriptor_, before) != 0) errno = why;
      errno = why;
      fail(file_);
    }
    written += static_cast<std::size_t>(n);
  }
}

PointRecords read_journals(const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (fs::is_regular_file(entry.path() / file_name)) files.push_back(entry.path() / file_name);
  std::ranges::sort(files);
  PointRecords records;
  for (const fs::path& file : files) read_journal(file, records);
  return records;
}

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

double figure_of(const PointRecord* point, std::size_t figure) {
  return point == nullptr ? no_number : point->outcome.figures[figure];
}

/// The values of a filter and the drilled figures of the same points.
struct Pairs {
  std::vector<double> filter, figure;

  void add(double of_filter, double drilled) {
    if (!std::isfinite(of_filter) || !std::isfinite(drilled)) return;
    filter.push_back(of_filter);
    figure.push_back(drilled);
  }
  long count() const { return std::ssize(filter); }
};

/// The direction in which a figure of the design improves: that of its goal, else that of the
/// filter.
Sense sense_of(const Design& d, const std::string& figure) {
  for (const Goal& goal : d.goals)
    if (goal.figure == figure) return goal.sense;
  return d.filter->goal.sense;
}

}  // namespace

Judged judged_by(const Filter& filter, std::vector<double> figure) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < figure.size(); ++i)
    if (std::isfinite(figure[i])) order.push_back(i);
  const double sign = filter.goal.sense == Sense::smaller ? 1.0 : -1.0;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return sign * figure[i]; });
  Judged judged{.figure = std::move(figure)};
  judged.kept.assign(judged.figure.size(), KeptAs::left_out);
  const auto best = std::min(order.size(), static_cast<std::size_t>(filter.keep));
  for (std::size_t k = 0; k < best; ++k) judged.kept[order[k]] = KeptAs::best;
  const std::size_t rest = order.size() - best;
  const auto samples = std::min(rest, static_cast<std::size_t>(sample_count(filter)));
  for (std::size_t k = 0; k < samples; ++k)
    judged.kept[order[best + (2 * k + 1) * rest / (2 * samples)]] = KeptAs::sample;
  return judged;
}

double rank_correlation(std::span<const double> a, std::span<const double> b) {
  constexpr long fewest = 3;
  Pairs pairs;
  for (std::size_t i = 0; i < a.size(); ++i) pairs.add(a[i], b[i]);
  const auto [low_a, high_a] = std::ranges::minmax_element(pairs.filter);
  const auto [low_b, high_b] = std::ranges::minmax_element(pairs.figure);
  if (pairs.count() < fewest || *low_a == *high_a || *low_b == *high_b) return no_number;
  std::vector<double> work(2 * pairs.filter.size());
  return gsl_stats_spearman(pairs.filter.data(), 1, pairs.figure.data(), 1, pairs.filter.size(),
                            work.data());
}

std::size_t compared_figure(const Design& d) {
  auto found = std::ranges::find(d.figures, d.filter->goal.figure);
  if (found == d.figures.end() && !d.goals.empty())
    found = std::ranges::find(d.figures, d.goals.front().figure);
  return found == d.figures.end() ? 0 : static_cast<std::size_t>(found - d.figures.begin());
}

FilterReport filter_report(const Design& d, const Judged& judged,
                           std::span<const PointRecord* const> points,
                           const PointRecord* unchanged) {
  const std::size_t compared = compared_figure(d);
  FilterReport r;
  r.filter = "planar." + d.filter->goal.figure;
  r.figure = d.figures[compared];
  r.unchanged_filter = judged.unchanged;
  r.unchanged_figure = figure_of(unchanged, compared);
  if (unchanged != nullptr) r.unchanged_message = unchanged->outcome.message;
  const double sign = sense_of(d, r.figure) == Sense::smaller ? 1.0 : -1.0;
  Pairs all, best;
  all.add(r.unchanged_filter, r.unchanged_figure);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double figure = figure_of(points[i], compared);
    if (!judged.keeps(i) || !std::isfinite(figure)) continue;
    all.add(judged.figure[i], figure);
    if (judged.kept[i] == KeptAs::best) best.add(judged.figure[i], figure);
    if (r.best_point < 0 || sign * figure < sign * r.best_figure) {
      r.best_point = static_cast<long>(i);
      r.best_figure = figure;
    }
  }
  r.points = all.count();
  r.best = best.count();
  r.of_all = rank_correlation(all.filter, all.figure);
  r.of_best = rank_correlation(best.filter, best.figure);
  return r;
}

std::string filter_csv(const Design& d, const Judged& judged,
                       std::span<const PointRecord* const> points, const PointRecord* unchanged) {
  const auto number = [](double x) { return std::isfinite(x) ? fmt::format("{}", x) : "nan"; };
  const auto row = [&](const std::string& why, const std::string& point, double filter,
                       const PointRecord* record) {
    std::string text = fmt::format("{},{},{}", why, point, number(filter));
    for (std::size_t k = 0; k < d.figures.size(); ++k) text += "," + number(figure_of(record, k));
    return text + "\n";
  };
  std::string text = "run as,point,planar." + d.filter->goal.figure;
  for (const std::string& figure : d.figures) text += "," + figure;
  text += "\n" + row("unchanged", "", judged.unchanged, unchanged);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (judged.keeps(i))
      text += row(judged.kept[i] == KeptAs::best ? "best" : "sample", fmt::format("{}", i),
                  judged.figure[i], points[i]);
  return text;
}

}  // namespace tdbd::sweep
