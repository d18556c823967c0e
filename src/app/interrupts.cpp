#include "app/interrupts.hpp"

#include <csignal>

namespace tdbd::app {
namespace {

std::atomic<bool> interrupted{false};

void on_interrupt(int) { interrupted = true; }

}  // namespace

const std::atomic<bool>& catch_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, on_interrupt);
  return interrupted;
}

}  // namespace tdbd::app
