#include <gtest/gtest.h>

#include "core/provenance.hpp"

namespace tdbd::program_file_test {

TEST(ProgramFile, is_the_program_that_runs) {
  EXPECT_TRUE(std::filesystem::equivalent(program_file(), "/proc/self/exe")) << program_file();
}

}  // namespace tdbd::program_file_test
