#include "sweep/table/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/whole_file.hpp"
#include "sweep/table/front.hpp"
#include "sweep/table/table_netcdf.hpp"

namespace tdbd::sweep {

namespace fs = std::filesystem;

namespace {

/// Levels that are all numbers in one unit are numbers.
FactorColumn column_of(const Factor& f) {
  if (f.levels.empty()) return {f.key, f.interval->unit, true};
  const Level& first = f.levels.front();
  const bool numbers = std::ranges::all_of(
      f.levels, [&](const Level& l) { return l.number.has_value() && l.unit == first.unit; });
  return {f.key, numbers ? first.unit : "", numbers};
}

std::vector<char> front_in(const Table& t) {
  const Design& d = *t.design;
  std::vector<std::size_t> columns;
  for (const Goal& goal : d.goals)
    columns.push_back(
        static_cast<std::size_t>(std::ranges::find(d.figures, goal.figure) - d.figures.begin()));
  std::vector<std::vector<double>> rows;
  for (const PointRecord* point : t.points) {
    std::vector<double>& row = rows.emplace_back();
    for (const std::size_t column : columns)
      row.push_back(point == nullptr ? std::numeric_limits<double>::quiet_NaN()
                                     : point->outcome.figures[column]);
  }
  return front_of(rows, d.goals);
}

/// A cell of a CSV file: quoted where a comma, a quote or a new line asks for it (RFC 4180).
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string header_of(const FactorColumn& f) {
  return cell(f.unit.empty() ? f.key : fmt::format("{} [{}]", f.key, f.unit));
}

std::string number_cell(double x) { return std::isfinite(x) ? fmt::format("{}", x) : "nan"; }

std::string status_of(const Table& t, std::size_t i) {
  const PointRecord* point = t.points[i];
  if (!t.judged.keeps(i)) return "left-out";
  if (point == nullptr) return "missing";
  return point->outcome.status == PointStatus::done ? "done" : "failed";
}

std::string row_of(const Table& t, std::size_t i) {
  std::string row = fmt::format("{}", i);
  for (std::size_t k = 0; k < t.factors.size(); ++k)
    row += "," + (t.factors[k].numbers ? number_cell(*t.levels[i][k].number)
                                       : cell(t.levels[i][k].word.text));
  const PointRecord* point = t.points[i];
  if (t.design->filter) row += "," + number_cell(t.judged.figure[i]);
  for (std::size_t k = 0; k < t.design->figures.size(); ++k)
    row += "," + (point == nullptr ? "nan" : number_cell(point->outcome.figures[k]));
  if (!t.design->goals.empty()) row += fmt::format(",{}", static_cast<int>(t.on_front[i]));
  row +=
      fmt::format(",{},{},{}\n", status_of(t, i), point == nullptr ? "" : point->outcome.case_hash,
                  cell(point == nullptr ? "" : point->outcome.message));
  return row;
}

/// Within a file system: whoever reads it sees the former file or this one.
void move(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) throw RunError(fmt::format("cannot write {}: {}", to.string(), error.message()));
}

std::string timing_csv(const Table& t) {
  std::string text = "point,seconds\n";
  for (std::size_t i = 0; i < t.points.size(); ++i)
    if (t.points[i] != nullptr) text += fmt::format("{},{:.4f}\n", i, t.points[i]->seconds);
  return text;
}

}  // namespace

Table table_of(const Design& d, const Points& points, const std::vector<std::string>& keys,
               const PointRecords& records, const Judged& judged) {
  Table t;
  t.judged = judged;
  t.design = &d;
  for (const Factor& f : d.factors) t.factors.push_back(column_of(f));
  for (long i = 0; i < points.count; ++i) {
    t.levels.push_back(levels_at(d, points, i));
    const auto found = records.find(keys[static_cast<std::size_t>(i)]);
    const bool left_out = !judged.keeps(static_cast<std::size_t>(i));
    t.points.push_back(found == records.end() || left_out ? nullptr : &found->second);
  }
  t.on_front = front_in(t);
  return t;
}

long done_points(const Table& t) {
  return std::ranges::count_if(t.points, [](const PointRecord* p) { return p != nullptr; });
}

long points_to_run(const Table& t) {
  long count = 0;
  for (std::size_t i = 0; i < t.points.size(); ++i) count += t.judged.keeps(i) ? 1 : 0;
  return count;
}

Judged judged_by(const Filter& filter, std::vector<double> figure) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < figure.size(); ++i)
    if (std::isfinite(figure[i])) order.push_back(i);
  const double sign = filter.goal.sense == Sense::smaller ? 1.0 : -1.0;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return sign * figure[i]; });
  Judged judged{std::move(figure), {}};
  judged.kept.assign(judged.figure.size(), 0);
  for (std::size_t k = 0; k < order.size() && k < static_cast<std::size_t>(filter.keep); ++k)
    judged.kept[order[k]] = 1;
  return judged;
}

std::string to_csv(const Table& t) {
  std::string text = "point";
  for (const FactorColumn& f : t.factors) text += "," + header_of(f);
  if (t.design->filter) text += ",planar." + cell(t.design->filter->goal.figure);
  for (const std::string& figure : t.design->figures) text += "," + cell(figure);
  text +=
      t.design->goals.empty() ? ",status,case_hash,message\n" : ",front,status,case_hash,message\n";
  for (std::size_t i = 0; i < t.points.size(); ++i) text += row_of(t, i);
  return text;
}

void write_table(const fs::path& netcdf_file, const Table& t, const fs::path& own_folder) {
  fs::path csv = netcdf_file, timing = netcdf_file;
  csv.replace_extension(".csv");
  timing.replace_filename(timing.stem().string() + "_timing.csv");
  const auto here = [&own_folder](const fs::path& file) { return own_folder / file.filename(); };
  write_text(here(timing), timing_csv(t));
  write_text(here(csv), to_csv(t));
  write_netcdf(here(netcdf_file), t);
  for (const fs::path& file : {timing, csv, netcdf_file}) move(here(file), file);
}

}  // namespace tdbd::sweep
