#include "app/print.hpp"

#include <cerrno>
#include <cstdio>

namespace tdbd::app {
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

}  // namespace tdbd::app
