#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/config/key.hpp"
#include "core/types.hpp"

namespace tdbd {

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
  std::string_view usual, meaning;
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
  virtual void operator()(ConfigWord& x, const WordKey& key) = 0;
  virtual void operator()(std::vector<ConfigWord>& x, const WordsKey& key) = 0;
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
    NamedChoice choice{key.name, {}, {}, key.need, key.usual, key.meaning};
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
    if (key.usual.empty()) key.usual = "none";
    T value{};
    (*this)(value, key);
    if (gives(key.name)) x = value;
  }
};

}  // namespace tdbd
