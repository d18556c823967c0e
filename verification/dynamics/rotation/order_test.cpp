#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/observed_order.hpp"
#include "verification/battery/evidence.hpp"
#include "verification/battery/golden.hpp"
#include "verification/battery/rotation_checks.hpp"
#include "verification/battery/rotation_orders.hpp"
#include "verification/battery/symplectic_defect.hpp"

namespace tdbd::battery::order_test {

/// How far a slope may be from the order; the asymptotic range is that of observed_orders.
double tolerance_of(const RotationScheme& scheme) {
  if (scheme.order != 2) return scheme.order == 4 ? 0.1 : 0.2;
  if (scheme.name == "lie-mean x2") return 0.05;
  return scheme.name.starts_with("lie-midpoint") ? 0.008 : 0.024;
}

constexpr int least_levels = 5;

/// Free rotation about the middle axis by the split drift of order 8: errors fall faster than with order 8 in all
/// levels above rounding.
bool falls_faster(const RotationScheme& scheme, const std::string& name) {
  return scheme.name == "split order 8" && name == "free_asym_unstable";
}

void record_faster(const RotationScheme& scheme, const std::string& name, const VariableOrder& o) {
  EXPECT_GT(o.order, scheme.order) << o.variable;
  record({"ours/compositions",
          fmt::format("{}: observed order of {} on {}", scheme.name, o.variable, name), o.order,
          "1",
          fmt::format("{} +- {} is missed: errors fall faster in all levels above rounding",
                      scheme.order, tolerance_of(scheme)),
          Verdict::holds_with_limits});
}

/// Checks every variable of every golden case; returns the largest deviation.
double check_orders(const RotationScheme& scheme) {
  double worst = 0.0;
  for (const std::string& name : golden_names()) {
    for (const VariableOrder& o : observed_orders(scheme, read_golden_case(name))) {
      const std::string where = fmt::format("{}, {}, {}: order {:.3f} from {} levels", scheme.name,
                                            name, o.variable, o.order, o.levels);
      if (o.exact) continue;
      if (falls_faster(scheme, name)) {
        record_faster(scheme, name, o);
        continue;
      }
      EXPECT_GE(o.levels, least_levels) << where;
      EXPECT_NEAR(o.order, scheme.order, tolerance_of(scheme)) << where;
      worst = std::max(worst, std::abs(o.order - scheme.order));
    }
  }
  return worst;
}

void check_and_record(const RotationScheme& scheme, const std::string& claim) {
  const double worst = check_orders(scheme);
  const double limit = tolerance_of(scheme);
  record({claim,
          fmt::format("{}: largest deviation of an observed order from {}, {} golden cases, all "
                      "state variables",
                      scheme.name, scheme.order,
                      falls_faster(scheme, "free_asym_unstable") ? "eight" : "nine"),
          worst, "1", fmt::format("<= {}", limit),
          worst <= limit ? Verdict::holds : Verdict::refuted});
}

TEST(ObservedOrders, second_order_schemes_are_of_order_2_in_every_variable) {
  for (const RotationScheme& scheme : second_order_schemes())
    check_and_record(scheme, scheme.name.starts_with("lie-midpoint") ? "chapter5/second-order"
                                                                     : "ours/second-order");
}

TEST(ObservedOrders, suzuki_compositions_are_of_order_4_in_every_variable) {
  for (const RotationScheme& scheme : composed_schemes(4))
    check_and_record(scheme, "ours/compositions");
}

TEST(ObservedOrders, kahan_li_compositions_are_of_order_6_in_every_variable) {
  for (const RotationScheme& scheme : composed_schemes(6))
    check_and_record(scheme, "ours/compositions");
}

TEST(ObservedOrders, kahan_li_compositions_are_of_order_8_in_every_variable) {
  for (const RotationScheme& scheme : composed_schemes(8))
    check_and_record(scheme, "ours/compositions");
}

/// The derivative by dual numbers is exact to rounding: entries of J up to about ten, some hundred
/// operations each, 12 x 12 products.
constexpr double rounding = 1e-13;
constexpr double closed_form = 4.5e-10;  ///< relative: rounding over defects of 1e-6 and more
constexpr double third_order = 0.018;

/// A system for the question: free and heavy, symmetric and not, with and without cones.
struct System {
  std::string name;
  dynamics::Gyrostat g;
  dynamics::Loads loads;
  dynamics::RotationState state;  ///< generic: no velocity along a principal axis
  bool spherical_without_spin = false;
};

std::vector<dynamics::Cone> three_cones() {
  return {{Vec3(0.819, 0.0, 0.574), 0.1},
          {Vec3(-0.41, 0.709, 0.574), 0.2},
          {Vec3(-0.41, -0.709, 0.574), 0.15}};
}

System make_system(const std::string& name, const Vec3& inertia, std::vector<dynamics::Cone> cones,
                   double gravity) {
  System s;
  s.name = name;
  s.g = dynamics::make_gyrostat(inertia.asDiagonal(), std::move(cones));
  s.loads.gravity_moment = gravity;
  s.loads.gravity_arm_B = Vec3(0.6, 0.0, 0.8);
  const std::vector<double> spins = {-6.0, 4.0, -9.0}, angles = {0.1, 0.2, 0.3};
  const Eigen::Quaterniond q(Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -0.5).normalized()));
  s.state = dynamics::make_state(s.g, q.toRotationMatrix(), Vec3(0.9, -0.7, 1.3),
                                 std::span(spins).first(s.g.cones.size()),
                                 std::span(angles).first(s.g.cones.size()));
  s.spherical_without_spin = s.g.cones.empty() && inertia[0] == inertia[2];
  return s;
}

std::vector<System> systems() {
  const Vec3 asymmetric(2.0, 2.6, 3.0), symmetric(2.0, 2.0, 3.0), spherical(2.0, 2.0, 2.0);
  return {make_system("asymmetric, free", asymmetric, {}, 0.0),
          make_system("asymmetric, heavy", asymmetric, {}, 5.0),
          make_system("symmetric, free", symmetric, {}, 0.0),
          make_system("symmetric, heavy", symmetric, {}, 5.0),
          make_system("spherical, free", spherical, {}, 0.0),
          make_system("asymmetric, three cones, free", asymmetric, three_cones(), 0.0),
          make_system("asymmetric, three cones, heavy", asymmetric, three_cones(), 5.0),
          make_system("symmetric, three cones, heavy", symmetric, three_cones(), 5.0),
          make_system("spherical, three cones, free", spherical, three_cones(), 0.0)};
}

bool is_thesis_drift(const RotationScheme& s) { return s.name.starts_with("lie-midpoint"); }

std::vector<RotationScheme> all_schemes() {
  std::vector<RotationScheme> schemes = second_order_schemes();
  for (const RotationScheme& s : composed_schemes(4)) schemes.push_back(s);
  return schemes;
}

TEST(Symplecticity, every_drift_but_the_thesis_one_is_symplectic_to_rounding) {
  const Chart away{Vec3(0.4, -0.3, 0.6)};
  for (const RotationScheme& scheme : all_schemes()) {
    if (is_thesis_drift(scheme)) continue;
    double worst = 0.0;
    for (const System& s : systems())
      for (const double h : {0.2, 0.05})
        for (const Chart& chart : {Chart{}, away}) {
          const double defect = symplectic_defect(scheme, s.g, s.loads, s.state, h, chart);
          EXPECT_LE(defect, rounding) << scheme.name << ", " << s.name << ", h = " << h;
          worst = std::max(worst, defect);
        }
    record({"ours/symplectic", scheme.name + ": largest |J^T Omega J - Omega|, nine systems", worst,
            "1", fmt::format("<= {}", rounding),
            worst <= rounding ? Verdict::holds : Verdict::refuted});
  }
}

JetMap thesis_drift(const System& s, double h) {
  return [&s, h](dynamics::RotationStateOf<Jet>& state) {
    dynamics::drift_lie<Jet>(s.g, dynamics::LieMomentum::middle, h, {}, state);
  };
}

TEST(Symplecticity, the_thesis_drift_misses_by_its_closed_form) {
  double worst = 0.0;
  for (const System& s : systems()) {
    for (const double h : {0.2, 0.1, 0.05}) {
      const Eigen::MatrixXd defect = symplectic_defect(s.state, thesis_drift(s, h));
      const Eigen::MatrixXd expected = lie_midpoint_defect(s.g, s.state, h);
      if (s.spherical_without_spin) {
        EXPECT_LE(defect.norm(), rounding) << s.name;
        continue;
      }
      EXPECT_GE(defect.norm(), 1e-6) << s.name << ", h = " << h;
      const double difference = (defect - expected).norm() / expected.norm();
      EXPECT_LE(difference, closed_form) << s.name << ", h = " << h;
      worst = std::max(worst, difference);
    }
  }
  record({"chapter5/symplectic",
          "lie-midpoint: relative difference of its symplectic defect from the closed form", worst,
          "1", fmt::format("<= {}", closed_form),
          worst <= closed_form ? Verdict::refuted : Verdict::holds_with_limits});
}

TEST(Symplecticity, the_thesis_drift_misses_by_third_order) {
  double worst = 0.0, at_one_tenth = 0.0;
  for (const System& s : systems()) {
    if (s.spherical_without_spin) continue;
    std::vector<double> steps, defects;
    for (const double h : {0.1, 0.05, 0.025, 0.0125, 0.00625}) {
      steps.push_back(h);
      defects.push_back(symplectic_defect(s.state, thesis_drift(s, h)).norm());
    }
    const double order = least_squares_order(steps, defects);
    EXPECT_NEAR(order, 3.0, third_order) << s.name;
    worst = std::max(worst, std::abs(order - 3.0));
    at_one_tenth = std::max(at_one_tenth, defects.front());
  }
  record({"chapter5/symplectic", "lie-midpoint: defect of one drift of 0.1 s, largest of systems",
          at_one_tenth, "1", fmt::format("a symplectic drift has <= {}", rounding),
          at_one_tenth <= rounding ? Verdict::holds : Verdict::refuted});
  record({"chapter5/symplectic", "lie-midpoint: deviation of the defect's order from 3", worst, "1",
          fmt::format("<= {}", third_order),
          worst <= third_order ? Verdict::refuted : Verdict::holds_with_limits});
}

/// For the figure: defect of one step against its size.
TEST(Symplecticity, leaves_a_table_of_defects_against_steps) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const System& s : systems())
    for (const RotationScheme& scheme : composed_schemes(2))
      for (double h = 0.4; h > 0.001; h *= 0.5) {
        nlohmann::ordered_json row{{"case", s.name}, {"drift", scheme.name}, {"h", h}};
        const double defect = symplectic_defect(scheme, s.g, s.loads, s.state, h);
        EXPECT_TRUE(std::isfinite(defect));
        row["defect"] = defect;
        row["closed_form"] =
            is_thesis_drift(scheme)
                ? nlohmann::ordered_json(lie_midpoint_defect(s.g, s.state, h).norm())
                : nlohmann::ordered_json(nullptr);
        rows.push_back(row);
      }
  EXPECT_EQ(rows.size(), systems().size() * 4 * 9);
  record_table("symplectic-defect", rows);
}

}  // namespace tdbd::battery::order_test
