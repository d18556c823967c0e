#include "string/node_flow.hpp"

#include <algorithm>

namespace tdbd::string {
namespace {

/// Time in which a force `a` (N, friction included) changes the speed of a body from one value to
/// another that it approaches.
double time_to(const DampedBody& body, double a, double from, double to) {
  if (body.damping == 0.0) return body.mass * (to - from) / a;
  return body.mass / body.damping *
         std::log1p(body.damping * (from - to) / (body.damping * to - a));
}

/// One piece of the flow with constant friction, whose force is included in `a`. It ends at speed
/// `stop` or after `time`. Returns the speed and subtracts the elapsed time from `time`.
double piece(const DampedBody& body, double a, double speed, double stop, double& time) {
  const double end = speed + mobility(time, body.mass, body.damping) * (a - body.damping * speed);
  if (speed == stop || (end - stop) * (speed - stop) > 0.0) {
    time = 0.0;
    return end;
  }
  time -= std::clamp(time_to(body, a, speed, stop), 0.0, time);
  return stop;
}

/// Slip after a flow with friction against that slip, whose size is `size`. f is the slip without
/// friction, x the mobilities times the friction level.
Slip slip_against_friction(const Slip& f, const Slip& x, double size) {
  return {f.along * size / (size + x.along), f.around * size / (size + x.around)};
}

/// The size s of the slip after the flow: solves sum f^2/(s + x)^2 = 1, x = b R. The sum decreases
/// with s.
double slip_size(const Slip& f, const Slip& x) {
  const double fa = f.along * f.along, fq = f.around * f.around, ff = std::sqrt(fa + fq);
  double lo = std::max(0.0, ff - std::max(x.along, x.around));
  double hi = ff - std::min(x.along, x.around);
  double s = std::clamp(ff - (fa * x.along + fq * x.around) / (ff * ff), lo, hi);
  for (int k = 0; k < 60 && hi > lo; ++k) {
    const double pa = 1.0 / (s + x.along), pq = 1.0 / (s + x.around);
    const double sum = fa * pa * pa + fq * pq * pq;
    (sum > 1.0 ? lo : hi) = s;
    const double slope = fa * pa * pa * pa + fq * pq * pq * pq;
    double next = s + (std::sqrt(sum) - 1.0) * sum / slope;  // Newton on sum^(-1/2)
    if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
    if (std::abs(next - s) <= 1e-15 * next) return next;
    s = next;
  }
  return s;
}

/// Friction in the mean direction of the slips before and after the flow, unless it would reverse
/// the slip or drive it: second order in time. `end` is the slip with friction against the final
/// slip.
Slip in_mean_direction(const Slip& start, const Slip& f, const Slip& x, const Slip& end) {
  const double before = size_of(start), after = size_of(end);
  if (before == 0.0 || after == 0.0) return end;
  const double ea = start.along / before + end.along / after;
  const double eq = start.around / before + end.around / after;
  const double square = ea * ea + eq * eq;
  if (square <= 2.0) return end;  // directions differ by more than 90 degrees
  const double k = 1.0 / std::sqrt(square);
  const Slip y{f.along - x.along * ea * k, f.around - x.around * eq * k};
  const bool same_side = y.along * end.along + y.around * end.around > 0.0;
  const bool resists = (y.along + start.along) * ea + (y.around + start.around) * eq > 0.0;
  return same_side && resists ? y : end;
}

}  // namespace

double flow_along(const DampedBody& body, double force, const Coulomb& friction, double time,
                  double speed) {
  if (friction.resting <= 0.0)
    return speed + mobility(time, body.mass, body.damping) * (force - body.damping * speed);
  const double vc = friction.threshold;
  bool fast = std::abs(speed) > vc;
  while (time > 0.0) {
    if (speed == 0.0 && !fast) {  // at rest
      if (std::abs(force) <= friction.resting) return 0.0;
      fast = vc == 0.0;
    }
    const double sign = speed > 0.0 ? 1.0 : speed < 0.0 ? -1.0 : force > 0.0 ? 1.0 : -1.0;
    const double a = force - sign * (fast ? friction.sliding : friction.resting);
    if (fast) {
      speed = piece(body, a, speed, sign * vc, time);
      fast = time <= 0.0;
    } else {
      // The force decides at which end the speed leaves the slow range.
      const bool faster = sign * (a - body.damping * speed) > 0.0;
      speed = piece(body, a, speed, faster ? sign * vc : 0.0, time);
      fast = faster;
    }
  }
  return speed;
}

Slip flow_slip(const Slip& start, const FreeFlow& free, const Coulomb& friction) {
  const Slip& f = free.speed;
  const double before = size_of(start);
  const bool fast = before > friction.threshold;
  double level = fast ? friction.sliding : friction.resting;
  if (level <= 0.0) return f;
  Slip x{free.mobility.along * level, free.mobility.around * level};
  const double pa = f.along / x.along, pq = f.around / x.around;
  if (pa * pa + pq * pq <= 1.0) return {};
  if (before == 0.0 && friction.threshold == 0.0) {
    level = friction.sliding;
    if (level <= 0.0) return f;
    x = {free.mobility.along * level, free.mobility.around * level};
  }
  const Slip end = slip_against_friction(f, x, slip_size(f, x));
  return in_mean_direction(start, f, x, end);
}

void add_flow_losses(const CompletedFlow& flow, const Slip& mass, const Slip& damping, Lost& lost) {
  const Slip &from = flow.from, &to = flow.to, &F = flow.force;
  const double before = size_of(from), R = flow.friction;
  if (R > 0.0 && to.along == 0.0 && to.around == 0.0) {
    if (before == 0.0) return;
    const double stored =
        0.5 * (mass.along * from.along * from.along + mass.around * from.around * from.around);
    const double driven = (F.along * from.along + F.around * from.around) / before;
    lost.friction += R - driven > 1e-9 * R ? stored * R / (R - driven) : stored;
    return;
  }
  const Slip mean{0.5 * (from.along + to.along), 0.5 * (from.around + to.around)};
  const double taken =
      (flow.time * F.along - mass.along * (to.along - from.along)) * mean.along +
      (flow.time * F.around - mass.around * (to.around - from.around)) * mean.around;
  const double damped = flow.time * (damping.along * mean.along * mean.along +
                                     damping.around * mean.around * mean.around);
  lost.damping += R > 0.0 ? damped : taken;
  if (R > 0.0) lost.friction += taken - damped;
}

}  // namespace tdbd::string
