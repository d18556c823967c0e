#include "simulation/history.hpp"

#include <fmt/format.h>

#include <iterator>

#include "mesh/files_whole.hpp"
#include "simulation/history_columns.hpp"
#include "simulation/history_netcdf.hpp"

namespace tdbd::simulation {
namespace {

std::filesystem::path csv_beside(std::filesystem::path path) {
  return path.replace_extension(".csv");
}

/// Column names with units, as a spreadsheet's first row: "position_x [m]".
std::string csv_head() {
  std::string line;
  for (const HistoryColumn& c : history_columns)
    line += fmt::format("{}{} [{}]", line.empty() ? "" : ",", c.name, c.units);
  return line + "\n";
}

/// The shortest digits that read back to the bit.
std::string csv_line(const HistoryRow& row) {
  std::string line;
  for (const HistoryColumn& c : history_columns)
    fmt::format_to(std::back_inserter(line), "{}{}", line.empty() ? "" : ",", c.value(row));
  return line + "\n";
}

}  // namespace

struct History::Files {
  std::filesystem::path path;
  HistoryNetcdf netcdf;
  mesh::WholeFile csv;
};

History::History(const std::filesystem::path& path, const std::vector<HistoryPart>& parts)
    : files_(
          new Files{path, {mesh::partial_path(path), parts}, mesh::WholeFile(csv_beside(path))}) {
  files_->csv.stream() << csv_head();
}

History::~History() = default;

void History::append(const HistoryRow& row) {
  files_->netcdf.append(row);
  files_->csv.stream() << csv_line(row);
}

void History::close() {
  files_->csv.commit();  // first: the smaller one still fits where the other fills the disk
  files_->netcdf.close();
  mesh::rename_partial(files_->path);
}

}  // namespace tdbd::simulation
