#include "rock/cut_rock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "rock/prism.hpp"

namespace tdbd::rock {
namespace {

constexpr int max_passes = 32;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Poses of one group during the step, and what follows from them.
struct Motion {
  Pose X_PW0, X_PW1;
  Pose X_BW1;
  Mat3 R_WB1;
  mesh::Box box_W;  ///< motion box: the group at pose 0 and pose 1 (4.1.1)
};

mesh::Box box_of_corners(const Pose& X, const mesh::Box& box, mesh::Box sum) {
  for (int k = 0; k < 8; ++k)
    sum.add(X * Vec3(k & 1 ? box.hi.x() : box.lo.x(), k & 2 ? box.hi.y() : box.lo.y(),
                     k & 4 ? box.hi.z() : box.lo.z()));
  return sum;
}

Motion group_motion(const CuttingGroup& g, const Pose& X_WB0, const Pose& X_WB1) {
  const Pose X_WP0 = X_WB0 * g.X_BP, X_WP1 = X_WB1 * g.X_BP;
  return {inverse(X_WP0), inverse(X_WP1), inverse(X_WB1), X_WB1.R,
          box_of_corners(X_WP1, g.box_P, box_of_corners(X_WP0, g.box_P, {}))};
}

/// Ur = Rz(azimuth of the vertex in the bit frame) U, in space (4.1.2.3, 4.1.3.2).
Vec3 mapped_direction_W(const CuttingGroup& g, const Motion& m, const Vec3& x_W) {
  const Vec3 x_B = m.X_BW1 * x_W;
  const double rho = std::hypot(x_B.x(), x_B.y());
  const double c = rho > 0.0 ? x_B.x() / rho : 1.0, s = rho > 0.0 ? x_B.y() / rho : 0.0;
  const Vec3& U = g.update_direction_B;
  return m.R_WB1 * Vec3(c * U.x() - s * U.y(), s * U.x() + c * U.y(), U.z());
}

/// The straight path of a vertex in the group's frame misses its box.
bool misses_box(const mesh::Box& box, const RelativePath& p) {
  return (p.q0_P.cwiseMax(p.q1_P).array() < box.lo.array()).any() ||
         (p.q0_P.cwiseMin(p.q1_P).array() > box.hi.array()).any();
}

void begin_part(CutWorkspace& w, const Rock& rock) {
  ++w.stamp;
  w.moved.clear();
  w.vertex_stamp.resize(rock.surface.positions.size(), 0);
  w.old_position.resize(rock.surface.positions.size());
  w.triangle_stamp.resize(rock.surface.triangles.size(), 0);
}

void move_vertex(Rock& rock, CutWorkspace& w, int v, const Vec3& x_W, const CuttingPart& part) {
  if (rock.surface.is_boundary(v))
    throw RunError(fmt::format(
        "{} swept the rock's boundary at ({:.3f}, {:.3f}, {:.3f}) mm: the wall is too low or "
        "the rock too narrow for this motion",
        part.name, 1e3 * x_W.x(), 1e3 * x_W.y(), 1e3 * x_W.z()));
  w.vertex_stamp[at(v)] = w.stamp;
  w.old_position[at(v)] = rock.surface.positions[at(v)];
  rock.surface.positions[at(v)] = x_W;
  rock.grid.move(v, x_W);
  rock.last_part[at(v)] = part.part;
  touch(rock, v);
  w.moved.push_back(v);
}

/// Prism volumes of the triangles around the vertices that this part moved (4.3).
double removed_by_moves(const Rock& rock, CutWorkspace& w) {
  w.triangles.clear();
  for (const int v : w.moved)
    mesh::visit_corners(rock.surface, v, [&](int c) {
      if (w.triangle_stamp[at(c / 3)] == w.stamp) return;
      w.triangle_stamp[at(c / 3)] = w.stamp;
      w.triangles.push_back(c / 3);
    });
  std::sort(w.triangles.begin(), w.triangles.end());  // the sum does not hang on the index's order
  double sum = 0.0;
  for (const int t : w.triangles) {
    Corners from, to;
    for (std::size_t i = 0; i < 3; ++i) {
      const int v = rock.surface.triangles[at(t)][i];
      to[i] = rock.surface.position(v);
      from[i] = w.vertex_stamp[at(v)] == w.stamp ? w.old_position[at(v)] : to[i];
    }
    sum += prism_volume(from, to);
  }
  return sum;
}

void process_part(Rock& rock, const CuttingGroup& g, const CuttingPart& part, const Motion& m,
                  CutWorkspace& w, CutReport& report) {
  begin_part(w, rock);
  for (const int v : w.candidates) {
    const Vec3& x_W = rock.surface.position(v);
    RelativePath path{m.X_PW0 * x_W, m.X_PW1 * x_W, {}, {}};
    if (misses_box(g.box_P, path) || !is_swept(part, path, w.swept)) continue;
    const Vec3 u_W = mapped_direction_W(g, m, x_W);
    path.u0_P = m.X_PW0.R * u_W;
    path.u1_P = m.X_PW1.R * u_W;
    const auto t = exit_distance(part, path, w.swept);
    if (t && *t > 0.0) move_vertex(rock, w, v, x_W + *t * u_W, part);
  }
  if (w.moved.empty()) return;
  const double removed = removed_by_moves(rock, w);
  report.removed_by_part[at(part.part)] += removed;
  report.removed += removed;
  report.moved += static_cast<long>(w.moved.size());
  w.moved_in_pass.insert(w.moved_in_pass.end(), w.moved.begin(), w.moved.end());
}

void find_candidates(const Rock& rock, const CuttingGroup& g, const Motion& m, CutWorkspace& w) {
  w.candidates.clear();
  rock.grid.visit(m.box_W, [&](int v) {
    const Vec3& x_W = rock.surface.position(v);
    if (!m.box_W.contains(x_W)) return;
    if (!misses_box(g.box_P, {m.X_PW0 * x_W, m.X_PW1 * x_W, {}, {}})) w.candidates.push_back(v);
  });
}

void find_among_moved(const Rock& rock, const Motion& m, CutWorkspace& w) {
  w.candidates.clear();
  for (const int v : w.moved_before)
    if (m.box_W.contains(rock.surface.position(v))) w.candidates.push_back(v);
}

std::string still_moving(const CuttingBit& bit, const Rock& rock, const std::vector<int>& moved) {
  std::string names;
  for (const CuttingGroup& g : bit.groups)
    for (const CuttingPart& p : g.parts)
      if (std::any_of(moved.begin(), moved.end(),
                      [&](int v) { return rock.last_part[at(v)] == p.part; }))
        names += (names.empty() ? "" : ", ") + p.name;
  return names;
}

}  // namespace

void cut_rock(Rock& rock, const CuttingBit& bit, const Pose& X_WB0, const Pose& X_WB1,
              CutWorkspace& work, CutReport& report) {
  report.removed_by_part.assign(at(bit.part_count), 0.0);
  report.removed = 0.0;
  report.candidates = report.moved = 0;
  work.moved_before.clear();
  for (report.passes = 1; report.passes <= max_passes; ++report.passes) {
    work.moved_in_pass.clear();
    for (const CuttingGroup& g : bit.groups) {
      const Motion m = group_motion(g, X_WB0, X_WB1);
      if (report.passes == 1)
        find_candidates(rock, g, m, work);
      else
        find_among_moved(rock, m, work);
      report.candidates += static_cast<long>(work.candidates.size());
      for (const CuttingPart& part : g.parts) process_part(rock, g, part, m, work, report);
    }
    if (work.moved_in_pass.empty()) return;
    std::sort(work.moved_in_pass.begin(), work.moved_in_pass.end());
    work.moved_in_pass.erase(std::unique(work.moved_in_pass.begin(), work.moved_in_pass.end()),
                             work.moved_in_pass.end());
    work.moved_before = work.moved_in_pass;
  }
  throw RunError(
      fmt::format("rock vertices still move after {} passes of one step; the parts are: {}",
                  max_passes, still_moving(bit, rock, work.moved_in_pass)));
}

}  // namespace tdbd::rock
