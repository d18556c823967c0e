#pragma once

#include <atomic>

namespace tdbd::app {

/// Exit code of a command that was interrupted: 128 + SIGINT, as a shell would say it.
inline constexpr int interrupted_code = 130;

/// From now on Ctrl-C, a polite kill and a closed terminal set the flag that is returned.
const std::atomic<bool>& catch_interrupts();

}  // namespace tdbd::app
