#include "app/interrupts.hpp"

#include <unistd.h>

#include <csignal>
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
  if (interrupted.exchange(true)) end_at_once("tdbd: interrupted again: ended immediately\n");
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

}  // namespace tdbd::app
