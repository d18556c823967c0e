#include <gtest/gtest.h>

#include <cmath>

#include "core/parallel.hpp"
#include "simulation/result/recorder.hpp"
#include "simulation/step/drive.hpp"
#include "simulation/step/simulation.hpp"
#include "simulation/step/wear_step.hpp"
#include "verification/simulation/mesh_bit.hpp"
#include "verification/simulation/same_run.hpp"

/// Runs whose teeth and gage pads wear.
namespace tdbd::simulation::worn_parts_test {
namespace {

constexpr double coefficient = 1e-4, hardness = 10e9;  // of sliding wear: 1, Pa

/// A shipped case in a coarse rock, that wears by Archard's law.
Case wearing(const std::string& name, const std::string& more_wear,
             std::vector<std::string> settings = {}) {
  settings.insert(settings.begin(),
                  {"rock.edge_length='4 mm'", "time.duration='0.1 s'",
                   "wear={law='sliding', coefficient=1e-4, hardness='10 GPa'" + more_wear + "}"});
  return read_case(TDBD_SOURCE_DIR "/cases/" + name + ".toml", settings);
}

Case worn_teeth(std::vector<std::string> settings = {}) {
  return wearing("drill-bit-m", ", acceleration=200, every_steps=9", std::move(settings));
}

void drill(const Case& c, Simulation& s, int steps) {
  for (int i = 0; i < steps; ++i) step(c, s);
}

/// m3, of all pieces: cut from the meshes, and what is still to be cut.
double worn_volume(const Simulation& s) {
  double sum = 0.0;
  for (std::size_t i = 0; i < s.state.wear->pieces.size(); ++i) {
    const PieceWear& p = s.state.wear->pieces[i];
    sum += p.volume + p.window.volume + p.window.height * s.work.wear->flats[i].area;
  }
  return sum;
}

/// m/s, over the rock: of a rigid bit, and of a cone that turns about its axis.
double speed_of_part(const Case& c, const Simulation& s, std::size_t p) {
  const BitVelocity& v = s.work.velocity;
  const Vec3& x = s.work.loads.parts[p].point_W;
  const Pose X_WB = over_rock(s.state.place);
  Vec3 u = v.v_W + v.w_W.cross(x - v.p_WB);
  const int cone = c.bit.parts[p].cone;
  if (cone >= 0) {
    const Pose X_WK = X_WB * c.bit.cones[static_cast<std::size_t>(cone)].X_BK;
    u += v.cone_speeds[static_cast<std::size_t>(cone)] * X_WK.R.col(2).cross(x - X_WK.p);
  }
  return u.norm();
}

/// k/H times the sum of force times path over the parts that wear. The method of windows extrapolates
/// from one to the next: shorter windows come nearer.
TEST(WornTeeth, lose_what_forces_and_paths_wear_off) {
  constexpr double at_16 = 0.25, at_1 = 0.015;  // 0.12 and 0.008 observed, 0.023 at 4
  for (const auto& [every, bound] : {std::pair{16, at_16}, std::pair{1, at_1}}) {
    const Case c = worn_teeth({"wear.every_steps=" + std::to_string(every)});
    Simulation s = start(c);
    double worn = 0.0;
    for (long i = 0; i < c.time.steps; ++i) {
      step(c, s);
      for (std::size_t p = 0; p < c.bit.parts.size(); ++p)
        if (c.bit.parts[p].kind == bit::PartKind::tooth)
          worn += 200.0 * coefficient / hardness * s.work.loads.parts[p].normal *
                  speed_of_part(case_now(c, s.work), s, p) * c.time.step;
    }
    EXPECT_GT(worn, 1e-10);
    EXPECT_NEAR(worn_volume(s) / worn, 1.0, bound) << every;
    EXPECT_LE(wear_ledger_defect(c.bit, s.work.wear->worn.bit, s.work.wear->solids, *s.state.wear),
              1e-12);
  }
}

TEST(WornTeeth, continue_from_a_checkpoint_and_on_two_threads_bitwise_identical) {
  const Case c = worn_teeth();
  for (const int before : {26, 27, 31}) {
    Simulation whole = start(c);
    drill(c, whole, before);
    const auto file = test_folder() / "checkpoint.bin";
    write_checkpoint(file, c, whole, {});
    Checkpoint saved = read_checkpoint(file, c);
    Simulation resumed = resume(c, std::move(saved.state), std::move(saved.statistics));
    const ThreadLimit limit(2);
    drill(c, whole, 20);
    drill(c, resumed, 20);
    EXPECT_GT(whole.state.wear->steps, 3);
    SCOPED_TRACE(before);
    expect_same_run(whole, resumed);
  }
}

/// Pose and velocities of bit and cones, whose inertia is less after a wear step.
TEST(WornTeeth, leave_the_motion_of_bit_and_cones_as_it_is) {
  constexpr double rounding = 1e-12;
  const Case c = worn_teeth({"wear.every_steps=60", "wear.largest_growth=0.1"});
  Simulation s = start(c);
  drill(c, s, 60);
  const auto motion = [&] {
    return velocity_of(case_now(c, s.work).drilling.system, s.state.drive->state);
  };
  const auto inertia = [&] {
    return case_now(c, s.work).drilling.system.gyrostat.cones[0].axial_inertia;
  };
  const BitVelocity before = motion();
  const double inertia_before = inertia();
  wear_if_due(c, s);
  ASSERT_EQ(s.state.wear->steps, 1);
  const BitVelocity after = motion();
  EXPECT_LT(inertia(), inertia_before);
  EXPECT_LT((after.p_WB - before.p_WB).norm(), rounding);
  EXPECT_LT((after.v_W - before.v_W).norm(), rounding);
  EXPECT_LT((after.w_W - before.w_W).norm(), rounding * before.w_W.norm());
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(after.cone_speeds[k], before.cone_speeds[k], rounding * before.w_W.norm());
}

/// Gage pads wear if an area enables it, and nothing else of the bit does.
TEST(WornPads, lose_height_by_the_law_of_their_area) {
  const Case c = wearing("drill-bit-b",
                         ", areas={pads={kind='gage-pad', law='sliding', coefficient=1e-3, "
                         "hardness='10 GPa'}, rest={kind='face', law='none'}, bodies={kind="
                         "'cutter-body', law='none'}, chamfers={kind='chamfer', law='none'}}, "
                         "acceleration=100, every_steps=10",
                         {"bit.set.gage_pads.under_gage=0"});
  Simulation s = start(c);
  drill(c, s, 100);
  double lost = 0.0;
  for (std::size_t i = 0; i < s.work.wear->solids.size(); ++i) {
    const bit::WearSolid& solid = s.work.wear->solids[i];
    if (solid.cutter < 0)
      lost = std::max(lost, s.state.wear->pieces[i].height);
    else
      EXPECT_EQ(s.state.wear->pieces[i].height, solid.start);
  }
  EXPECT_GT(lost, 0.0);
  EXPECT_LE(wear_ledger_defect(c.bit, s.work.wear->worn.bit, s.work.wear->solids, *s.state.wear),
            1e-12);
}

}  // namespace
}  // namespace tdbd::simulation::worn_parts_test
