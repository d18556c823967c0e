#include "simulation/case/path_table.hpp"

#include <fmt/format.h>

#include <array>

#include "core/config/csv.hpp"
#include "core/error.hpp"

namespace tdbd::simulation {
namespace {

using Columns = std::array<std::size_t, 7>;

Columns find_columns(const CsvTable& t) {
  Columns c{};
  const std::array<const char*, 7> names{"time_s", "x_m",    "y_m",   "z_m",
                                         "rx_rad", "ry_rad", "rz_rad"};
  for (std::size_t i = 0; i < names.size(); ++i) c[i] = csv_column(t, names[i]);
  return c;
}

void require_rising_times(const CsvTable& t, const std::vector<PathPoint>& path) {
  if (path.size() < 2)
    throw InputError(fmt::format("{}: found {} rows, expected at least two", t.file, path.size()));
  for (std::size_t i = 1; i < path.size(); ++i)
    if (!(path[i].time > path[i - 1].time))
      throw InputError(fmt::format("{}:{}: time_s: found {} after {}, expected rising times",
                                   t.file, t.lines[i], path[i].time, path[i - 1].time));
}

}  // namespace

std::vector<PathPoint> read_path_table(const std::string& file) {
  const CsvTable t = read_csv(file);
  const Columns c = find_columns(t);
  std::vector<PathPoint> path;
  path.reserve(t.rows.size());
  for (std::size_t i = 0; i < t.rows.size(); ++i) {
    const std::vector<double>& row = t.rows[i];
    path.push_back({row[c[0]], Vec3(row[c[1]], row[c[2]], row[c[3]]),
                    Vec3(row[c[4]], row[c[5]], row[c[6]]), 0.0, t.lines[i]});
  }
  require_rising_times(t, path);
  sum_turns(path);
  return path;
}

}  // namespace tdbd::simulation
