#include "calibration/fit/problem.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/types.hpp"
#include "simulation/case/force_settings.hpp"

namespace tdbd::calibration {
namespace {

/// Velocity of the tool: a bit rotates about z and moves along it; a cutter moves along x without
/// rotation.
simulation::BitVelocity velocity_of(const Record& record) {
  simulation::BitVelocity v;
  if (record.rate > 0.0) {
    v.v_W = record.rate * Vec3::UnitZ();
    v.w_W = record.speed * Vec3::UnitZ();
  } else {
    v.v_W = record.speed * Vec3::UnitX();
  }
  return v;
}

/// Adds the loads of a force on the tool: opposite to z, and opposite to the rotation about z.
void add(const forces::PartForce& f, Loads& loads) {
  loads[axial] -= f.force.z();
  loads[turning] -= f.point.x() * f.force.y() - f.point.y() * f.force.x();
}

bool follows(const forces::Law& law, const forces::PartCut& cut) {
  return simulation::follows_the_run(cut.kind) &&
         forces::law_problem(law, cut.kind, cut.diameter).empty();
}

const forces::Law& law_of(Laws laws, const Sample& sample, std::size_t cut) {
  return laws[sample.mix.empty() ? 0 : at(sample.mix[cut])];
}

}  // namespace

Sample sample_of(const CutRun& run, const Record& record, const forces::Strength& strength,
                 const forces::Law& law, std::span<const int> mix_of_part) {
  static const bit::Bit without_cones;
  constexpr double instant = 1.0;  // s; only PartCut::path depends on it
  const simulation::BitVelocity motion = velocity_of(record);
  Sample sample;
  for (const simulation::CutOfPart& mean : run.cuts) {
    forces::PartCut cut = simulation::cut_at(without_cones, Pose{}, motion, instant, mean);
    cut.strength = strength;
    if (follows(law, cut)) {
      sample.cuts.push_back(cut);
      if (!mix_of_part.empty()) sample.mix.push_back(mix_of_part[at(mean.part)]);
    } else
      add(forces::force(simulation::own_law_of(cut.kind), cut), sample.others);
  }
  return sample;
}

Loads mean_loads(Laws laws, const Sample& sample) {
  Loads loads = sample.others;
  for (std::size_t i = 0; i < sample.cuts.size(); ++i)
    add(forces::force(law_of(laws, sample, i), sample.cuts[i]), loads);
  return loads;
}

Loads loads_of(Laws laws, const Sample& sample, const Kinds& kinds) {
  Loads loads{};
  for (std::size_t i = 0; i < sample.cuts.size(); ++i)
    if (kinds[static_cast<std::size_t>(sample.cuts[i].kind)])
      add(forces::force(law_of(laws, sample, i), sample.cuts[i]), loads);
  return loads;
}

Loads depth_slopes(Laws laws, const Sample& sample) {
  constexpr double step = 1e-4;
  const auto scaled = [&](double factor) {
    Sample s = sample;
    for (forces::PartCut& cut : s.cuts) {
      cut.cut_area *= factor;
      cut.depth *= factor;
    }
    return mean_loads(laws, s);
  };
  const Loads more = scaled(1.0 + step), less = scaled(1.0 - step);
  Loads slopes{};
  for (const std::size_t k : {axial, turning})
    if (more[k] > 0.0 && less[k] > 0.0) slopes[k] = std::log(more[k] / less[k]) / (2.0 * step);
  return slopes;
}

namespace {

/// Names of the tests in order of their first occurrence.
std::vector<std::string> tests_of(const std::vector<Record>& records) {
  std::vector<std::string> tests;
  for (const Record& r : records)
    if (std::ranges::find(tests, r.test) == tests.end()) tests.push_back(r.test);
  return tests;
}

double own_deviation(const Noise& noise, const Reading& reading) {
  return reading.deviation ? *reading.deviation / *reading.value : noise.reading;
}

/// Covariance of the readings from row `first` on.
Eigen::MatrixXd covariance_of(const Problem& p, const Noise& noise, std::size_t first,
                              const std::vector<Loads>& slopes) {
  const auto n = static_cast<Eigen::Index>(p.places.size() - first);
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Constant(n, n, noise.test * noise.test);
  for (Eigen::Index i = 0; i < n; ++i) {
    const ReadingPlace& a = p.places[first + static_cast<std::size_t>(i)];
    const double own = own_deviation(noise, p.records[a.sample].readings[a.load]);
    covariance(i, i) += own * own;
    for (Eigen::Index j = 0; j < n; ++j) {
      const ReadingPlace& b = p.places[first + static_cast<std::size_t>(j)];
      if (a.sample == b.sample)
        covariance(i, j) +=
            noise.rop * noise.rop * slopes[a.sample][a.load] * slopes[b.sample][b.load];
    }
  }
  return covariance;
}

void add_test(const std::string& test, const Noise& noise, const std::vector<Loads>& slopes,
              Problem& p) {
  const std::size_t first = p.places.size();
  for (std::size_t i = 0; i < p.records.size(); ++i)
    for (const std::size_t load : {axial, turning})
      if (p.records[i].test == test && p.records[i].readings[load].value)
        p.places.push_back({i, load});
  if (p.places.size() == first) return;
  p.blocks.push_back(
      {static_cast<Eigen::Index>(first), covariance_of(p, noise, first, slopes).llt().matrixL()});
}

/// Two values of an unknown for a difference quotient: around its value, or inwards from it near an
/// end of its range.
std::pair<double, double> around(const Unknown& u, double value, Difference difference) {
  constexpr double relative = 1e-5;
  const double h = relative * std::max(std::abs(value), 1e-3 * std::abs(u.start));
  if (value + h > u.range.hi) return {value - h, value};
  if (value - h < u.range.lo || difference == Difference::one_sided) return {value, value + h};
  return {value - h, value + h};
}

/// Logarithms of the loads of the readings, in their order.
Eigen::VectorXd logarithms(const Problem& p, const std::vector<Loads>& loads) {
  constexpr double least = 1e-300;
  Eigen::VectorXd logs(static_cast<Eigen::Index>(p.readings()));
  for (std::size_t i = 0; i < p.readings(); ++i)
    logs[static_cast<Eigen::Index>(i)] =
        std::log(std::max(least, loads[p.places[i].sample][p.places[i].load]));
  return logs;
}

/// Whitens the rows of the readings and appends those of the priors.
Eigen::VectorXd all_rows(const Problem& p, const Eigen::VectorXd& errors,
                         const Eigen::VectorXd& from_centres) {
  const auto n = static_cast<Eigen::Index>(p.readings());
  Eigen::VectorXd rows(p.rows());
  rows.head(n) = errors;
  whiten(p, rows.head(n));
  Eigen::Index row = n;
  for (std::size_t k = 0; k < p.unknowns.size(); ++k)
    if (const auto& sd = p.unknowns[k].prior_sd)
      rows[row++] = from_centres[static_cast<Eigen::Index>(k)] / *sd;
  return rows;
}

/// The kinds of part that a coefficient of the law affects.
Kinds kinds_felt(forces::Law law, const std::string& key) {
  Kinds kinds{};
  for (const forces::LawField& f : forces::law_fields(law))
    for (std::size_t i = 0; i < kinds.size(); ++i)
      if (f.key == key) kinds[i] = forces::acts_on(f, static_cast<bit::PartKind>(i));
  return kinds;
}

}  // namespace

Eigen::Index Problem::rows() const {
  const auto priors =
      std::ranges::count_if(unknowns, [](const Unknown& u) { return u.prior_sd.has_value(); });
  return static_cast<Eigen::Index>(places.size()) + priors;
}

double reading_variance(const Noise& noise, const Reading& reading, double slope) {
  const double own = reading.value ? own_deviation(noise, reading) : noise.reading;
  return own * own + noise.test * noise.test + slope * slope * noise.rop * noise.rop;
}

Problem problem_of(const CalibrationCase& c, const CutStore& cuts,
                   const std::vector<Record>& records) {
  Problem p{c.law, c.unknowns, {}, records, {}, {}, c.areas};
  const std::vector<forces::Law> laws = laws_of_mixes(c.areas, c.law);
  std::vector<Loads> slopes;
  for (const Record& r : records) {
    p.samples.push_back(sample_of(c, cuts, r));
    slopes.push_back(depth_slopes(laws, p.samples.back()));
  }
  for (const std::string& test : tests_of(records)) add_test(test, c.noise, slopes, p);
  return p;
}

Data data_of(const Problem& p) {
  Data d{Eigen::VectorXd(static_cast<Eigen::Index>(p.readings())),
         Eigen::VectorXd(static_cast<Eigen::Index>(p.unknowns.size()))};
  for (std::size_t i = 0; i < p.readings(); ++i)
    d.log_loads[static_cast<Eigen::Index>(i)] =
        std::log(*p.records[p.places[i].sample].readings[p.places[i].load].value);
  for (std::size_t k = 0; k < p.unknowns.size(); ++k)
    d.prior_centres[static_cast<Eigen::Index>(k)] = p.unknowns[k].start;
  return d;
}

forces::Law law_at(const Problem& p, const Eigen::VectorXd& values) {
  forces::Law law = p.law;
  for (const forces::LawField& f : forces::law_fields(law))
    for (std::size_t k = 0; k < p.unknowns.size(); ++k)
      if (p.unknowns[k].area < 0 && law_key(p.unknowns[k]) == f.key)
        *f.value = values[static_cast<Eigen::Index>(k)];
  return law;
}

AreaLaws areas_at(const Problem& p, const Eigen::VectorXd& values) {
  AreaLaws areas = p.areas;
  forces::Law law = p.law;
  const std::vector<forces::LawField> fields = forces::law_fields(law);
  for (std::size_t u = 0; u < p.unknowns.size(); ++u)
    for (std::size_t k = 0; k < fields.size(); ++k)
      if (p.unknowns[u].area >= 0 && law_key(p.unknowns[u]) == fields[k].key)
        areas.areas[at(p.unknowns[u].area)].values[k] = values[static_cast<Eigen::Index>(u)];
  return areas;
}

std::vector<forces::Law> laws_at(const Problem& p, const Eigen::VectorXd& values) {
  const forces::Law whole = law_at(p, values);
  if (p.areas.areas.empty()) return {whole};
  return laws_of_mixes(areas_at(p, values), whole);
}

Sample sample_of(const CalibrationCase& c, const CutStore& cuts, const Record& record) {
  return sample_of(cut_run_of(cuts, record), record, strength_of(c.rock, record), c.law,
                   mix_of_parts(c.areas, record.tool));
}

Eigen::VectorXd log_loads(const Problem& p, Laws laws) {
  std::vector<Loads> loads;
  loads.reserve(p.samples.size());
  for (const Sample& s : p.samples) loads.push_back(mean_loads(laws, s));
  return logarithms(p, loads);
}

void whiten(const Problem& p, Eigen::Ref<Eigen::VectorXd> residuals) {
  for (const TestBlock& b : p.blocks)
    b.factor.triangularView<Eigen::Lower>().solveInPlace(
        residuals.segment(b.first, b.factor.rows()));
}

Eigen::VectorXd residuals_at(const Problem& p, const Data& data, const Eigen::VectorXd& values) {
  return all_rows(p, log_loads(p, laws_at(p, values)) - data.log_loads,
                  values - data.prior_centres);
}

SingleChange::SingleChange(const Problem& problem, const Eigen::VectorXd& values)
    : problem_(problem), values_(values) {
  for (const Unknown& u : problem.unknowns) kinds_.push_back(kinds_felt(problem.law, law_key(u)));
}

const std::vector<Loads>& SingleChange::rest_of(const Kinds& moved) {
  std::vector<Loads>& rest = rests_[moved];
  if (!rest.empty()) return rest;
  Kinds others{};
  for (std::size_t i = 0; i < others.size(); ++i) others[i] = !moved[i];
  const std::vector<forces::Law> laws = laws_at(problem_, values_);
  for (const Sample& s : problem_.samples) {
    rest.push_back(loads_of(laws, s, others));
    for (const std::size_t load : {axial, turning}) rest.back()[load] += s.others[load];
  }
  return rest;
}

Eigen::VectorXd SingleChange::residuals(Eigen::Index k, double value) {
  const Kinds& kinds = kinds_[static_cast<std::size_t>(k)];
  std::vector<Loads> loads = rest_of(kinds);
  Eigen::VectorXd values = values_;
  values[k] = value;
  const std::vector<forces::Law> laws = laws_at(problem_, values);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const Loads moved = loads_of(laws, problem_.samples[i], kinds);
    for (const std::size_t load : {axial, turning}) loads[i][load] += moved[load];
  }
  return all_rows(problem_, logarithms(problem_, loads), values);
}

Eigen::MatrixXd jacobian_at(const Problem& p, const Eigen::VectorXd& values,
                            Difference difference) {
  SingleChange moves(p, values);
  Eigen::VectorXd here;
  const auto rows_at = [&](Eigen::Index k, double value) {
    if (value != values[k]) return moves.residuals(k, value);
    if (here.size() == 0) here = moves.residuals(k, value);
    return here;
  };
  Eigen::MatrixXd J(p.rows(), values.size());
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    const auto [lo, hi] = around(p.unknowns[static_cast<std::size_t>(k)], values[k], difference);
    J.col(k) = (rows_at(k, hi) - rows_at(k, lo)) / (hi - lo);
  }
  return J;
}

}  // namespace tdbd::calibration
