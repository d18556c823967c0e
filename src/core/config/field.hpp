#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
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
// (`visit`, below). All types have the following members, and convert to their name:
//   name              in its table
//   need              what happens if the file does not give the key
//   computed_default  the default in words if it is not the field's initial value ("one turn of the
//                     bit"), or if the key is required
//   meaning           one line for users
//   fallback          the default of a key that sets no field; without it and `computed_default` it
//                     is required

/// A value of a type that the reader does not know: as written, and as TOML.
struct ConfigScalar {
  std::string text;  ///< "60 rpm", "0.5", "true"
  std::string toml;  ///< "\"60 rpm\"", "0.5", "true"
};

/// A number with a unit (SI, in the notation of UDUNITS-2; "1": a plain number).
struct QuantityKey {
  std::string_view name;
  std::string_view unit = "1";
  std::optional<double> fallback = {};
  Need need = Need::defaulted;
  std::string_view computed_default = {};
  Range range = {};
  std::string_view meaning = {};
  Range usual =
      {};  ///< SI, without sign; for doubts about numbers without a unit (number_doubts.hpp)
  constexpr operator std::string_view() const { return name; }
};

/// Three quantities.
struct VectorKey {
  std::string_view name;
  std::string_view unit = "1";
  std::optional<std::array<double, 3>> fallback = {};
  Need need = Need::defaulted;
  std::string_view computed_default = {};
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};

/// Quantities in an array, whose shape depends on the type.
template <class T>
struct ArrayKey {
  std::string_view name;
  std::string_view unit = "1";
  Need need = Need::defaulted;
  std::string_view computed_default = {};
  std::string_view meaning = {};
  Range usual = {};  ///< of the elements, as in QuantityKey
  constexpr operator std::string_view() const { return name; }
};
using ListKey = ArrayKey<std::vector<double>>;
using PairsKey = ArrayKey<std::vector<std::pair<double, double>>>;  ///< [[a, b], [c, d], ...]
using MatrixKey = ArrayKey<Mat3>;                                   ///< 3 x 3, row by row

/// An array of texts: ["A", "B"].
struct TextsKey {
  std::string_view name;
  Need need = Need::defaulted;
  std::string_view computed_default = {};
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};

/// A whole number from lo to hi, including both.
struct IntegerKey {
  std::string_view name;
  std::optional<long> fallback = {};
  Need need = Need::defaulted;
  std::string_view computed_default = {};
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
  std::string_view computed_default = {};
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};

struct TextKey {
  std::string_view name;
  std::optional<std::string_view> fallback = {};
  Need need = Need::defaulted;
  std::string_view computed_default = {};
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};

/// A text, a number or a flag, as written in the file (Config::word), or an array of them
/// (Config::words).
struct ScalarKey {
  std::string_view name;
  Need need = Need::defaulted;
  std::string_view computed_default = {};
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};
struct ScalarsKey {
  std::string_view name;
  Need need = Need::defaulted;
  std::string_view computed_default = {};
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};

/// Represents, in lists of keys, those that are declared elsewhere or that are named by the file.
struct AnyKey {
  std::string_view name;  ///< "KEY"
  std::string_view kind;  ///< in words
  std::string_view computed_default = {};
  std::string_view meaning = {};
};

/// The path of an existing file, relative to the folder of the file that names it.
struct PathKey {
  std::string_view name;
  Need need = Need::defaulted;
  std::string_view computed_default = {};
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
  std::string_view computed_default = {};
  std::string_view meaning = {};
  constexpr operator std::string_view() const { return name; }
};

/// One of the names of a list that is declared elsewhere, for example of force laws or rocks.
struct NameKey {
  std::string_view name;
  std::vector<std::string_view> (*names)() = nullptr;
  Need need = Need::defaulted;
  std::string_view computed_default = {};
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

/// Why a file must not give a key, in the words of a message.
struct Refusal {
  std::string_view found, expected;
};

/// A choice among named values of any type.
struct NamedChoice {
  std::string_view name;
  std::vector<std::string_view> names;
  std::optional<std::size_t> index;  ///< of the field's value; empty if it has no name
  Need need = Need::defaulted;
  std::string_view computed_default, meaning;
};

/// Visits the fields of a settings struct. Each settings struct declares its fields once:
///
///     struct Maintenance {
///       double worst_quality = 0.1;
///       static constexpr TableKey table{"maintenance", "how the rock's mesh is kept in shape"};
///       void visit(FieldVisitor& v) {
///         v(worst_quality, {.name = "worst_quality",
///                           .range = Range::within(0.0, 0.5),
///                           .meaning = "an operation makes no triangle worse than this"});
///       }
///     };
///
/// read_table (config.hpp) reads them, table_of (key_table.hpp) lists them. The initial value of a
/// field is its default. `visit` may set it before it visits the field, depending on fields that it
/// has visited already.
class FieldVisitor {
 public:
  virtual ~FieldVisitor() = default;

  virtual void operator()(double& x, const QuantityKey& key) = 0;
  virtual void operator()(Vec3& x, const VectorKey& key) = 0;
  virtual void operator()(std::vector<double>& x, const ListKey& key) = 0;
  virtual void operator()(std::vector<std::pair<double, double>>& x, const PairsKey& key) = 0;
  virtual void operator()(Mat3& x, const MatrixKey& key) = 0;
  virtual void operator()(std::vector<std::string>& x, const TextsKey& key) = 0;
  virtual void operator()(long& x, const IntegerKey& key) = 0;
  virtual void operator()(bool& x, const FlagKey& key) = 0;
  virtual void operator()(std::string& x, const TextKey& key) = 0;
  virtual void operator()(ConfigScalar& x, const ScalarKey& key) = 0;
  virtual void operator()(std::vector<ConfigScalar>& x, const ScalarsKey& key) = 0;
  virtual void path(std::string& x, const PathKey& key) = 0;  ///< returned absolute
  virtual void name(std::string& x, const NameKey& key) = 0;  ///< of a list declared elsewhere
  virtual void any(const AnyKey& key) = 0;                    ///< listed, but read elsewhere
  virtual void any(const QuantityKey& key) = 0;               ///< the same

  // Whole numbers of other types. The range of the key must fit into the type.
  void operator()(int& x, const IntegerKey& key) { visit_as_long(x, key); }
  void operator()(std::uint64_t& x, const IntegerKey& key) { visit_as_long(x, key); }

  // Fields that are empty if the file does not give their key.
  void operator()(std::optional<double>& x, const QuantityKey& key) { visit_if_given(x, key); }
  void operator()(std::optional<int>& x, const IntegerKey& key) { visit_if_given(x, key); }
  void operator()(std::optional<bool>& x, const FlagKey& key) { visit_if_given(x, key); }
  void operator()(std::optional<std::string>& x, const TextKey& key) { visit_if_given(x, key); }
  template <class E>
  requires std::is_enum_v<E>
  void operator()(std::optional<E>& x, const ChoiceKey<E>& key) { visit_if_given(x, key); }

  template <class E>
  requires std::is_enum_v<E>
  void operator()(E& x, const ChoiceKey<E>& key) {
    NamedChoice choice{key.name, {}, {}, key.need, key.computed_default, key.meaning};
    for (std::size_t i = 0; i < key.values.size() && !key.values[i].name.empty(); ++i) {
      choice.names.push_back(key.values[i].name);
      if (key.values[i].value == x && !choice.index) choice.index = i;
    }
    if (const auto index = choose(choice)) x = key.values[*index].value;
  }

  /// Whether to visit fields that apply only under a condition. If they do not apply, their keys
  /// are unknown keys. A visitor that lists the fields visits all of them.
  virtual bool when(bool applies) = 0;

  /// Whether the file gives this key.
  virtual bool gives(std::string_view name) = 0;

  /// Visits the fields of a group that applies only under a condition. If it does not apply, a file
  /// that gives one of their keys has a mistake. In nested groups, the outer refusal is used.
  template <class Group>
  void only(bool applies, const Refusal& refusal, Group group) {
    const auto before = refuse(applies ? std::nullopt : std::optional(refusal));
    if (before) refuse(before);
    group();
    refuse(before);
  }

 protected:
  /// Returns the index of the choice; nothing if the field keeps its value.
  virtual std::optional<std::size_t> choose(const NamedChoice& choice) = 0;

  /// Refuses the keys of the fields that follow, or reads them if empty. Returns the previous
  /// setting.
  virtual std::optional<Refusal> refuse(std::optional<Refusal> refusal) = 0;

 private:
  template <class T>
  void visit_as_long(T& x, const IntegerKey& key) {
    long value = static_cast<long>(x);
    (*this)(value, key);
    x = static_cast<T>(value);
  }

  template <class T, class Key>
  void visit_if_given(std::optional<T>& x, Key key) {
    key.need = Need::optional;
    if (key.computed_default.empty()) key.computed_default = "none";
    T value{};
    (*this)(value, key);
    if (gives(key.name)) x = value;
  }
};

}  // namespace tdbd
