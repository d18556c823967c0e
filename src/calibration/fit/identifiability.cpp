#include "calibration/fit/identifiability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.hpp"

namespace tdbd::calibration {
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
  return fmt::format("{}: this changes the readings by {:.2g} times their noise",
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

}  // namespace tdbd::calibration
