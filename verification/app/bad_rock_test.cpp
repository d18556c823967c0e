#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/small_case.hpp"

namespace tdbd::app::bad_rock_test {

/// A square net over a plane at a depth, facets up, as text (OFF, mm). A facet is left out (a hole)
/// or turned over.
struct Net {
  int cells = 30;
  double edge = 4.0, depth = 1.0;
  int left_out = -1, flipped = -1;
  bool all_flipped = false;
  bool degenerate = false;
  bool pierced = false;  ///< a point is drawn under facets beyond its own, whose middle dips
  bool fin = false;      ///< a facet more on an inner edge
  bool island = false;   ///< a facet of its own beside the net
};

std::string facet(const Net& n, int number, int a, int b, int c) {
  if (number == n.left_out) return "";
  const bool down = (number == n.flipped) != n.all_flipped;
  return down ? fmt::format("3 {} {} {}\n", a, b, c) : fmt::format("3 {} {} {}\n", a, c, b);
}

std::string off(const Net& n) {
  const int side = n.cells + 1, points = side * side;
  const int facets =
      2 * n.cells * n.cells - (n.left_out >= 0 ? 1 : 0) + (n.fin ? 1 : 0) + (n.island ? 1 : 0);
  std::string text =
      fmt::format("OFF\n{} {} 0\n", points + (n.fin ? 1 : 0) + (n.island ? 3 : 0), facets);
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      // A point on its neighbour makes two facets without area.
      const bool special = i == 7 && j == 7;
      const double x = special && n.degenerate ? 6.0 : special && n.pierced ? 10.3 : i;
      text += fmt::format(
          "{} {} {}\n", n.edge * (x - 0.5 * n.cells), n.edge * (j - 0.5 * n.cells),
          n.pierced && j == 7 && (i == 7 || i == 9) ? n.depth + (i == 7 ? 1.0 : 2.0) : n.depth);
    }
  if (n.fin) text += "0 0 -50\n";
  if (n.island) text += "200 0 0\n200 4 0\n204 0 0\n";
  for (int j = 0; j < n.cells; ++j)
    for (int i = 0; i < n.cells; ++i) {
      const int a = j * side + i, number = 2 * (j * n.cells + i);
      text += facet(n, number, a, a + 1, a + side + 1);
      text += facet(n, number + 1, a, a + side + 1, a + side);
    }
  if (n.fin) text += fmt::format("3 {} {} {}\n", 5 * side + 5, 5 * side + 6, points);
  if (n.island) text += fmt::format("3 {} {} {}\n", points, points + 1, points + 2);
  return text;
}

SmallCase case_on(const Net& net) {
  SmallCase c;
  c.write("rock.off", off(net));
  c.edit("case.toml", "wall = \"20 mm\"", "shape = \"file\"\nfile = \"rock.off\"");
  return c;
}

/// One mistake in the file of the rock: the message contains these words.
void expect_wrong(const SmallCase& c, const std::string& file, const std::string& words) {
  for (const battery::Outcome& o : {c.check(), c.run()}) {
    EXPECT_EQ(o.exit_code, 2);
    EXPECT_EQ(o.err.rfind("tdbd: " + c.path(file).string() + ": ", 0), 0u) << o.err;
    EXPECT_NE(o.err.find(words), std::string::npos) << o.err;
  }
  EXPECT_FALSE(std::filesystem::exists(c.path("out")));
}

TEST(BadRock, that_the_net_is_right) {
  const auto o = case_on({}).run();
  EXPECT_EQ(o.exit_code, 0) << o.err;
}

TEST(BadRock, holes) { expect_wrong(case_on({.left_out = 500}), "rock.off", "boundary"); }

TEST(BadRock, a_flipped_facet) { expect_wrong(case_on({.flipped = 500}), "rock.off", "flipped"); }

TEST(BadRock, all_facets_flipped) {
  expect_wrong(case_on({.all_flipped = true}), "rock.off", "found all facets flipped");
}

TEST(BadRock, degenerate_facets) {
  expect_wrong(case_on({.degenerate = true}), "rock.off", "degenerate");
}

TEST(BadRock, an_edge_of_three_facets) {
  expect_wrong(case_on({.fin = true}), "rock.off", "edge of more than two triangles");
}

TEST(BadRock, two_pieces) {
  expect_wrong(case_on({.island = true}), "rock.off", "not one connected surface: 2 pieces");
}

/// Tested once, when the case is read; a case may disable the test.
TEST(BadRock, a_surface_that_intersects_itself) {
  const SmallCase c = case_on({.pierced = true});
  expect_wrong(c, "rock.off", "pairs of triangles that intersect, the first triangle ");
  EXPECT_EQ(c.check({"--set", "rock.intersection_check=off"}).exit_code, 0);
}

TEST(BadRock, a_wrong_unit) {
  const SmallCase c = case_on({});
  c.edit("case.toml", "shape =", "unit = 1\nshape =");
  expect_wrong(c, "rock.off", "found edges of about 4.3e+03 mm with rock.unit = 1 m");
  expect_wrong(c, "rock.off", "is it in mm (rock.unit = \"1 mm\": edges of ");
}

/// A sheet of 120 mm whose file is in metres, read as mm, and one that is narrower than the bit.
TEST(BadRock, a_unit_that_makes_the_rock_too_small) {
  const SmallCase small = case_on({.cells = 30, .edge = 0.004});
  expect_wrong(small, "rock.off", "is it in m (rock.unit = \"1 m\": edges of ");
  const SmallCase narrow = case_on({.cells = 8, .edge = 4.0});
  const auto told = narrow.check();
  EXPECT_NE(told.err.find("rock.off: the rock is 32 mm wide with rock.unit = 0.001 m, and the bit"),
            std::string::npos)
      << told.err;
}

/// The header of the file states another unit than the case.
TEST(BadRock, a_unit_other_than_the_file_states) {
  const SmallCase c = case_on({});
  c.write("rock.off", "OFF\n# tdbd unit mm" + off({}).substr(3));
  EXPECT_EQ(c.check().exit_code, 0) << c.check().err;
  c.edit("case.toml", "shape =", "unit = 1\nshape =");
  const auto o = c.check();
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_NE(o.err.find("rock.unit: found 1 m, but the header of "), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("rock.off states the unit mm, expected the unit that the file states"),
            std::string::npos)
      << o.err;
}

TEST(BadRock, no_mesh_at_all) {
  const SmallCase c = case_on({});
  c.write("rock.off", "a poem\n");
  expect_wrong(c, "rock.off:1", "found 'a', expected 'OFF'");
}

TEST(BadRock, a_bit_that_starts_inside_it) {
  expect_wrong(case_on({.depth = -12.0}), "case.toml:7: motion",
               "found the middle of cutter-2/face ");
  EXPECT_EQ(case_on({.depth = -3.0}).check().exit_code, 0);
}

TEST(BadRock, a_bit_that_starts_wholly_below_its_surface) {
  expect_wrong(case_on({.depth = -200.0}), "case.toml:7: motion",
               "below the rock's surface at the start");
}

}  // namespace tdbd::app::bad_rock_test
