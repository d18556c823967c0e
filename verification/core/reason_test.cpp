#include <gtest/gtest.h>

#include "core/error.hpp"

namespace tdbd::reason_test {

TEST(Reason, is_in_words) {
  EXPECT_STREQ(error_message_of(std::bad_alloc()), "out of memory");
  EXPECT_STREQ(error_message_of(RunError("the bit left the rock")), "the bit left the rock");
}

/// The difference between exit codes 1 and 2.
TEST(Reason, distinguishes_missing_resources_from_mistakes) {
  for (const int lacking : {ENOSPC, EMFILE, ENFILE, ENOMEM, EFBIG, EIO, EROFS})
    EXPECT_TRUE(is_resource_error({lacking, std::system_category()})) << lacking;
  for (const int mistaken : {ENOENT, ENOTDIR, EACCES, EISDIR})
    EXPECT_FALSE(is_resource_error({mistaken, std::system_category()})) << mistaken;
}

}  // namespace tdbd::reason_test
