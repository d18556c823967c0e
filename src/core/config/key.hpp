#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/types.hpp"

namespace tdbd {

/// The values that a quantity may take, in SI.
struct Range {
  enum class Ends { closed, open_lo };  ///< open_lo: greater than lo, not lo itself
  double lo = -std::numeric_limits<double>::infinity();
  double hi = std::numeric_limits<double>::infinity();
  Ends ends = Ends::closed;

  constexpr bool contains(double x) const {
    return (ends == Ends::closed ? x >= lo : x > lo) && x <= hi;
  }
  std::string text() const;  ///< ", > 0", ", in [0, 1]"; empty when there is no limit

  static constexpr Range positive() { return {.lo = 0.0, .ends = Ends::open_lo}; }
  static constexpr Range non_negative() { return {.lo = 0.0}; }
  static constexpr Range within(double lo, double hi) { return {.lo = lo, .hi = hi}; }
};

// The keys of an input file, one constexpr declaration each. Config::read reads them, and the
// resolved file, `tdbd keys` and KEYS.md follow from them. All kinds have
//   name      in its table
//   fallback  the value when the file does not give it
//   usual     in place of a fixed fallback: how the value is found, in words ("one turn of the
//             bit"); a key with neither is required
//   meaning   one line for a reader
//   former    names that the key had: a file that still uses one is told the new name
// and stand for their name wherever a key is asked for by name.

using FormerNames = std::array<std::string_view, 2>;

/// A number with a unit (SI, as UDUNITS-2 writes it; "1": a plain number).
struct QuantityKey {
  std::string_view name;
  std::string_view unit = "1";
  std::optional<double> fallback = {};
  std::string_view usual = {};
  Range range = {};
  std::string_view meaning = {};
  FormerNames former = {};
  constexpr operator std::string_view() const { return name; }
};

/// Three quantities.
struct VectorKey {
  std::string_view name;
  std::string_view unit = "1";
  std::optional<std::array<double, 3>> fallback = {};
  std::string_view usual = {};
  std::string_view meaning = {};
  FormerNames former = {};
  constexpr operator std::string_view() const { return name; }
};

/// Quantities in an array of a shape that the type tells.
template <class T>
struct ArrayKey {
  std::string_view name;
  std::string_view unit = "1";
  std::string_view usual = {};
  std::string_view meaning = {};
  FormerNames former = {};
  constexpr operator std::string_view() const { return name; }
};
using ListKey = ArrayKey<std::vector<double>>;
using PairsKey = ArrayKey<std::vector<std::pair<double, double>>>;  ///< [[a, b], [c, d], ...]
using MatrixKey = ArrayKey<Mat3>;                                   ///< 3 x 3, row by row

/// Texts in an array: ["A", "B"].
struct TextsKey {
  std::string_view name;
  std::string_view usual = {};
  std::string_view meaning = {};
  FormerNames former = {};
  constexpr operator std::string_view() const { return name; }
};

/// A whole number from lo to hi, ends included.
struct IntegerKey {
  std::string_view name;
  std::optional<long> fallback = {};
  std::string_view usual = {};
  long lo = 0;
  long hi = std::numeric_limits<long>::max();
  std::string_view meaning = {};
  FormerNames former = {};
  constexpr operator std::string_view() const { return name; }
};

/// true, false, "on" or "off".
struct FlagKey {
  std::string_view name;
  std::optional<bool> fallback = {};
  std::string_view usual = {};
  std::string_view meaning = {};
  FormerNames former = {};
  constexpr operator std::string_view() const { return name; }
};

struct TextKey {
  std::string_view name;
  std::optional<std::string_view> fallback = {};
  std::string_view usual = {};
  std::string_view meaning = {};
  FormerNames former = {};
  constexpr operator std::string_view() const { return name; }
};

/// A text, a number or a flag, as the file has it (Config::word), and an array of them (Config::words).
struct WordKey {
  std::string_view name;
  std::string_view usual = {};
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};
struct WordsKey {
  std::string_view name;
  std::string_view usual = {};
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};

/// Stands in lists of keys for those that are declared elsewhere, or that a file names itself.
struct AnyKey {
  std::string_view name;  ///< "KEY"
  std::string_view kind;  ///< in words
  std::string_view usual = {};
  std::string_view meaning = {};
};

/// An existing file, relative to the folder of the file that names it.
struct PathKey {
  std::string_view name;
  std::string_view usual = {};
  std::string_view meaning = {};
  FormerNames former = {};
  constexpr operator std::string_view() const { return name; }
};

/// One of several named values; unused places at the end have no name.
template <class E>
struct ChoiceKey {
  struct Named {
    std::string_view name;
    E value{};
  };
  std::string_view name;
  std::array<Named, 8> values = {};
  std::optional<E> fallback = {};
  std::string_view usual = {};
  std::string_view meaning = {};
  FormerNames former = {};
  constexpr operator std::string_view() const { return name; }
};

/// One of the names of a list that is kept elsewhere: force laws, rocks.
struct NameKey {
  std::string_view name;
  std::vector<std::string_view> (*names)() = nullptr;
  std::string_view usual = {};
  std::string_view meaning = {};
  FormerNames former = {};
  constexpr operator std::string_view() const { return name; }
};

enum class Repeats { no, yes };  ///< [name] or [[name]]

/// A table of keys, by its dotted name from the top of the file ("motion.whirl").
struct TableKey {
  std::string_view name;
  std::string_view meaning;
  Repeats repeats = Repeats::no;
};

}  // namespace tdbd
