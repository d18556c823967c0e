#include "calibration/fit/quality.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.hpp"

namespace tdbd::calibration {
namespace {

double prior_rows(const Fit& f) {
  double sum = 0.0;
  for (std::size_t k = 0; k < f.problem.unknowns.size(); ++k) {
    const Unknown& u = f.problem.unknowns[k];
    if (u.prior_sd)
      sum += std::pow((f.values[static_cast<Eigen::Index>(k)] - u.start) / *u.prior_sd, 2);
  }
  return sum;
}

/// Residuals of one test given the others of the test: (C^-1 r)_i / sqrt((C^-1)_ii), from the
/// factor L of C.
Eigen::VectorXd conditional(const TestBlock& block, const Eigen::VectorXd& errors) {
  const Eigen::Index n = block.factor.rows();
  const Eigen::MatrixXd inverse =
      block.factor.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd::Identity(n, n));
  const Eigen::VectorXd weighted = inverse.transpose() * (inverse * errors.segment(block.first, n));
  return weighted.cwiseQuotient(inverse.colwise().norm().transpose());
}

std::vector<FittedReading> readings_of(const Fit& f) {
  std::vector<FittedReading> readings(f.problem.readings());
  const Eigen::VectorXd scaled = f.errors.cwiseQuotient(deviations(f.problem));
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const ReadingPlace& place = f.problem.places[i];
    readings[i] = {place.sample, place.load, std::exp(f.errors[row]), scaled[row], 0.0};
  }
  for (const TestBlock& block : f.problem.blocks) {
    const Eigen::VectorXd of_block = conditional(block, f.errors);
    for (Eigen::Index i = 0; i < of_block.size(); ++i)
      readings[static_cast<std::size_t>(block.first + i)].deviations_in_test = of_block[i];
  }
  return readings;
}

double largest(const FittedReading& r) {
  return std::max(std::abs(r.deviations), std::abs(r.deviations_in_test));
}

}  // namespace

FitQuality quality_of(const Fit& f, std::size_t fits) {
  FitQuality q;
  q.statistic = f.chi2 + prior_rows(f);
  q.degrees_of_freedom =
      f.degrees_of_freedom + std::ranges::count_if(f.coefficients, &FittedCoefficient::at_bound);
  q.threshold = false_alarm / static_cast<double>(std::max<std::size_t>(1, fits));
  if (q.degrees_of_freedom > 0)
    q.p_value = gsl_cdf_chisq_Q(q.statistic, static_cast<double>(q.degrees_of_freedom));
  q.readings = readings_of(f);
  return q;
}

std::vector<FittedReading> worst_readings(const FitQuality& q, double limit, std::size_t most) {
  std::vector<FittedReading> worst;
  std::ranges::copy_if(q.readings, std::back_inserter(worst),
                       [&](const FittedReading& r) { return largest(r) > limit; });
  std::ranges::stable_sort(worst, std::greater{}, largest);
  if (worst.size() > most) worst.resize(most);
  return worst;
}

long readings_within(const FitQuality& q, double limit) {
  return std::ranges::count_if(
      q.readings, [&](const FittedReading& r) { return std::abs(r.deviations) <= limit; });
}

namespace {

Eigen::VectorXd starts(const Problem& p) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(p.unknowns.size()));
  for (std::size_t k = 0; k < p.unknowns.size(); ++k)
    values[static_cast<Eigen::Index>(k)] = p.unknowns[k].start;
  return values;
}

/// Scales the columns to relative changes of the unknowns.
Eigen::MatrixXd relative(const Problem& p, Eigen::MatrixXd J, const Eigen::VectorXd& values) {
  for (Eigen::Index k = 0; k < J.cols(); ++k) {
    const double start = p.unknowns[static_cast<std::size_t>(k)].start;
    J.col(k) *= std::max(std::abs(values[k]), 1e-3 * std::abs(start));
  }
  return J;
}

Eigen::JacobiSVD<Eigen::MatrixXd> decomposed(const Eigen::MatrixXd& J) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(J, Eigen::ComputeFullU | Eigen::ComputeFullV);
}

/// Describes a direction with its largest component as "+100 %". Components below 3 % of it are
/// omitted.
std::string direction_in_words(const Problem& p, const Eigen::VectorXd& v) {
  constexpr double negligible = 0.03;
  Eigen::Index top = 0;
  v.cwiseAbs().maxCoeff(&top);
  std::string text = fmt::format("{} +100 %", p.unknowns[static_cast<std::size_t>(top)].key);
  for (Eigen::Index k = 0; k < v.size(); ++k) {
    const double share = v[k] / v[top];
    if (k == top || std::abs(share) < negligible) continue;
    text +=
        fmt::format(", {} {:+.0f} %", p.unknowns[static_cast<std::size_t>(k)].key, 100.0 * share);
  }
  return text;
}

std::string help(const Problem& p) {
  std::set<double> pressures;
  bool turning_read = false;
  for (const Record& r : p.records) {
    pressures.insert(r.pressure);
    turning_read |= r.readings[turning].value.has_value();
  }
  std::string text;
  if (!turning_read) text += "a torque (or drag) reading, ";
  if (pressures.size() < 2) text += "a test at another pressure, ";
  return text + "a prior_sd for one of them, or one of them in [fixed]";
}

/// The kinds of part that a coefficient affects: "cse", "chamfer or cse".
std::string kinds_of(forces::Law law, const std::string& key) {
  std::string kinds;
  for (const forces::LawField& f : forces::law_fields(law))
    for (const bit::PartKind kind : bit::part_kinds)
      if (f.key == key && forces::acts_on(f, kind))
        kinds += (kinds.empty() ? "" : " or ") + std::string(bit::kind_words(kind));
  return kinds;
}

void reject_ineffective_unknowns(const Problem& p, const Eigen::MatrixXd& J) {
  std::string lines;
  for (std::size_t k = 0; k < p.unknowns.size(); ++k) {
    const auto column =
        J.col(static_cast<Eigen::Index>(k)).head(static_cast<Eigen::Index>(p.readings()));
    if (column.norm() > 0.0) continue;
    lines += fmt::format(
        "{}{}: found a coefficient that acts on no part of the fitted bits (it "
        "acts on {}), expected it in [fixed]",
        lines.empty() ? "" : "\n", p.unknowns[k].place, kinds_of(p.law, law_key(p.unknowns[k])));
  }
  if (!lines.empty()) throw InputError(lines);
}

}  // namespace

Identifiability identifiability_at(const Problem& p, const Eigen::VectorXd& values) {
  if (p.unknowns.empty()) return {};
  const Eigen::MatrixXd J =
      relative(p, jacobian_at(p, values), values).topRows(static_cast<Eigen::Index>(p.readings()));
  const auto svd = decomposed(J);
  Identifiability found;
  const Eigen::VectorXd& s = svd.singularValues();
  found.singular_values.assign(static_cast<std::size_t>(values.size()), 0.0);
  std::copy(s.data(), s.data() + s.size(), found.singular_values.begin());
  Eigen::VectorXd weakest = svd.matrixV().col(values.size() - 1);
  Eigen::Index top = 0;
  weakest.cwiseAbs().maxCoeff(&top);
  if (weakest[top] < 0.0) weakest = -weakest;
  found.weakest_direction.assign(weakest.data(), weakest.data() + weakest.size());
  return found;
}

std::string in_words(const Problem& p, const Identifiability& found) {
  if (p.unknowns.empty()) return "nothing was fitted";
  const auto n = static_cast<Eigen::Index>(found.weakest_direction.size());
  const Eigen::VectorXd v = Eigen::Map<const Eigen::VectorXd>(found.weakest_direction.data(), n);
  return fmt::format("{}: this changes all readings together by {:.2g} times their noise",
                     direction_in_words(p, v),
                     found.singular_values.back() / v.cwiseAbs().maxCoeff());
}

void require_identifiable(const Problem& p) {
  if (p.unknowns.empty()) return;
  const Eigen::VectorXd values = starts(p);
  const Eigen::MatrixXd J = relative(p, jacobian_at(p, values), values);
  reject_ineffective_unknowns(p, J);
  const auto svd = decomposed(J);
  const Eigen::VectorXd& s = svd.singularValues();
  if (s.size() == values.size() && s[s.size() - 1] > unseen * s[0]) return;
  const Eigen::VectorXd weakest = svd.matrixV().col(values.size() - 1);
  Eigen::Index top = 0;
  weakest.cwiseAbs().maxCoeff(&top);
  throw InputError(fmt::format(
      "{}: found a direction that the records do not determine: {}; expected {}",
      p.unknowns[static_cast<std::size_t>(top)].place, direction_in_words(p, weakest), help(p)));
}

namespace {

/// The standardised errors of the readings with the deviations of `original`.
Eigen::VectorXd standardised(const Problem& original, const Eigen::VectorXd& errors) {
  return errors.cwiseQuotient(deviations(original));
}

/// The records with larger deviations of the readings that are far from the law.
std::vector<Record> reweighted(const CalibrationCase& c, const Problem& original,
                               const Eigen::VectorXd& errors) {
  std::vector<Record> records = original.records;
  const Eigen::VectorXd distance = standardised(original, errors).cwiseAbs();
  const Eigen::VectorXd whole = deviations(original);
  for (std::size_t i = 0; i < original.readings(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (distance[row] <= huber_limit) continue;
    Reading& reading = records[original.places[i].sample].readings[original.places[i].load];
    const double own = reading.deviation ? *reading.deviation / *reading.value : c.noise.reading;
    // The part that the reading shares with others is unchanged, so its own one contains the rest.
    const double more = whole[row] * whole[row] * (distance[row] / huber_limit - 1.0);
    reading.deviation = std::sqrt(own * own + more) * *reading.value;
  }
  return records;
}

/// Replaces the deviations of a fit by those of the original problem.
Fit with_original_deviations(Fit f, const Problem& original) {
  f.problem = original;
  const Eigen::VectorXd scaled = standardised(original, f.errors);
  f.objectives = {};
  for (std::size_t i = 0; i < original.readings(); ++i)
    f.objectives[original.places[i].load] += std::pow(scaled[static_cast<Eigen::Index>(i)], 2);
  Eigen::VectorXd whitened = f.errors;
  whiten(original, whitened);
  f.chi2 = whitened.squaredNorm();
  return f;
}

}  // namespace

Fit fit_with_loss(const CalibrationCase& c, const CutStore& cuts, const Problem& problem) {
  Fit f = fit(problem, c.intervals);
  if (c.loss == Loss::squares || c.unknowns.empty()) return f;
  for (int k = 0; k < most_reweightings; ++k) {
    const Eigen::VectorXd before = f.values;
    f = fit(problem_of(c, cuts, reweighted(c, problem, f.errors)), c.intervals);
    const Eigen::ArrayXd change = (f.values - before).array().abs();
    const Eigen::ArrayXd errors = f.covariance.diagonal().array().sqrt();
    if ((change <= settled_weights * errors).all())
      return with_original_deviations(std::move(f), problem);
  }
  throw RunError(
      fmt::format("the weights of the robust fit do not settle in {} fits: use "
                  "calibration.loss = \"squares\", or leave out the wrong rows",
                  most_reweightings));
}

}  // namespace tdbd::calibration
