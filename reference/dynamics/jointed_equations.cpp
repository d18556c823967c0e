#include "reference/dynamics/jointed_equations.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "reference/dynamics/cross_matrix.hpp"

namespace tdbd::reference {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Accelerations of body i are at the indices 6 i (centre) and 6 i + 3 (angular).
Index centre_at(std::size_t i) { return 6 * static_cast<Index>(i); }
Index turn_at(std::size_t i) { return centre_at(i) + 3; }

/// The linear system M a = f, G a = gamma during assembly.
struct System {
  MatrixXd M, G;
  VectorXd f, gamma;
  Index rows = 0;  ///< number of filled rows of G
};

/// Adds sign times the acceleration of the point at r_W from body i's centre to three rows: a +
/// alpha x r + w x (w x r).
void add_point(System& s, Index row, std::size_t i, const BodyMotion& m, const Vec3& r_W,
               double sign) {
  s.G.block<3, 3>(row, centre_at(i)) = sign * Mat3::Identity();
  s.G.block<3, 3>(row, turn_at(i)) = -sign * cross_matrix(r_W);
  s.gamma.segment<3>(row) -= sign * m.w_W.cross(m.w_W.cross(r_W));
}

/// Requires that the cone's axis s stays perpendicular to u, which is fixed in the body: the second
/// derivative of s . u, whose first derivative is (w_cone - w_body) . (s x u).
void add_square(System& s, std::size_t cone, const BodyMotion& body_motion,
                const BodyMotion& cone_motion, const Vec3& axis_W, const Vec3& u_W) {
  const Vec3 normal = axis_W.cross(u_W);
  const Vec3 normal_rate =
      cone_motion.w_W.cross(axis_W).cross(u_W) + axis_W.cross(body_motion.w_W.cross(u_W));
  s.G.block<1, 3>(s.rows, turn_at(cone)) = normal.transpose();
  s.G.block<1, 3>(s.rows, turn_at(0)) = -normal.transpose();
  s.gamma[s.rows] = -(cone_motion.w_W - body_motion.w_W).dot(normal_rate);
  ++s.rows;
}

void add_bearing(System& s, const JointedBit& bit, const std::vector<RigidBody>& all,
                 const std::vector<BodyMotion>& m, std::size_t k) {
  const JointedCone& cone = bit.cones[k];
  const std::size_t i = k + 1;
  const Mat3 R_body = attitude(m[0]), R_cone = attitude(m[i]);
  add_point(s, s.rows, 0, m[0], R_body * (cone.bearing_B - all[0].centre_B), 1.0);
  add_point(s, s.rows, i, m[i], R_cone * (cone.bearing_B - all[i].centre_B), -1.0);
  s.rows += 3;
  const Vec3 u_B = cone.axis_B.unitOrthogonal();
  const Vec3 axis_W = R_cone * cone.axis_B;
  add_square(s, i, m[0], m[i], axis_W, R_body * u_B);
  add_square(s, i, m[0], m[i], axis_W, R_body * cone.axis_B.cross(u_B));
}

/// Inertia, gyroscopic torque, weight.
void add_body(System& s, std::size_t i, const RigidBody& b, const BodyMotion& m, double gravity) {
  const Mat3 inertia_W = space_inertia(b, m);
  s.M.block<3, 3>(centre_at(i), centre_at(i)) = b.mass * Mat3::Identity();
  s.M.block<3, 3>(turn_at(i), turn_at(i)) = inertia_W;
  s.f.segment<3>(centre_at(i)) = b.mass * gravity * Vec3::UnitZ();
  s.f.segment<3>(turn_at(i)) = -m.w_W.cross(inertia_W * m.w_W);
}

/// Internal loads act on the cone and, with opposite sign, on the body. External loads act on the
/// cone alone.
void add_loads(System& s, const JointedBit& bit, const std::vector<BodyMotion>& m) {
  const Mat3 R_body = attitude(m[0]);
  s.f.segment<3>(turn_at(0)) += R_body * bit.torque_B;
  for (std::size_t k = 0; k < bit.loads.size(); ++k) {
    const Vec3 axis_W = R_body * bit.cones[k].axis_B;
    const dynamics::ConeLoad& load = bit.loads[k];
    const double spin = (m[k + 1].w_W - m[0].w_W).dot(axis_W);
    const double from_bit = load.internal - load.damping * spin;
    s.f.segment<3>(turn_at(k + 1)) += (from_bit + load.external) * axis_W;
    s.f.segment<3>(turn_at(0)) -= from_bit * axis_W;
  }
}

System empty_system(const JointedBit& bit) {
  const Index n = 6 * static_cast<Index>(bit.cones.size() + 1);
  const Index rows =
      5 * static_cast<Index>(bit.cones.size()) + (bit.mount == Mount::pinned ? 3 : 0);
  return {MatrixXd::Zero(n, n), MatrixXd::Zero(rows, n), VectorXd::Zero(n), VectorXd::Zero(rows)};
}

/// Solves the whole system, including multipliers, for the accelerations.
VectorXd solve(const System& s) {
  const Index n = s.M.rows(), rows = s.G.rows();
  MatrixXd A = MatrixXd::Zero(n + rows, n + rows);
  A << s.M, s.G.transpose(), s.G, MatrixXd::Zero(rows, rows);
  VectorXd b(n + rows);
  b << s.f, s.gamma;
  return A.fullPivLu().solve(b).head(n);
}

VectorXd accelerations(const JointedBit& bit, const std::vector<BodyMotion>& m) {
  const std::vector<RigidBody> all = bodies(bit);
  System s = empty_system(bit);
  for (std::size_t i = 0; i < all.size(); ++i) add_body(s, i, all[i], m[i], bit.gravity);
  add_loads(s, bit, m);
  for (std::size_t k = 0; k < bit.cones.size(); ++k) add_bearing(s, bit, all, m, k);
  if (bit.mount == Mount::pinned)
    add_point(s, s.rows, 0, m[0], -(attitude(m[0]) * all[0].centre_B), 1.0);
  return solve(s);
}

/// d/dt of an assembly, as an assembly.
Assembly rates(const JointedBit& bit, const Assembly& a) {
  const VectorXd acceleration = accelerations(bit, a.motions);
  Assembly d = a;
  for (std::size_t i = 0; i < a.motions.size(); ++i) {
    const BodyMotion& m = a.motions[i];
    const Eigen::Quaterniond half_w(0.0, 0.5 * m.w_W.x(), 0.5 * m.w_W.y(), 0.5 * m.w_W.z());
    d.motions[i] = {m.v_W, half_w * m.q_WB, acceleration.segment<3>(centre_at(i)),
                    acceleration.segment<3>(turn_at(i))};
  }
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    d.cone_angles[k] =
        (a.motions[k + 1].w_W - a.motions[0].w_W).dot(attitude(a.motions[0]) * bit.cones[k].axis_B);
  return d;
}

}  // namespace

std::vector<RigidBody> bodies(const JointedBit& bit) {
  std::vector<RigidBody> all{bit.body};
  for (const JointedCone& c : bit.cones) {
    const Mat3 along = c.axis_B * c.axis_B.transpose();
    all.push_back({c.mass, c.bearing_B + c.offset * c.axis_B + c.off_axis_B,
                   c.axial_inertia * along + c.transverse_inertia * (Mat3::Identity() - along) +
                       c.asymmetry_B});
  }
  return all;
}

Mat3 attitude(const BodyMotion& m) { return m.q_WB.normalized().toRotationMatrix(); }

Mat3 space_inertia(const RigidBody& b, const BodyMotion& m) {
  return attitude(m) * b.inertia_B * attitude(m).transpose();
}

std::vector<double> unknowns(const Assembly& a) {
  std::vector<double> y;
  for (const BodyMotion& m : a.motions) {
    y.insert(y.end(), m.x_W.begin(), m.x_W.end());
    y.insert(y.end(), m.q_WB.coeffs().begin(), m.q_WB.coeffs().end());
    y.insert(y.end(), m.v_W.begin(), m.v_W.end());
    y.insert(y.end(), m.w_W.begin(), m.w_W.end());
  }
  y.insert(y.end(), a.cone_angles.begin(), a.cone_angles.end());
  return y;
}

Assembly assembly_of(std::span<const double> y, std::size_t cones) {
  Assembly a;
  for (std::size_t i = 0; i <= cones; ++i) {
    const double* m = y.subspan(13 * i, 13).data();
    a.motions.push_back({Vec3(m), Eigen::Quaterniond(m + 3), Vec3(m + 7), Vec3(m + 10)});
  }
  const auto angles = y.subspan(13 * (cones + 1), cones);
  a.cone_angles.assign(angles.begin(), angles.end());
  return a;
}

RightHandSide jointed_equations(const JointedBit& bit) {
  return [bit](double, std::span<const double> y, std::span<double> dydt) {
    std::ranges::copy(unknowns(rates(bit, assembly_of(y, bit.cones.size()))), dydt.begin());
  };
}

}  // namespace tdbd::reference
