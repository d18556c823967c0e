#include <cmath>

#include "claims/example_bits.hpp"
#include "claims/rock_runs.hpp"
#include "core/tolerance.hpp"
#include "simulation/result/figures.hpp"

/// Claims of chapter 2's equations on a bit that drills by itself.
namespace tdbd::claims::drilling_test {

/// Where bit B is after 48 ms, and how it moves, with steps of this length.
struct End {
  Vec3 c_W, momentum_W;
  double turned, spin_momentum, residual;
};

enum class BodiesBear { yes, no };

End end_of(double step, BodiesBear bodies) {
  std::vector<std::string> overrides = {"rock.edge_length='2 mm'", "time.duration='48 ms'",
                                        fmt::format("time.step={}", step), "maintenance.every=0"};
  if (bodies == BodiesBear::no) overrides.emplace_back("forces.cutter_body.law='none'");
  const simulation::Case c = rock_case("drill-bit-b", overrides);
  const simulation::Simulation s = drilled(c);
  const dynamics::DrillingSystem& system = c.drilling.system;
  const dynamics::StoredEnergy stored =
      dynamics::stored_energy(system, s.work.drive.at, s.state.drive->state);
  return {s.state.drive->state.c_W, s.state.drive->state.momentum_W, s.state.place.turned,
          s.state.drive->state.rotation.momentum_W.z(),
          std::abs(dynamics::residual(stored, s.state.drive->ledger))};
}

const std::vector<double>& steps() {
  static const std::vector<double> all = {2e-3, 1e-3, 0.5e-3, 0.25e-3, 0.125e-3, 0.0625e-3};  // s
  return all;
}

const std::vector<End>& ends() {
  static const std::vector<End> all = [] {
    std::vector<End> e;
    for (const double step : steps()) e.push_back(end_of(step, BodiesBear::no));
    return e;
  }();
  return all;
}

/// Least-squares slope of log y over log x.
double slope(const std::vector<double>& x, const std::vector<double>& y) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  const auto n = static_cast<double>(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double a = std::log(x[i]), b = std::log(y[i]);
    sx += a;
    sy += b;
    sxx += a * a;
    sxy += a * b;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// Observed order of f at the end, from its changes as the step is halved.
template <class F>
double order_of(const F& change) {
  std::vector<double> differences;
  for (std::size_t i = 1; i < ends().size(); ++i)
    differences.push_back(change(ends()[i - 1], ends()[i]));
  return slope(steps(), differences);
}

/// The whole step with its cut is of first order: rock is cut once a step, and its vertices come
/// into reach one by one, so that forces jump. The smooth step is of second order. Cutter bodies bear
/// nothing here: at this edge length one vertex after the other touches the innermost one, so its
/// force jumps, and no order is to be seen (the next test).
TEST(Drilling, converges_with_first_order_where_rock_is_cut) {
  const struct {
    const char* name;
    double order;
  } variables[] = {
      {"place", order_of([](const End& a, const End& b) { return (a.c_W - b.c_W).norm(); })},
      {"momentum",
       order_of([](const End& a, const End& b) { return (a.momentum_W - b.momentum_W).norm(); })},
      {"angle", order_of([](const End& a, const End& b) { return std::abs(a.turned - b.turned); })},
      {"angular momentum", order_of([](const End& a, const End& b) {
         return std::abs(a.spin_momentum - b.spin_momentum);
       })}};
  for (const auto& v : variables)
    record_near(
        "chapter2/drill-string",
        fmt::format("bit B under given weight, cutting, without the force on cutter bodies, "
                    "steps of 2 to 0.06 ms: order of {}",
                    v.name),
        v.order, 1.0, 0.25);
}

TEST(Drilling, changes_little_with_the_step_where_cutter_bodies_bear) {
  constexpr double least_step = 0.0625e-3;  // s
  const End twice = end_of(2.0 * least_step, BodiesBear::yes),
            once = end_of(least_step, BodiesBear::yes);
  record_bound("chapter2/drill-string",
               "bit B under given weight, cutting: change of the place from a step of 0.125 ms to "
               "0.0625 ms, after 1.9 mm",
               (twice.c_W - once.c_W).norm(), "m", 4.5e-7);
  record_bound("chapter2/drill-string",
               "bit B under given weight, cutting: change of the angle from a step of 0.125 ms to "
               "0.0625 ms, after 0.7 rad",
               std::abs(twice.turned - once.turned), "rad", 1.2e-5);
}

/// Whatever the cut does, the ledger counts its work exactly: the residual is that of the step.
TEST(Drilling, accounts_for_its_energy_to_second_order) {
  std::vector<double> residuals;
  for (const End& e : ends()) residuals.push_back(e.residual);
  record_near("chapter2/drill-string",
              "bit B under given weight, steps of 2 to 0.06 ms: order of the ledger's residual",
              slope(steps(), residuals), 2.0, 0.001);
}

/// Stick-slip on 2000 m of pipe. Unfavourable: while the bit sticks the string winds up, so a period is
/// longer than that of string and mass, which is all that the equation of the string alone gives.
TEST(Drilling, sticks_and_slips_below_the_frequency_of_its_string) {
  const simulation::Case c =
      rock_case("stick-slip",
                {"rock.edge_length='4 mm'", "time.duration='7 s'", "output.means_from='1.5 s'"});
  const simulation::Simulation s = drilled(c);
  const simulation::Diagnosis d =
      simulation::diagnose(s.statistics.trace, s.statistics.loads.tob.mean);
  const double expected =
      simulation::expected_of(c.drilling.system, c.motion.rotary_speed).torsional;
  EXPECT_GT(d.stick_slip_severity, 1.0);
  const double ratio = d.torsional_frequency / expected;
  EXPECT_GT(ratio, 0.6);
  EXPECT_LT(ratio, 1.0);
  battery::record(
      {"chapter2/drill-string",
       "long string in stick-slip, 7 s, edges of 4 mm: strongest frequency of the speed "
       "over that of string and mass",
       ratio, "1",
       "1 where the bit never sticks; below 1, by the time that it sticks in each "
       "period, it is no longer that of the string",
       battery::Verdict::holds_with_limits});
  record_bound("chapter2/drill-string", "long string: defect of the volume ledger",
               simulation::ledger_defect(s), "1", tolerance::ledger);
}

}  // namespace tdbd::claims::drilling_test
