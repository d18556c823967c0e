#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.hpp"

namespace tdbd::memory_left_test {

/// In a process of its own, which may take 100 MB more than it has.
template <class Question>
bool answer_with_limit(Question question) {
  const pid_t child = fork();
  if (child == 0) {
    const rlimit limit{100'000'000, 100'000'000};
    _exit(setrlimit(RLIMIT_DATA, &limit) == 0 && question() ? 0 : 1);
  }
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST(MemoryLeft, is_what_the_system_would_give) {
  EXPECT_TRUE(answer_with_limit([] { return has_memory(10'000'000); }));
  EXPECT_TRUE(answer_with_limit([] { return !has_memory(200'000'000); }));
  EXPECT_TRUE(has_memory(200'000'000));
}

TEST(MemoryLeft, that_is_demanded_is_not_taken) {
  EXPECT_TRUE(answer_with_limit([] {
    for (int i = 0; i < 1000; ++i) require_allocatable(10'000'000);
    return true;
  }));
  EXPECT_TRUE(answer_with_limit([] {
    try {
      require_allocatable(200'000'000);
    } catch (const std::bad_alloc&) {
      return true;
    }
    return false;
  }));
}

}  // namespace tdbd::memory_left_test
