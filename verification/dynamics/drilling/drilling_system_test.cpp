#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/error.hpp"
#include "verification/dynamics/drilling/coupled_bit.hpp"

namespace tdbd::dynamics::drilling_system_test {

std::string problem(const std::function<void(DrillingSystem&)>& spoil) {
  DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  spoil(s);
  const std::string why = drilling_problem(s);
  if (!why.empty()) {
    EXPECT_THROW(make_drilling_system(s), InputError);
  }
  return why;
}

TEST(DrillingSystem, refuses_what_is_no_system) {
  using S = DrillingSystem;
  EXPECT_EQ(problem([](S&) {}), "");
  EXPECT_EQ(problem([](S& s) { s.mass = 0.0; }), "a mass of 0 kg");
  EXPECT_EQ(problem([](S& s) { s.gravity = std::nan(""); }), "gravity of nan m/s2");
  EXPECT_EQ(problem([](S& s) { s.integrator.order = 4; }),
            "an integrator of order 4: drilling has order 2");
  EXPECT_EQ(problem([](S& s) { s.string.stiffness(0, 1) += 1.0; }),
            "a string's stiffness that is not symmetric");
  EXPECT_EQ(problem([](S& s) { s.string.turn_damping = Vec3(1, 1, -2).asDiagonal(); }),
            "a string's damping in turning that is not positive: principal value -2");
  EXPECT_EQ(problem([](S& s) { s.string.damping(0, 0) = INFINITY; }),
            "a string's damping that is not finite");
  EXPECT_EQ(problem([](S& s) { s.wall.restitution = 1.01; }),
            "a wall's restitution of 1.01: at most 1");
  EXPECT_EQ(problem([](S& s) { s.wall.friction = -0.1; }), "a wall's friction of -0.1");
  EXPECT_EQ(problem([](S& s) { s.bearing_damping = {1.0}; }), "1 bearing dampings for 2 cones");
  EXPECT_EQ(problem([](S& s) { s.rock.damping = -1.0; }), "a rock mount's damping of -1");
}

/// Every number of wall, rock and bearings must be finite and not negative; 0 is none, and fine.
TEST(DrillingSystem, refuses_a_number_that_is_negative_or_none) {
  using Of = std::function<double&(DrillingSystem&)>;
  const std::vector<std::pair<std::string, Of>> numbers{
      {"a wall's stiffness", [](auto& s) -> double& { return s.wall.stiffness; }},
      {"a wall's clearance", [](auto& s) -> double& { return s.wall.clearance; }},
      {"a wall's ring of radius", [](auto& s) -> double& { return s.wall.ring_radius; }},
      {"a wall's restitution", [](auto& s) -> double& { return s.wall.restitution; }},
      {"a wall's friction", [](auto& s) -> double& { return s.wall.friction; }},
      {"a wall's slip speed", [](auto& s) -> double& { return s.wall.slip_speed; }},
      {"a top's following time", [](auto& s) -> double& { return s.top.following_time; }},
      {"a rock's mass", [](auto& s) -> double& { return s.rock.mass; }},
      {"a rock mount's stiffness", [](auto& s) -> double& { return s.rock.stiffness; }},
      {"a rock mount's damping", [](auto& s) -> double& { return s.rock.damping; }},
      {"a bearing's damping", [](auto& s) -> double& { return s.bearing_damping[1]; }}};
  for (const auto& [name, of] : numbers) {
    EXPECT_EQ(problem([&](DrillingSystem& s) { of(s) = 0.0; }), "") << name;
    EXPECT_EQ(problem([&](DrillingSystem& s) { of(s) = -1e-9; }), name + " of -1e-09");
    EXPECT_EQ(problem([&](DrillingSystem& s) { of(s) = INFINITY; }), name + " of inf");
  }
}

/// Each matrix and each vector by its name; a wall may give all back.
TEST(DrillingSystem, names_what_is_not_finite_or_not_positive) {
  using S = DrillingSystem;
  EXPECT_EQ(problem([](S& s) { s.mass = INFINITY; }), "a mass of inf kg");
  EXPECT_EQ(problem([](S& s) { s.centre_B.y() = INFINITY; }),
            "a centre of mass that is not finite");
  EXPECT_EQ(problem([](S& s) { s.wall.restitution = 1.0; }), "");
  for (const auto& [matrix, name] :
       {std::pair{&DrillString::stiffness, "a string's stiffness"},
        {&DrillString::damping, "a string's damping"},
        {&DrillString::turn_stiffness, "a string's stiffness in turning"},
        {&DrillString::turn_damping, "a string's damping in turning"}}) {
    const std::string that = std::string(name) + " that is not ";
    EXPECT_EQ(problem([&](S& s) { (s.string.*matrix)(1, 2) = INFINITY; }), that + "finite");
    EXPECT_EQ(problem([&](S& s) { (s.string.*matrix)(1, 2) += 1.0; }), that + "symmetric");
    EXPECT_EQ(problem([&](S& s) { s.string.*matrix = Vec3(-3.0, 1.0, 1.0).asDiagonal(); }),
              that + "positive: principal value -3");
  }
  for (Vec3 DrillString::*const place : {&DrillString::attachment_B, &DrillString::rest_W})
    EXPECT_EQ(problem([&](S& s) { (s.string.*place).x() = INFINITY; }),
              "a string's attachment or rest that is not finite");
}

/// What is negative by rounding alone is so beside the matrix's largest element.
TEST(DrillingSystem, tells_rounding_by_the_size_of_the_matrix) {
  const auto with = [](double size, double least) {
    return problem([&](DrillingSystem& s) {
      s.string.stiffness = Vec3(size, size, least * size).asDiagonal();
    });
  };
  for (const double size : {1e-9, 1.0, 1e9}) {
    EXPECT_EQ(with(size, -1e-10), "");
    EXPECT_NE(with(size, -1e-8), "");
  }
}

/// A stiff spring along one way has none across it but for rounding, whatever its unit.
TEST(DrillingSystem, takes_a_spring_along_one_way) {
  const Vec3 way = Vec3(0.3, -0.5, 0.7).normalized();
  for (const double stiffness : {1e-6, 1.0, 1e6, 1e14})
    EXPECT_EQ(
        problem([&](DrillingSystem& s) { s.string.stiffness = stiffness * way * way.transpose(); }),
        "")
        << stiffness;
}

/// A damping without coupling is its own principal form: along x, y, z in this order, exactly.
TEST(DrillingSystem, uncoupled_dampers_stay_as_given) {
  DrillingSystem s = plain_bit();
  s.string.damping = Vec3(30.0, 10.0, 20.0).asDiagonal();
  s.string.turn_damping = Vec3(2.0, 3.0, 1.0).asDiagonal();
  s = make_drilling_system(s);
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    EXPECT_EQ(s.dampers[k].axis_W, Vec3(Vec3::Unit(i)));
    EXPECT_EQ(s.dampers[k].coefficient, s.string.damping(i, i));
    EXPECT_EQ(s.turn_dampers[k].axis_W, Vec3(Vec3::Unit(i)));
    EXPECT_EQ(s.turn_dampers[k].coefficient, s.string.turn_damping(i, i));
  }
}

TEST(DrillingSystem, state_is_made_of_pose_and_velocities) {
  const DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  const Pose X_WB{Eigen::AngleAxisd(0.3, Vec3(0.6, 0.0, 0.8)).toRotationMatrix(), Vec3(1, 2, 3)};
  const DrillingVelocity v{Vec3(0.1, 0.2, 0.3), Vec3(-1.0, 2.0, 7.0), {4.0, -5.0}, 0.01};
  const DrillingState x = make_drilling_state(s, X_WB, v, std::vector<double>{0.5, 0.6});
  EXPECT_LT((bit_pose(s, x).R - X_WB.R).norm(), 1e-14);
  EXPECT_LT((bit_pose(s, x).p - X_WB.p).norm(), 1e-14);
  const DrillingVelocity found = velocity(s, x);
  EXPECT_LT((found.v_W - v.v_W).norm() + (found.w_W - v.w_W).norm(), 1e-13);
  EXPECT_NEAR(found.cone_rates[1], -5.0, 1e-13);
  EXPECT_NEAR(found.rock, 0.01, 1e-16);
  EXPECT_EQ(x.rotation.cone_angles[1], 0.6);
}

/// The moments are proportional to the stiffness, to the bit, however weak it is.
TEST(DrillingSystem, weak_string_turns_back_in_proportion) {
  DrillingSystem s = coupled_bit(AxialMode::rate, DamperEnd::space);
  const DrillingState x = coupled_start(s);
  Configuration strong, weak;
  configure(s, x, strong);
  s.string.turn_stiffness *= 0x1p-40;
  configure(s, x, weak);
  EXPECT_GT(strong.pull.turn_W.norm(), 1.0);
  EXPECT_EQ(weak.pull.turn_W, 0x1p-40 * strong.pull.turn_W);
  EXPECT_EQ(weak.pull.twist_moment, 0x1p-40 * strong.pull.twist_moment);
}

/// Upside down a string's angles are not defined; a bit that none turns back may pass there.
TEST(DrillingSystem, bit_without_stiffness_may_turn_over) {
  DrillingSystem s = plain_bit();
  s.string.turn_stiffness.setZero();
  DrillingState x = at_rest(s);
  x.rotation.q_WB = Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0);
  Configuration over;
  configure(s, x, over);
  EXPECT_EQ(over.pull.turn_W, Vec3::Zero());
  EXPECT_EQ(over.pull.twist_moment, 0.0);
  EXPECT_TRUE(std::isfinite(over.pull.energy));
}

/// The bit hangs still on a coupled string from the first step on.
TEST(DrillingSystem, string_hung_by_the_bits_weight_is_at_rest) {
  DrillingSystem s = plain_bit();
  s.gravity = 9.81;
  s.string.stiffness = coupled(Vec3(4e5, 5e5, 7e5), 0.3);
  s = make_drilling_system(s);
  s.string.rest_W = hanging_rest_W(s, at_rest(s));
  DrillingRun d = start(s, nullptr, at_rest(s));
  for (int i = 0; i < 1000; ++i) step(s, nullptr, 1e-3, d);
  EXPECT_LT(d.state.c_W.norm(), 1e-15);
}

}  // namespace tdbd::dynamics::drilling_system_test
