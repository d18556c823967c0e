#include "reference/literature/roller/craters/cone_recursion.hpp"

#include <array>
#include <cmath>

namespace tdbd::reference {

ConeTurn started_cone(double angle, double speed, double torque, double inertia, double step,
                      ConeStart start) {
  if (start == ConeStart::simple) return {angle, speed * step, 0.0};
  const double change = torque / inertia * step * step;
  return {angle, speed * step - 0.5 * change, change};
}

void advance_cone(ConeTurn& cone, ConeReading reading, double torque, double inertia, double step) {
  const double before = cone.increment;
  switch (reading) {
    case ConeReading::as_printed:
      cone.increment = torque * inertia * step * step;
      break;
    case ConeReading::divided:
      cone.increment = torque / inertia * step * step;
      break;
    case ConeReading::increments:
      cone.increment += torque / inertia * step * step;
      break;
  }
  cone.change = cone.increment - before;
  cone.angle += cone.increment;
}

double recursion_result(const ConeProblem& problem, ConeReading reading, ConeStart start,
                        long steps) {
  const double step = problem.duration / static_cast<double>(steps);
  ConeTurn cone = started_cone(0.0, problem.speed, problem.torque(0.0, problem.speed),
                               problem.inertia, step, start);
  for (long i = 0; i < steps; ++i)
    advance_cone(cone, reading, problem.torque(cone.angle, cone_speed(cone, step)), problem.inertia,
                 step);
  return cone.angle;
}

double runge_kutta_result(const ConeProblem& problem, long steps) {
  struct State {
    double angle, speed;
  };
  const double h = problem.duration / static_cast<double>(steps);
  const auto slope = [&](const State& s) {
    return State{s.speed, problem.torque(s.angle, s.speed) / problem.inertia};
  };
  const auto moved = [](const State& s, const State& k, double by) {
    return State{s.angle + by * k.angle, s.speed + by * k.speed};
  };
  State s{0.0, problem.speed};
  for (long i = 0; i < steps; ++i) {
    const State a = slope(s), b = slope(moved(s, a, h / 2)), c = slope(moved(s, b, h / 2)),
                d = slope(moved(s, c, h));
    s = moved(moved(moved(moved(s, a, h / 6), b, h / 3), c, h / 3), d, h / 6);
  }
  return s.angle;
}

std::vector<RecursionRow> recursion_table(const ConeProblem& problem, long steps) {
  constexpr int levels = 5;
  const double exact = runge_kutta_result(problem, steps << levels);
  std::vector<RecursionRow> rows{{ConeReading::as_printed, ConeStart::simple},
                                 {ConeReading::divided, ConeStart::simple},
                                 {ConeReading::increments, ConeStart::simple},
                                 {ConeReading::increments, ConeStart::half_step}};
  for (RecursionRow& row : rows) {
    std::array<double, levels> sizes{}, errors{};
    for (int level = 0; level < levels; ++level) {
      const long n = steps << level;
      const double result = recursion_result(problem, row.reading, row.start, n);
      sizes[static_cast<std::size_t>(level)] = problem.duration / static_cast<double>(n);
      errors[static_cast<std::size_t>(level)] = std::abs(result - exact);
      if (level == 0) row.result = result;
    }
    row.error = errors[0];
    row.order = observed_order(sizes, errors, std::abs(exact));
  }
  return rows;
}

}  // namespace tdbd::reference
