#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/tolerance.hpp"
#include "rock/maintain/invariants.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/simulation/mesh_bit.hpp"

/// Every combination of what makes a step quicker, on every kind of run: the rock stays sound, and an option that only
/// measures or computes differently leaves the rock as it is.
namespace tdbd::simulation::option_combinations_test {

using Settings = std::vector<std::string>;

struct Kind {
  const char* name;
  const char* file;  ///< in cases; none: one cutter in flat rock
  Settings settings;
};

void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

/// One value of each option.
struct Options {
  int rest, section_every;
  const char* exit_from;
};

constexpr int steps = 24;

/// A case of one cutter, 20 mm from the axis.
std::string one_cutter_case() {
  const auto folder = test_folder();
  write_file(folder / "one.csv",
             "bit,cutter,blade,zone,dia_mm,r_tip_mm,phi_deg,h_tip_mm,profile_angle_deg,"
             "back_rake_deg,side_rake_deg\none,1,1,nose,13.4,20,0,0,0,15,0\n");
  const std::string bit =
      write_file(folder / "one.toml",
                 "name = \"one\"\ntable = \"one.csv\"\ngage_diameter = \"56 mm\"\n"
                 "[cutters]\nchamfer = \"0.3 mm\"\nchamfer_angle = \"45 deg\"\nlength = \"8 mm\"\n"
                 "table_thickness = \"2 mm\"\n");
  return write_case(
      folder, bit, "shape = \"flat\"\nradius = \"40 mm\"\nwall = \"15 mm\"\nedge_length = \"1 mm\"",
      "step = \"1 ms\"\nduration = \"120 ms\"");
}

Case case_of(const Kind& kind, const Options& o) {
  Settings all = kind.settings;
  all.push_back(fmt::format("maintenance.rest={}", o.rest));
  all.push_back(fmt::format("measure.section_every={}", o.section_every));
  all.push_back(fmt::format("update.exit_from='{}'", o.exit_from));
  return read_case(
      kind.file == nullptr ? one_cutter_case() : std::string(TDBD_SOURCE_DIR "/cases/") + kind.file,
      all);
}

Simulation drilled(const Case& c, int threads = 1) {
  const ThreadLimit limit(threads);
  Simulation s = start(c);
  for (int i = 0; i < steps; ++i) step(c, s);
  return s;
}

bool is_moved_by_forces(const Kind& kind) {
  return start(case_of(kind, {0, 1, "parts"})).state.drive.has_value();
}

void expect_sound_rock(const Simulation& s) {
  EXPECT_LE(ledger_defect(s), tolerance::ledger);
  EXPECT_EQ(rock::describe(rock::check_disc(s.state.rock)), "");
  EXPECT_GT(s.state.ledger.removed.value(), 0.0);
}

void expect_equal_rock(const Simulation& a, const Simulation& b) {
  EXPECT_EQ(mesh::positions_of(a.state.rock.surface), mesh::positions_of(b.state.rock.surface));
  EXPECT_EQ(a.state.rock.surface.triangles, b.state.rock.surface.triangles);
  EXPECT_EQ(a.state.ledger.removed_by_revolution, b.state.ledger.removed_by_revolution);
}

class OptionCombinations : public testing::TestWithParam<Kind> {};

/// The whole cutter and its parts one after another lead to the same places but for rounding, and to
/// the same decisions of maintenance: total volumes agree to this share.
constexpr double same_volume = 1e-12;
/// Contact forces depend on which part moved a vertex (rock (14)), and so does a motion by forces.
constexpr double same_volume_by_forces = 7e-3;

TEST_P(OptionCombinations, keep_the_rock_sound) {
  const bool by_forces = is_moved_by_forces(GetParam());
  for (const int rest : {0, 4}) {
    const Simulation plain = drilled(case_of(GetParam(), {rest, 1, "parts"}));
    for (const char* exit_from : {"parts", "whole"})
      for (const int every : {1, 4}) {
        SCOPED_TRACE(
            fmt::format("rest {}, sections every {}, exit from {}", rest, every, exit_from));
        if (by_forces && every > 1) {
          EXPECT_THROW(case_of(GetParam(), {rest, every, exit_from}), InputError);
          continue;
        }
        const Case c = case_of(GetParam(), {rest, every, exit_from});
        const Simulation s = drilled(c);
        expect_sound_rock(s);
        expect_equal_rock(s, drilled(c, 2));
        if (std::string(exit_from) == "parts") expect_equal_rock(s, plain);
        EXPECT_NEAR(s.state.ledger.removed.value() / plain.state.ledger.removed.value(), 1.0,
                    by_forces ? same_volume_by_forces : same_volume);
      }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, OptionCombinations,
    testing::Values(
        Kind{"everything", "bit-b-steady.toml", {"rock.edge_length='4 mm'"}},
        Kind{"volumes_only",
             "bit-b-steady.toml",
             {"rock.edge_length='4 mm'", "measure.section='off'", "measure.contact='off'"}},
        Kind{"contact_off",
             "bit-b-steady.toml",
             {"rock.edge_length='4 mm'", "measure.contact='off'"}},
        Kind{"sections_off",
             "bit-b-steady.toml",
             {"rock.edge_length='4 mm'", "measure.section='off'"}},
        Kind{"sharp_discs", "standard-workload.toml", {"rock.edge_length='4 mm'"}},
        Kind{"one_cutter", nullptr, {}}, Kind{"core", "core.toml", {"rock.edge_length='3 mm'"}},
        Kind{"tooth", "single-tooth.toml", {"rock.edge_length='0.6 mm'"}},
        Kind{"mesh_bit", "outside-bit.toml", {}},
        Kind{"cones",
             "bit-r-rolling.toml",
             {"rock.edge_length='4 mm'", "motion.rate_of_penetration='120 m/h'"}},
        Kind{"layers", "high-frequency-beds.toml", {"rock.edge_length='4 mm'"}},
        Kind{"by_forces", "drill-bit-b.toml", {"rock.edge_length='4 mm'"}},
        Kind{"whirl", "bit-b-whirl.toml", {"rock.edge_length='4 mm'"}}),
    [](const testing::TestParamInfo<Kind>& kind) { return std::string(kind.param.name); });

}  // namespace tdbd::simulation::option_combinations_test
