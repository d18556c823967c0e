#include "simulation/case/step_check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "mesh/measures.hpp"
#include "rotation/screw.hpp"

namespace tdbd::simulation {
namespace {

/// What a step must not jump over.
struct Obstacle {
  const bit::Part* part;
  Vec3 middle_B;
  double size;  ///< m
};

std::vector<Obstacle> cutting_parts(const bit::Bit& bit) {
  std::vector<Obstacle> parts;
  for (const bit::Part& part : bit.parts) {
    if (final_cutting(part) != bit::Cutting::cuts || part.mesh_P.positions.empty()) continue;
    const mesh::Box box_P = mesh::bounding_box(part.mesh_P);
    parts.push_back({&part, part.X_BP * (0.5 * (box_P.lo + box_P.hi)), box_P.size().norm()});
  }
  return parts;
}

/// How far the middle of the part goes in a step, at most, m.
double jump(const Speeds& s, const Obstacle& o, double dt) {
  return dt * (s.shift + s.w_B.cross(o.middle_B).norm() + s.swing * o.middle_B.norm());
}

/// What is wrong with the step during one piece of the motion: found and expected.
std::optional<std::pair<std::string, std::string>> fault(const Speeds& s, double dt,
                                                         const std::vector<Obstacle>& parts) {
  constexpr double largest_turn = 0.5;  // rad
  if (s.w_B.norm() * dt > largest_turn)
    return std::pair(fmt::format("a turn of {:.3g} rad in one step", s.w_B.norm() * dt),
                     fmt::format("at most {} rad", largest_turn));
  for (const Obstacle& o : parts)
    if (const double far = jump(s, o, dt); far > o.size)
      return std::pair(
          fmt::format("a jump of {:.3g} mm of {} in one step of {} s", 1e3 * far, o.part->name, dt),
          fmt::format("at most the part's size, {:.3g} mm: a shorter time.step or a slower motion",
                      1e3 * o.size));
  return std::nullopt;
}

double over(double x, double ramp) { return ramp > 0.0 ? x / ramp : 0.0; }

std::vector<Speeds> speeds_on(const std::vector<PathPoint>& path) {
  std::vector<Speeds> speeds;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const PathPoint &a = path[i - 1], &b = path[i];
    const double dt = b.time - a.time;
    const Vec3 turn =
        rotation::log(rotation::exp(a.rotation_WB).transpose() * rotation::exp(b.rotation_WB));
    speeds.push_back({(b.p_WB - a.p_WB).norm() / dt, turn / dt, 0.0, b.line});
  }
  return speeds;
}

}  // namespace

std::vector<Speeds> speeds_of(const Motion& m) {
  if (has_path(m)) return speeds_on(m.path);
  return {{std::abs(m.rate_of_penetration) +
               m.whirl.radius * (m.whirl.frequency + over(1.0, m.whirl.ramp)),
           m.rotary_speed * Vec3::UnitZ(),
           m.tilt.angle * (m.tilt.frequency + over(1.0, m.tilt.ramp)), 0}};
}

void check_step_length(Config& c, const Case& read) {
  if (c.problem_count() > 0) return;
  const std::vector<Obstacle> parts = cutting_parts(read.bit);
  for (const Speeds& s : speeds_of(read.motion)) {
    const auto wrong = fault(s, read.time.step, parts);
    if (!wrong) continue;
    const auto& [found, expected] = *wrong;
    if (s.line == 0) return c.table(time_keys::table).problem(time_keys::step, found, expected);
    return c.other_file(fmt::format("{}:{}: time_s: found {}, expected {}", read.motion.path_file,
                                    s.line, found, expected));
  }
}

}  // namespace tdbd::simulation
