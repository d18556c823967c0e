#include "rock/rock.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "rock/maintain/invariants.hpp"
#include "rock/maintain/maintain.hpp"
#include "verification/rock/bumpy_sheet.hpp"
#include "verification/rock/cut/cutting_scene.hpp"
#include "verification/rock/maintain/bare_limits.hpp"

namespace tdbd::rock::rock_test {

void drill(const Scene& s, const CuttingBit& bit, Rock& rock, CutReport& report) {
  CutWorkspace work;
  MaintenanceWorkspace maintenance;
  MaintenanceReport repairs;
  cut_rock(rock, bit, s.X_WB0, s.X_WB1, work, report);
  maintain(rock, bare_limits_for(0.3), maintenance, repairs);
}

/// Between two cuts and their maintenance, about any box: the vertices, the triangles and the
/// volumes are the same.
RC_GTEST_PROP(Rock, is_the_same_whenever_its_index_is_rebuilt, ()) {
  const Scene s = *scene();
  const CuttingBit bit = prepare_cutting_bit(s.bit);
  Rock rock = rock_of(s), other = rock;
  CutReport report, slow;
  drill(s, bit, rock, report);
  drill(s, bit, other, slow);
  mesh::Box box_W;
  for (int k = 0; k < 2; ++k) box_W.add(*battery::point(2.0));
  rebuild_index(other, box_W);
  drill(s, bit, rock, report);
  drill(s, bit, other, slow);
  RC_ASSERT(mesh::positions_of(rock.surface) == mesh::positions_of(other.surface));
  RC_ASSERT(rock.surface.triangles == other.surface.triangles);
  RC_ASSERT(report.removed_by_part == slow.removed_by_part);
  RC_ASSERT(describe(check_disc(other)) == "");
}

/// A sheet that moves down in small steps that the index does not record.
TEST(Rock, deepens_its_index_with_the_hole) {
  Rock rock = rock_of(battery::bumpy_rock(1.5, 10, 0.1, 3));
  const double cell = rock.grid.cell(), start = rock.grid.box().hi.z();
  int made_anew = 0;
  for (int k = 0; k < 100; ++k) {
    for (int v = 0; v < rock.surface.vertex_slots(); ++v)
      place_vertex(rock, v, rock.surface.position(v) + Vec3(0.0, 0.0, 0.1));
    const double held = rock.grid.box().hi.z();
    deepen_index(rock);
    made_anew += rock.grid.box().hi.z() > held ? 1 : 0;
    ASSERT_LE(rock.grid.deepest(), rock.grid.box().hi.z() + 4.0 * cell);
    ASSERT_EQ(describe(check_disc(rock)), "");
  }
  EXPECT_GT(rock.grid.deepest(), start + 9.0);
  EXPECT_GE(made_anew, 2);
  EXPECT_LE(made_anew, 20);
  EXPECT_EQ(rock.grid.cell(), cell);
}

/// Each new index holds twice the hole's depth, so that there are few.
TEST(Rock, rebuilds_its_index_whenever_the_hole_is_twice_as_deep) {
  Rock rock = rock_of(battery::bumpy_rock(1.5, 10, 0.1, 3));
  int made_anew = 0;
  for (int k = 0; k < 300; ++k) {
    for (int v = 0; v < rock.surface.vertex_slots(); ++v)
      if (!rock.surface.is_boundary(v))
        place_vertex(rock, v, rock.surface.position(v) + Vec3(0.0, 0.0, 0.1));
    const double held = rock.grid.box().hi.z();
    deepen_index(rock);
    made_anew += rock.grid.box().hi.z() > held ? 1 : 0;
  }
  EXPECT_GE(made_anew, 2);
  EXPECT_LE(made_anew, 5);  // 30 m from 2 m on
}

}  // namespace tdbd::rock::rock_test
