#include "string/survey.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "verification/battery/refused_call.hpp"
#include "verification/string/wells.hpp"

namespace tdbd::string::survey_test {

const double rounding = 1e-15;

Survey turning() {
  return make_survey({{0.0, 300.0, 900.0, 1500.0},
                      {0.0, 5.0 * degree, 50.0 * degree, 80.0 * degree},
                      {0.0, 20.0 * degree, 70.0 * degree, 150.0 * degree}});
}

TEST(Survey, tangents_at_stations_are_those_of_the_survey) {
  const Survey s = turning();
  const Vec3 t = tangent_at(s, 900.0 - 1e-9);
  EXPECT_NEAR(t.z(), std::cos(50.0 * degree), 3e-12);
  EXPECT_NEAR(std::atan2(t.y(), t.x()), 70.0 * degree, 3e-12);
  for (double depth = 0.0; depth < 2000.0; depth += 7.3)
    EXPECT_NEAR(tangent_at(s, depth).norm(), 1.0, 2.0 * rounding);
}

/// Positions by the formula of the ratio factor (Zaremba).
TEST(Survey, positions_are_those_of_minimum_curvature) {
  const Survey s = turning();
  const auto t = [](double inc, double azi) {
    return Vec3(std::sin(inc) * std::cos(azi), std::sin(inc) * std::sin(azi), std::cos(inc));
  };
  const Vec3 a = t(5.0 * degree, 20.0 * degree), b = t(50.0 * degree, 70.0 * degree);
  const double angle = std::acos(a.dot(b));
  const Vec3 step = 300.0 * (a + b) * (2.0 / angle) * std::tan(0.5 * angle);
  EXPECT_NEAR((position_at(s, 900.0) - position_at(s, 300.0) - step).norm(), 0.0, 5e-13);
}

TEST(Survey, positions_are_integrals_of_tangents_also_beyond_the_last_station) {
  const Survey s = turning();
  Vec3 sum = Vec3::Zero();
  const int n = 20000;
  const double l = 1800.0 / n;
  for (int i = 0; i < n; ++i) sum += l * tangent_at(s, (i + 0.5) * l);
  EXPECT_NEAR((position_at(s, 1800.0) - sum).norm(), 0.0, 1.5e-6);
}

TEST(Survey, rejects_stations_that_make_no_path) {
  const auto refused = [](Stations s, const char* part) {
    EXPECT_NE(survey_problem(s).find(part), std::string::npos) << survey_problem(s);
  };
  refused({{0.0, 10.0}, {0.0}, {0.0}}, "2 depths, 1 inclinations, 1 azimuths");
  refused({{5.0}, {0.0}, {0.0}}, "the first station is at 0 m");
  refused({{0.0, 10.0, 10.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}, "station 3 at 10 m after 10 m");
  refused({{0.0, 10.0}, {0.0, 3.2}, {0.0, 0.0}}, "at most 180 deg");
  refused({{0.0, 1e3}, {0.5, 3.141592653589793 - 0.5}, {0.0, 3.141592653589793}}, "opposite");
  EXPECT_EQ(survey_problem({{0.0, 10.0}, {0.0, 0.1}, {0.0, 0.0}}), "");
}

TEST(Survey, finds_the_worst_dogleg) {
  const Dogleg d = worst_dogleg({{0.0, 500.0, 1100.0, 2500.0}, {0.0, 0.0, 1.0, 1.2}, {0, 0, 0, 0}});
  EXPECT_EQ(d.station, 3);
  EXPECT_NEAR(d.severity, 1.0 / 600.0, 1e-18);
}

}  // namespace tdbd::string::survey_test
