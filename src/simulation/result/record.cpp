#include "simulation/result/record.hpp"

#include <fmt/format.h>

#include <iterator>

#include "core/error.hpp"
#include "core/whole_file.hpp"
#include "simulation/result/record_netcdf.hpp"

namespace tdbd::simulation {
namespace {

std::filesystem::path csv_beside(std::filesystem::path path) {
  return path.replace_extension(".csv");
}

/// Column names with units, as a spreadsheet's first row: "position_x [m]".
std::string csv_head(const RecordLayout& layout) {
  std::string line;
  const auto add = [&](const RecordColumn& c, const std::string& suffix) {
    line += fmt::format("{}{}{} [{}]", line.empty() ? "" : ",", c.name, suffix, c.units);
  };
  for (const RecordColumn& c : layout.columns) {
    if (c.csv == InCsv::no) continue;
    if (c.axis < 0) add(c, "");
    if (c.axis >= 0)
      for (const std::string& component : layout.axes[static_cast<std::size_t>(c.axis)].components)
        add(c, "_" + component);
  }
  return line + "\n";
}

/// The shortest digits that read back to the bit.
std::string csv_line(const RecordLayout& layout, std::span<const double> row) {
  std::string line;
  for (const RecordColumn& c : layout.columns) {
    const std::size_t width = layout.width(c);
    for (std::size_t i = 0; c.csv == InCsv::yes && i < width; ++i)
      fmt::format_to(std::back_inserter(line), "{}{}", line.empty() ? "" : ",", row[i]);
    row = row.subspan(width);
  }
  return line + "\n";
}

}  // namespace

std::size_t RecordLayout::width(const RecordColumn& c) const {
  return c.axis < 0 ? 1 : axes[static_cast<std::size_t>(c.axis)].components.size();
}

std::size_t RecordLayout::row_width() const {
  std::size_t sum = 0;
  for (const RecordColumn& c : columns) sum += width(c);
  return sum;
}

struct Record::Files {
  std::filesystem::path path;
  RecordLayout layout;
  RecordNetcdf netcdf;
  WholeFile csv;
};

Record::Record(const std::filesystem::path& path, const RecordLayout& layout)
    : files_(new Files{path, layout, {partial_path(path), layout}, WholeFile(csv_beside(path))}) {
  files_->csv.stream() << csv_head(layout);
}

Record::~Record() = default;

void Record::append(std::span<const double> row) {
  if (row.size() != files_->layout.row_width())
    throw RunError(fmt::format("{}: a row of {} numbers in a record of {}", files_->path.string(),
                               row.size(), files_->layout.row_width()));
  files_->netcdf.append(row);
  files_->csv.stream() << csv_line(files_->layout, row);
}

void Record::close() {
  files_->csv.commit();  // first: the smaller one still fits where the other fills the disk
  files_->netcdf.close();
  rename_partial(files_->path);
}

}  // namespace tdbd::simulation
