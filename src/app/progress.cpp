#include "app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace tdbd::app {

Progress::Progress()
    : started_(Clock::now()), shown_(started_), terminal_(isatty(STDERR_FILENO) == 1) {}

bool Progress::is_due(long done, long total) const {
  constexpr std::chrono::milliseconds on_terminal(200), in_log(2000);
  return done >= total || Clock::now() - shown_ >= (terminal_ ? on_terminal : in_log);
}

void Progress::show(long done, long total, const std::string& detail) {
  shown_ = Clock::now();
  const double part = static_cast<double>(done) / static_cast<double>(total);
  const double passed = std::chrono::duration<double>(shown_ - started_).count();
  const std::string line = fmt::format("{:3.0f} %  step {} of {}  {:.1f} s left{}", 100.0 * part,
                                       done, total, passed * (1.0 - part) / part, detail);
  if (!terminal_) return static_cast<void>(std::fprintf(stderr, "%s\n", line.c_str()));
  constexpr int width = 24;
  const std::string bar(static_cast<std::size_t>(part * width), '#');
  std::fprintf(stderr, "\r[%-24s] %s   ", bar.c_str(), line.c_str());
}

void Progress::finish() {
  if (terminal_) std::fputc('\n', stderr);
}

}  // namespace tdbd::app
