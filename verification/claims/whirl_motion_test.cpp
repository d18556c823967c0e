#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "bit/cutter/cutter.hpp"
#include "claims/example_bits.hpp"
#include "claims/rock_runs.hpp"

/// Thesis 1.3: "backwards whirl can cause cutters on a PDC bit to travel backwards and sideways".
namespace tdbd::claims::whirl_motion_test {

constexpr double pi = std::numbers::pi, mm = 1e-3;
const char* const backwards = "chapter1/backwards";

/// How the cutters of a bit moved, in share of time, and what they cut meanwhile.
struct Travel {
  std::vector<double> backward, sideways;    ///< of each cutter; sideways: rather than along
  double removed = 0.0, removed_back = 0.0;  ///< m3, by all
  long steps = 0;
};

/// Adds a step in which the bit went from one pose to the other.
void add_step(const bit::Bit& bit, const Pose& X0, const Pose& X1,
              const std::vector<double>& removed_by_part, Travel& sum) {
  ++sum.steps;
  std::vector<bool> back(bit.cutters.size());
  for (std::size_t i = 0; i < bit.cutters.size(); ++i) {
    const Vec3 tip = bit::tip_B(bit.cutters[i]), way = X1 * tip - X0 * tip;
    const Vec3 out = 0.5 * (X0.rotate(tip) + X1.rotate(tip)), along = Vec3::UnitZ().cross(out);
    back[i] = way.dot(along) < 0.0;
    sum.backward[i] += back[i];
    sum.sideways[i] += std::abs(way.head<2>().dot(out.head<2>())) > std::abs(way.dot(along));
  }
  for (std::size_t p = 0; p < bit.parts.size(); ++p) {
    const int cutter = bit.parts[p].cutter;
    if (cutter < 0) continue;
    sum.removed += removed_by_part[p];
    if (back[static_cast<std::size_t>(cutter)]) sum.removed_back += removed_by_part[p];
  }
}

/// Drills the case and watches the cutters once the whirl has its radius.
Travel travel(const simulation::Case& c) {
  simulation::Simulation s = simulation::start(c);
  Travel sum;
  sum.backward.resize(c.bit.cutters.size());
  sum.sideways = sum.backward;
  while (s.state.steps_done < c.time.steps) {
    const Pose before = s.state.place.X_WB;
    simulation::step(c, s);
    if (c.time.step * static_cast<double>(s.state.steps_done - 1) >= c.motion.whirl.ramp)
      add_step(c.bit, before, s.state.place.X_WB, s.state.cut.removed_by_part, sum);
  }
  for (auto* share : {&sum.backward, &sum.sideways})
    for (double& x : *share) x /= static_cast<double>(sum.steps);
  return sum;
}

/// Distance of the instantaneous centre of rotation from the centre of the bit, m.
double centre_distance(const simulation::Motion& m) {
  return m.whirl.radius * m.whirl.frequency / m.rotary_speed;
}

/// Share of time in which a cutter at r moves backward: literature, pure rolling, with the distance
/// of the instantaneous centre in place of the bit's radius.
double expected_backward(double r, double centre) {
  return r < centre ? std::acos(r / centre) / pi : 0.0;
}

simulation::Case whirling(const std::vector<std::string>& settings) {
  std::vector<std::string> all{"rock.edge_length='2.5 mm'", "time.revolutions=1",
                               "motion.whirl.ramp='20 ms'"};
  all.insert(all.end(), settings.begin(), settings.end());
  return rock_case("bit-b-whirl", all);
}

/// The largest difference of shares from those that rolling about that centre has.
double worst_backward(const simulation::Case& c, const Travel& t) {
  double worst = 0.0;
  for (std::size_t i = 0; i < c.bit.cutters.size(); ++i)
    worst = std::max(worst, std::abs(t.backward[i] - expected_backward(c.bit.cutters[i].tip_radius,
                                                                       centre_distance(c.motion))));
  return worst;
}

void record_shares(const simulation::Case& c, const Travel& t) {
  nlohmann::ordered_json rows;
  for (std::size_t i = 0; i < c.bit.cutters.size(); ++i) {
    const double r = c.bit.cutters[i].tip_radius;
    rows.push_back({{"cutter", c.bit.cutters[i].id},
                    {"r_over_gage", r / c.bit.gage_radius},
                    {"backward", t.backward[i]},
                    {"expected_backward", expected_backward(r, centre_distance(c.motion))},
                    {"sideways", t.sideways[i]}});
  }
  battery::record_table("whirl-motion", rows);
}

/// The orbit of 1.5 mm of a bit that rolls on its wall. Sideways is half the time at any radius:
/// the tip sees the centre of rotation and the bit's within 45 degrees of each other (Thales).
TEST(WhirlMotion, takes_cutters_backwards_and_sideways_where_the_bit_rolls_on_its_wall) {
  const simulation::Case c = whirling(
      {"motion.whirl.radius='1.5 mm'", "motion.whirl.frequency='8636 rpm'", "time.step='0.1 ms'"});
  EXPECT_NEAR(centre_distance(c.motion) / c.bit.gage_radius, 1.0, 1e-12);
  const Travel t = travel(c);
  record_shares(c, t);
  const std::string of = "bit B rolls backward on its wall, orbit of 1.5 mm, 120 rpm: ";
  constexpr double seen = 0.005;  // near the gage a tenth of a step's orbit shows
  constexpr double half = 0.0024;
  record_bound(backwards,
               of + "share of time in which a cutter moves backward, against arccos(r/R)/pi, worst",
               worst_backward(c, t), "1", seen);
  record_near(backwards, of + "the same share for the innermost cutter", t.backward[0],
              expected_backward(c.bit.cutters[0].tip_radius, centre_distance(c.motion)),
              2.0 / static_cast<double>(t.steps),
              fmt::format("two of {} steps may count on either side", t.steps));
  const auto [least, most] = std::ranges::minmax(t.sideways);
  record_near(backwards, of + "share of time in which a cutter moves more sideways than along",
              std::abs(least - 0.5) > std::abs(most - 0.5) ? least : most, 0.5, half);
  record_near(backwards, of + "share of the rock that cutters remove while they move backward",
              t.removed_back / t.removed, 0.10, 0.007);
}

/// A slow orbit does not roll: the bit turns about a centre 3 mm away, within all cutters.
TEST(WhirlMotion, takes_no_cutter_backwards_that_is_beyond_the_centre_of_rotation) {
  const simulation::Case c = whirling({});
  const Travel t = travel(c);
  EXPECT_NEAR(centre_distance(c.motion), 3 * mm, 1e-15);
  record_near(backwards,
              "bit B as in cases/bit-b-whirl, centre of rotation 3 mm off: share of time in which "
              "a cutter moves backward, most",
              std::ranges::max(t.backward), 0.0, 1e-12);
}

}  // namespace tdbd::claims::whirl_motion_test
