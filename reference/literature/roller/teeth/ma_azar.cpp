#include "reference/literature/roller/teeth/ma_azar.hpp"

#include <cmath>

#include "core/error.hpp"

namespace tdbd::reference {
namespace {

/// Components of a tooth's place along u and e_t, and their derivatives.
struct CircleCourse {
  Course down, across;
};

CircleCourse circle(double radius, double gamma, const Course& turn) {
  const double c = radius * std::cos(gamma), s = radius * std::sin(gamma);
  const double square = turn.rate * turn.rate;
  return {{c, -turn.rate * s, -turn.acceleration * s - square * c},
          {s, turn.rate * c, turn.acceleration * c - square * s}};
}

/// Converts coordinates in a frame that turns about z to velocity and acceleration relative to
/// space.
ToothState against_space(const Vec3& q, const Vec3& q1, const Vec3& q2, const Course& turn) {
  const double w = turn.rate, w1 = turn.acceleration;
  return {q,
          {q1.x() - w * q.y(), q1.y() + w * q.x(), q1.z()},
          {q2.x() - 2.0 * w * q1.y() - w1 * q.y() - w * w * q.x(),
           q2.y() + 2.0 * w * q1.x() + w1 * q.x() - w * w * q.y(), q2.z()}};
}

/// With given axes, so that quantities shared by the teeth of a cone are computed once.
ToothState state_on(const JournalAxes& axes, const RollerCone& cone, const ToothPlace& tooth,
                    const RollerMotion& bit, const Course& cone_turn) {
  const CircleCourse on = circle(tooth.radius, tooth.angle + cone_turn.value, cone_turn);
  const Vec3 q = Vec3(0.0, cone.offset + on.across.value, bit.depth.value + cone.elevation) -
                 tooth.along * axes.s + on.down.value * axes.u;
  const Vec3 q1 = Vec3(0.0, on.across.rate, bit.depth.rate) + on.down.rate * axes.u;
  const Vec3 q2 =
      Vec3(0.0, on.across.acceleration, bit.depth.acceleration) + on.down.acceleration * axes.u;
  return against_space(q, q1, q2, bit.turn);
}

ToothState turned_by(double cosine, double sine, const ToothState& x) {
  const auto turned = [&](const Vec3& v) {
    return Vec3(cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y(), v.z());
  };
  return {turned(x.place), turned(x.velocity), turned(x.acceleration)};
}

std::size_t count_teeth(const RollerBit& bit) {
  std::size_t n = 0;
  for (const RollerCone& cone : bit.cones)
    for (const RollerRow& row : cone.rows) n += row.angles.size();
  return n;
}

}  // namespace

Course steady_course(double start, double rate, double time) {
  return {start + rate * time, rate, 0.0};
}

ToothState tooth_state(const RollerCone& cone, const ToothPlace& tooth, const RollerMotion& bit,
                       const Course& cone_turn) {
  return state_on(journal_axes(cone), cone, tooth, bit, cone_turn);
}

ToothState in_space(const RollerCone& cone, const RollerMotion& bit, const ToothState& turning) {
  const double angle = cone.azimuth + bit.turn.value;
  return turned_by(std::cos(angle), std::sin(angle), turning);
}

CylindricalPlace cylindrical(const RollerCone& cone, const RollerMotion& bit, const Vec3& place) {
  return {std::hypot(place.x(), place.y()),
          cone.azimuth + bit.turn.value + std::atan2(place.y(), place.x()), place.z()};
}

void place_teeth(const RollerBit& bit, const RollerMotion& motion,
                 const std::vector<Course>& cone_turns, std::vector<ToothState>& teeth_W) {
  if (cone_turns.size() != bit.cones.size())
    throw InputError("Ma and Azar: found " + std::to_string(cone_turns.size()) +
                     " cone motions, expected one for each of " + std::to_string(bit.cones.size()) +
                     " cones");
  teeth_W.resize(count_teeth(bit));
  std::size_t next = 0;
  for (std::size_t k = 0; k < bit.cones.size(); ++k) {
    const RollerCone& cone = bit.cones[k];
    const JournalAxes axes = journal_axes(cone);
    const double angle = cone.azimuth + motion.turn.value;
    const double cosine = std::cos(angle), sine = std::sin(angle);
    for (const RollerRow& row : cone.rows)
      for (const double gamma : row.angles)
        teeth_W[next++] =
            turned_by(cosine, sine,
                      state_on(axes, cone, {row.along, row.radius, gamma}, motion, cone_turns[k]));
  }
}

double rolling_ratio(const RollerCone& cone, const RollerRow& row) {
  return std::cos(cone.journal_angle) * row.along / row.radius + std::sin(cone.journal_angle);
}

RowSlip slip_at_the_lowest(const RollerCone& cone, const RollerRow& row, double ratio,
                           double bit_speed) {
  return {bit_speed * (rolling_ratio(cone, row) - ratio) * row.radius, -bit_speed * cone.offset};
}

}  // namespace tdbd::reference
