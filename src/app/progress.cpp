#include "app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace tdbd::app {

Progress::Progress()
    : started_(Clock::now()), shown_(started_), terminal_(isatty(STDERR_FILENO) == 1) {}

void Progress::show(const simulation::Simulation& s, long total) {
  constexpr std::chrono::milliseconds on_terminal(200), in_log(2000);
  const auto now = Clock::now();
  if (now - shown_ < (terminal_ ? on_terminal : in_log) && s.steps_done < total) return;
  shown_ = now;
  const double part = static_cast<double>(s.steps_done) / static_cast<double>(total);
  const double passed = std::chrono::duration<double>(now - started_).count();
  const std::string line =
      fmt::format("{:3.0f} %  step {} of {}  {:.1f} s left  {} triangles  {:.3f} cm3", 100.0 * part,
                  s.steps_done, total, passed * (1.0 - part) / part,
                  s.rock.surface.triangle_count(), 1e6 * s.ledger.removed.value());
  if (!terminal_) return static_cast<void>(std::fprintf(stderr, "%s\n", line.c_str()));
  constexpr int width = 24;
  const std::string bar(static_cast<std::size_t>(part * width), '#');
  std::fprintf(stderr, "\r[%-24s] %s   ", bar.c_str(), line.c_str());
}

void Progress::finish() {
  if (terminal_) std::fputc('\n', stderr);
}

}  // namespace tdbd::app
