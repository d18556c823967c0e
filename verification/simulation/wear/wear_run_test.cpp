#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bit/bit.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "simulation/result/recorder.hpp"
#include "simulation/result/run.hpp"
#include "simulation/step/drive.hpp"
#include "simulation/step/wear_step.hpp"
#include "verification/simulation/mesh_bit.hpp"
#include "verification/simulation/same_run.hpp"

namespace tdbd::simulation::wear_run_test {
namespace {

/// Of the volume that a mesh lost to the worn volume, relative.
constexpr double wear_ledger = 1e-12;

Case wearing(std::vector<std::string> settings = {}) {
  settings.insert(settings.begin(), {"rock.edge_length='4 mm'", "time.revolutions=0.2",
                                     "wear.every_steps=7", "wear.from=0"});
  return read_case(TDBD_SOURCE_DIR "/cases/wear-bit-b.toml", settings);
}

const std::vector<std::string> drilled_by_forces{
    "motion={kind='drilling', rotary_speed='120 rpm', weight_on_bit='30 kN', "
    "expected_rate='25 m/h', torque_at_start='2600 N m'}",
    "string={mass='1000 kg', torsional_inertia='10 kg m2', bending_inertia='10 kg m2', "
    "lateral_stiffness='5e7 N/m', lateral_damping='2e5 N s/m', axial_damping='2e5 N s/m', "
    "torsional_stiffness='5000 N m/rad', torsional_damping='50 N m s/rad', "
    "bending_stiffness='1e6 N m/rad', bending_damping='1e3 N m s/rad', attachment_height=0}",
    "time={step='1 ms', duration='60 ms'}"};

void drill(const Case& c, Simulation& s, int steps) {
  for (int i = 0; i < steps; ++i) step(c, s);
}

TEST(WearRun, closes_its_ledger_and_removes_mass) {
  const Case c = wearing();
  Simulation s = start(c);
  drill(c, s, 40);
  EXPECT_GE(s.state.wear->steps, 5);
  double volume = 0.0, widest = 0.0;
  for (std::size_t i = 0; i < c.bit.cutters.size(); ++i) {
    volume += s.state.wear->pieces[i].volume;
    widest = std::max(widest, s.work.wear->flats[i].width);
  }
  EXPECT_GT(volume, 0.0);
  EXPECT_GT(widest, 0.0);
  EXPECT_LE(wear_ledger_defect(c.bit, s.work.wear->worn.bit, s.work.wear->solids, *s.state.wear),
            wear_ledger);
  EXPECT_LT(bit::mass_properties(s.work.wear->worn.bit).mass, bit::mass_properties(c.bit).mass);
  EXPECT_LE(ledger_defect(s), 1e-12);
}

/// In the middle of windows, before a wear step, and with one in the next step.
TEST(WearRun, continues_from_a_checkpoint_bitwise_identical) {
  std::vector<std::vector<std::string>> motions{{}, drilled_by_forces};
  for (const std::vector<std::string>& settings : motions) {
    const Case c = wearing(settings);
    for (const int before : {11, 13, 14, 21}) {
      Simulation whole = start(c);
      drill(c, whole, before);
      const auto file = test_folder() / "checkpoint.bin";
      write_checkpoint(file, c, whole, {});
      Checkpoint saved = read_checkpoint(file, c);
      Simulation resumed = resume(c, std::move(saved.state), std::move(saved.statistics));
      expect_same_run(whole, resumed);
      drill(c, whole, 17);
      drill(c, resumed, 17);
      EXPECT_GT(whole.state.wear->steps, 2);
      SCOPED_TRACE(fmt::format("{} steps, {} settings", before, settings.size()));
      expect_same_run(whole, resumed);
    }
  }
}

TEST(WearRun, is_bitwise_identical_on_two_threads) {
  const Case c = wearing();
  const auto drilled = [&](int threads) {
    const ThreadLimit limit(threads);
    Simulation s = start(c);
    drill(c, s, 25);
    return s;
  };
  expect_same_run(drilled(1), drilled(2));
}

/// Pose and velocity of the bit's origin before and after a wear step. Relative to 1 m and to 1 m/s
/// and rad/s: a few roundings.
TEST(WearRun, continues_the_motion_of_a_bit_that_forces_move) {
  constexpr double rounding = 1e-13;
  std::vector<std::string> settings = drilled_by_forces;
  settings.insert(settings.end(), {"wear.every_steps=40", "wear.largest_growth=0.1"});
  const Case c = wearing(settings);
  Simulation s = start(c);
  drill(c, s, 40);
  const auto motion = [&] {
    return velocity_of(case_now(c, s.work).drilling.system, s.state.drive->state);
  };
  const BitVelocity before = motion();
  const double mass = case_now(c, s.work).drilling.system.mass;
  wear_if_due(c, s);
  ASSERT_EQ(s.state.wear->steps, 1);
  const BitVelocity after = motion();
  EXPECT_LT(case_now(c, s.work).drilling.system.mass, mass);
  EXPECT_LT((after.p_WB - before.p_WB).norm(), rounding);
  EXPECT_LT((after.v_W - before.v_W).norm(), rounding);
  EXPECT_LT((after.w_W - before.w_W).norm(), rounding * before.w_W.norm());
}

/// A flat grows by at most the share that the case allows, however long windows may be.
TEST(WearRun, flats_grow_by_at_most_the_given_share) {
  const Case c = wearing({"wear.every_steps=0", "wear.largest_growth=0.002"});
  Simulation s = start(c);
  std::vector<bit::WearFlat> flats = s.work.wear->flats;
  double most = 0.0;
  for (int i = 0; i < 40; ++i) {
    step(c, s);
    for (std::size_t k = 0; k < flats.size(); ++k)
      most = std::max(most,
                      (s.work.wear->flats[k].height - flats[k].height) / c.bit.cutters[k].diameter);
    flats = s.work.wear->flats;
  }
  EXPECT_GT(s.state.wear->steps, 1);
  EXPECT_GT(most, 0.0);
  EXPECT_LE(most, 0.002);
}

TEST(WearRun, ends_where_a_flat_is_as_large_as_its_cutter_with_the_wear_before) {
  const Case c = wearing();
  Simulation s = start(c);
  drill(c, s, 5);
  const bit::WearSolid& solid = s.work.wear->solids[3];
  PieceWear& cutter = s.state.wear->pieces[3];
  cutter.height = solid.largest - 1e-6;
  cutter.volume = bit::flat_at(solid, cutter.height).volume;
  cutter.window.height = 2e-6;
  const WearState before = *s.state.wear;
  try {
    drill(c, s, 20);
    FAIL() << "no error";
  } catch (const WearEnd& e) {
    const std::string expected = "the flat of " + solid.name + " is as large as the cutter";
    EXPECT_EQ(std::string(e.what()).substr(0, expected.size()), expected);
  }
  EXPECT_EQ(s.state.wear->pieces[3].height, before.pieces[3].height);
  EXPECT_EQ(s.state.wear->steps, before.steps);
}

/// In the hands of users: 2.7 mm of wear for every turn, until the cutters are gone.
TEST(WearRun,
     a_flat_as_large_as_the_cutter_ends_the_run_with_the_state_saved_and_the_cutter_named) {
  const Case c = wearing({"motion.rate_of_penetration='60 m/h'", "wear.acceleration=1e6",
                          "wear.largest_growth=0.1", "wear.every_steps=0", "time.revolutions=3"});
  RunOptions options;
  options.folder = test_folder() / "worn-out";
  try {
    run(c, options);
    FAIL() << "no error";
  } catch (const RunError& e) {
    const std::string message = e.what();
    EXPECT_NE(message.find("the flat of cutter-"), std::string::npos) << message;
    EXPECT_NE(message.find(" is as large as the cutter"), std::string::npos) << message;
  }
  EXPECT_TRUE(std::filesystem::exists(options.folder / "failure.txt"));
  const Checkpoint saved = read_checkpoint(options.folder / "checkpoint.bin", c);
  EXPECT_GT(saved.state.wear->steps, 5);
}

/// Wear that is far too fast: the message names the setting; the checkpoint is there.
TEST(WearRun, names_an_acceleration_that_is_too_large_and_saves_the_state) {
  const Case c = wearing({"wear.acceleration=1e12"});
  RunOptions options;
  options.folder = test_folder() / "fast";
  try {
    run(c, options);
    FAIL() << "no error";
  } catch (const RunError& e) {
    EXPECT_NE(std::string(e.what()).find("wear.acceleration: found 1e+12"), std::string::npos)
        << e.what();
  }
  EXPECT_TRUE(std::filesystem::exists(options.folder / "checkpoint.bin"));
  EXPECT_TRUE(std::filesystem::exists(options.folder / "failure.txt"));
}

/// The contact of a flat is its area behind the edge times the share that is in rock. Steady drilling
/// has cutters whose edge on the flat is in rock as a whole: they bear with all of it, in a coarse rock.
TEST(WearRun, flats_whose_edge_is_in_rock_bear_the_stress_times_their_area_exactly) {
  constexpr double rounding = 1e-12, stress = 100e6;
  const Case c = wearing({"forces.cutter_body.cap=10"});
  Simulation s = start(c);
  drill(c, s, 300);
  const Case& now = case_now(c, s.work);
  int whole = 0;
  for (std::size_t p = 0; p < now.bit.parts.size(); ++p) {
    const bit::Part& part = now.bit.parts[p];
    if (part.kind != bit::PartKind::cutter_body) continue;
    const rock::FlatPiece all = flat_between(s.work.faces.faces[at(part.cutter)].flat, -1.0, 1.0);
    const double most = stress * all.area, force = s.work.loads.parts[p].normal;
    EXPECT_LE(s.work.measures.sections[at(part.cutter)].flat_area, all.area * (1.0 + rounding))
        << part.name;
    whole += std::abs(force - most) <= rounding * most ? 1 : 0;
  }
  EXPECT_GE(whole, 15);
}

TEST(WearRun, begins_to_wear_at_the_given_time) {
  const Case c = wearing({"wear.from='40 ms'"});
  Simulation s = start(c);
  drill(c, s, 20);
  EXPECT_EQ(s.state.wear->distance, 0.0);
  EXPECT_EQ(s.state.wear->window_steps, 0);
  drill(c, s, 1);
  EXPECT_EQ(s.state.wear->window_steps, 1);
}

TEST(WearRun, reports_its_wear_by_cutter) {
  const Case c = wearing();
  RunOptions options;
  options.folder = test_folder() / "run";
  const RunSummary summary = run(c, options);
  ASSERT_TRUE(summary.wear);
  EXPECT_EQ(summary.wear->pieces.size(), c.bit.cutters.size());
  EXPECT_NEAR(summary.wear->distance, 6000.0 * 0.2 * 15.0 / 3600.0 * 0.5,
              1e-12 * summary.wear->distance);
  std::ifstream in(options.folder / "summary.json");
  const auto json = nlohmann::json::parse(in);
  EXPECT_LE(json["wear"]["volume_ledger_defect"].get<double>(), wear_ledger);
  EXPECT_EQ(json["wear"]["over_distance"]["distance_m"].size(), summary.wear->records.size());
  EXPECT_GT(summary.wear->records.size(), 2U);
  // The last wear step is at the end of the run.
  EXPECT_EQ(summary.wear->records.back().distance, summary.wear->distance);
  for (const PieceWearFigures& cutter : summary.wear->pieces) EXPECT_EQ(cutter.pending, 0.0);
  EXPECT_NEAR(summary.wear->records.back().rate, 15.0 / 3600.0, 1e-12);
  EXPECT_GT(summary.wear->records.back().weight, 0.0);
  std::vector<double> volumes;
  for (const PieceWearFigures& cutter : summary.wear->pieces)
    if (cutter.flat.volume > 0.0) volumes.push_back(cutter.flat.volume);
  double sum = 0.0, squares = 0.0;
  for (const double v : volumes) sum += v;
  const double mean = sum / static_cast<double>(volumes.size());
  for (const double v : volumes) squares += (v - mean) * (v - mean);
  EXPECT_NEAR(summary.wear->worn, sum, 1e-12 * sum);
  EXPECT_EQ(summary.wear->largest, std::ranges::max(volumes));
  EXPECT_NEAR(summary.wear->unevenness,
              std::sqrt(squares / static_cast<double>(volumes.size())) / mean, 1e-12);
}

}  // namespace
}  // namespace tdbd::simulation::wear_run_test
