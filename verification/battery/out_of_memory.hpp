#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <new>

namespace tdbd::battery {

/// From now on this process gets so many bytes more, and a little that it gave back before.
inline bool limit_memory(std::size_t more) {
  std::ifstream in("/proc/self/statm");
  std::size_t pages = 0;  // the sixth number: of data and stack
  for (int i = 0; i < 6; ++i) in >> pages;
  const rlim_t most = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + more;
  const rlimit limit{most, most};
  return in && setrlimit(RLIMIT_DATA, &limit) == 0;
}

/// From now on this process gets no block of 500 kB or more, and little below.
inline bool take_all_memory() {
  constexpr std::size_t block = 500'000;
  const rlimit none{0, 0};
  if (setrlimit(RLIMIT_DATA, &none) != 0) return false;
  void* volatile taken =
      nullptr;  // volatile: the compiler would remove the allocation of unused blocks
  do taken = std::malloc(block);
  while (taken != nullptr);
  return true;
}

/// Whether a call that comes `after` another throws std::bad_alloc where there is no memory left; in a process of its own, which
/// ends there. For suites whose name has MemoryLeft in it: sanitizers need memory of their own, and leave those out.
template <class Before, class Call>
bool throws_for_want_of_memory(Before before, Call call) {
  const pid_t child = fork();
  if (child == 0) {
    auto made = before();
    int code = take_all_memory() ? 1 : 2;
    try {
      call(made);
    } catch (const std::bad_alloc&) {
      code = 0;
    } catch (...) {
      code = 3;
    }
    _exit(code);
  }
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace tdbd::battery
