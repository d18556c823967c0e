#include "calibration/twin_readings.hpp"

#include <cmath>

namespace tdbd::calibration {
namespace {

double& of(reference::Coefficients& c, const std::string& key) {
  if (key == "A1") return c.A1;
  if (key == "A2") return c.A2;
  if (key == "A3") return c.A3;
  if (key == "A4") return c.A4;
  if (key == "A5") return c.A5;
  if (key == "A6") return c.A6;
  if (key == "te") return c.te;
  return c.pressure_share;
}

Eigen::VectorXd logs(const Problem& p, const reference::Coefficients& c) {
  Eigen::VectorXd all(static_cast<Eigen::Index>(p.readings()));
  for (std::size_t i = 0; i < p.readings(); ++i)
    all[static_cast<Eigen::Index>(i)] = std::log(reference::loads(
        p.samples[p.places[i].sample].cuts, c)[static_cast<Eigen::Index>(p.places[i].load)]);
  return all;
}

}  // namespace

reference::Coefficients twin_coefficients(const forces::Law& law) {
  const auto& l = std::get<forces::HansonHansen>(law);
  return {l.A1, l.A2, l.A3, l.A4, l.te, l.A5, l.A6, l.pressure_share};
}

reference::Readings twin_readings(const Problem& p, const Noise& noise) {
  reference::Readings r;
  for (const Sample& s : p.samples) r.records.push_back(s.cuts);
  const reference::Coefficients start = twin_coefficients(p.law);
  std::vector<reference::ReadingError> errors;
  r.log_loads.resize(static_cast<Eigen::Index>(p.readings()));
  for (std::size_t i = 0; i < p.readings(); ++i) {
    const auto [sample, load] = p.places[i];
    const Reading& reading = p.records[sample].readings[load];
    r.places.emplace_back(sample, static_cast<int>(load));
    r.log_loads[static_cast<Eigen::Index>(i)] = std::log(*reading.value);
    errors.push_back(
        {p.records[sample].test, static_cast<long>(sample),
         reading.deviation ? *reading.deviation / *reading.value : noise.reading,
         reference::depth_slopes(p.samples[sample].cuts, start)[static_cast<Eigen::Index>(load)]});
  }
  r.covariance = reference::covariance_of_readings(errors, {noise.test, noise.rop});
  return r;
}

Eigen::MatrixXd twin_derivatives(const Problem& p, const forces::Law& law) {
  Eigen::MatrixXd J(static_cast<Eigen::Index>(p.readings()),
                    static_cast<Eigen::Index>(p.unknowns.size()));
  for (std::size_t k = 0; k < p.unknowns.size(); ++k) {
    reference::Coefficients more = twin_coefficients(law), less = more;
    const double h = 1e-5 * of(more, p.unknowns[k].key);
    of(more, p.unknowns[k].key) += h;
    of(less, p.unknowns[k].key) -= h;
    J.col(static_cast<Eigen::Index>(k)) = (logs(p, more) - logs(p, less)) / (2.0 * h);
  }
  return J;
}

}  // namespace tdbd::calibration
