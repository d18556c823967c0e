#include "battery/run_tdbd.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>

#include "battery/refused_call.hpp"

namespace tdbd::battery {
namespace {

namespace fs = std::filesystem;

std::string take(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(in), {});
  fs::remove(file);
  return text;
}

void redirect(int descriptor, const fs::path& file) {
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (opened < 0 || dup2(opened, descriptor) < 0) _exit(127);
}

/// The build's own program, or the one that the environment names: a mutant of it (scripts/mutate).
const char* program() {
  const char* named = std::getenv("TDBD_PROGRAM");
  return named != nullptr ? named : TDBD_PROGRAM;
}

[[noreturn]] void become_tdbd(const std::vector<std::string>& arguments, const fs::path& out,
                              const fs::path& err, const Surroundings& around) {
  redirect(STDOUT_FILENO, out);
  redirect(STDERR_FILENO, err);
  if (around.largest_file >= 0) {
    const auto bytes = static_cast<rlim_t>(around.largest_file);
    const rlimit limit{bytes, bytes};
    if (setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(127);
  }
  if (!around.has_threads && !(refuse_call(__NR_clone3, EAGAIN) && refuse_call(__NR_clone, EAGAIN)))
    _exit(126);
  std::vector<char*> argv{const_cast<char*>(program())};
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  execv(program(), argv.data());
  _exit(127);
}

/// Both reach a program that is stopped, so that it does nothing in between.
void send(pid_t child, const Surroundings& around) {
  if (around.second_signal != 0) kill(child, SIGSTOP);
  kill(child, around.signal);
  if (around.second_signal == 0) return;
  kill(child, around.second_signal);
  kill(child, SIGCONT);
}

/// Waits for the end, and on the way for the file after which the signal goes out.
int wait_for(pid_t child, const Surroundings& around) {
  int status = 0;
  const auto started = std::chrono::steady_clock::now();
  const auto is_due = [&] {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - started;
    return around.signal_after_seconds > 0.0 ? passed.count() > around.signal_after_seconds
                                             : fs::exists(around.signal_after);
  };
  bool sent = around.signal_after.empty() && around.signal_after_seconds <= 0.0;
  while (waitpid(child, &status, sent ? 0 : WNOHANG) == 0) {
    if (is_due()) {
      send(child, around);
      sent = true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

Outcome run_tdbd(const std::vector<std::string>& arguments, const Surroundings& around) {
  const std::string own = ::testing::TempDir() + "tdbd_" + std::to_string(getpid());
  const fs::path out = own + ".out", err = own + ".err";
  const bool captured = around.standard_output.empty();
  const pid_t child = fork();
  if (child == 0) become_tdbd(arguments, captured ? out : around.standard_output, err, around);
  Outcome outcome;
  outcome.exit_code = wait_for(child, around);
  if (captured) outcome.out = take(out);
  outcome.err = take(err);
  return outcome;
}

}  // namespace tdbd::battery
