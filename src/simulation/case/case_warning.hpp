#pragma once

#include <string>
#include <vector>

namespace tdbd::simulation {

/// Something that a case says in vain. It is told, and the run goes on.
struct CaseWarning {
  std::string place;  ///< "FILE:LINE: KEY" (Config::place)
  std::string key;    ///< dotted, from the top of the file
  std::string text;   ///< what is in vain, and what to do
};

/// "FILE:LINE: KEY: TEXT", for whoever has the file at hand.
inline std::string with_place(const CaseWarning& w) { return w.place + ": " + w.text; }

/// "KEY: TEXT", the same wherever the file lies and however it is laid out.
inline std::string without_place(const CaseWarning& w) { return w.key + ": " + w.text; }

}  // namespace tdbd::simulation
