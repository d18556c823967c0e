#include "simulation/rotate/rotate_checkpoint.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/random.hpp"
#include "simulation/rotate/rotate_fields.hpp"
#include "simulation/rotate/rotate_summary.hpp"
#include "verification/simulation/mesh_bit.hpp"
#include "verification/simulation/rotated_cases.hpp"

namespace tdbd::simulation::rotate_checkpoint_test {

/// All numbers of a checkpoint, and everything else that a summary contains.
void expect_same(const RotateCase& c, const RotateSimulation& a, const RotateSimulation& b) {
  Tape x, y;
  TapeWriter write_x(x), write_y(y);
  write_x("simulation", a);
  write_y("simulation", b);
  EXPECT_EQ(x.reals, y.reals);
  EXPECT_EQ(x.wholes, y.wholes);
  EXPECT_EQ(summary_json(c, a, RunStatus::completed), summary_json(c, b, RunStatus::completed));
}

class RotateCheckpoints : public ::testing::TestWithParam<RotatedCase> {};

TEST_P(RotateCheckpoints, go_on_to_the_bit) {
  const RotateCase c = rotated_case(GetParam());
  Random random{20261123};
  for (int k = 0; k < 5; ++k) {
    const long before = static_cast<long>(random.uniform(0.0, 300.0)),
               after = static_cast<long>(random.uniform(1.0, 300.0));
    RotateSimulation whole = start(c);
    advance(c, whole, before);
    const auto file = test_folder() / "checkpoint.nc";
    write_rotate_checkpoint(file, c, whole, {7, before});
    RotateCheckpoint saved = read_rotate_checkpoint(file, c);
    EXPECT_EQ(saved.written.rows, 7);
    EXPECT_EQ(saved.written.last_step, before);
    expect_same(c, whole, saved.simulation);
    advance(c, whole, after);
    advance(c, saved.simulation, after);
    expect_same(c, whole, saved.simulation);
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, RotateCheckpoints, ::testing::ValuesIn(rotated_cases()),
                         [](const auto& instance) { return instance.param.name; });

TEST(RotateCheckpoint, names_what_changed_in_the_case) {
  const RotatedCase top = rotated_cases()[1];
  const RotateCase c = rotated_case(top);
  const auto file = test_folder() / "checkpoint.nc";
  write_rotate_checkpoint(file, c, start(c), {});
  try {
    read_rotate_checkpoint(file, rotated_case(top, {"time.step=0.005"}));
    FAIL() << "not refused";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(
                  "the case has changed since: [time] found step = 0.005, expected step = 0.01"),
              std::string::npos)
        << e.what();
  }
}

}  // namespace tdbd::simulation::rotate_checkpoint_test
