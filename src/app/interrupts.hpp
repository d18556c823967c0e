#pragma once

#include <atomic>

namespace tdbd::app {

/// Exit code of an interrupted command: 128 + SIGINT, the convention of shells.
inline constexpr int interrupted_code = 130;

/// Makes SIGINT (Ctrl-C), SIGTERM and SIGHUP end the program immediately, while there is nothing to
/// save.
void end_on_interrupt();

/// Makes the first of these signals set the returned flag, so that results can be saved. A second
/// signal ends the program immediately.
const std::atomic<bool>& save_on_interrupt();

/// The flag set by save_on_interrupt.
const std::atomic<bool>& interrupt_flag();

}  // namespace tdbd::app
