#include "reference/simulation/axial_bit.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::reference {
namespace {

/// The part of a face that is in rock. Frame B.
struct Engaged {
  double area = 0.0, edge = 0.0, attack = 0.0;  ///< m2, m, m rad
  Vec3 area_moment_B = Vec3::Zero(), edge_moment_B = Vec3::Zero();
};

/// Velocity of a point of the bit, in the bit's frame.
Vec3 velocity_at(const AxialState& s, const Vec3& x_B) {
  return {-s.speed * x_B.y(), s.speed * x_B.x(), s.rate};
}

/// The rock of a column that the face meets. Parts of the face that do not move forwards are
/// omitted.
struct Met {
  double up, deep;
};

Met met(const Columns& bit, std::size_t k, const Column& c, const HeightHistory& history,
        const AxialState& s) {
  const RockInColumn rock = rock_in_column(c, bit.marks, history, s.turned, s.height);
  const double forward = bit.cutters[k].X_BF.R.col(0).dot(velocity_at(s, c.foot_B));
  // m, lever arm of the motion about the axis
  const double arm = s.speed > 0.0 ? forward / s.speed : 1.0;
  return {rock.up, std::min(rock.deep, arm)};
}

/// Sums trapezoids between columns. If one of two columns is outside the rock, only the part in
/// rock counts.
Engaged engaged(const Columns& bit, std::size_t k, const HeightHistory& history,
                const AxialState& s) {
  const Vec3 forward = bit.cutters[k].X_BF.R.col(0), up = bit.cutters[k].X_BF.R.col(2);
  const std::vector<Column>& columns = bit.columns[k];
  Engaged e;
  if (columns.empty()) return e;
  Met last = met(bit, k, columns[0], history, s);
  for (std::size_t i = 1; i < columns.size(); ++i) {
    const Column *a = &columns[i - 1], *b = &columns[i];
    Met at_a = last, at_b = last = met(bit, k, *b, history, s);
    if (at_a.deep <= 0.0 && at_b.deep <= 0.0) continue;
    if (at_a.deep <= 0.0) {
      std::swap(a, b);
      std::swap(at_a, at_b);
    }
    const double in = at_b.deep > 0.0 ? 1.0 : at_a.deep / (at_a.deep - at_b.deep);
    const Vec3 end_B = a->foot_B + in * (b->foot_B - a->foot_B), foot_B = 0.5 * (a->foot_B + end_B);
    const double high = 0.5 * (at_a.up + (at_b.deep > 0.0 ? at_b.up : 0.0));
    const double area = high * in * std::abs(b->y - a->y), edge = (end_B - a->foot_B).norm();
    const Vec3 v_B = velocity_at(s, foot_B);
    e.area += area;
    e.area_moment_B += area * (foot_B + 0.5 * high * up);
    e.edge += edge;
    e.edge_moment_B += edge * foot_B;
    if (v_B.norm() > 0.0)
      e.attack += edge * std::asin(std::clamp(forward.dot(v_B) / v_B.norm(), -1.0, 1.0));
  }
  return e;
}

void add(const Vec3& force_B, const Vec3& x_B, AxialLoads& loads) {
  loads.weight -= force_B.z();
  loads.torque -= x_B.x() * force_B.y() - x_B.y() * force_B.x();
}

void add_face(const RoundCutter& cutter, const Engaged& e, const EdgeLaw& law, const AxialState& s,
              AxialLoads& loads) {
  const Vec3 x_B = e.area_moment_B / e.area, v_B = velocity_at(s, x_B);
  const double speed = v_B.norm();
  const double ahead =
      speed > 0.0 ? std::clamp(cutter.X_BF.R.col(0).dot(v_B) / speed, 0.0, 1.0) : 1.0;
  const EdgeForce f = law({true, e.area * ahead, e.edge, std::acos(ahead), speed});
  add(directed(f, v_B, cutter.normal_B), x_B, loads);
}

void add_chamfer(const RoundCutter& cutter, const Engaged& e, const EdgeLaw& law,
                 const AxialState& s, AxialLoads& loads) {
  const Vec3 x_B = e.edge_moment_B / e.edge, v_B = velocity_at(s, x_B);
  const double attack = e.attack / e.edge;  // the complement of the rake
  const double width =
      cutter.chamfer_depth * std::sin(attack) + cutter.chamfer_width * std::cos(attack);
  const EdgeForce f = law({false, e.edge * width, e.edge, 0.0, v_B.norm()});
  add(directed(f, v_B, cutter.normal_B), x_B, loads);
}

AxialState moved(const AxialState& s, const AxialState& rate, double h) {
  return {s.time + h,
          s.height + h * rate.height,
          s.rate + h * rate.rate,
          s.end_rate + h * rate.end_rate,
          s.turned + h * rate.turned,
          s.speed + h * rate.speed,
          s.spent + h * rate.spent};
}

}  // namespace

AxialLoads axial_loads(const Columns& bit, const EdgeLaw& law, const HeightHistory& history,
                       const AxialState& s) {
  AxialLoads loads;
  for (std::size_t k = 0; k < bit.cutters.size(); ++k) {
    const Engaged e = engaged(bit, k, history, s);
    if (e.area <= 0.0) continue;
    add_face(bit.cutters[k], e, law, s, loads);
    add_chamfer(bit.cutters[k], e, law, s, loads);
  }
  return loads;
}

AxialRun::AxialRun(const Columns& bit, EdgeLaw law, const AxialString& string,
                   const AxialState& start, int bins_per_turn)
    : bit_(bit), law_(std::move(law)), string_(string), state_(start), history_(bins_per_turn) {
  state_.end_rate = string.rate;
}

AxialState AxialRun::rates(const AxialState& s) const {
  const AxialLoads rock = axial_loads(bit_, law_, history_, s);
  const AxialString& t = string_;
  const double force = t.load - t.damping * (s.rate - s.end_rate) - rock.weight;
  const double twist = t.start_angle + t.speed * s.time - s.turned;
  const double torque = t.stiffness * twist + t.turn_damping * (t.speed - s.speed) - rock.torque;
  return {1.0,
          s.rate,
          force / t.mass,
          t.following_time > 0.0 ? (s.rate - s.end_rate) / t.following_time : 0.0,
          s.speed,
          torque / t.inertia,
          rock.weight * s.rate + rock.torque * s.speed};
}

void AxialRun::step(double h) {
  const AxialState a = rates(state_), b = rates(moved(state_, a, 0.5 * h)),
                   c = rates(moved(state_, b, 0.5 * h)), d = rates(moved(state_, c, h));
  AxialState next = moved(state_, a, h / 6.0);
  next = moved(next, b, h / 3.0);
  next = moved(next, c, h / 3.0);
  next = moved(next, d, h / 6.0);
  state_ = next;
  history_.pass(state_.turned, state_.height);
}

}  // namespace tdbd::reference
