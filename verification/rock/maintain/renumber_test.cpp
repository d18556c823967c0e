#include "rock/maintain/renumber.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "core/tolerance.hpp"
#include "rock/maintain/invariants.hpp"
#include "rock/maintain/maintain.hpp"
#include "verification/battery/generators.hpp"
#include "verification/rock/cut/cutting_scene.hpp"

namespace tdbd::rock::renumber_test {

/// A random bit in rock that it has cut and that was maintained, in which some vertices wait.
struct Drilled {
  CuttingBit bit;
  Pose X_WB, motion;
  Rock rock;

  explicit Drilled(const Scene& s)
      : bit(prepare_cutting_bit(s.bit)),
        X_WB(s.X_WB0),
        motion(inverse(s.X_WB0) * s.X_WB1),
        rock(rock_of(s)) {
    const double side = 3.0 / std::sqrt(0.5 * rock.surface.triangle_count());
    MaintenanceLimits limits = limits_for(side * *battery::number(0.7, 2.0));
    limits.flip_quality = 0.6;
    limits.smoothing = Smoothing::tangential;
    limits.smooth_quality = 0.5;
    limits.rest = static_cast<int>(*battery::integer(0, 4));
    MaintenanceWorkspace work;
    MaintenanceReport report;
    for (int k = 0; k < 3; ++k) {
      if (!cut(rock)) RC_DISCARD("leaves the rock");
      X_WB = X_WB * motion;
      if (*battery::integer(0, 2) > 0) maintain(rock, limits, work, report);
    }
  }

  /// The next step; nothing if it leaves the rock.
  std::optional<CutReport> cut(Rock& of) const {
    CutWorkspace work;
    CutReport report;
    try {
      cut_rock(of, bit, X_WB, X_WB * motion, work, report);
    } catch (const RunError&) {
      return {};
    }
    return report;
  }
};

double any_cube() { return *battery::number(0.05, 3.0); }

RC_GTEST_PROP(RenumberedRock, is_the_same_rock, ()) {
  const Drilled d(*scene());
  Rock rock = d.rock;
  RenumberWork work;
  renumber(rock, any_cube(), work);
  RC_TAG(d.rock.touched_list.empty() ? "none waits" : "some wait");
  RC_ASSERT(describe(check_disc(rock)) == "");
  RC_ASSERT(rock.surface.vertex_slots() == d.rock.surface.vertex_count());
  RC_ASSERT(rock.surface.triangle_slots() == d.rock.surface.triangle_count());
  RC_ASSERT(describe(check_ledger(d.rock.surface, rock.surface, 0.0)) == "");
  RC_ASSERT(rock.cuts == d.rock.cuts);
}

RC_GTEST_PROP(RenumberedRock, keeps_the_marks_of_every_vertex_and_what_waits, ()) {
  const Drilled d(*scene());
  Rock rock = d.rock;
  RenumberWork work;
  renumber(rock, any_cube(), work);
  std::vector<int> listed;
  for (int v = 0; v < d.rock.surface.vertex_slots(); ++v) {
    const int n = work.mesh.number[at(v)];
    RC_ASSERT((n >= 0) == d.rock.surface.is_alive(v));
    if (n < 0) continue;
    RC_ASSERT(rock.surface.position(n) == d.rock.surface.position(v));
    RC_ASSERT(rock.last_part[at(n)] == d.rock.last_part[at(v)]);
    RC_ASSERT(rock.touched[at(n)] == d.rock.touched[at(v)]);
    RC_ASSERT(rock.moved_in[at(n)].first == d.rock.moved_in[at(v)].first);
    RC_ASSERT(rock.moved_in[at(n)].last == d.rock.moved_in[at(v)].last);
  }
  for (const int v : d.rock.touched_list)
    if (work.mesh.number[at(v)] >= 0) listed.push_back(work.mesh.number[at(v)]);
  RC_ASSERT(rock.touched_list == listed);
}

/// Numbers decide ties of maintenance, but nothing of a cut: every vertex goes to the same place to
/// the bit, while volumes are summed in another order.
RC_GTEST_PROP(RenumberedRock, is_cut_as_it_was, ()) {
  const Drilled d(*scene());
  Rock rock = d.rock, as_it_was = d.rock;
  RenumberWork work;
  renumber(rock, any_cube(), work);
  const std::optional<CutReport> cut = d.cut(rock), expected = d.cut(as_it_was);
  RC_ASSERT(cut.has_value() == expected.has_value());
  if (!cut) RC_DISCARD("leaves the rock");
  RC_TAG(cut->moved > 0 ? "cuts" : "does not cut");
  RC_ASSERT(cut->moved == expected->moved);
  RC_ASSERT(cut->candidates == expected->candidates);
  for (std::size_t k = 0; k < cut->removed_by_part.size(); ++k)
    RC_ASSERT(std::abs(cut->removed_by_part[k] - expected->removed_by_part[k]) <=
              tolerance::ledger);  // of 1 m3, as large as the rock
  for (int v = 0; v < d.rock.surface.vertex_slots(); ++v)
    if (const int n = work.mesh.number[at(v)]; n >= 0) {
      RC_ASSERT(rock.surface.position(n) == as_it_was.surface.position(v));
      RC_ASSERT(rock.last_part[at(n)] == as_it_was.last_part[at(v)]);
    }
}

/// A copy that was numbered otherwise gets the same numbers.
RC_GTEST_PROP(RenumberedRock, has_numbers_that_follow_from_its_shape, ()) {
  const Drilled d(*scene());
  const double cube = any_cube();
  Rock rock = d.rock, other = d.rock;
  RenumberWork work;
  renumber(other, any_cube(), work);
  renumber(other, cube, work);
  renumber(rock, cube, work);
  RC_ASSERT(mesh::positions_of(rock.surface) == mesh::positions_of(other.surface));
  RC_ASSERT(rock.surface.triangles == other.surface.triangles);
  RC_ASSERT(rock.surface.corner_of == other.surface.corner_of);
  RC_ASSERT(rock.last_part == other.last_part);
}

}  // namespace tdbd::rock::renumber_test
