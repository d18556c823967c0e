#include "forces/laws/virgin_groove.hpp"

#include <algorithm>
#include <cmath>

#include "core/angles.hpp"
#include "forces/part/part_cut.hpp"

namespace tdbd::forces {
namespace {

constexpr int most_iterations = 50;
/// The error after a Newton step is less than the square of the step, both relative to t.
constexpr double converged = 1e-8;

double cosine(const GrooveCutter& c) {
  return std::cos(std::clamp(c.back_rake, -steepest_rake, steepest_rake));
}

/// t - sin t cos t, by its series for small t to avoid cancellation.
double segment(double t) {
  if (t > 0.3) return t - std::sin(t) * std::cos(t);
  const double s = 4.0 * t * t;  // the series is that of (2t - sin 2t)/2
  double sum = 1.0;
  for (const double divisor : {210.0, 156.0, 110.0, 72.0, 42.0, 20.0})
    sum = 1.0 - s / divisor * sum;
  return 2.0 / 3.0 * t * t * t * sum;
}

struct HalfAngle {
  double t = 0.0;  // rad
  int iterations = 0;
};

/// Solves segment(t) = q for t in [0, pi/2].
HalfAngle half_angle(double q) {
  HalfAngle h{.t = std::cbrt(1.5 * q)};
  while (h.t > 0.0 && h.iterations < most_iterations) {
    const double sine = std::sin(h.t), step = (segment(h.t) - q) / (2.0 * sine * sine);
    h.t -= step;
    ++h.iterations;
    if (std::abs(step) <= converged * h.t) break;
  }
  return h;
}

}  // namespace

double groove_area(const GrooveCutter& cutter, double depth) {
  const double a = cutter.diameter / 2.0, c = cosine(cutter);
  const double t = 2.0 * std::asin(std::sqrt(std::clamp(depth / (2.0 * a * c), 0.0, 1.0)));
  return a * a * segment(t) * c;
}

GrooveDepth groove_depth(const GrooveCutter& cutter, double area) {
  const double a = cutter.diameter / 2.0, c = cosine(cutter);
  const double q = std::min(area / (a * a * c), pi);
  if (q <= pi / 2.0) {
    const HalfAngle h = half_angle(q);
    const double sine = std::sin(h.t / 2.0);
    return {.depth = 2.0 * a * c * sine * sine, .iterations = h.iterations};
  }
  const HalfAngle h = half_angle(pi - q);
  const double cosine_of_rest = std::cos(h.t / 2.0);
  return {.depth = 2.0 * a * c * cosine_of_rest * cosine_of_rest, .iterations = h.iterations};
}

}  // namespace tdbd::forces
