#pragma once

#include <atomic>

namespace tdbd::app {

/// Exit code of a command that was interrupted: 128 + SIGINT, as shells have it.
inline constexpr int interrupted_code = 130;

/// From now on SIGINT (Ctrl-C), SIGTERM and SIGHUP set the flag that is returned.
const std::atomic<bool>& catch_interrupts();

}  // namespace tdbd::app
