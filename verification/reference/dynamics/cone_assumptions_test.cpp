#include "bit/cone/cone_assumptions.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "bit/cone/cone_measures.hpp"
#include "core/observed_order.hpp"
#include "reference/dynamics/jointed_bodies.hpp"

namespace tdbd::reference::cone_assumptions_test {

constexpr double pi = std::numbers::pi;
constexpr double bit_speed = 4.0 * pi;  ///< rad/s
constexpr double cone_ratio = -1.4;
constexpr double heavy = 1e6;  ///< of the cone: the bit's turn stays steady to a millionth
/// Second order in the smallest asymmetry, 1 %; scale: the predicted amplitude.
constexpr double leading_order = 0.0085;

/// What is wrong with the cone.
enum class Fault { asymmetry, centre, tilt };

mesh::TriangleMesh box(const Vec3& half) {
  mesh::TriangleMesh m;
  for (int k = 0; k < 8; ++k)
    m.positions.push_back(
        half.cwiseProduct(Vec3(2 * (k & 1) - 1, 2 * ((k >> 1) & 1) - 1, 2 * (k >> 2) - 1)));
  m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return m;
}

/// A bit whose only cone is a box on a journal, 0.8 rad from the bit's axis; symmetric but for a
/// fault of size `amount`.
bit::Bit boxed(Fault fault, double amount) {
  constexpr double side = 0.05;
  bit::Bit b;
  bit::Cone cone;
  cone.name = "cone-1";
  cone.X_BK.R = Eigen::AngleAxisd(0.8, Vec3(0.6, 0.8, 0.0)).toRotationMatrix();
  cone.X_BK.p = Vec3(0.07, -0.02, 0.01);
  b.cones.push_back(cone);
  bit::Part part;
  part.cone = 0;
  part.density = 7850.0;
  Vec3 half(side, side, 0.5 * side);
  Pose X_KP;
  if (fault == Fault::asymmetry) half += Vec3(amount * side, -amount * side, 0.0);
  if (fault == Fault::centre) X_KP.p = Vec3(0.8 * amount * side, 0.6 * amount * side, 0.0);
  if (fault == Fault::tilt) X_KP.R = Eigen::AngleAxisd(amount, Vec3::UnitY()).toRotationMatrix();
  part.mesh_P = box(half);
  part.X_BP = cone.X_BK * X_KP;
  b.parts.push_back(part);
  return b;
}

/// The same cone in a bearing of a body that is too heavy to feel it.
JointedBit jointed(const bit::Bit& b) {
  const bit::ConeMass m = bit::cone_mass(b, 0);
  const Pose& X_BK = b.cones[0].X_BK;
  JointedBit j;
  j.body = {heavy * m.body_K.mass, Vec3::Zero(), heavy * m.axial_inertia * Mat3::Identity()};
  JointedCone c;
  c.mass = m.body_K.mass;
  c.axis_B = X_BK.R.col(2);
  c.bearing_B = X_BK.p;
  c.offset = m.body_K.centre.z();
  c.off_axis_B = X_BK.R * Vec3(m.body_K.centre.x(), m.body_K.centre.y(), 0.0);
  c.asymmetry_B = X_BK.R * m.body_K.inertia * X_BK.R.transpose();
  j.cones.push_back(c);
  j.loads.resize(1);
  return j;
}

/// Amplitude, at `times` the cone's frequency, of the torque that changes pi = Ic (phi' + s . W):
/// from the momentum at 16 times of one turn of the cone.
double torque_amplitude(const bit::Bit& b, int times) {
  constexpr int samples = 16;
  const JointedBit j = jointed(b);
  const double ic = bit::cone_mass(b, 0).axial_inertia, speed = bit_speed * std::abs(cone_ratio);
  std::complex<double> sum = 0.0;
  for (int k = 0; k < samples; ++k) {
    JointedState start;
    start.w_B = Vec3(0.0, 0.0, bit_speed);
    start.spins = {bit_speed * cone_ratio};
    const double t = 2.0 * pi / speed * (k + 0.5) / samples;
    const JointedState end = jointed_run(j, start, t).state;
    const double momentum = ic * (end.spins[0] + j.cones[0].axis_B.dot(end.w_B));
    sum += momentum * std::polar(1.0, times * speed * t);
  }
  return 2.0 / samples * std::abs(sum) * times * speed;
}

/// Five sizes of a fault, halved: the torque falls with order 1 and tends to the predicted one.
void expect_predicted(Fault fault, int times) {
  std::vector<double> sizes, torques;
  for (double size = 0.08; sizes.size() < 5; size /= 2.0) {
    const bit::Bit b = boxed(fault, size);
    sizes.push_back(size);
    torques.push_back(torque_amplitude(b, times));
    const double bound = bit::cone_assumptions(b, 0, bit_speed, cone_ratio).torque_error;
    EXPECT_LT(torques.back(), bound * (1.0 + size));  // what is left out is of second order
    std::printf("fault %.3f: torque %.6e N m, predicted %.6e N m\n", size, torques.back(), bound);
  }
  const double predicted =
      bit::cone_assumptions(boxed(fault, sizes.back()), 0, bit_speed, cone_ratio).torque_error;
  EXPECT_NEAR(torques.back() / predicted, 1.0, leading_order);
  const double order = least_squares_order(sizes, torques);
  std::printf("observed order %.3f\n", order);
  EXPECT_NEAR(order, 1.0, 0.05);
}

TEST(ConeAssumptions, asymmetry_drives_the_cone_twice_a_turn_as_predicted) {
  expect_predicted(Fault::asymmetry, 2);
}

TEST(ConeAssumptions, a_centre_off_the_axis_drives_the_cone_once_a_turn_as_predicted) {
  expect_predicted(Fault::centre, 1);
}

TEST(ConeAssumptions, a_tilted_principal_axis_drives_the_cone_once_a_turn_as_predicted) {
  expect_predicted(Fault::tilt, 1);
}

/// A ball of the box's mass does not feel where its axis is: nothing to predict, nothing found.
TEST(ConeAssumptions, of_a_symmetric_cone_are_nothing) {
  const bit::Bit b = boxed(Fault::asymmetry, 0.0);
  const bit::ConeAssumptions a = bit::cone_assumptions(b, 0, bit_speed, cone_ratio);
  const double scale = bit::cone_mass(b, 0).axial_inertia * bit_speed * bit_speed;
  EXPECT_LT(a.torque_error, 1e-14 * scale);
  EXPECT_LT(torque_amplitude(b, 1), 1e-12 * scale);
  EXPECT_LT(torque_amplitude(b, 2), 1e-12 * scale);
}

/// Closed forms: m e phi'^2, m g e, and the share of the inertia about the bit's axis.
TEST(ConeAssumptions, are_forces_and_shares_in_closed_form) {
  const double amount = 0.02, e = amount * 0.05;
  const bit::Bit b = boxed(Fault::centre, amount);
  const bit::ConeAssumptions a = bit::cone_assumptions(b, 0, bit_speed, cone_ratio);
  const double mass = 7850.0 * 0.1 * 0.1 * 0.05, speed = 4.0 * pi * 1.4;
  EXPECT_NEAR(a.unbalance_force, mass * e * speed * speed, 1e-12);
  EXPECT_NEAR(a.unbalance_share, e * speed * speed / 9.80665, 1e-12);
  EXPECT_NEAR(a.gravity_torque, mass * 9.80665 * e, 1e-14);
  EXPECT_NEAR(a.frequency, speed / (2.0 * pi), 1e-14);
  EXPECT_GT(a.modulation_once, 0.0);
  EXPECT_LT(a.modulation_twice, 0.007 * a.modulation_once);
}

}  // namespace tdbd::reference::cone_assumptions_test
