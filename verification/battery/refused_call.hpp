#pragma once

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <optional>

namespace tdbd::battery {

/// From now on the system answers this call of this process, __NR_close, with an error, as a disk or a network may. False: it
/// takes no such rule. For processes that end soon: nothing takes it back.
inline bool refuse_call(unsigned call, unsigned error) {
  std::array<sock_filter, 4> rules{{{BPF_LD | BPF_W | BPF_ABS, 0, 0, offsetof(seccomp_data, nr)},
                                    {BPF_JMP | BPF_JEQ | BPF_K, 0, 1, call},
                                    {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ERRNO | error},
                                    {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW}}};
  const sock_fprog program{rules.size(), rules.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

/// Whether it holds in a process of its own; none if the system accepts no rules, in which case
/// `holds` returns none.
template <class Holds>
std::optional<bool> in_a_process(Holds holds) {
  constexpr int yes = 0, no = 1, unknown = 2;
  const pid_t child = fork();
  if (child == 0) {
    const std::optional<bool> answer = holds();
    _exit(!answer ? unknown : *answer ? yes : no);
  }
  int status = 0;
  if (waitpid(child, &status, 0) != child || !WIFEXITED(status)) return false;
  if (WEXITSTATUS(status) == unknown) return std::nullopt;
  return WEXITSTATUS(status) == yes;
}

}  // namespace tdbd::battery
