#include "rock/cut/swept_whole.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "core/tolerance.hpp"
#include "rock/cut/cut_rock.hpp"
#include "rotation/rotation_vector.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"
#include "verification/rock/cut/cutting_scene.hpp"
#include "verification/rock/cut/round_solids.hpp"

namespace tdbd::rock::swept_whole_test {

bit::Bit any_cutter() {
  return cutter_bit(*rc::gen::element(0.0, 0.05), *rc::gen::element(0.0, 0.03), 32);
}

RelativePath any_path() {
  const Vec3 q = 0.4 * *battery::point(1.0) - 0.2 * Vec3::UnitX(), u = *battery::direction();
  return {q, q + 0.2 * *battery::point(1.0), u, u};
}

/// Twin: out of one part after another until none sweeps it.
double exit_part_by_part(const CuttingGroup& g, RelativePath p) {
  SweptScratch scratch;
  double t = 0.0;
  for (bool moves = true; moves;) {
    moves = false;
    for (const CuttingPart& part : g.parts) {
      const double more = exit_distance(part, p, scratch).value_or(0.0);
      p.q0_P += more * p.u0_P;
      p.q1_P += more * p.u1_P;
      t += more;
      moves = moves || more > tolerance::inside;
    }
  }
  return t;
}

RC_GTEST_PROP(WholeExits, are_where_the_way_through_the_parts_ends, ()) {
  const bit::Bit bit = any_cutter();
  const CuttingBit cutting = prepare_cutting_bit(bit, {.exit_from = ExitFrom::whole});
  const CuttingGroup& g = cutting.groups.front();
  RC_ASSERT(g.whole.has_value());
  SweptScratch scratch;
  const RelativePath p = any_path();
  prepare_exits(g.whole->solid, boxes_around({p}, {0}), scratch);
  const auto x = prepared_whole_exit(*g.whole, p, scratch);
  RC_TAG(x ? static_cast<int>(x->part) : -1);
  RC_ASSERT(std::abs((x ? x->t : 0.0) - exit_part_by_part(g, p)) < 1e-12);
  if (!x) return;
  double nearest = 1.0;  // some place of the level at the exit touches its owner
  for (int k = 0; k <= 1000; ++k) {
    const Vec3 x_P = p.q0_P + 1e-3 * k * (p.q1_P - p.q0_P) + x->t * p.u0_P;
    nearest = std::min(nearest, -depth_inside(g.parts[x->part], x_P));
  }
  RC_ASSERT(nearest < 1.5e-4);
}

struct Cut {
  Rock rock;
  CutReport report;
};

Cut cut(const Scene& s, ExitFrom from) {
  Cut c;
  c.rock = rock_of(s);
  CutWorkspace work;
  cut_rock(c.rock, prepare_cutting_bit(s.bit, {.exit_from = from}), s.X_WB0, s.X_WB1, work,
           c.report);
  return c;
}

Scene cutter_in_rock() {
  Scene s = *scene();
  s.bit = any_cutter();
  return s;
}

/// The cutter's volume is the same, its parts' shares are not; every vertex was last moved by the
/// same part, so that contact areas are the same.
RC_GTEST_PROP(WholeExits, leave_the_same_rock_volume_and_last_parts_as_part_by_part, ()) {
  const Scene s = cutter_in_rock();
  const Cut parts = cut(s, ExitFrom::parts), whole = cut(s, ExitFrom::whole);
  RC_TAG(whole.report.moved > 0 ? "cuts" : "misses");
  RC_ASSERT(whole.report.passes <= 2);
  RC_ASSERT(std::abs(whole.report.removed - parts.report.removed) < 1e-12);
  for (int v = 0; v < whole.rock.surface.vertex_slots(); ++v)
    RC_ASSERT((whole.rock.surface.position(v) - parts.rock.surface.position(v)).norm() < 1e-12);
  RC_ASSERT(whole.rock.last_part == parts.rock.last_part);
}

/// The contract of rock (5).
RC_GTEST_PROP(WholeExits, leave_no_vertex_inside_a_part, ()) {
  const Scene s = cutter_in_rock();
  const Cut c = cut(s, ExitFrom::whole);
  for (const bit::Part& p : s.bit.parts)
    for (const Vec3& x_W : mesh::positions_of(c.rock.surface)) {
      const Vec3 x_P = inverse(s.X_WB1 * p.X_BP) * x_W;
      RC_ASSERT(depth_behind_triangles(p.mesh_P, x_P) < tolerance::inside);
    }
}

}  // namespace tdbd::rock::swept_whole_test
