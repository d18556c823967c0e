#include "mesh/files/length_unit.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>

#include "core/error.hpp"
#include "core/units.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/example_meshes.hpp"
#include "mesh/files/files.hpp"
#include "mesh/files/solids.hpp"
#include "mesh/measures.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::mesh::length_unit_test {

namespace fs = std::filesystem;

/// A path used by the running test alone.
fs::path temporary(const std::string& name) {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  return tdbd::temporary_folder() + "tdbd_unit_" + test->name() + "_" + name;
}

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {(std::istreambuf_iterator<char>(in)), {}};
}

std::string refusal(const fs::path& path, double unit) {
  try {
    read_solids(path, unit);
  } catch (const InputError& e) {
    return e.what();
  }
  return "nothing was refused";
}

double any_number() {
  const double mantissa = static_cast<double>(*rc::gen::arbitrary<std::int64_t>());
  return std::ldexp(mantissa, *rc::gen::inRange(-120, 20));
}

RC_GTEST_PROP(DecimalText, reads_back_bitwise_identical_in_any_decimal_unit, ()) {
  const double x = any_number();
  const int power = *rc::gen::inRange(-12, 7);
  const std::string text = decimal_text(x, power);
  RC_ASSERT(decimal_number(text, power) == x);
  const double in_unit = std::stod(text) * std::pow(10.0, power);
  RC_ASSERT(std::abs(in_unit - x) <= 1e-15 * std::abs(x));  // two roundings
}

TEST(DecimalText, moves_the_point_of_the_shortest_digits) {
  EXPECT_EQ(decimal_text(0.0123, -3), "12.3");
  EXPECT_EQ(decimal_text(-0.1, -3), "-100");
  EXPECT_EQ(decimal_text(4e-7, -3), "0.0004");
  EXPECT_EQ(decimal_text(0.0, -3), "0");
  EXPECT_EQ(decimal_text(1e30, -3), "1e33");
  EXPECT_FALSE(decimal_number("1e", -3));
  EXPECT_FALSE(decimal_number("1 ", -3));
  EXPECT_FALSE(decimal_number("nan", -3));
  EXPECT_FALSE(decimal_number("1e99999999999", -3));
  EXPECT_EQ(decimal_number("+2.5E+1", -3), 0.025);
}

TEST(LengthUnit, is_read_with_and_without_a_number) {
  EXPECT_EQ(length_unit("mm").name, "mm");
  EXPECT_EQ(length_unit("1 mm").name, "mm");
  EXPECT_EQ(length_unit("0.1 mm").name, "0.0001m");
  EXPECT_EQ(length_unit("0.1 mm").power, -4);
  EXPECT_NEAR(length_unit("in").metres, 0.0254, 1e-17);
  EXPECT_FALSE(length_unit("in").power);
  for (const char* wrong : {"", "kg", "0 mm", "-1 mm", "furlongish"})
    EXPECT_THROW(length_unit(wrong), UnitError) << wrong;
}

/// Every format states its unit, in single and in double precision, and reads back without one.
TEST(UnitInHeaders, is_written_and_recognised_in_every_format) {
  const TriangleMesh m = battery::box({0, 0, 0}, {0.04, 0.03, 0.02});
  for (const char* unit : {"mm", "in", "m", "0.1 mm"})
    for (const char* name : {"a.stl", "a.obj", "a.off", "a.ply"}) {
      const fs::path path = temporary(name);
      write_mesh(path, m, length_unit(unit));
      const auto stated = stated_unit_of(path);
      ASSERT_TRUE(stated) << unit << name;
      EXPECT_EQ(stated->name, length_unit(unit).name);
      const TriangleMesh back = read_mesh(path, unit_or(path, 1e-3));
      const Box box = bounding_box(back);  // STL is read with its points in another order
      EXPECT_NEAR((box.hi - Vec3(0.04, 0.03, 0.02)).norm() + box.lo.norm(), 0.0, 4e-9)
          << unit << name;
      EXPECT_NE(refusal(path, 2.0).find("found the unit 2m, but the header of "), std::string::npos)
          << refusal(path, 2.0);
    }
}

TEST(UnitInHeaders, is_the_last_word_of_the_names_in_text_stl) {
  const fs::path path = temporary("a.stl");
  const std::vector<Solid> solids = {{"cutter-1/face", battery::box({0, 0, 0}, {1, 1, 1})},
                                     {"", battery::box({2, 0, 0}, {3, 1, 1})}};
  write_solids(path, solids, {length_unit("mm")});
  const std::string text = text_of(path);
  EXPECT_EQ(text.find("solid cutter-1/face unit=mm\n"), 0u) << text.substr(0, 60);
  EXPECT_NE(text.find("vertex 1000 0 0\n"), std::string::npos);
  const std::vector<Solid> back = read_solids(path, 1e-3);
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(back[0].name, "cutter-1/face");
  EXPECT_EQ(back[1].name, "");
  EXPECT_EQ(bounding_box(back[0].mesh).hi, Vec3(1, 1, 1));
}

TEST(UnitInHeaders, may_not_differ_between_solids) {
  const std::string body = "endsolid\n";
  const fs::path path = temporary("two.stl");
  std::ofstream(path) << "solid a unit=mm\n" << body << "solid b unit=in\n" << body;
  EXPECT_NE(refusal(path, 1e-3)
                .find("two.stl:3: found unit=in, expected unit=mm, as in the line of the first"),
            std::string::npos)
      << refusal(path, 1e-3);
  std::ofstream(path) << "solid a\n" << body << "solid b unit=in\n" << body;
  EXPECT_NE(refusal(path, 1e-3).find("found unit=in, expected no unit"), std::string::npos);
}

/// A header that states no length is no statement: such files have the unit that the user gives.
TEST(UnitInHeaders, is_none_without_a_length) {
  EXPECT_FALSE(stated_unit("# tdbd unit kg\nv 0 0 0\n", ".obj"));
  EXPECT_FALSE(stated_unit("# a comment\n# tdbd unit\n", ".obj"));
  EXPECT_FALSE(stated_unit("v 0 0 0\n# tdbd unit mm\n", ".obj"));
  EXPECT_FALSE(stated_unit("solid a unit=\n", ".stl"));
  EXPECT_FALSE(stated_unit("ply\nformat ascii 1.0\nend_header\ncomment tdbd unit mm\n", ".ply"));
  EXPECT_FALSE(stated_unit("", ".off"));
  EXPECT_TRUE(stated_unit("OFF\r\n# tdbd unit mm\r\n", ".off"));
  EXPECT_FALSE(stated_unit_of("/dev/null"));
  EXPECT_FALSE(stated_unit_of("no such file.stl"));
}

/// Old files state no unit, and the unit that is given applies.
TEST(UnitInHeaders, is_not_required) {
  const fs::path path = temporary("old.obj");
  write_mesh(path, tetrahedron());
  EXPECT_FALSE(stated_unit_of(path));
  EXPECT_EQ(unit_contradiction(path, 0.7), "");
  EXPECT_EQ(read_mesh(path, 1e-3).positions[1], Vec3(1e-3, 0, 0));
}

/// A copy keeps the digits of its original in the same unit, stated or not.
TEST(WriteLike, keeps_the_digits_of_the_original) {
  const fs::path original = temporary("original.obj"), copy = temporary("copy.obj");
  for (const char* head : {"", "# tdbd unit mm\n"}) {
    std::ofstream(original) << head << "v 0.1 0.7 12.300\nv 1 0 0\nv 0 1.1 0\nf 1 2 3\n";
    write_like(copy, read_solids(original, 1e-3), {length_unit("mm")}, original, 1e-3);
    EXPECT_EQ(text_of(copy),
              "# tdbd unit mm\ng solid-1\nv 0.1 0.7 12.3\nv 1 0 0\nv 0 1.1 0\n"
              "f 1 2 3\n");
  }
  write_like(copy, read_solids(original, 1e-3), {length_unit("m")}, original, 1e-3);
  EXPECT_NE(text_of(copy).find("v 0.0001 0.0007 0.0123\n"), std::string::npos) << text_of(copy);
}

}  // namespace tdbd::mesh::length_unit_test
