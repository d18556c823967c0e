#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>

#include "claims/example_bits.hpp"
#include "reference/literature/roller/craters/huang_cawthorne.hpp"
#include "reference/literature/roller/craters/line_spectrum.hpp"
#include "reference/literature/roller/craters/ma_zhou_deng.hpp"
#include "verification/literature/roller/example_roller_bit.hpp"

/// Chapter 2: how Ma, Zhou and Deng, and the patent of Huang and Cawthorne, move cones and bit.
namespace tdbd::claims::cone_ways_test {
namespace {

using reference::ConeProblem;
using reference::RecursionRow;

const char* const readings[] = {"(i) the angle itself grows by T Ic dt2",
                                "(ii) the angle itself grows by (T/Ic) dt2",
                                "(iii) its increment grows by (T/Ic) dt2, simple start",
                                "(iii) its increment grows by (T/Ic) dt2, half-step start"};

ConeProblem constant_torque() {
  return {0.005, 0.0, 0.1, [](double, double) { return 2.0; }};
}

ConeProblem coasting() {
  return {0.005, -12.9, 0.1, [](double, double) { return 0.0; }};
}

/// A cone that rocks between teeth, with drag that grows with the square of its speed.
ConeProblem rocking() {
  return {0.005, -12.9, 0.2, [](double angle, double speed) {
            return 0.8 * std::sin(3.0 * angle) - 2e-4 * speed * std::abs(speed);
          }};
}

TEST(ConeWays, of_the_readings_of_the_cones_step_only_increments_integrate) {
  const std::string claim = "chapter2/cone-recursion";
  const auto constant = recursion_table(constant_torque(), 100),
             coast = recursion_table(coasting(), 100), rock = recursion_table(rocking(), 200);
  nlohmann::ordered_json table = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < rock.size(); ++i)
    table.push_back({{"reading", readings[i]},
                     {"constant_torque_rad", constant[i].result},
                     {"coasting_rad", coast[i].result},
                     {"order", rock[i].order.order_of_all}});
  battery::record_table("cone-recursion", table);
  record_bound(
      claim,
      "2 N m on 0.005 kg m2 for 0.1 s in steps of 1 ms, (iii) with the half-step start: error",
      constant[3].error, "rad", 1e-12);
  record_near(claim, "the same, (iii) with the simple start: angle over the exact 2 rad",
              constant[2].result / 2.0, 1.01, 1e-12);
  record_near(
      claim,
      "order over five levels under a torque of angle and speed, (iii) with the half-step start",
      rock[3].order.order, 2.0, 3e-5);
  record_near(claim, "the same, (iii) with the simple start", rock[2].order.order, 1.0, 0.05);
  for (std::size_t i : {0U, 1U}) {
    record_near(claim, fmt::format("the same, {}: order, none", readings[i]),
                rock[i].order.order_of_all, 0.0, 1.6e-6);
    record_near(claim,
                fmt::format("a cone that coasts 1.29 rad, {}: share of that way", readings[i]),
                coast[i].result / -1.29, 0.0, 1e-12);
  }
}

reference::RollerSchedule schedule(double revolutions, double step) {
  return {3.0 * std::numbers::pi, 20e3, step, revolutions, revolutions / 2};
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

TEST(ConeWays, of_the_patent_are_one_recursion_under_one_torque) {
  const std::string claim = "chapter2/two-ways";
  const reference::RollerBit bit = reference::example::roller_bit(4e-3);
  const auto drill = [&](reference::PatentMethod way, double average, double given,
                         double bearing) {
    reference::HuangCawthorneOptions o;
    o.way = way;
    o.torque_average = average;
    o.prescribed_ratio_revolutions = given;
    o.bearing = bearing;
    o.drilling.print.release = reference::ToothRelease::elastic;
    return huang_cawthorne(bit, reference::example::tooth_table(), schedule(1.0, 1e-3), o);
  };
  using enum reference::PatentMethod;
  const auto a = drill(first, 0.0, 0.0, 0.0), b = drill(second, 0.0, 0.0, 0.0);
  const std::string what =
      "a turn of three free cones on tables of single-tooth tests, 1 ms: largest difference of ";
  record_bound(claim, what + "cone speeds between the two ways without bearing and averaging",
               largest_difference(a.series.cone_speeds, b.series.cone_speeds), "rad/s", 1e-12);
  record_bound(claim, what + "the bit's depth, likewise",
               largest_difference(a.series.depth, b.series.depth), "m", 1e-15);
  const double averaged =
      largest_difference(drill(first, 10e-3, 0.0, 0.0).series.cone_speeds, b.series.cone_speeds);
  const double bearing =
      largest_difference(drill(second, 0.0, 0.0, 5.0).series.cone_speeds, b.series.cone_speeds);
  for (const auto& [name, difference] : {std::pair{"a torque averaged over 10 ms", averaged},
                                         std::pair{"a bearing of 5 N m", bearing}}) {
    EXPECT_GT(difference, 0.1) << name;
    battery::record({claim, what + "cone speeds that " + name + " makes", difference, "rad/s",
                     ">= 0.1",
                     difference >= 0.1 ? battery::Verdict::holds : battery::Verdict::refuted});
  }
}

/// Depth less its line in time, second half of a run: standard deviation, m.
double bounce_of(const reference::RollerSeries& s) {
  const std::size_t first = s.depth.size() / 2;
  const double n = static_cast<double>(s.depth.size() - first);
  double t = 0.0, z = 0.0, tt = 0.0, tz = 0.0, sum = 0.0;
  for (std::size_t i = first; i < s.depth.size(); ++i) t += s.time[i] / n, z += s.depth[i] / n;
  for (std::size_t i = first; i < s.depth.size(); ++i) {
    tt += (s.time[i] - t) * (s.time[i] - t);
    tz += (s.time[i] - t) * (s.depth[i] - z);
  }
  for (std::size_t i = first; i < s.depth.size(); ++i)
    sum += std::pow(s.depth[i] - z - tz / tt * (s.time[i] - t), 2) / n;
  return std::sqrt(sum);
}

/// Amplitudes of the weight, second half of a run, in steps of 1 Hz up to 200 Hz: rows of a table.
void add_spectrum(nlohmann::ordered_json& table, double mass, const reference::RollerSeries& s) {
  std::vector<double> frequencies;
  for (int f = 1; f <= 200; ++f) frequencies.push_back(f);
  const std::span<const double> weight(s.weight);
  const auto amplitudes = reference::line_spectrum(weight.subspan(weight.size() / 2),
                                                   s.time[1] - s.time[0], frequencies);
  for (std::size_t i = 0; i < frequencies.size(); ++i)
    table.push_back(
        {{"mass_kg", mass}, {"frequency_Hz", frequencies[i]}, {"weight_N", amplitudes[i]}});
}

/// Balancing the weight at every moment hides what a mass does to it. With the damping of a string of
/// 0.5 MN s/m; masses from 0.5 to 50 t.
TEST(ConeWays, that_balance_the_weight_do_not_depend_on_axial_mass) {
  const std::string claim = "chapter2/weight-balance";
  const reference::RollerBit bit = reference::example::roller_bit(4e-3);
  nlohmann::ordered_json table = nlohmann::ordered_json::array(), spectrum = table;
  std::vector<double> deviations;
  for (const double mass : {0.0, 500.0, 5000.0, 50000.0}) {
    reference::MaZhouDengOptions o;
    o.drilling.axial = mass > 0.0 ? reference::AxialMotion::mass : reference::AxialMotion::balance;
    o.drilling.mass = mass;
    o.drilling.axial_damping = 5e5;
    const auto r = ma_zhou_deng(bit, reference::example::power_tooth(), schedule(12.0, 0.25e-3), o);
    deviations.push_back(r.weight_deviation / 20e3);
    add_spectrum(spectrum, mass, r.series);
    table.push_back({{"mass_kg", mass},
                     {"weight_deviation_N", r.weight_deviation},
                     {"bounce_m", bounce_of(r.series)},
                     {"rate_m_h", 3600.0 * r.rate},
                     {"torque_N_m", r.torque}});
  }
  battery::record_table("axial-mass", table);
  battery::record_table("axial-mass-spectrum", spectrum);
  const std::string what =
      "20 kN on three free cones: standard deviation of the weight over its mean, ";
  record_bound(claim, what + "found by iteration", deviations[0], "1", 1.1e-5);
  for (std::size_t i = 1; i < deviations.size(); ++i) EXPECT_GT(deviations[i], deviations[i - 1]);
  battery::record({claim, what + "with a mass of 50 t", deviations[3], "1", ">= 0.3",
                   deviations[3] >= 0.3 ? battery::Verdict::holds : battery::Verdict::refuted});
}

}  // namespace
}  // namespace tdbd::claims::cone_ways_test
