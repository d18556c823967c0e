#include <gtest/gtest.h>

#include "core/read_file.hpp"
#include "sweep/point/run_point.hpp"
#include "sweep/sweep.hpp"
#include "verification/sweep/small_design.hpp"

namespace tdbd::sweep::kept_test {

/// A store of numbers that counts how many were made.
struct Store {
  explicit Store(double most) : kept(most) {}

  int get(const std::string& key, int value, double weight = 1.0) {
    const auto make = [&] {
      ++made;
      return value;
    };
    return *kept.get(key, make, [&](int) { return weight; });
  }

  Kept<int> kept;
  int made = 0;
};

TEST(Kept, makes_a_value_once) {
  Store s(4.0);
  EXPECT_EQ(s.get("a", 1), 1);
  EXPECT_EQ(s.get("b", 2), 2);
  EXPECT_EQ(s.get("a", 3), 1);
  EXPECT_EQ(s.made, 2);
}

TEST(Kept, lets_the_oldest_go_that_weigh_too_much_together) {
  Store s(4.0);
  s.get("a", 1, 1.0);
  s.get("b", 2, 2.0);
  s.get("c", 3, 3.0);  // a and b go
  EXPECT_EQ(s.get("c", 0), 3);
  EXPECT_EQ(s.get("d", 4, 1.0), 4);  // all of 4.0 is used
  EXPECT_EQ(s.get("c", 0), 3);
  EXPECT_EQ(s.made, 4);
  EXPECT_EQ(s.get("b", 5, 1.0), 5);  // c goes
  EXPECT_EQ(s.get("d", 0), 4);
  EXPECT_EQ(s.get("c", 6, 1.0), 6);
}

TEST(Kept, does_not_keep_what_weighs_more_than_it_holds) {
  Store s(4.0);
  s.get("a", 1, 1.0);
  EXPECT_EQ(s.get("b", 2, 5.0), 2);
  EXPECT_EQ(s.get("b", 3, 5.0), 3);
  EXPECT_EQ(s.get("a", 4), 1);
}

TEST(Kept, does_not_keep_what_has_no_key) {
  Store s(4.0);
  EXPECT_EQ(s.get("", 1), 1);
  EXPECT_EQ(s.get("", 2), 2);
}

}  // namespace tdbd::sweep::kept_test

namespace tdbd::sweep::starts_test {

namespace fs = std::filesystem;

/// A few steps of bit R.
std::string design(const std::string& levels) {
  return "[sweep]\ncase = \"" TDBD_SOURCE_DIR
         "/cases/bit-r-rolling.toml\"\nfigures = [\"removed_volume_m3\", \"rock_triangles_start\", "
         "\"rock_quality_min\"]\n[set]\nrock.wall = \"20 mm\"\ntime.revolutions = 0.02\n" +
         levels;
}

const std::string cones =
    "[[factors]]\nkey = \"rock.edge_length\"\nvalues = [\"12 mm\", \"10 mm\"]\n"
    "[[factors]]\nkey = \"update.gage_teeth\"\nvalues = [\"normal\", \"down\"]\n"
    "[[factors]]\nkey = \"motion.rate_of_penetration\"\nvalues = [\"10 m/h\", \"20 m/h\"]\n";

const std::string cutters =
    "[[factors]]\nkey = \"bit.set.adjust.back_rake\"\nvalues = [\"0 deg\", \"5 deg\"]\n"
    "[[factors]]\nkey = \"update.directions\"\nvalues = [\"hybrid\", \"all-down\"]\n"
    "[[factors]]\nkey = \"update.inside_cutters\"\nvalues = [\"down\", \"plus-x\"]\n"
    "[[factors]]\nkey = \"update.exit_from\"\nvalues = [\"parts\", \"whole\"]\n"
    "[[factors]]\nkey = \"motion.rate_of_penetration\"\nvalues = [\"10 m/h\", \"20 m/h\"]\n";

/// The same of bit B.
std::string with_bit_b(std::string text) {
  const std::string cones_case = "bit-r-rolling", pdc_case = "bit-b-steady";
  return text.replace(text.find(cones_case), cones_case.size(), pdc_case)
      .replace(text.find("[set]\n"), 6, "[set]\nrock.edge_length = \"8 mm\"\n");
}

/// The bytes of the table's two files.
std::string table_of(const Design& d, const fs::path& table, int threads, Keeping keeping) {
  SweepOptions options;
  options.table = table;
  options.threads = threads;
  options.keeping = keeping;
  const SweepResult r = run_sweep(d, options);
  EXPECT_TRUE(r.written);
  EXPECT_EQ(r.failed, 0) << r.first_failure;
  return read_file(table, "a table") +
         read_file(fs::path(table).replace_extension(".csv"), "a table");
}

void expect_same_bytes(const std::string& name, const std::string& text) {
  const fs::path folder = empty_folder("starts_" + name);
  const Design d = design_from(folder, text);
  const std::string alone = table_of(d, folder / "alone.nc", 1, Keeping::off);
  EXPECT_EQ(table_of(d, folder / "kept.nc", 1, Keeping::on), alone);
  EXPECT_EQ(table_of(d, folder / "two.nc", 2, Keeping::on), alone);
}

TEST(Starts, change_no_byte_of_a_table_of_cones) { expect_same_bytes("cones", design(cones)); }

TEST(Starts, change_no_byte_of_a_table_of_cutters) {
  expect_same_bytes("cutters", with_bit_b(design(cutters)));
}

/// Points of one bit and one rock share them, others do not.
TEST(Starts, are_made_once) {
  Starts kept(Keeping::on);
  const auto bit_of = [&](std::vector<std::string> overrides) {
    overrides.push_back("rock.edge_length=12 mm");
    const simulation::Case c =
        read_case(TDBD_SOURCE_DIR "/cases/bit-b-steady.toml", overrides, kept);
    start(c, kept, {});
    const auto none = [] { return rock::CuttingBit{}; };
    return kept.bits.get(c.bit_hash, none, [](const rock::CuttingBit&) { return 1.0; });
  };
  const auto first = bit_of({});
  EXPECT_FALSE(first->groups.empty());
  EXPECT_EQ(bit_of({"motion.rate_of_penetration=3 m/h"}), first);
  EXPECT_NE(bit_of({"bit.set.adjust.back_rake=2 deg"}), first);
}

/// What is kept is bounded: 16 bits, and a million triangles of rock, together and alone.
TEST(Starts, keep_no_more_than_memory_has_room_for) {
  Starts kept(Keeping::on);
  int made = 0;
  const auto weighs = [](double weight) { return [weight](const auto&) { return weight; }; };
  const auto surface = [&](const char* key, double triangles) {
    const auto make = [&] {
      ++made;
      return simulation::StartSurface{};
    };
    kept.surfaces.get(key, make, weighs(triangles));
  };
  surface("a", 1e6);
  surface("a", 1e6);
  EXPECT_EQ(made, 1);
  surface("too large", 1.1e6);
  surface("too large", 1.1e6);
  EXPECT_EQ(made, 3);
  surface("b", 1e5);  // and a goes
  surface("a", 1e6);
  EXPECT_EQ(made, 5);

  int bits = 0;
  const auto bit = [&](int key) {
    const auto make = [&] {
      ++bits;
      return rock::CuttingBit{};
    };
    kept.bits.get(std::to_string(key), make, weighs(1.0));
  };
  for (int twice = 0; twice < 2; ++twice)
    for (int i = 1; i <= 16; ++i) bit(i);
  EXPECT_EQ(bits, 16);
  bit(17);  // and 1 goes
  bit(1);
  EXPECT_EQ(bits, 18);
}

}  // namespace tdbd::sweep::starts_test
