#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numeric>

#include "core/parallel.hpp"
#include "mesh/check/check.hpp"
#include "simulation/case/case.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/simulation/sound_rock.hpp"

/// A bit that turns, with rock that breaks out.
namespace tdbd::simulation::spalling_run_test {
namespace {

Case bit_b(std::vector<std::string> more, const std::string& file = "bit-b-3000psi") {
  more.emplace_back("rock.edge_length='3 mm'");
  if (file == "bit-b-3000psi") more.emplace_back("rock.pressure=0");
  return read_case(TDBD_SOURCE_DIR "/cases/" + file + ".toml", more);
}

const std::string on = "spalling={angle='70 deg', ahead_share=0.3}";

Simulation drilled(const Case& c, int steps, int threads = 1) {
  const ThreadLimit limit(threads);
  Simulation s = start(c);
  for (int i = 0; i < steps; ++i) step(c, s);
  return s;
}

void expect_equal(const Simulation& a, const Simulation& b) {
  EXPECT_EQ(mesh::positions_of(a.state.rock.surface), mesh::positions_of(b.state.rock.surface));
  EXPECT_EQ(a.state.rock.surface.triangles, b.state.rock.surface.triangles);
  EXPECT_EQ(a.state.ledger.removed_by_revolution, b.state.ledger.removed_by_revolution);
  EXPECT_EQ(a.work.loads.force_W, b.work.loads.force_W);
}

double broken_out(const Simulation& s) {
  double sum = 0.0;
  for (const CompensatedSum& of_cutter : s.state.spalling->broken_out) sum += of_cutter.value();
  return sum;
}

/// No vertex is left in a cutter or in what breaks out, the ledger closes, the surface is sound, and
/// what broke out is a part of what the faces removed.
TEST(Spalling, keeps_the_contract_of_a_step) {
  const Case c = bit_b({on, "time.revolutions=1"});
  Simulation s = start(c);
  run_out(c, s, 11);
  expect_sound(s);
  EXPECT_GT(broken_out(s), 0.02 * s.state.ledger.removed.value());
  for (std::size_t p = 0; p < c.bit.parts.size(); ++p) {
    const bit::Part& part = c.bit.parts[p];
    if (part.kind != bit::PartKind::face) continue;
    EXPECT_LE(s.state.spalling->broken_out[at(part.cutter)].value(),
              s.state.ledger.removed_by_part[p].value());
  }
}

TEST(Spalling, is_bitwise_the_same_on_two_threads) {
  const Case c = bit_b({on});
  expect_equal(drilled(c, 90, 1), drilled(c, 90, 2));
}

/// Off under pressure, and where no share breaks out: bitwise the run without the table.
TEST(Spalling, that_is_off_changes_nothing) {
  const Simulation plain = drilled(bit_b({}), 60);
  expect_equal(plain, drilled(bit_b({"spalling={angle='70 deg', depth_share=0}"}), 60));
  const Simulation confined =
      drilled(bit_b({"rock.confinement='impermeable'", "rock.overburden='30 MPa'"}), 60);
  expect_equal(
      confined,
      drilled(bit_b({"rock.confinement='impermeable'", "rock.overburden='30 MPa'", on}), 60));
}

/// With the rock that it breaks out a cutter leaves less to the next ones: forces fall.
TEST(Spalling, lowers_the_forces_of_the_next_cutters) {
  const auto weight = [](const Case& c) {
    Simulation s = start(c);
    double sum = 0.0;
    for (int i = 0; i < 500; ++i) {
      step(c, s);
      if (i >= 400) sum -= s.work.loads.force_W.z() / 100.0;
    }
    return sum;
  };
  const double plain = weight(bit_b({"spalling={angle='65 deg', depth_share=0}"})),
               beside = weight(bit_b({"spalling={angle='65 deg'}"}));
  fmt::print("weight {:.0f} N, with break-out beside the faces {:.0f} N\n", plain, beside);
  EXPECT_LT(beside, plain);
  EXPECT_GT(beside, 0.97 * plain);
}

/// With wear steps, which prepare the bit again, and with parts that start late.
TEST(Spalling, goes_with_wear_and_late_starts) {
  const Case c = bit_b({on, "spalling.up_to_pressure='1 GPa'", "wear.every_steps=7", "wear.from=0",
                        "bit.set.areas.a={blade=2, removal.from_time='20 ms'}"},
                       "wear-bit-b");
  const Simulation s = drilled(c, 60);
  EXPECT_GT(broken_out(s), 0.0);
  EXPECT_GT(s.state.wear->steps, 3);
  EXPECT_EQ(s.work.waits, Waits::none);
  expect_sound(s);
  Simulation first = drilled(c, 40);
  Simulation resumed = resume(c, first.state, first.statistics);
  for (int i = 0; i < 20; ++i) step(c, resumed);
  expect_equal(s, resumed);
}

/// Rock breaks out in the beds of its material alone.
TEST(Spalling, follows_the_beds) {
  const Case c = bit_b({on, "spalling.material='sierra-white-granite'",
                        "rock.layers=[{top='1 m', material='sierra-white-granite'}]"});
  EXPECT_EQ(broken_out(drilled(c, 60)), 0.0);
  const Case above = bit_b({on, "spalling.material='mancos-shale'",
                            "rock.layers=[{top='1 m', material='sierra-white-granite'}]"});
  EXPECT_GT(broken_out(drilled(above, 60)), 0.0);
}

}  // namespace
}  // namespace tdbd::simulation::spalling_run_test
