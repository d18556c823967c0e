#include "app/terminal.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <string_view>

namespace tdbd::app {
namespace {

std::atomic<bool> interrupted{false}, is_saving{false};
static_assert(std::atomic<bool>::is_always_lock_free, "signal handlers touch them");

/// Uses only functions that are permitted in a signal handler.
[[noreturn]] void end_at_once(std::string_view message) {
  if (write(STDERR_FILENO, message.data(), message.size()) < 0) _exit(interrupted_code);
  _exit(interrupted_code);
}

void on_interrupt(int) {
  if (!is_saving) end_at_once("tdbd: interrupted before the first step: nothing was saved\n");
  if (interrupted.exchange(true))
    end_at_once(
        "tdbd: interrupted again: ended immediately\n"
        "tdbd: nothing after the last checkpoint was saved\n");
}

}  // namespace

void end_on_interrupt() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, on_interrupt);
}

const std::atomic<bool>& save_on_interrupt() {
  is_saving = true;
  end_on_interrupt();
  return interrupted;
}

const std::atomic<bool>& interrupt_flag() { return interrupted; }

namespace {

int failure = 0;  ///< errno of the first failed write

void note_failure() {
  if (failure == 0) failure = errno != 0 ? errno : EIO;
}

}  // namespace

void write_out(const std::string& text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) note_failure();
}

int after_output(int exit_code) {
  errno = 0;
  if (std::fflush(stdout) != 0) note_failure();
  if (failure == 0 || failure == EPIPE) return exit_code;
  std::fputs("tdbd: cannot write to standard output\n", stderr);
  return exit_code == 0 ? 1 : exit_code;
}

Progress::Progress()
    : started_(Clock::now()), shown_(started_), terminal_(isatty(STDERR_FILENO) == 1) {}

bool Progress::is_due(long done, long total) {
  constexpr std::chrono::milliseconds on_terminal(200), in_log(2000);
  if (first_ < 0) {
    first_ = done;
    started_ = Clock::now();
  }
  return done >= total || Clock::now() - shown_ >= (terminal_ ? on_terminal : in_log);
}

/// The first steps of a run are not typical: buffers grow, and the bit only begins to cut.
std::string Progress::time_left(long done, long total) const {
  constexpr long enough_steps = 20, share = 50;
  const long made = done - first_, needed = std::clamp((total - first_) / share, 1L, enough_steps);
  if (done >= total) return "0.0 s left";
  if (made < needed) return "";
  const double passed = std::chrono::duration<double>(shown_ - started_).count();
  const double left = passed * static_cast<double>(total - done) / static_cast<double>(made);
  return fmt::format("{:.1f} s left", left);
}

void Progress::show(long done, long total, const std::string& detail) {
  shown_ = Clock::now();
  const double part = static_cast<double>(done) / static_cast<double>(total);
  const std::string line = fmt::format("{:3.0f} %  step {} of {}  {}{}", 100.0 * part, done, total,
                                       time_left(done, total), detail);
  if (!terminal_) return static_cast<void>(std::fprintf(stderr, "%s\n", line.c_str()));
  constexpr int width = 24;
  const std::string bar(static_cast<std::size_t>(part * width), '#');
  std::fprintf(stderr, "\r[%-24s] %s   ", bar.c_str(), line.c_str());
}

void Progress::finish() {
  if (terminal_) std::fputc('\n', stderr);
}

}  // namespace tdbd::app
