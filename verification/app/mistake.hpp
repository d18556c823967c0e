#pragma once

#include <ostream>

namespace tdbd::app {

/// One mistake in a case file: the text that it replaces, and the message of the program.
struct Mistake {
  const char* name;
  const char* from;
  const char* to;
  const char* message;
};

inline void PrintTo(const Mistake& m, std::ostream* out) { *out << m.name; }

}  // namespace tdbd::app
