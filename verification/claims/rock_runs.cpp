#include "claims/rock_runs.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "mesh/measures.hpp"
#include "rock/cut/swept_part.hpp"

namespace tdbd::claims {

simulation::Case rock_case(const std::string& name, const std::vector<std::string>& settings) {
  return simulation::read_case(TDBD_SOURCE_DIR "/cases/" + name + ".toml", settings);
}

simulation::Case until_an_update(simulation::Case c) {
  c.time.steps -= c.time.steps % c.maintenance.every == 0;
  return c;
}

simulation::Simulation drilled(const simulation::Case& c) {
  simulation::Simulation s = simulation::start(c);
  while (s.state.steps_done < c.time.steps) simulation::step(c, s);
  return s;
}

std::vector<double> qualities(const mesh::Surface& s) {
  std::vector<double> all;
  all.reserve(s.triangles.size());
  for (const auto& [a, b, c] : s.triangles)
    if (a >= 0) all.push_back(mesh::triangle_quality(s.position(a), s.position(b), s.position(c)));
  std::ranges::sort(all);
  return all;
}

long thesis_operations(const simulation::Simulation& s) {
  using rock::Operation;
  long sum = 0;
  for (const Operation o : {Operation::collapse, Operation::bisection, Operation::smoothing})
    sum += s.state.maintenance.carried_out(o);
  return sum;
}

long operations(const simulation::Simulation& s) {
  return std::accumulate(s.state.maintenance.done.begin(), s.state.maintenance.done.end(), 0L);
}

double volume_per_revolution(const simulation::Case& c) {
  const double r = c.bit.gage_radius;
  const double advance =
      c.motion.rate_of_penetration * 2.0 * std::numbers::pi / c.motion.rotary_speed;
  return std::numbers::pi * r * r * advance;
}

double removed_in(const simulation::Simulation& s, std::size_t revolution) {
  const std::vector<double>& parts = s.state.ledger.removed_by_revolution.at(revolution);
  return std::accumulate(parts.begin(), parts.end(), 0.0);
}

double deepest_inside(const simulation::Case& c, const simulation::Simulation& s) {
  const Pose X_WB = pose_at(c.motion, c.time.step * static_cast<double>(s.state.steps_done));
  double deepest = 0.0;
  for (const rock::CuttingGroup& g : s.work.cutting.groups) {
    const Pose X_PW = inverse(X_WB * g.X_BP1);  // cones turn in a step
    for (int v = 0; v < s.state.rock.surface.vertex_slots(); ++v) {
      if (!s.state.rock.surface.is_alive(v)) continue;
      const Vec3 x_P = X_PW * s.state.rock.surface.position(v);
      if (!g.box_P.contains(x_P)) continue;
      for (const rock::CuttingPart& p : g.parts)
        deepest = std::max(deepest, rock::depth_inside(p, x_P));
    }
  }
  return deepest;
}

}  // namespace tdbd::claims
