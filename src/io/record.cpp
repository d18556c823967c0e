#include "io/record.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iterator>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "io/netcdf_file.hpp"
#include "io/whole_file.hpp"

namespace tdbd {
namespace {

std::filesystem::path csv_beside(std::filesystem::path path) {
  return path.replace_extension(".csv");
}

/// Returns the names of the columns with units, for the first row of the csv: "position_x [m]".
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

/// Writes the shortest digits that read back exactly.
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

/// Returns the name in the CF conventions.
const char* cell_method(Over over) {
  switch (over) {
    case Over::mean:
      return "time: mean";
    case Over::sum:
      return "time: sum";
    case Over::minimum:
      return "time: minimum";
    case Over::maximum:
      return "time: maximum";
    case Over::point:
      break;
  }
  return "";
}

/// Upper bound of the memory, in bytes, that NetCDF and HDF5 need at a time. They crash if an
/// allocation fails.
std::size_t memory_for(const RecordLayout& layout) {
  constexpr std::size_t own = 8'000'000, blocks = 4;
  return own + blocks * record_block * layout.row_width() * sizeof(double);
}

}  // namespace

/// The NetCDF part of a record: an open file and the block that is not yet written.
class RowsOfNetcdf {
 public:
  RowsOfNetcdf(const std::filesystem::path& file, const RecordLayout& layout)
      : file_(file, NetcdfFile::Use::create, memory_for(layout)) {
    const int time = file_.dimension("time", 0);
    std::vector<int> dims;  // an empty axis becomes unlimited, and stays empty
    for (const RecordAxis& axis : layout.axes)
      dims.push_back(file_.dimension(axis.name, axis.components.size()));
    for (const RecordColumn& c : layout.columns) {
      std::vector<int> of_column{time};
      if (c.axis >= 0) of_column.push_back(dims[static_cast<std::size_t>(c.axis)]);
      columns_.push_back({define(c, of_column, layout), layout.width(c), {}});
    }
    std::vector<int> labels;
    for (const RecordLabels& l : layout.labels)
      labels.push_back(file_.variable(
          {l.name, NetcdfType::text, {dims[static_cast<std::size_t>(l.axis)]}, "1", l.long_name}));
    file_.end_definitions();
    for (std::size_t i = 0; i < labels.size(); ++i) file_.put(labels[i], layout.labels[i].texts);
  }

  void append(std::span<const double> row) {
    for (Column& c : columns_) {
      const std::span<const double> own = row.first(c.width);
      c.waiting.insert(c.waiting.end(), own.begin(), own.end());
      row = row.subspan(c.width);
    }
    if (++waiting_ == record_block) write_block();
  }

  void close() {
    write_block();
    file_.close();
  }

 private:
  /// A variable and its values in the block.
  struct Column {
    int variable = -1;
    std::size_t width = 1;
    std::vector<double> waiting;
  };

  int define(const RecordColumn& c, const std::vector<int>& dims, const RecordLayout& layout) {
    const NetcdfType type =
        c.precision == Precision::single ? NetcdfType::single : NetcdfType::real;
    const int variable = file_.variable({c.name, type, dims, c.units, c.long_name});
    file_.set_chunks(variable,
                     {record_chunk, layout.width(c), layout.storage == Storage::deflated});
    if (const std::string method = cell_method(c.over); !method.empty())
      file_.attribute(variable, "cell_methods", method);
    return variable;
  }

  void write_block() {
    if (waiting_ == 0) return;
    for (Column& c : columns_) {
      file_.put_rows(c.variable, written_, waiting_, c.width, c.waiting);
      c.waiting.clear();
    }
    written_ += waiting_;
    waiting_ = 0;
  }

  NetcdfFile file_;
  std::vector<Column> columns_;
  std::size_t written_ = 0;  ///< rows in the file
  std::size_t waiting_ = 0;  ///< rows in the block, not yet written
};

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
  RowsOfNetcdf netcdf;
  std::optional<AtomicFile> csv;
};

Record::Record(const std::filesystem::path& path, const RecordLayout& layout, CsvBeside csv)
    : files_(new Files{path, layout, {partial_path(path), layout}, std::nullopt}) {
  if (csv == CsvBeside::no) return;
  files_->csv.emplace(csv_beside(path));
  files_->csv->stream() << csv_head(layout);
}

Record::~Record() = default;

void Record::append(std::span<const double> row) {
  if (row.size() != files_->layout.row_width())
    throw RunError(fmt::format("{}: a row of {} numbers in a record of {}", files_->path.string(),
                               row.size(), files_->layout.row_width()));
  files_->netcdf.append(row);
  if (files_->csv) files_->csv->stream() << csv_line(files_->layout, row);
}

void Record::close() {
  if (files_->csv) files_->csv->commit();  // first: the smaller file may fit on a full disk
  files_->netcdf.close();
  rename_partial(files_->path);
}

RowLog::RowLog(std::filesystem::path path, std::size_t width, long kept)
    : path_(std::move(path)), width_(width), rows_(kept) {
  file_.reset(std::fopen(path_.c_str(), kept > 0 ? "r+b" : "w+b"));
  require(file_ != nullptr);
  const auto end = static_cast<off_t>(static_cast<std::size_t>(kept) * width * sizeof(double));
  require(fseeko(file_.get(), 0, SEEK_END) == 0);
  if (ftello(file_.get()) < end)
    throw RunError(fmt::format("{}: holds fewer than {} rows", path_.string(), kept));
  require(ftruncate(fileno(file_.get()), end) == 0);
  require(fseeko(file_.get(), end, SEEK_SET) == 0);
}

void RowLog::replay(const std::function<void(std::span<const double>)>& visit) {
  std::vector<double> row(width_);
  require(fseeko(file_.get(), 0, SEEK_SET) == 0);
  for (long i = 0; i < rows_; ++i) {
    require(std::fread(row.data(), sizeof(double), width_, file_.get()) == width_);
    visit(row);
  }
  require(fseeko(file_.get(), 0, SEEK_CUR) == 0);  // C requires it between reading and writing
}

void RowLog::append(std::span<const double> row) {
  require(std::fwrite(row.data(), sizeof(double), row.size(), file_.get()) == row.size());
  ++rows_;
}

void RowLog::sync() {
  require(std::fflush(file_.get()) == 0);
  require(fsync(fileno(file_.get())) == 0);
}

void RowLog::require(bool is_done) const {
  if (is_done) return;
  throw RunError(fmt::format("cannot write {}: {}", path_.string(), std::strerror(errno)));
}

}  // namespace tdbd
