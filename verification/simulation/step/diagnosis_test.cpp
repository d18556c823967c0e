#include "simulation/step/diagnosis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace tdbd::simulation::diagnosis_test {

constexpr double two_pi = 2.0 * std::numbers::pi, dt = 1e-3;
constexpr double speed = 10.0;     // rad/s, of the bit
constexpr double resisting = 2e3;  // N m, mean torque on bit
constexpr int steps = 8000;

/// A record of made-up functions of time.
struct Made {
  std::function<double(double)> wob = [](double) { return 1e4; };
  std::function<double(double)> rotary_speed = [](double) { return speed; };
  std::function<Eigen::Vector2d(double)> centre = [](double) {
    return Eigen::Vector2d(1e-3, 2e-3);
  };
};

Diagnosis diagnosis_of(const Made& m, double torque = resisting) {
  Trace t;
  t.dt = dt;
  for (int i = 0; i < steps; ++i) {
    t.wob.push_back(m.wob(i * dt));
    t.rotary_speed.push_back(m.rotary_speed(i * dt));
    t.centre_W.push_back(m.centre(i * dt));
  }
  return diagnose(t, torque);
}

Eigen::Vector2d circle(double radius, double frequency, double t) {
  return radius *
         Eigen::Vector2d(std::cos(two_pi * frequency * t), std::sin(two_pi * frequency * t));
}

TEST(Diagnosis, calls_what_does_not_vary_steady) {
  const Diagnosis d = diagnosis_of({});
  EXPECT_EQ(d.text, "steady");
  EXPECT_EQ(d.whirl, WhirlKind::none);
  EXPECT_EQ(d.stick_slip_severity, 0.0);
  EXPECT_EQ(d.lost_contact_share, 0.0);
}

TEST(Diagnosis, finds_stick_slip_with_its_severity_and_frequency) {
  Made m;
  m.rotary_speed = [](double t) { return speed * (1.0 + std::sin(two_pi * 0.5 * t)); };
  const Diagnosis d = diagnosis_of(m);
  EXPECT_NEAR(d.stick_slip_severity, 1.0, 1e-14);
  EXPECT_NEAR(d.torsional_frequency, 0.5, 1e-12);
  EXPECT_GT(d.stuck_share, 0.05);
  EXPECT_NE(d.text.find("stick-slip"), std::string::npos);
}

/// Stick-slip of severity 1, whose record ends within a cycle. Speeds of rectangles: 2 in one half of a
/// cycle, 0 in the other. Of three and a half cycles the mean speed is 8/7 of the bit's, and more than
/// half of the time belongs to the faster half.
TEST(Diagnosis, does_not_depend_on_where_the_record_ends_within_a_cycle) {
  for (const double frequency : {0.4375, 0.4583, 0.4791}) {  // 3.5, 3.67 and 3.83 cycles in 8 s
    Made m;
    m.rotary_speed = [=](double t) {
      return speed * (1.0 + std::copysign(1.0, std::sin(two_pi * frequency * t)));
    };
    const Diagnosis d = diagnosis_of(m);
    const double of_frequency = 0.01;  // the line between two of a short spectrum
    EXPECT_NEAR(d.stick_slip_severity, 1.0, of_frequency) << frequency;
    EXPECT_NEAR(d.stuck_share, 0.5, 0.5 * of_frequency) << frequency;
  }
}

/// Half a revolution that starts from rest; half a revolution that sticks has a diagnosis.
TEST(Diagnosis, of_less_than_a_revolution_is_that_the_run_is_too_short) {
  Trace t;
  t.dt = 1e-3;
  for (int i = 0; i < 500; ++i) {
    t.rotary_speed.push_back(two_pi * (1.0 + 0.9 * std::sin(two_pi * 4e-3 * i)));
    t.wob.push_back(1e4);
    t.centre_W.emplace_back(0.0, 0.0);
  }
  EXPECT_EQ(diagnose(t, 1e3).text, "too short to judge: 0.5 revolutions, at least one is required");
  for (int i = 0; i < 250; ++i) t.rotary_speed[static_cast<std::size_t>(2 * i)] = 0.0;
  EXPECT_NE(diagnose(t, 1e3).text.find("stick-slip"), std::string::npos);
}

TEST(Diagnosis, finds_lost_contact) {
  Made m;
  m.wob = [](double t) { return std::max(0.0, 1e4 * std::sin(two_pi * 7.3 * t)); };
  const Diagnosis d = diagnosis_of(m);
  EXPECT_NEAR(d.lost_contact_share, 0.5, 0.01);
  EXPECT_NEAR(d.axial_frequency, 7.3, 4.5e-3);
  EXPECT_NE(d.text.find("bounce"), std::string::npos);
}

TEST(Diagnosis, calls_a_bit_that_never_touches_free) {
  Made m;
  m.wob = [](double) { return 0.0; };
  const Diagnosis d = diagnosis_of(m);
  EXPECT_EQ(d.lost_contact_share, 1.0);
  EXPECT_EQ(d.text, "off bottom, no contact with rock");
}

/// A bit that swings on its string, about a small mean speed.
Made swinging(double mean, double amplitude) {
  Made m;
  m.rotary_speed = [=](double t) { return mean + amplitude * std::sin(two_pi * 0.5 * t); };
  return m;
}

void expect_no_stick_slip(const Diagnosis& d, const std::string& text) {
  EXPECT_EQ(d.stick_slip_severity, 0.0);
  EXPECT_EQ(d.stuck_share, 0.0);
  EXPECT_EQ(d.text, text);
}

TEST(Diagnosis, of_a_pendulum_off_bottom_is_not_stick_slip) {
  for (const double mean : {0.1, speed}) {
    Made m = swinging(mean, speed);
    m.wob = [](double) { return 0.0; };
    expect_no_stick_slip(diagnosis_of(m, 0.0),
                         "off bottom, no contact with rock; torsional vibration at 0.5 Hz");
  }
}

/// Each condition of diagnose() by itself, at values next to its threshold.
TEST(Diagnosis, needs_contact_torque_and_net_rotation_for_stick_slip) {
  const auto severity = [](const Made& m, double torque) {
    return diagnosis_of(m, torque).stick_slip_severity;
  };
  const Made sticking = swinging(speed, speed);
  EXPECT_GT(severity(sticking, 1.0), 0.99);
  expect_no_stick_slip(diagnosis_of(sticking, 0.0), "torsional vibration at 0.5 Hz");
  expect_no_stick_slip(diagnosis_of(sticking, -1.0), "torsional vibration at 0.5 Hz");
  EXPECT_GT(severity(swinging(-speed, speed), -1.0), 0.99);
  for (const auto& [touches, sticks] : {std::pair(51, true), std::pair(49, false)}) {
    Made m = sticking;
    m.wob = [n = touches](double t) { return std::lround(t / dt) % 100 < n ? 1e4 : 0.0; };
    EXPECT_EQ(severity(m, resisting) > 0.0, sticks) << touches;
  }
  // mean(|w|) = 2 mean(w) at a mean of 0.3365 of the amplitude
  EXPECT_GT(severity(swinging(3.4, 10.0), resisting), 0.0);
  EXPECT_EQ(severity(swinging(3.3, 10.0), resisting), 0.0);
}

/// Rounding on the speed of a bit that does not turn is no vibration.
TEST(Diagnosis, of_a_bit_at_rest_is_steady) {
  expect_no_stick_slip(diagnosis_of(swinging(0.0, 1e-15)), "steady");
  expect_no_stick_slip(diagnosis_of(swinging(0.0, 0.9e-3)), "steady");
  expect_no_stick_slip(diagnosis_of(swinging(0.0, 1.1e-3)), "torsional vibration at 0.5 Hz");
}

/// Of too few steps for a spectrum.
TEST(Diagnosis, names_no_frequency_where_none_is_known) {
  Trace t;
  t.dt = 1.0;
  t.wob = {0.0, 1e4, 0.0, 1e4};
  t.rotary_speed = {0.0, speed, 0.0, speed};
  t.centre_W.assign(4, Eigen::Vector2d::Zero());
  EXPECT_EQ(diagnose(t, resisting).text,
            "stick-slip, severity 1.00, stuck 50 % of the time; bit bounce, without contact 50 % "
            "of the time");
  t.wob = {1.0, 1e4, 1.0, 1e4};
  t.rotary_speed.assign(4, speed);
  EXPECT_EQ(diagnose(t, resisting).text, "axial vibration, weight swings by 100 %");
}

TEST(Diagnosis, finds_axial_vibration_without_lost_contact) {
  Made m;
  m.wob = [](double t) { return 1e4 * (1.0 + 0.7 * std::sin(two_pi * 12.5 * t)); };
  const Diagnosis d = diagnosis_of(m);
  EXPECT_EQ(d.lost_contact_share, 0.0);
  EXPECT_NE(d.text.find("axial vibration, weight swings by 70 % at 12.5 Hz"), std::string::npos);
}

TEST(Diagnosis, distinguishes_whirls_by_sense_and_frequency) {
  const double turn = speed / two_pi;
  const struct {
    double frequency;
    WhirlKind kind;
  } whirls[] = {
      {-31.7, WhirlKind::backward}, {4.4, WhirlKind::forward}, {turn, WhirlKind::synchronous}};
  for (const auto& w : whirls) {
    Made m;
    m.centre = [&](double t) {
      return Eigen::Vector2d(Eigen::Vector2d(1e-3, 0.0) + circle(2e-3, w.frequency, t));
    };
    const Diagnosis d = diagnosis_of(m);
    EXPECT_EQ(d.whirl, w.kind) << whirl_name(d.whirl);
    EXPECT_NEAR(d.orbit_frequency, w.frequency, 1.6e-3);  // the mean is that of a cut circle
    EXPECT_NEAR(d.orbit_radius, 2e-3, 1e-6);
  }
}

/// Rocking to and fro is no whirl, however far.
TEST(Diagnosis, does_not_take_rocking_for_whirl) {
  Made m;
  m.centre = [](double t) {
    return Eigen::Vector2d(5e-3 * std::sin(two_pi * 3.0 * t), 1e-5 * std::cos(two_pi * 5.1 * t));
  };
  EXPECT_EQ(diagnosis_of(m).whirl, WhirlKind::none);
}

/// Four corners of a square of which the middle is the mean: three quarters of a turn in three steps.
TEST(Diagnosis, of_a_square_orbit_is_exact) {
  Trace t;
  t.dt = 0.1;
  t.wob = {2.0, 1.0, 0.0, 1.0};
  t.rotary_speed = {0.45, 0.55, 0.6, 38.4};  // mean 10, a twentieth of it 0.5
  for (const auto& x : {Eigen::Vector2d(1.0, 1.0), Eigen::Vector2d(-1.0, 1.0),
                        Eigen::Vector2d(-1.0, -1.0), Eigen::Vector2d(1.0, -1.0)})
    t.centre_W.emplace_back(Eigen::Vector2d(0.5, 0.25) + 0.003 * x);
  const Diagnosis d = diagnose(t, resisting);
  EXPECT_NEAR(d.orbit_radius, 0.003 * std::numbers::sqrt2, 1e-16);
  EXPECT_NEAR(d.orbit_frequency, 2.5, 1e-12);
  EXPECT_EQ(d.whirl, WhirlKind::forward);  // at 15.7 rad/s
  EXPECT_DOUBLE_EQ(d.stick_slip_severity, (38.4 - 0.45) / 20.0);
  EXPECT_EQ(d.stuck_share, 0.25);
  EXPECT_EQ(d.lost_contact_share, 0.25);
  EXPECT_EQ(d.wob_swing, 1.0);
}

/// Two steps are the fewest that can differ.
TEST(Diagnosis, needs_two_steps) {
  Trace t;
  t.dt = dt;
  t.wob = {3.0};
  t.rotary_speed = {9.0};
  t.centre_W = {Eigen::Vector2d::Zero()};
  EXPECT_EQ(diagnose(t, resisting).wob_swing, 0.0);
  EXPECT_EQ(diagnose(t, resisting).text, Diagnosis{}.text);
  t.wob.push_back(1.0);
  t.rotary_speed.push_back(11.0);
  t.centre_W.emplace_back(0.0, 0.0);
  EXPECT_DOUBLE_EQ(diagnose(t, resisting).wob_swing, 0.5);
  EXPECT_DOUBLE_EQ(diagnose(t, resisting).stick_slip_severity, 0.1);
}

/// Severities and swings from one half, lost contact from a hundredth.
TEST(Diagnosis, names_what_is_beyond_its_thresholds) {
  const auto speeds = [](double severity) {
    Made m;
    m.rotary_speed = [=](double t) { return speed * (1.0 + severity * std::sin(two_pi * t)); };
    return diagnosis_of(m).text;
  };
  EXPECT_EQ(speeds(0.45), "steady");
  EXPECT_EQ(speeds(0.6).rfind("stick-slip, severity 0.60, at 1 Hz, stuck 0 % of the time", 0), 0U)
      << speeds(0.6);
  const auto weights = [](double swing) {
    Made m;
    m.wob = [=](double t) { return 1e4 * (1.0 + swing * std::sin(two_pi * t)); };
    return diagnosis_of(m).text;
  };
  EXPECT_EQ(weights(0.45), "steady");
  EXPECT_EQ(weights(0.6), "axial vibration, weight swings by 60 % at 1 Hz");
  const auto losing = [](int every) {
    Made m;
    m.wob = [=](double t) { return std::lround(t / dt) % every == 0 ? 0.0 : 1e4; };
    return diagnosis_of(m).text;
  };
  EXPECT_EQ(losing(110).rfind("axial vibration", 0), 0U) << losing(110);
  EXPECT_EQ(losing(86).rfind("bit bounce, without contact 1 % of the time", 0), 0U) << losing(86);
}

/// An orbit from a tenth of a millimetre, within a tenth of the bit's speed, or another.
TEST(Diagnosis, distinguishes_whirls_by_thresholds_of_radius_and_speed) {
  const auto kind = [](double radius, double of_the_bits_speed) {
    Made m;
    m.centre = [=](double t) { return circle(radius, of_the_bits_speed * speed / two_pi, t); };
    return diagnosis_of(m).whirl;
  };
  EXPECT_EQ(kind(0.9e-4, -3.0), WhirlKind::none);
  EXPECT_EQ(kind(1.2e-4, -3.0), WhirlKind::backward);
  for (const double same : {0.92, 1.08})
    EXPECT_EQ(kind(1e-3, same), WhirlKind::synchronous) << same;
  for (const double other : {0.88, 1.12}) EXPECT_EQ(kind(1e-3, other), WhirlKind::forward) << other;
}

/// So many steps of an eighth of a turn on and so many back, again and again: whirl where half of all turning goes one way.
TEST(Diagnosis, takes_turning_that_mostly_goes_one_way_for_whirl) {
  const auto kind = [](int on, int back) {
    int eighths = 0;
    Made m;
    m.centre = [&, on, back](double t) {
      const bool goes_on = std::lround(t / dt) % (on + back) < on;
      eighths += goes_on ? 1 : -1;
      return circle(1e-3, 1.0, eighths / 8.0);
    };
    return diagnosis_of(m).whirl;
  };
  EXPECT_EQ(kind(4, 1), WhirlKind::forward);   // 3/5
  EXPECT_EQ(kind(1, 4), WhirlKind::backward);  // 3/5
  EXPECT_EQ(kind(7, 3), WhirlKind::none);      // 4/10
}

/// Between two lines of the spectrum, whatever the phase: within a twentieth of a line.
/// The longest wave that a record can show; to half a line, since the mean has no part in it.
TEST(StrongestFrequency, is_found_of_one_period) {
  std::vector<double> samples;
  for (int i = 0; i < steps; ++i) samples.push_back(std::sin(two_pi * i / steps));
  EXPECT_NEAR(strongest_frequency(samples, dt), 1.0 / (steps * dt), 0.45 / (steps * dt));
}

/// Every other sample at the mean: the spectrum is the same at k and n/2 - k, and the slower one is named.
TEST(StrongestFrequency, is_the_lower_one_of_two_that_are_as_strong) {
  const std::vector<double> x{1.0, 0.0, -1.0, 0.0, -1.0, 0.0, 1.0, 0.0};
  const double found = strongest_frequency(x, dt) * 8.0 * dt;
  EXPECT_GT(found, 0.5);
  EXPECT_LT(found, 1.7);
}

TEST(StrongestFrequency, is_found_between_lines) {
  constexpr int count = 1000;
  for (int k = 0; k < 40; ++k) {
    const double f = 20.0 + 0.05 * k, phase = 0.7 * k;
    std::vector<double> x;
    for (int i = 0; i < count; ++i) x.push_back(3.0 + std::sin(two_pi * f * i * dt + phase));
    EXPECT_NEAR(strongest_frequency(x, dt), f, 0.047 / (count * dt)) << f;
  }
}

}  // namespace tdbd::simulation::diagnosis_test
