#include "calibration/made_up_laboratory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/random.hpp"
#include "core/types.hpp"

namespace tdbd::calibration {
namespace {

constexpr double psi = 6894.757293168361, metres_an_hour = 1.0 / 3600.0;

/// After Marsaglia: a point of the unit disk.
double normal_number(Random& random) {
  for (;;) {
    const double x = random.uniform(-1.0, 1.0), y = random.uniform(-1.0, 1.0), s = x * x + y * y;
    if (s > 0.0 && s < 1.0) return x * std::sqrt(-2.0 * std::log(s) / s);
  }
}

/// The face of cutter i: a spiral over a profile that falls off towards the gage.
simulation::CutOfPart face_of(const MadeUpBit& bit, int i, double depth) {
  constexpr double gage = 0.105, golden_turn = 2.4;
  const double share = (i + 0.6) / bit.cutters, turn = golden_turn * i;
  const double steepness = 70 * degree * share * share;
  const Vec3 outward(std::cos(turn), std::sin(turn), 0.0),
      along(-std::sin(turn), std::cos(turn), 0);
  const double rake = bit.least_rake + share * (bit.most_rake - bit.least_rake);
  simulation::CutOfPart face;
  face.part = 2 * i;
  face.cut.kind = bit::PartKind::face;
  face.cut.diameter = bit.diameter;
  face.cut.normal = std::sin(steepness) * outward + std::cos(steepness) * Vec3::UnitZ();
  face.cut.point = gage * share * outward;
  face.cut.engaged_edge = 0.3 * bit.diameter + 2.0 * std::sqrt(bit.diameter * depth);
  face.face_area = depth * gage / bit.cutters / std::cos(rake);
  face.forward_W = std::cos(rake) * along - std::sin(rake) * face.cut.normal;
  return face;
}

std::vector<Unknown> seven_unknowns() {
  const Range positive = Range::non_negative();
  return {
      {"A1", 1.0, {}, positive, "case.toml:1: unknowns.A1"},
      {"A2", 1.0, {}, positive, "case.toml:2: unknowns.A2"},
      {"A3", 18 * degree, {}, Range::within(0.0, 45 * degree), "case.toml:3: unknowns.A3"},
      {"A4", 1.0, {}, positive, "case.toml:4: unknowns.A4"},
      {"A5", 1.0, {}, positive, "case.toml:5: unknowns.A5"},
      {"A6", 0.5, {}, positive, "case.toml:6: unknowns.A6"},
      {"pressure_share", 1.0, {}, Range::within(0.0, 2.0), "case.toml:7: unknowns.pressure_share"}};
}

void add_tests(const std::string& bit, CalibrationCase& c) {
  for (const double pressure : {3000 * psi, 6000 * psi})
    for (const double rate : {5.0, 10.0, 15.0, 20.0}) {
      Record r;
      r.test = fmt::format("{}-{:.0f}", bit, pressure / psi);
      r.tool = bit;
      r.pressure = pressure;
      r.speed = 4 * pi;
      r.rate = rate * metres_an_hour;
      r.depth = r.rate * 2 * pi / r.speed;
      c.records.rows.push_back(r);
    }
}

}  // namespace

const std::vector<MadeUpBit>& made_up_bits() {
  static const std::vector<MadeUpBit> bits{{"A", 6, 16e-3, 10 * degree, 20 * degree, 0.4e-3},
                                           {"B", 5, 19e-3, 5 * degree, 15 * degree, 0.25e-3},
                                           {"C", 7, 13e-3, 15 * degree, 30 * degree, 0.5e-3}};
  return bits;
}

CutRun made_up_run(const MadeUpBit& bit, double depth) {
  CutRun run{depth, {}};
  for (int i = 0; i < bit.cutters; ++i) {
    const simulation::CutOfPart face = face_of(bit, i, depth);
    simulation::CutOfPart chamfer = face;
    chamfer.part = 2 * i + 1;
    chamfer.cut.kind = bit::PartKind::chamfer;
    chamfer.cut.contact_area = bit.chamfer * face.cut.engaged_edge;
    chamfer.face_area = 0.0;
    chamfer.forward_W.setZero();
    run.cuts.push_back(face);
    run.cuts.push_back(chamfer);
  }
  return run;
}

forces::HansonHansen hidden_law() {
  forces::HansonHansen law;
  law.A1 = 1.3;
  law.A2 = 0.5;
  law.A3 = 22 * degree;
  law.A4 = 0.8;
  law.A5 = 1.4;
  law.A6 = 0.4;
  law.pressure_share = 0.85;
  return law;
}

CalibrationCase made_up_case() {
  CalibrationCase c;
  c.path = "case.toml";
  c.unknowns = seven_unknowns();
  forces::HansonHansen start = hidden_law();
  c.law = start;
  for (const forces::LawField& f : forces::law_fields(c.law))
    if (const Unknown* u = unknown(c, std::string(f.key))) *f.value = u->start;
  c.fit = {"B", "C"};
  c.predict = {"A"};
  for (const MadeUpBit& bit : made_up_bits()) {
    c.tools.push_back({bit.name, ToolKind::bit, "", {}});
    add_tests(bit.name, c);
  }
  c.rock.materials[""] = {"made-up", 60e6, 30 * degree};
  c.noise.reading = 0.03;
  return c;
}

CalibrationCase well_conditioned_case() {
  CalibrationCase c = made_up_case();
  std::erase_if(c.unknowns, [](const Unknown& u) { return u.key == "A2" || u.key == "A4"; });
  auto& law = std::get<forces::HansonHansen>(c.law);
  law.A2 = hidden_law().A2;
  law.A4 = hidden_law().A4;
  return c;
}

Unknown* unknown(CalibrationCase& c, const std::string& key) {
  const auto at = std::ranges::find(c.unknowns, key, &Unknown::key);
  return at == c.unknowns.end() ? nullptr : &*at;
}

CutStore made_up_cuts(const CalibrationCase& c) {
  CutStore store;
  for (const Record& r : c.records.rows)
    store.runs[{r.tool, depth_of_run(r)}] =
        made_up_run(*std::ranges::find(made_up_bits(), r.tool, &MadeUpBit::name), depth_of_run(r));
  return store;
}

void read_loads(CalibrationCase& c, const CutStore& cuts, const forces::Law& law,
                const LaboratoryNoise& noise, std::uint64_t seed) {
  Random random{seed};
  std::map<std::string, double> factor;
  for (Record& r : c.records.rows) {
    if (!factor.contains(r.test)) factor[r.test] = noise.test * normal_number(random);
    const Sample s = sample_of(cut_run_of(cuts, r), r, strength_of(c.rock, r), law);
    const Loads loads = mean_loads(law, s);
    for (const std::size_t k : {axial, turning})
      r.readings[k].value =
          loads[k] * std::exp(factor[r.test] + noise.reading * normal_number(random));
  }
}

forces::Law drawn_from_priors(const CalibrationCase& c, Random& random) {
  forces::Law law = c.law;
  for (const forces::LawField& f : forces::law_fields(law))
    for (const Unknown& u : c.unknowns) {
      if (u.key != f.key) continue;
      do {
        *f.value = u.start + *u.prior_sd * normal_number(random);
      } while (!u.range.contains(*f.value));
    }
  return law;
}

Problem fitted_problem(const CalibrationCase& c, const CutStore& cuts) {
  return problem_of(c, cuts, records_of(c, c.fit));
}

Eigen::VectorXd truth_of(const Problem& p, forces::Law law) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(p.unknowns.size()));
  for (const forces::LawField& f : forces::law_fields(law))
    for (std::size_t k = 0; k < p.unknowns.size(); ++k)
      if (p.unknowns[k].key == f.key) values[static_cast<Eigen::Index>(k)] = *f.value;
  return values;
}

double relative_difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (a.cwiseQuotient(b).array() - 1.0).abs().maxCoeff();
}

}  // namespace tdbd::calibration
