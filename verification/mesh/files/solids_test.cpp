#include "mesh/files/solids.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "mesh/check/check.hpp"
#include "mesh/check/nesting.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/files/files.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::mesh::solids_test {

namespace fs = std::filesystem;

fs::path temporary(const std::string& name) {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  return tdbd::temporary_folder() + "tdbd_solids_" + test->name() + "_" + name;
}

fs::path write_text_file(const std::string& name, const std::string& text) {
  std::ofstream(temporary(name)) << text;
  return temporary(name);
}

/// Corner by corner: what a format must not change, even if it renumbers the points.
std::vector<std::array<Vec3, 3>> corners(const TriangleMesh& m) {
  std::vector<std::array<Vec3, 3>> all;
  all.reserve(m.triangles.size());
  const auto x = [&](int v) { return m.positions[static_cast<std::size_t>(v)]; };
  for (const Triangle& t : m.triangles) all.push_back({x(t[0]), x(t[1]), x(t[2])});
  return all;
}

/// A coordinate with all its digits in use.
double any_coordinate() {
  const double mantissa = static_cast<double>(*rc::gen::arbitrary<std::int64_t>());
  return std::ldexp(mantissa, *rc::gen::inRange(-70, -60));
}

/// Tetrahedra, each next to or on top of the one before: neighbours share the three points of a facet.
std::vector<Solid> any_solids() {
  std::vector<Solid> solids;
  const int n = *rc::gen::inRange(1, 12);
  Vec3 base[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (int k = 0; k < n; ++k) {
    const double x = any_coordinate(), y = any_coordinate(), z = std::abs(any_coordinate());
    const Vec3 top(x, y, 1.0 + z + k);
    TriangleMesh m{{base[0], base[1], base[2], top}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    solids.push_back({"cutter-" + std::to_string(k) + "/face", m});
    if (*rc::gen::arbitrary<bool>()) base[2] = top;
  }
  return solids;
}

void expect_same_bodies(const std::vector<Solid>& a, const std::vector<Solid>& b) {
  RC_ASSERT(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) RC_ASSERT(corners(a[i].mesh) == corners(b[i].mesh));
}

RC_GTEST_PROP(Solids, formats_with_names_keep_names_and_every_bit, ()) {
  const std::vector<Solid> solids = any_solids();
  for (const char* extension : {".stl", ".obj"}) {
    const fs::path path = temporary(std::string("named") + extension);
    write_solids(path, solids);
    const std::vector<Solid> back = read_solids(path, 1.0);
    expect_same_bodies(solids, back);
    for (std::size_t i = 0; i < solids.size(); ++i) RC_ASSERT(solids[i].name == back[i].name);
  }
}

RC_GTEST_PROP(Solids, formats_without_names_fall_into_the_same_pieces, ()) {
  const std::vector<Solid> solids = any_solids();
  RC_PRE(facets_of_bodies(merged(solids)).size() == solids.size());  // none inside another
  for (const char* extension : {".ply", ".off"}) {
    const fs::path path = temporary(std::string("nameless") + extension);
    write_solids(path, solids);
    const std::vector<Solid> back = read_solids(path, 1.0);
    expect_same_bodies(solids, back);
    for (std::size_t i = 0; i < back.size(); ++i)
      RC_ASSERT(back[i].name == "solid-" + std::to_string(i + 1));
  }
}

/// Two stacked boxes share the points of an edge, which a binary STL shows only by their positions.
TEST(Solids, a_binary_stl_falls_into_bodies_that_touch) {
  const std::vector<Solid> boxes = {{"a", battery::box({0, 0, 0}, {1, 1, 1})},
                                    {"b", battery::box({1, 1, 0}, {2, 2, 1})},
                                    {"c", battery::box({0, 0, 1}, {1, 1, 2})}};
  const fs::path path = temporary("boxes.stl");
  write_mesh(path, merged(boxes));
  const std::vector<Solid> back = read_solids(path, 1.0);
  ASSERT_EQ(back.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(corners(back[i].mesh), corners(boxes[i].mesh));
    EXPECT_TRUE(check_closed(back[i].mesh).empty()) << describe(check_closed(back[i].mesh));
  }
}

/// Facets in any order: bodies that share no edge are separated nevertheless.
TEST(Solids, pieces_are_found_in_shuffled_facets) {
  TriangleMesh m = merged(
      {{"a", battery::box({0, 0, 0}, {1, 1, 1})}, {"b", battery::box({5, 0, 0}, {6, 1, 1})}});
  for (std::size_t i = 0; i + 13 < m.triangles.size(); i += 2)
    std::swap(m.triangles[i], m.triangles[i + 12]);
  const auto pieces = divide(m);
  ASSERT_EQ(pieces.size(), 2u);
  for (const TriangleMesh& piece : pieces) EXPECT_TRUE(check_closed(piece).empty());
}

/// One body whose facets and points come in any order: no facet before the last one closes it.
RC_GTEST_PROP(Solids, a_body_in_any_order_is_one_piece, ()) {
  const TriangleMesh body = battery::sphere(1, 1);
  const auto draws = *rc::gen::container<std::vector<unsigned>>(
      body.positions.size() + body.triangles.size(), rc::gen::arbitrary<unsigned>());
  TriangleMesh m = body;
  std::vector<int> number(body.positions.size());
  std::iota(number.begin(), number.end(), 0);
  std::size_t drawn = 0;
  const auto shuffle = [&](auto& items) {
    for (std::size_t i = items.size(); i > 1; --i)
      std::swap(items[i - 1], items[draws[drawn++] % i]);
  };
  shuffle(number);
  shuffle(m.triangles);
  for (std::size_t v = 0; v < number.size(); ++v)
    m.positions[static_cast<std::size_t>(number[v])] = body.positions[v];
  for (Triangle& t : m.triangles)
    for (int& v : t) v = number[static_cast<std::size_t>(v)];
  const auto pieces = divide(m);
  RC_ASSERT(pieces.size() == 1u);
  RC_ASSERT(corners(pieces[0]) == corners(m));
}

/// Two equal facets use each of their edges twice, but close nothing.
TEST(Solids, a_facet_given_twice_stays_with_its_body) {
  TriangleMesh m = battery::box({0, 0, 0}, {1, 1, 1});
  m.triangles[0] = {0, 1, 2};
  m.triangles.insert(m.triangles.begin(), m.triangles[0]);
  const auto pieces = divide(m);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].triangles.size(), 13u);
}

TEST(Solids, a_body_of_an_obj_has_the_name_of_its_group) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const auto path = write_text_file(
      "groups.obj", points + "o cutter 1 \ng empty\ng a\nf 1 3 2\ng b\nf 1//1 2//1 4//1\ng a\n" +
                        "usemtl steel\nf -4 -1 -2\nf 2 3 4\n" + points +
                        "g a\nf 5 7 6\nf 5 6 8\ng\ng a\nf 5 8 7\nf 6 7 8\n");
  const std::vector<Solid> solids = read_solids(path, 1e-3);
  ASSERT_EQ(solids.size(), 2u);
  EXPECT_EQ(solids[0].name, "solid-1");
  EXPECT_EQ(solids[0].mesh.positions[3], Vec3(0, 0, 1e-3));
  EXPECT_EQ(solids[1].name, "a");
  for (const Solid& solid : solids) EXPECT_TRUE(check_closed(solid.mesh).empty());
}

std::string refusal(const std::string& name, const std::string& text) {
  try {
    read_solids(write_text_file(name, text), 1.0);
  } catch (const InputError& e) {
    return e.what();
  }
  return "nothing was refused";
}

void expect_in(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << " is not in: " << text;
}

TEST(Solids, bad_lines_of_text_files_are_named) {
  const std::string facet = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n";
  expect_in(refusal("nan.stl", facet + "vertex 1 nan 0\n"), "nan.stl:5: found 'nan', expected a f");
  expect_in(refusal("few.stl", facet + "vertex 1 2\n"),
            "few.stl:5: found 2 numbers, expected three");
  expect_in(refusal("cut.stl", facet + "vertex 1 0 0\n"), "cut.stl:5: found the end of the file");
  expect_in(refusal("four.stl", facet + "vertex 1 0 0\nvertex 1 1 0\nvertex 2 2 0\n"),
            "four.stl:7: found 'vertex', expected 'endloop'");
  expect_in(refusal("open.stl", "solid a\n"), "open.stl:1: found the end of the file");
  expect_in(refusal("none.stl", "solid a\nendsolid a\n"), "no triangles");
  expect_in(refusal("index.obj", "v 0 0 0\nf 1 2 0\n"), "index.obj:2: found a polygon names");
  expect_in(refusal("zero.obj", "v 0 0 0\nf 0 1 1\n"), "zero.obj:2: found '0'");
  expect_in(refusal("word.obj", "v 0 0 0\nfacet 1 1 1\n"), "word.obj:2: found 'facet'");
  expect_in(refusal("inf.obj", "v 0 0 1e999\n"), "inf.obj:1: found '1e999'");
}

TEST(Solids, a_truncated_binary_stl_is_reported_with_its_size) {
  const fs::path path = temporary("cut.stl");
  write_mesh(path, battery::box({0, 0, 0}, {1, 1, 1}));
  fs::resize_file(path, 600);
  try {
    read_solids(path, 1.0);
    ADD_FAILURE() << "nothing was thrown";
  } catch (const InputError& e) {
    expect_in(e.what(), "600 bytes, expected 684 for 12 facets");
  }
}

}  // namespace tdbd::mesh::solids_test
