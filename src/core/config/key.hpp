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

/// The allowed values of a quantity, in SI.
struct Range {
  enum class Ends { closed, open_lo };  ///< open_lo: greater than lo
  double lo = -std::numeric_limits<double>::infinity();
  double hi = std::numeric_limits<double>::infinity();
  Ends ends = Ends::closed;

  constexpr bool contains(double x) const {
    return (ends == Ends::closed ? x >= lo : x > lo) && x <= hi;
  }
  std::string text() const;  ///< ", > 0", ", in [0, 1]"; empty without limits

  static constexpr Range positive() { return {.lo = 0.0, .ends = Ends::open_lo}; }
  static constexpr Range non_negative() { return {.lo = 0.0}; }
  static constexpr Range within(double lo, double hi) { return {.lo = lo, .hi = hi}; }
};

/// What happens if a file does not give a key.
enum class Need {
  defaulted,  ///< the field keeps its value, which is written to the resolved file
  optional,   ///< the field keeps its value, and the key is not written to the resolved file
  required,   ///< a mistake
};

// The keys of an input file. A settings struct declares each of them with the field that it sets
// (core/config/fields.hpp). All types have the following members, and convert to their name:
//   name      in its table
//   need      what happens if the file does not give the key
//   usual     the default in words if it is not the field's initial value ("one turn of the bit"),
//             or if the key is required
//   meaning   one line for users
//   fallback  the default of a key that sets no field; without it and `usual` it is required

/// A value of a type that the reader does not know: as written, and as TOML.
struct ConfigWord {
  std::string text;  ///< "60 rpm", "0.5", "true"
  std::string toml;  ///< "\"60 rpm\"", "0.5", "true"
};

/// A number with a unit (SI, in the notation of UDUNITS-2; "1": a plain number).
struct QuantityKey {
  std::string_view name;
  std::string_view unit = "1";
  std::optional<double> fallback = {};
  Need need = Need::defaulted;
  std::string_view usual = {};
  Range range = {};
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};

/// Three quantities.
struct VectorKey {
  std::string_view name;
  std::string_view unit = "1";
  std::optional<std::array<double, 3>> fallback = {};
  Need need = Need::defaulted;
  std::string_view usual = {};
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};

/// Quantities in an array, whose shape depends on the type.
template <class T>
struct ArrayKey {
  std::string_view name;
  std::string_view unit = "1";
  Need need = Need::defaulted;
  std::string_view usual = {};
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};
using ListKey = ArrayKey<std::vector<double>>;
using PairsKey = ArrayKey<std::vector<std::pair<double, double>>>;  ///< [[a, b], [c, d], ...]
using MatrixKey = ArrayKey<Mat3>;                                   ///< 3 x 3, row by row

/// An array of texts: ["A", "B"].
struct TextsKey {
  std::string_view name;
  Need need = Need::defaulted;
  std::string_view usual = {};
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};

/// A whole number from lo to hi, including both.
struct IntegerKey {
  std::string_view name;
  std::optional<long> fallback = {};
  Need need = Need::defaulted;
  std::string_view usual = {};
  long lo = 0;
  long hi = std::numeric_limits<long>::max();
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};

/// true, false, "on" or "off".
struct FlagKey {
  std::string_view name;
  std::optional<bool> fallback = {};
  Need need = Need::defaulted;
  std::string_view usual = {};
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};

struct TextKey {
  std::string_view name;
  std::optional<std::string_view> fallback = {};
  Need need = Need::defaulted;
  std::string_view usual = {};
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};

/// A text, a number or a flag, as written in the file (Config::word), or an array of them
/// (Config::words).
struct WordKey {
  std::string_view name;
  Need need = Need::defaulted;
  std::string_view usual = {};
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};
struct WordsKey {
  std::string_view name;
  Need need = Need::defaulted;
  std::string_view usual = {};
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};

/// Represents, in lists of keys, those that are declared elsewhere or that are named by the file.
struct AnyKey {
  std::string_view name;  ///< "KEY"
  std::string_view kind;  ///< in words
  std::string_view usual = {};
  std::string_view meaning = {};
};

/// The path of an existing file, relative to the folder of the file that names it.
struct PathKey {
  std::string_view name;
  Need need = Need::defaulted;
  std::string_view usual = {};
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};

/// One of several named values. Unused elements at the end have no name.
template <class E>
struct ChoiceKey {
  struct Named {
    std::string_view name;
    E value{};
  };
  std::string_view name;
  std::array<Named, 8> values = {};
  std::optional<E> fallback = {};
  Need need = Need::defaulted;
  std::string_view usual = {};
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};

/// One of the names of a list that is declared elsewhere, for example of force laws or rocks.
struct NameKey {
  std::string_view name;
  std::vector<std::string_view> (*names)() = nullptr;
  Need need = Need::defaulted;
  std::string_view usual = {};
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};

enum class Repeats { no, yes };  ///< [name] or [[name]]

/// A table of keys. The name is dotted and begins at the top of the file ("motion.whirl").
struct TableKey {
  std::string_view name;
  std::string_view meaning;
  Repeats repeats = Repeats::no;
};

}  // namespace tdbd
