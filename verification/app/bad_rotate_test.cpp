#include <gtest/gtest.h>

#include "app/mistake.hpp"
#include "app/rotate_folder.hpp"

namespace tdbd::app::bad_rotate_test {

class BadRotate : public ::testing::TestWithParam<Mistake> {};

TEST_P(BadRotate, is_rejected_with_its_place_and_reason) {
  const Mistake& m = GetParam();
  const RotateFolder c;
  c.edit("case.toml", m.from, m.to);
  const std::string message = c.path("case.toml").string() + ":" + m.message;
  expect_refusal(c.check(), message);
  expect_refusal(c.rotate(), message);
  expect_refusal(c.converge({"--over", "time.step", "--levels", "4"}), message);
  EXPECT_FALSE(std::filesystem::exists(c.path("out")));
  EXPECT_FALSE(std::filesystem::exists(c.path("orders")));
}

#define TDBD_POSSIBLE                                                                     \
  "expected what a body can have (body.check = \"off\" admits the inertias of published " \
  "benchmarks that no body has)"

#define TDBD_ENDLESS                            \
  "found a kinetic energy that is not finite, " \
  "expected numbers whose squares and inverses are numbers"

const Mistake mistakes[] = {
    {"inertia_that_breaks_the_triangle_inequality", "[0, 0, 3]]", "[0, 0, 5]]",
     "3: body.inertia: found an inertia that violates the triangle inequality: principal values 2, "
     "2.6, 5 kg m2, " TDBD_POSSIBLE},
    {"inertia_that_is_not_positive", "[[2, 0, 0]", "[[-2, 0, 0]",
     "3: body.inertia: found an inertia that is not positive: principal values -2, 2.6, 3 kg "
     "m2, " TDBD_POSSIBLE},
    {"inertia_that_is_not_symmetric", "[[2, 0, 0]", "[[2, 0.5, 0]",
     "3: body.inertia: found an inertia that is not symmetric (by 0.5 kg m2), " TDBD_POSSIBLE},
    {"inertia_that_is_not_finite", "[[2, 0, 0]", "[[inf, 0, 0]",
     "3: body.inertia: found inf, expected moment of inertia in kg m2, or a text with a unit"},
    {"inertia_of_two_rows", "[0, \"2.6 kg m2\", 0], ", "",
     "3: body.inertia: found an array of 2, expected three rows of three: moment of inertia in kg "
     "m2"},
    {"inertia_of_a_wrong_dimension", "2.6 kg m2", "2.6 kg m",
     "3: body.inertia: found \"2.6 kg m\" (kg m is a unit of dimension m.kg), expected moment of "
     "inertia in kg m2 or in another unit"},
    {"missing_inertia", "inertia = [[2, 0, 0], [0, \"2.6 kg m2\", 0], [0, 0, 3]]\n", "",
     "2: body.inertia: found nothing, expected three rows of three: moment of inertia in kg m2 "
     "(the "
     "key is required)"},
    {"cone_heavier_than_the_whole", "axial_inertia = 0.2", "axial_inertia = 20",
     "14: cones[1].axial_inertia: found 20 kg m2: cones with more inertia than the whole permits: "
     "without their axial "
     "inertias principal values -17.3581, 2.11671, 2.84143 kg m2, " TDBD_POSSIBLE},
    {"cone_that_leaves_no_body", "[0, 0, 3]]", "[0, 0, 4.6]]",
     "8: cones[0].axial_inertia: found 0.1 kg m2: cones whose removal leaves an inertia that "
     "violates "
     "the triangle inequality: principal values 1.91778, 2.55, 4.53222 kg m2, " TDBD_POSSIBLE},
    {"cones_that_leave_no_body_together", "[0, 0, 3]]", "[0, 0, 4.42]]",
     "6: cones: found cones whose removal leaves an inertia that violates the triangle inequality: "
     "principal values 1.80088, 2.40181, 4.21731 kg m2, " TDBD_POSSIBLE},
    {"cone_of_negative_inertia", "axial_inertia = 0.2", "axial_inertia = -0.2",
     "14: cones[1].axial_inertia: found -0.2, expected moment of inertia in kg m2, > 0"},
    {"axis_of_length_zero", "[0.8, 0, 0.6]\naxial", "[0, 0, 0]\naxial",
     "7: cones[0].axis: found an axis of length 0, expected a direction"},
    {"missing_axis", "axis = [0.8, 0, 0.6]\n", "",
     "6: cones[0].axis: found nothing, expected an array of three: a plain number (the key is "
     "required)"},
    {"negative_step", "10 ms", "-10 ms",
     "34: time.step: found \"-10 ms\", expected time in s, > 0"},
    {"step_of_zero", "10 ms", "0 ms", "34: time.step: found \"0 ms\", expected time in s, > 0"},
    {"step_beyond_the_run", "10 ms", "3 s",
     "34: time.step: found 3 s for a run of 2 s, expected at most the duration"},
    {"too_many_steps", "10 ms", "1e-20 s",
     "34: time.step: found 1e-20 s, which makes 2e+20 steps, expected at most 1000000000000000 "
     "steps"},
    {"load_that_is_not_finite", "body_torque = [0.1, 0, 0]", "body_torque = [0.1, nan, 0]",
     "18: load.body_torque: found nan, expected torque in N m, or a text with a unit"},
    {"load_without_end", "amplitude = [0, 0.3, 0]", "amplitude = [0, inf, 0]",
     "25: load.harmonics[0].amplitude: found inf, expected torque in N m, or a text with a unit"},
    {"cone_torque_that_is_not_finite", "torque = 0.01", "torque = -inf",
     "11: cones[0].torque: found -inf, expected torque in N m, or a text with a unit"},
    {"gravity_arm_of_length_zero", "gravity_arm = [0.6, 0, 0.8]", "gravity_arm = [0, 0, 0]",
     "20: load.gravity_arm: found an arm of length 0, expected a direction"},
    {"negative_stiffness", "stiffness = [0, 0, 1]", "stiffness = [0, -2, 1]",
     "21: load.stiffness: found -2, expected numbers that are not negative"},
    {"negative_damping", "damping = [0.1, 0.1, 0.1]", "damping = [0.1, 0.1, -3]",
     "22: load.damping: found -3, expected numbers that are not negative"},
    {"damping_that_feeds_a_cone", "damping = 0.01", "damping = -0.01",
     "16: cones[1].damping: found -0.01, expected rotational damping in N m s/rad, >= 0"},
    {"unknown_key", "spin = 4", "spinn = 4",
     "15: cones[1].spinn: found an unknown key, expected spin"},
    {"unknown_load", "gravity_moment =", "gravity_momentum =",
     "19: load.gravity_momentum: found an unknown key, expected gravity_moment"},
    {"unknown_table", "[integrator]", "[integrater]",
     "32: integrater.drift: found an unknown key, expected integrator.drift"},
    {"unknown_drift", "\"split\"", "\"splitt\"",
     "32: integrator.drift: found \"splitt\", expected one of split, three-axis, lie-midpoint, "
     "lie-mean (did you mean split?)"},
    {"odd_order", "drift = \"split\"", "order = 3",
     "32: integrator.order: found 3, expected 2, 4, 6 or 8"},
    {"order_of_ten", "drift = \"split\"", "order = 10",
     "32: integrator.order: found 10, expected a whole number from 2 to 8"},
    {"attitude_that_is_no_rotation", "rotation_vector = [\"20 deg\", 0.1, 0]",
     "attitude = [[1, 0, 0], [0, 1, 0], [0, 0, 1.1]]",
     "4: body.attitude: found a matrix that misses a rotation by 0.21, expected a rotation to "
     "1e-09"},
    {"attitude_that_is_a_mirror", "rotation_vector = [\"20 deg\", 0.1, 0]",
     "attitude = [[1, 0, 0], [0, 1, 0], [0, 0, -1]]",
     "4: body.attitude: found a matrix that misses a rotation by 2, expected a rotation to 1e-09"},
    {"two_attitudes",
     "rotation_vector =", "attitude = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\nrotation_vector =",
     "4: body.attitude: found rotation_vector as well, expected one of the two"},
    {"rotation_of_no_digits", "[\"20 deg\", 0.1, 0]", "[1e200, 0.1, 0]",
     "4: body.rotation_vector: found an angle of 1e+200 rad, expected at most 1e+13 rad, beyond "
     "which no digit of an attitude is left"},
    {"angular_velocity_of_endless_energy", "[0.5, -0.4, \"20 rpm\"]", "[0.5, 1e200, 0]",
     "5: body.angular_velocity: " TDBD_ENDLESS},
    {"spin_of_endless_energy", "spin = 4", "spin = 1e200", "15: cones[1].spin: " TDBD_ENDLESS},
    {"inertia_without_an_inverse", "axial_inertia = 0.2", "axial_inertia = 1e-320",
     "14: cones[1].axial_inertia: " TDBD_ENDLESS},
    {"inertia_of_endless_energy", "[[2, 0, 0], [0, \"2.6 kg m2\", 0], [0, 0, 3]]",
     "[[1e308, 0, 0], [0, 1e308, 0], [0, 0, 1e308]]", "3: body.inertia: " TDBD_ENDLESS},
    {"mesh_without_density", "inertia = [[2, 0, 0], [0, \"2.6 kg m2\", 0], [0, 0, 3]]",
     "mesh = \"box.off\"\nunit = 1",
     "2: body.density: found nothing, expected density in kg/m3, > 0 (the key is required)"},
    {"wrong_check", "[load]", "[load]\ncheck = \"off\"",
     "18: load.check: found an unknown key, expected body.check"},
};

INSTANTIATE_TEST_SUITE_P(One, BadRotate, ::testing::ValuesIn(mistakes),
                         [](const auto& one) { return std::string(one.param.name); });

/// A case whose body is this mesh; line 2 names it.
std::string mesh_case(const std::string& file) {
  return "[body]\nmesh = \"" + file + "\"\ndensity = 2\nunit = 1\n[time]\nstep = 1\nduration = 1\n";
}

TEST(BadRotate, a_mesh_that_bounds_no_solid_is_rejected_at_its_key) {
  const RotateFolder c;
  const std::string box = read(c.path("box.off"));
  c.write("open.off", "OFF\n8 11 0" + box.substr(10, box.rfind("3 3 4 7") - 10));
  c.write("case.toml", mesh_case("open.off"));
  const auto o = c.rotate();
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_EQ(o.err.rfind("tdbd: " + c.path("case.toml").string() + ":2: body.mesh: found " +
                            c.path("open.off").string() +
                            ", which bounds no solid, expected a closed mesh whose triangles face "
                            "outward\n" +
                            c.path("open.off").string() + ": solid body: hole: ",
                        0),
            0u)
      << o.err;
  EXPECT_EQ(o.err.find("\n\n"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(c.path("out")));
}

TEST(BadRotate, a_file_that_is_no_mesh_is_rejected_at_its_key) {
  const RotateFolder c;
  c.write("case.toml", mesh_case("torque.csv"));
  expect_refusal(c.rotate(), c.path("case.toml").string() + ":2: body.mesh: found " +
                                 c.path("torque.csv").string() +
                                 ": unknown mesh format '.csv', expected .stl, .obj, .ply or .off, "
                                 "expected a mesh that can be read");
}

TEST(BadRotate, that_the_case_with_all_keys_is_right) {
  const RotateFolder c;
  EXPECT_EQ(c.check().exit_code, 0) << c.check().err;
  EXPECT_EQ(c.check().out, c.path("case.toml").string() +
                               ": valid; 2 cones, 200 steps of 0.01 s, energy 13.6347 J\n");
  EXPECT_EQ(c.rotate().exit_code, 0);
}

TEST(BadRotate, an_inertia_that_no_body_has_passes_with_the_check_off) {
  const RotateFolder c;
  c.edit("case.toml", "[0, 0, 3]]", "[0, 0, 50]]\ncheck = \"off\"");
  EXPECT_EQ(c.check().exit_code, 0) << c.check().err;
  c.edit("case.toml", "[[2, 0, 0]", "[[-2, 0, 0]");
  EXPECT_EQ(c.check().exit_code, 2);
  EXPECT_NE(c.check().err.find("expected a positive definite inertia"), std::string::npos);
}

TEST(BadRotate, a_flat_body_is_a_body) {
  const RotateFolder c;
  c.write("case.toml",
          "[body]\ninertia = [[1, 0, 0], [0, 2, 0], [0, 0, 3]]\n[time]\nstep = 1\n"
          "duration = 1\n");
  EXPECT_EQ(c.check().exit_code, 0) << c.check().err;
}

TEST(BadRotate, samples_are_rejected_with_their_line) {
  const RotateFolder c;
  const std::string file = c.path("torque.csv").string();
  c.write("torque.csv", "time_s,x,y,z\n0,0,0,0\n1,0,0,0\n1,0,0,0\n");
  expect_refusal(c.rotate(), file + ":4: time_s: found 1 after 1, expected rising times");
  c.write("torque.csv", "time_s,x,y\n0,0,0\n");
  expect_refusal(c.rotate(), file + ": z: found the column x, expected a column of this name");
  c.write("torque.csv", "time_s,x,y,z\n0,0,inf,0\n");
  expect_refusal(c.rotate(), file + ":2: y: found \"inf\", expected a finite number");
  c.write("torque.csv", "time_s,x,y,z\n");
  expect_refusal(c.rotate(), file + ": found no rows, expected at least one");
}

void expect_missing(const RotateFolder& c, const std::string& place, const std::string& name) {
  expect_refusal(c.rotate(), c.path("case.toml").string() + place + ": found \"" + name +
                                 "\" (there is no " + c.path(name).string() +
                                 "), expected the path of an existing file, from the case file's "
                                 "folder");
}

TEST(BadRotate, missing_files) {
  const RotateFolder c;
  c.edit("case.toml", "torque.csv", "absent.csv");
  expect_missing(c, ":30: load.samples[0].file", "absent.csv");
  c.write("case.toml",
          "[body]\ndensity = 1\nmesh = \"absent.stl\"\n[time]\nstep = 1\nduration = 1\n");
  expect_missing(c, ":3: body.mesh", "absent.stl");
}

TEST(BadRotate, two_inertias) {
  const RotateFolder c;
  c.edit("case.toml", "inertia =", "density = 1000\nunit = 1\nmesh = \"box.off\"\ninertia =");
  expect_refusal(c.rotate(), c.path("case.toml").string() +
                                 ":6: body.inertia: found mesh as well, expected one of the two");
}

TEST(BadRotate, all_mistakes_at_once) {
  const RotateFolder c;
  c.edit("case.toml", "[0, 0, 3]]", "[0, 0, nan]]");
  c.edit("case.toml", "axis = [0.8, 0, 0.6]", "axis = [0, 0, 0]");
  c.edit("case.toml", "gravity_moment", "gravity_mment");
  c.edit("case.toml", "10 ms", "-10 ms");
  c.write("torque.csv", "time_s,x,y,z\n0,0,zero,0\n");
  const std::string at = c.path("case.toml").string();
  expect_refusal(
      c.check(),
      at + ":3: body.inertia: found nan, expected moment of inertia in kg m2, or a text with a " +
          "unit\n" + at + ":7: cones[0].axis: found an axis of length 0, expected a direction\n" +
          at + ":19: load.gravity_mment: found an unknown key, expected gravity_moment\n" + at +
          ":34: time.step: found \"-10 ms\", expected time in s, > 0\n" +
          c.path("torque.csv").string() + ":2: y: found \"zero\", expected a finite number");
}

TEST(BadRotate, numbers_whose_energy_is_beyond_all_numbers) {
  const RotateFolder c;
  c.edit("case.toml", "angular_velocity = [0.5,", "angular_velocity = [1e200,");
  const auto o = c.rotate();
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_NE(
      o.err.find("case.toml:5: body.angular_velocity: found a kinetic energy that is not finite"),
      std::string::npos)
      << o.err;
}

TEST(BadRotate, a_run_case_to_rotate) {
  const RotateFolder c;
  c.write("case.toml", "[bit]\nfile = \"bit.toml\"\n[time]\nstep = 1\nduration = 1\n");
  const auto o = c.rotate();
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_NE(o.err.find("case.toml:1: body.inertia: found nothing"), std::string::npos) << o.err;
}

}  // namespace tdbd::app::bad_rotate_test
