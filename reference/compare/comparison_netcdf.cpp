#include <H5public.h>
#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <limits>

#include "core/error.hpp"
#include "core/whole_file.hpp"
#include "reference/compare/comparison_files.hpp"

namespace tdbd::reference {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// A file that is being written.
class NetcdfWriter {
 public:
  explicit NetcdfWriter(const std::filesystem::path& file) : file_(file) {
    H5dont_atexit();
    require(nc_create(partial_path(file).c_str(), NC_NETCDF4 | NC_CLOBBER, &id_));
  }
  ~NetcdfWriter() {
    if (id_ >= 0) nc_close(id_);
  }
  NetcdfWriter(const NetcdfWriter&) = delete;
  NetcdfWriter& operator=(const NetcdfWriter&) = delete;

  int dimension(const char* name, std::size_t length) {
    int dim = -1;
    require(nc_def_dim(id_, name, length, &dim));
    return dim;
  }

  void numbers(std::string_view name, std::string_view units, std::string_view long_name,
               const std::vector<int>& dims, const std::vector<double>& values) {
    int variable = -1;
    require(nc_def_var(id_, std::string(name).c_str(), NC_DOUBLE, static_cast<int>(dims.size()),
                       dims.data(), &variable));
    require(nc_put_att_double(id_, variable, "_FillValue", NC_DOUBLE, 1, &missing));
    require(nc_put_att_text(id_, variable, "units", units.size(), units.data()));
    require(nc_put_att_text(id_, variable, "long_name", long_name.size(), long_name.data()));
    require(nc_put_var_double(id_, variable, values.data()));
  }

  void names(const char* name, int dim, const std::vector<std::string>& values) {
    int variable = -1;
    require(nc_def_var(id_, name, NC_STRING, 1, &dim, &variable));
    std::vector<const char*> texts;
    for (const std::string& v : values) texts.push_back(v.c_str());
    require(nc_put_var_string(id_, variable, texts.data()));
  }

  void close() {
    require(nc_close(std::exchange(id_, -1)));
    rename_partial(file_);
  }

 private:
  void require(int status) const {
    if (status != NC_NOERR)
      throw RunError(fmt::format("cannot write {}: {}", file_.string(), nc_strerror(status)));
  }
  std::filesystem::path file_;
  int id_ = -1;
};

/// Rows of different lengths as a matrix; shorter rows are padded with NaN.
std::vector<double> padded(const std::vector<std::vector<double>>& rows, std::size_t length) {
  std::vector<double> all;
  for (const std::vector<double>& row : rows) {
    all.insert(all.end(), row.begin(), row.end());
    all.insert(all.end(), length - row.size(), missing);
  }
  return all;
}

std::size_t longest(const std::vector<std::vector<double>>& rows) {
  std::size_t length = 0;
  for (const std::vector<double>& row : rows) length = std::max(length, row.size());
  return length;
}

void write_quantities(NetcdfWriter& nc, int model, const Comparison& all) {
  for (std::size_t i = 0; i < quantity_count; ++i) {
    std::vector<double> values;
    for (const Answer& a : all.answers)
      values.push_back(a.findings.says[i].value.value_or(missing));
    const QuantityText& q = quantity_texts()[i];
    nc.numbers(q.name, q.unit, q.meaning, {model}, values);
  }
}

void write_series(NetcdfWriter& nc, int model, const Comparison& all) {
  std::vector<std::vector<double>> weight, torque;
  std::vector<double> step;
  for (const Answer& a : all.answers) {
    weight.push_back(a.findings.series.weight);
    torque.push_back(a.findings.series.torque);
    step.push_back(a.findings.series.step);
  }
  const std::size_t length = longest(weight);
  if (length == 0) return;
  const int sample = nc.dimension("sample", length);
  nc.numbers("series_step", "s", "time between samples; 0: a steady model", {model}, step);
  nc.numbers("series_weight", "N", "weight in the steps that count", {model, sample},
             padded(weight, length));
  nc.numbers("series_torque", "N m", "torque in the steps that count", {model, sample},
             padded(torque, length));
}

void write_bottoms(NetcdfWriter& nc, int model, const Comparison& all) {
  std::vector<std::vector<double>> depth;
  std::vector<double> radius, samples;
  for (const Answer& a : all.answers) {
    const std::optional<BottomCircle>& bottom = a.findings.bottom;
    depth.push_back(bottom ? bottom->depth : std::vector<double>());
    radius.push_back(bottom ? bottom->radius : missing);
    samples.push_back(static_cast<double>(depth.back().size()));
  }
  const std::size_t length = longest(depth);
  if (length == 0) return;
  const int sample = nc.dimension("circle_sample", length);
  nc.numbers("circle_radius", "m", "of the circle about the hole's axis", {model}, radius);
  nc.numbers("circle_samples", "1", "at equal angles from azimuth 0", {model}, samples);
  nc.numbers("bottom_depth", "m", "of the bottom on the circle, z down", {model, sample},
             padded(depth, length));
}

}  // namespace

void write_comparison_netcdf(const std::filesystem::path& file, const Comparison& all) {
  NetcdfWriter nc(file);
  const int model = nc.dimension("model", all.answers.size());
  std::vector<std::string> names;
  for (const Answer& a : all.answers) names.emplace_back(a.model->name);
  nc.names("model", model, names);
  write_quantities(nc, model, all);
  write_series(nc, model, all);
  write_bottoms(nc, model, all);
  nc.close();
}

}  // namespace tdbd::reference
