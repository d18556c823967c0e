#include "simulation/start/start_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace tdbd::simulation {
namespace {

double cross(const Vec3& a, const Vec3& b) { return a.x() * b.y() - a.y() * b.x(); }

Vec3 centre_W(const bit::Part& part, const Pose& X_WB) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& x_P : part.mesh_P.positions) sum += x_P;
  return X_WB * (part.X_BP * (sum / static_cast<double>(part.mesh_P.positions.size())));
}

}  // namespace

double cover_above(const mesh::Surface& rock, const Vec3& x_W) {
  // Off the vertices, which often lie right below one another; far less than any edge's length.
  const Vec3 p = x_W + Vec3(1.37e-8, 2.11e-8, 0.0);
  int up_minus_down = 0;
  double cover = 0.0;
  for (const mesh::Triangle& t : rock.triangles) {
    if (t[0] < 0) continue;
    const Vec3 a = rock.position(t[0]) - p, b = rock.position(t[1]) - p,
               c = rock.position(t[2]) - p;
    const double wa = cross(b, c), wb = cross(c, a), wc = cross(a, b), sum = wa + wb + wc;
    if (std::min({wa, wb, wc}) < 0.0 && std::max({wa, wb, wc}) > 0.0) continue;
    const double height = sum == 0.0 ? 0.0 : -(wa * a.z() + wb * b.z() + wc * c.z()) / sum;
    if (height <= 0.0) continue;
    up_minus_down += sum < 0.0 ? 1 : -1;  // z points down: a face turned up has a negative area
    cover = std::max(cover, height);
  }
  return up_minus_down > 0 ? cover : 0.0;
}

void require_free_start(const Case& c, const mesh::Surface& rock) {
  const Pose X_WB = pose_at(c.motion, time_at(c.time, c.time.first));
  for (const bit::Part& part : c.bit.parts) {
    if (part.cutting != bit::Cutting::cuts) continue;
    const double cover = cover_above(rock, centre_W(part, X_WB));
    if (cover > 0.0)
      throw InputError(
          fmt::format("{}: found the middle of {} {:.3f} mm below the rock's surface at the start, "
                      "expected a bit that starts inside the rock by at most a cutter's radius",
                      c.places.motion, part.name, 1e3 * cover));
  }
}

}  // namespace tdbd::simulation
