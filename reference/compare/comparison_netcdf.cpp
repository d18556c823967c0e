#include <algorithm>
#include <limits>

#include "io/netcdf_file.hpp"
#include "io/whole_file.hpp"
#include "reference/compare/comparison_files.hpp"

namespace tdbd::reference {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// A file of numbers without a value here and there.
class NetcdfWriter {
 public:
  explicit NetcdfWriter(const std::filesystem::path& file)
      : path_(file), file_(partial_path(file), NetcdfFile::Use::create) {}

  int dimension(const char* name, std::size_t length) { return file_.dimension(name, length); }

  void numbers(std::string_view name, std::string_view units, std::string_view long_name,
               const std::vector<int>& dims, const std::vector<double>& values) {
    const int variable = file_.variable(
        {std::string(name), NetcdfType::real, dims, std::string(units), std::string(long_name)});
    file_.attribute(variable, "_FillValue", missing);
    file_.put(variable, values);
  }

  void names(const char* name, int dim, const std::vector<std::string>& values) {
    file_.put(file_.variable({name, NetcdfType::text, {dim}, "", ""}), values);
  }

  void close() {
    file_.close();
    rename_partial(path_);
  }

 private:
  std::filesystem::path path_;
  NetcdfFile file_;
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
