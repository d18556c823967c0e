#include "reference/simulation/rolled_bit.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::reference {
namespace {

Mat3 about_z(double angle) { return Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix(); }

/// A tooth in space: its centre, and the axis and origin of its cone.
struct PlacedTooth {
  Vec3 centre_W, axis_W, origin_W;
};

PlacedTooth placed(const RolledBit& bit, const RolledState& s, std::size_t k, std::size_t tooth) {
  const RolledCone& cone = bit.cones[k];
  const Mat3 R = about_z(s.turned);
  const Vec3 down(0.0, 0.0, s.height);
  return {R * (cone.X_BK * (about_z(s.angles[k]) * cone.centres_K[tooth])) + down,
          R * cone.X_BK.R.col(2), R * cone.X_BK.p + down};
}

Vec3 velocity_of(const RolledBit& bit, const RolledState& s, std::size_t k, const PlacedTooth& t,
                 const Vec3& x_W) {
  return Vec3(0.0, 0.0, s.rate) + rotary_speed(bit, s) * Vec3::UnitZ().cross(x_W) +
         cone_speed(bit, s, k) * t.axis_W.cross(x_W - t.origin_W);
}

/// Calls `visit` for every column of the grid below a sphere, with the sphere's lower surface
/// there, if that may be below the rock. The rock is never above z = 0.
template <class Visit>
void visit_columns(const RockGrid& rock, const Vec3& centre, double radius, const Visit& visit) {
  const double high = std::max(0.0, -centre.z());
  const double reach = std::sqrt(std::max(0.0, radius * radius - high * high));
  for (int i = rock.index(centre.x() - reach); i <= rock.index(centre.x() + reach) + 1; ++i)
    for (int j = rock.index(centre.y() - reach); j <= rock.index(centre.y() + reach) + 1; ++j) {
      const double x = rock.place(i) - centre.x(), y = rock.place(j) - centre.y();
      const double down2 = radius * radius - x * x - y * y;
      if (down2 > 0.0) visit(i, j, Vec3(x, y, std::sqrt(down2)));
    }
}

/// The force on a tooth, N, and its point of application.
struct ToothForce {
  Vec3 force_W = Vec3::Zero(), point_W = Vec3::Zero();
};

ToothForce force_on(const RolledBit& bit, const RockGrid& rock, const RolledState& s, std::size_t k,
                    const PlacedTooth& t) {
  constexpr double touching = 1e-12;  // m
  ToothForce f;
  if (t.centre_W.z() + bit.tooth_radius <= 0.0) return f;
  const Vec3 middle_v = velocity_of(bit, s, k, t, t.centre_W);
  double area = 0.0;
  Vec3 area_vector = Vec3::Zero(), moment = Vec3::Zero();
  visit_columns(rock, t.centre_W, bit.tooth_radius, [&](int i, int j, const Vec3& arm) {
    if (t.centre_W.z() + arm.z() < rock.height(i, j) - touching || arm.dot(middle_v) < 0.0) return;
    const double part = rock.spacing() * rock.spacing() * bit.tooth_radius / arm.z();
    area += part;
    area_vector += part / bit.tooth_radius * arm;
    moment += part * arm;
  });
  if (area == 0.0) return f;
  const Vec3 n = area_vector.normalized();
  f.point_W = t.centre_W + moment / area;
  const Vec3 v = velocity_of(bit, s, k, t, f.point_W), slip = v - v.dot(n) * n;
  const double pressed = bit.pressure * area_vector.norm() *
                         std::clamp(v.dot(n) / bit.contact.crushing_speed, 0.0, 1.0);
  f.force_W =
      -pressed * (n + bit.contact.mu * slip / std::hypot(slip.norm(), bit.contact.slip_speed));
  return f;
}

RolledState rates(const RolledBit& bit, const AxialString& string, const RockGrid& rock,
                  const RolledState& s) {
  const RolledLoads loads = rolled_loads(bit, rock, s);
  const double speed = rotary_speed(bit, s);
  RolledState d = s;
  d.time = 1.0;
  d.height = s.rate;
  d.rate = (string.load - string.damping * (s.rate - string.rate) - loads.weight) / string.mass;
  d.turned = speed;
  d.momentum = string.stiffness * (string.start_angle + string.speed * s.time - s.turned) +
               string.turn_damping * (string.speed - speed) - loads.torque;
  d.spent = loads.power;
  for (std::size_t k = 0; k < bit.cones.size(); ++k) d.angles[k] = cone_speed(bit, s, k);
  d.spins = loads.cones;
  return d;
}

RolledState moved(const RolledState& s, const RolledState& rate, double h) {
  RolledState to = s;
  to.time += h * rate.time;
  to.height += h * rate.height;
  to.rate += h * rate.rate;
  to.turned += h * rate.turned;
  to.momentum += h * rate.momentum;
  to.spent += h * rate.spent;
  for (std::size_t k = 0; k < s.angles.size(); ++k) {
    to.angles[k] += h * rate.angles[k];
    to.spins[k] += h * rate.spins[k];
  }
  return to;
}

}  // namespace

RockGrid::RockGrid(double half_side, double spacing)
    : spacing_(spacing), half_(static_cast<int>(std::ceil(half_side / spacing)) + 2) {
  const auto side = static_cast<std::size_t>(2 * half_ + 1);
  heights_.assign(side * side, 0.0);
}

int RockGrid::index(double x) const { return static_cast<int>(std::floor(x / spacing_)) + half_; }

double& RockGrid::height(int i, int j) {
  return heights_.at(static_cast<std::size_t>(i) * static_cast<std::size_t>(2 * half_ + 1) +
                     static_cast<std::size_t>(j));
}

double RockGrid::height(int i, int j) const {
  return heights_.at(static_cast<std::size_t>(i) * static_cast<std::size_t>(2 * half_ + 1) +
                     static_cast<std::size_t>(j));
}

double rotary_speed(const RolledBit& bit, const RolledState& s) {
  double body = s.momentum;
  for (std::size_t k = 0; k < bit.cones.size(); ++k) body -= s.spins[k] * bit.cones[k].X_BK.R(2, 2);
  return body / bit.carrier_inertia;
}

double cone_speed(const RolledBit& bit, const RolledState& s, std::size_t k) {
  const RolledCone& cone = bit.cones[k];
  return s.spins[k] / cone.axial_inertia - cone.X_BK.R(2, 2) * rotary_speed(bit, s);
}

RolledLoads rolled_loads(const RolledBit& bit, const RockGrid& rock, const RolledState& s) {
  RolledLoads loads;
  loads.cones.assign(bit.cones.size(), 0.0);
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    for (std::size_t tooth = 0; tooth < bit.cones[k].centres_K.size(); ++tooth) {
      const PlacedTooth t = placed(bit, s, k, tooth);
      const ToothForce f = force_on(bit, rock, s, k, t);
      if (f.force_W.isZero(0.0)) continue;
      loads.weight -= f.force_W.z();
      loads.torque -= f.point_W.x() * f.force_W.y() - f.point_W.y() * f.force_W.x();
      loads.cones[k] += t.axis_W.dot((f.point_W - t.origin_W).cross(f.force_W));
      loads.power -= f.force_W.dot(velocity_of(bit, s, k, t, f.point_W));
    }
  return loads;
}

void roll(const RolledBit& bit, const AxialString& string, double h, RockGrid& rock,
          RolledState& s) {
  const RolledState a = rates(bit, string, rock, s),
                    b = rates(bit, string, rock, moved(s, a, 0.5 * h)),
                    c = rates(bit, string, rock, moved(s, b, 0.5 * h)),
                    d = rates(bit, string, rock, moved(s, c, h));
  s = moved(moved(moved(moved(s, a, h / 6.0), b, h / 3.0), c, h / 3.0), d, h / 6.0);
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    for (std::size_t tooth = 0; tooth < bit.cones[k].centres_K.size(); ++tooth) {
      const PlacedTooth t = placed(bit, s, k, tooth);
      if (t.centre_W.z() + bit.tooth_radius <= 0.0) continue;
      visit_columns(rock, t.centre_W, bit.tooth_radius, [&](int i, int j, const Vec3& arm) {
        rock.height(i, j) = std::max(rock.height(i, j), t.centre_W.z() + arm.z());
      });
    }
}

}  // namespace tdbd::reference
