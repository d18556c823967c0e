#pragma once

#include <atomic>

namespace tdbd::app {

/// Exit code of a command that was interrupted: 128 + SIGINT, as shells have it.
inline constexpr int interrupted_code = 130;

/// From now on SIGINT (Ctrl-C), SIGTERM and SIGHUP end the program at once: there is nothing to save
/// yet.
void end_on_interrupt();

/// From now on the first of them sets the flag that is returned, so that what was done is saved; a
/// second one ends the program at once.
const std::atomic<bool>& save_on_interrupt();

/// The flag.
const std::atomic<bool>& interrupt_flag();

}  // namespace tdbd::app
