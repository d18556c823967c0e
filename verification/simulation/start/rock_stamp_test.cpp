#include <gtest/gtest.h>

#include "core/error.hpp"
#include "io/whole_file.hpp"
#include "mesh/files/files.hpp"
#include "mesh/files/ply.hpp"
#include "simulation/mesh_bit.hpp"
#include "simulation/start/rock_start.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::simulation::rock_stamp_test {

mesh::TriangleMesh box() { return battery::box({0, 0, 0}, {1, 1, 1}); }

std::filesystem::path write_stamped(const std::vector<std::string>& comments) {
  const std::filesystem::path path = test_folder() / "rock.ply";
  AtomicFile file(path);
  mesh::write_ply(file.stream(), box(), comments);
  file.commit();
  return path;
}

TEST(RockStamp, reads_back_and_leaves_the_mesh_alone) {
  const auto path = write_stamped(comments_of({60, 0.1 + 0.2, "0123abcd"}));
  const std::optional<RockStamp> stamp = read_stamp(path);
  ASSERT_TRUE(stamp);
  EXPECT_EQ(stamp->step, 60);
  EXPECT_EQ(stamp->time, 0.1 + 0.2);
  EXPECT_EQ(stamp->case_hash, "0123abcd");
  EXPECT_TRUE(mesh::read_mesh(path, 1.0).positions == box().positions);
}

TEST(RockStamp, is_none_where_a_file_has_not_all_of_it) {
  EXPECT_FALSE(read_stamp(write_stamped({})));
  EXPECT_FALSE(read_stamp(write_stamped({"tdbd step 60", "tdbd time_s 0.3"})));
  EXPECT_FALSE(read_stamp(write_stamped({"tdbd step x", "tdbd time_s 0.3", "tdbd case_hash 1"})));
  EXPECT_FALSE(read_stamp(test_folder() / "nothing.ply"));
  const auto text = write_file(test_folder() / "rock.off", "comment tdbd step 60\n");
  EXPECT_FALSE(read_stamp(text));
}

/// A rock after 100 steps of 2 ms, and a run that continues from it.
Case continued(double step, long first, const std::vector<std::string>& comments) {
  Case c;
  c.rock.file = write_stamped(comments).string();
  c.time = {.step = step, .steps = 1000, .first = first};
  c.places.first_step = "case.toml:9: time.first_step";
  return c;
}

TEST(RequireSameTime, rejects_a_first_step_that_is_not_that_of_the_rock) {
  const std::vector<std::string> stamp = comments_of({100, 100 * 0.002, "0123abcd"});
  EXPECT_NO_THROW(require_same_time(continued(0.002, 100, stamp)));
  EXPECT_NO_THROW(require_same_time(continued(0.001, 200, stamp))) << "half the step";
  EXPECT_NO_THROW(require_same_time(continued(0.002, 0, stamp))) << "a new motion";
  EXPECT_NO_THROW(require_same_time(continued(0.002, 50, {}))) << "another program's file";
  for (const long first : {1, 99, 101, 200})
    EXPECT_THROW(require_same_time(continued(0.002, first, stamp)), InputError) << first;
  try {
    const Case c = continued(0.002, 50, stamp);
    require_same_time(c);
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()),
              "case.toml:9: time.first_step: found 50, at t = 0.1 s, expected 100: " +
                  (test_folder() / "rock.ply").string() +
                  " is the rock after step 100, at t = 0.2 s (0 starts a new motion in this rock)");
  }
}

}  // namespace tdbd::simulation::rock_stamp_test
