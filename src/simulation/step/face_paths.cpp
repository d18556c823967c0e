#include "simulation/step/face_paths.hpp"

#include <variant>

#include "bit/cutter/cutter_frame.hpp"

namespace tdbd::simulation {
namespace {

double tip_speed(const bit::Cutter& cutter, const rotation::Twist& path) {
  return rotation::velocity_B(path, bit::tip_B(cutter)).norm();
}

/// Whether the face moves forward faster than it would creep, or much faster in any direction.
bool is_on_its_way(const bit::Cutter& cutter, const rotation::Twist& path, double creep) {
  constexpr double much = 10.0;
  const Vec3 v_B = rotation::velocity_B(path, bit::tip_B(cutter));
  return cutter.X_BC.R.col(0).dot(v_B) > creep || v_B.norm() > much * creep;
}

double slip_speed_of(const forces::Law& law) {
  return std::visit(
      [](const auto& l) {
        if constexpr (requires { l.slip_speed; }) return l.slip_speed;
        return 0.0;
      },
      law);
}

}  // namespace

std::vector<double> creep_of_faces(const bit::Bit& bit, const ForcePlan& plan) {
  const double usual =
      plan.forces == Forces::off ? 0.0 : slip_speed_of(law_of(plan, bit::PartKind::face));
  std::vector<double> creep(bit.cutters.size(), usual);
  if (plan.forces == Forces::off) return creep;
  for (std::size_t p = 0; p < bit.parts.size(); ++p)
    if (const bit::Part& part = bit.parts[p]; part.kind == bit::PartKind::face && part.cutter >= 0)
      creep[at(part.cutter)] = slip_speed_of(law_of(plan, part.kind, static_cast<int>(p)));
  return creep;
}

void follow(const bit::Bit& bit, const Move& move, std::span<const double> creep,
            FacePaths& paths) {
  const rotation::Twist now = rotation::twist_from(move.X_WB0, move.X_WB1, move.dt);
  if (paths.size() != bit.cutters.size()) paths.assign(bit.cutters.size(), {});
  for (std::size_t i = 0; i < paths.size(); ++i) {
    paths[i].creeps = !is_on_its_way(bit.cutters[i], now, creep[i]);
    if (!paths[i].creeps) paths[i].way = now;
  }
}

rotation::Twist path_of(const FacePaths& paths, const bit::Bit& bit, int cutter,
                        const rotation::Twist& of_step) {
  if (!creeps(paths, cutter)) return of_step;
  rotation::Twist path = paths[at(cutter)].way;
  const double then = tip_speed(bit.cutters[at(cutter)], path);
  if (!(then > 0.0)) return of_step;
  const double slower = tip_speed(bit.cutters[at(cutter)], of_step) / then;
  path.angular_B *= slower;
  path.linear_B *= slower;
  return path;
}

}  // namespace tdbd::simulation
