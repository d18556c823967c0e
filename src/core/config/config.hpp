#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/config/field.hpp"
#include "core/types.hpp"

namespace tdbd {

struct ConfigDocument;  // the file, the keys that were read, and the problems found so far

/// A value that is legal but probably unintended.
struct ConfigDoubt {
  std::string place;  ///< "FILE:LINE: KEY" (Config::place)
  std::string key;    ///< dotted, from the top of the file
  std::string text;
};

/// A strict reader of a TOML file. Keys are relative to the table that this Config represents. A
/// wrong or missing value does not throw immediately: the read records the problem and returns the
/// fallback or a harmless value, so that finish() reports all mistakes of the file together.
class Config {
 public:
  /// Parses a file, then applies overrides "key.sub=value" (a TOML value, otherwise a bare string).
  /// Throws InputError if the file cannot be read or is not TOML (file:line:column). `origin`: the
  /// source of the overrides, for messages.
  static Config read_file(const std::string& path, const std::vector<std::string>& overrides,
                          const std::string& origin = "--set");

  /// Parses a text as if it were in a file at this path: messages name that file, and paths in the
  /// text are relative to its directory. Throws InputError.
  static Config read_text(const std::string& text, const std::string& path);

  /// Whether the key is given. The key does not count as read.
  bool has(std::string_view key) const;

  /// Whether the key is given as a text. The key does not count as read.
  bool is_text(std::string_view key) const;

  /// Reads a declared key. A quantity is a string with a unit ("8.5 in") or a number in the key's
  /// SI unit, and is returned in that unit. A path is returned absolute.
  double read(const QuantityKey& key) { return read(key, key.fallback); }
  Vec3 read(const VectorKey& key);
  template <class T>
  T read(const ArrayKey<T>& key) {
    return read(key, std::optional<T>());
  }
  long read(const IntegerKey& key) { return read(key, key.fallback); }
  bool read(const FlagKey& key) { return read(key, key.fallback); }
  std::string read(const TextKey& key);
  std::string read(const PathKey& key);
  template <class E>
  E read(const ChoiceKey<E>& key) {
    return read(key, key.fallback);
  }
  std::string read(const NameKey& key) { return read(key, std::optional<std::string>()); }
  std::vector<std::string> read(const TextsKey& key) {
    return read(key, std::optional<std::vector<std::string>>());
  }

  /// Reads a key whose fallback is computed (`computed_default`). Without a fallback, the key is required.
  double read(const QuantityKey& key, std::optional<double> fallback);
  Vec3 read(const VectorKey& key, const std::optional<Vec3>& fallback);
  std::vector<double> read(const ListKey& key, std::optional<std::vector<double>> fallback);
  std::vector<std::pair<double, double>> read(
      const PairsKey& key, std::optional<std::vector<std::pair<double, double>>> fallback);
  Mat3 read(const MatrixKey& key, const std::optional<Mat3>& fallback);
  std::vector<std::string> read(const TextsKey& key,
                                const std::optional<std::vector<std::string>>& fallback);
  long read(const IntegerKey& key, std::optional<long> fallback);
  bool read(const FlagKey& key, std::optional<bool> fallback);
  template <class E>
  E read(const ChoiceKey<E>& key, std::optional<E> fallback) {
    std::vector<std::pair<std::string, E>> names;
    for (const auto& named : key.values)
      if (!named.name.empty()) names.emplace_back(std::string(named.name), named.value);
    return choice<E>(key.name, names, fallback);
  }
  std::string read(const NameKey& key, const std::optional<std::string>& fallback);

  /// Returns the keys and tables that the file gives in this table, sorted. They do not count as
  /// read.
  std::vector<std::string> given() const;

  /// Returns the table, given or not, or the tables of an array of tables. The last part of the
  /// key's name is the name of the table.
  Config table(const TableKey& key);
  std::vector<Config> tables(const TableKey& key);
  bool has(const TableKey& key) const;

  // The same with names and units, for keys without a declaration. A key may be dotted
  // ("motion.whirl.radius"). A read without a fallback requires the key.

  /// Reads a string with a unit ("8.5 in") or a number in `si_unit`. Returns it in `si_unit`.
  double quantity(std::string_view key, const std::string& si_unit, std::optional<double> fallback,
                  Range range = {}, Range usual = {});
  /// Reads three quantities.
  Vec3 vector(std::string_view key, const std::string& si_unit, std::optional<Vec3> fallback);
  /// Reads any number of quantities.
  std::vector<double> list(std::string_view key, const std::string& si_unit,
                           std::optional<std::vector<double>> fallback, Range usual = {});
  /// Reads any number of texts.
  std::vector<std::string> texts(std::string_view key,
                                 const std::optional<std::vector<std::string>>& fallback);
  /// Reads any number of pairs of quantities: [[a, b], [c, d], ...].
  std::vector<std::pair<double, double>> pairs(
      std::string_view key, const std::string& si_unit,
      std::optional<std::vector<std::pair<double, double>>> fallback, Range usual = {});
  /// Reads 3 x 3 quantities, row by row: [[a, b, c], [d, e, f], [g, h, i]].
  Mat3 matrix(std::string_view key, const std::string& si_unit, std::optional<Mat3> fallback);
  /// Reads a whole number from lo to hi, including both.
  long integer(std::string_view key, std::optional<long> fallback, long lo, long hi);
  /// Reads true, false, "on" or "off".
  bool flag(std::string_view key, std::optional<bool> fallback);
  std::string text(std::string_view key, std::optional<std::string> fallback);
  /// Reads a text, a number or a flag, or an array of them, as written in the file.
  ConfigScalar word(std::string_view key, const std::optional<ConfigScalar>& fallback);
  std::vector<ConfigScalar> words(std::string_view key);
  /// Returns all values below this table as overrides "a.b=value" for another file.
  std::vector<std::string> assignments();
  /// Reads the path of an existing file or folder, relative to the folder of the case file. Returns
  /// it absolute. If the fallback is an empty text, an empty text means no file.
  std::string path(std::string_view key, std::optional<std::string> fallback);

  /// Reads one of the named values.
  template <class E>
  E choice(std::string_view key, const std::vector<std::pair<std::string, E>>& names,
           std::optional<E> fallback) {
    std::vector<std::string> texts;
    std::optional<std::size_t> default_index;
    for (std::size_t i = 0; i < names.size(); ++i) {
      texts.push_back(names[i].first);
      if (fallback == names[i].second && !default_index) default_index = i;
    }
    return names[choice_index(key, texts, default_index)].second;
  }

  /// Returns a table, given or not, which shares the problems of this one.
  Config table(std::string_view key);
  /// Returns the elements of an array of tables ([[key]]); none if the key is missing.
  std::vector<Config> tables(std::string_view key);

  /// Records a mistake that only the caller can detect, at the line of the key, or of this table if
  /// the key is empty. Ignored if the read of the key already failed.
  void problem(std::string_view key, const std::string& found, const std::string& expected);

  /// Records the mistakes of a file that this one names. The message already contains file and
  /// line.
  void other_file(const std::string& message);

  /// Returns the place of a key as in messages: "FILE:LINE: KEY", or "--set: KEY" of an override.
  /// For mistakes that are found after the file was read.
  std::string place(std::string_view key) const;

  /// The number of mistakes recorded so far. A check of several keys is meaningful only if all of
  /// them were read without mistakes.
  std::size_t problem_count() const;

  /// Throws InputError if there are problems or keys that were not read. The message has one line
  /// for each, sorted by line: "FILE:LINE: KEY: found F, expected E". Mistakes of other files
  /// follow.
  void finish() const;

  /// As finish(), but without the unread keys of a table that is read later. Call finish() after
  /// that.
  void finish_before(const std::string& later) const;

  /// Throws InputError like finish() if there are problems so far, but without reporting unread
  /// keys. For mistakes after which the rest of the file cannot be interpreted.
  void stop_at_problems() const;

  /// Returns every value read so far, including defaults, as a TOML file in SI that reads
  /// identically.
  std::string resolved() const;

  /// Returns the resolved text with each path replaced by a hash of the file's contents. It is the
  /// same for the same contents, wherever the files are.
  std::string fingerprint() const;

  /// Records a doubt about a value that can be used.
  void doubt(const std::string& key, const std::string& text);

  /// Returns the recorded doubts and those about numbers without a unit that were read so far,
  /// sorted by key: values that are unusual in SI and usual in another unit (number_doubts.hpp).
  std::vector<ConfigDoubt> doubts() const;

  /// Returns every single quantity read so far, in SI, by its dotted key.
  std::map<std::string, double> quantities() const;

  /// Returns the file itself and the files that were named by the paths read so far.
  std::vector<std::string> files() const;

 private:
  Config(std::shared_ptr<ConfigDocument> document, std::string prefix);
  std::size_t choice_index(std::string_view key, const std::vector<std::string>& names,
                           std::optional<std::size_t> fallback);
  std::string full(std::string_view key) const;

  std::shared_ptr<ConfigDocument> document_;
  std::string prefix_;  ///< dotted path of the table that this represents; empty: the whole file
};

/// Reads the fields of a settings struct from a table, in which it records mistakes.
class FieldReader final : public FieldVisitor {
 public:
  /// With a refusal, each key that is given is a mistake.
  explicit FieldReader(Config& table, std::optional<Refusal> refusal = {})
      : table_(table), refusal_(refusal) {}

  using FieldVisitor::operator();
  void operator()(double& x, const QuantityKey& key) override;
  void operator()(Vec3& x, const VectorKey& key) override;
  void operator()(std::vector<double>& x, const ListKey& key) override;
  void operator()(std::vector<std::pair<double, double>>& x, const PairsKey& key) override;
  void operator()(Mat3& x, const MatrixKey& key) override;
  void operator()(std::vector<std::string>& x, const TextsKey& key) override;
  void operator()(long& x, const IntegerKey& key) override;
  void operator()(bool& x, const FlagKey& key) override;
  void operator()(std::string& x, const TextKey& key) override;
  void operator()(ConfigScalar& x, const ScalarKey& key) override;
  void operator()(std::vector<ConfigScalar>& x, const ScalarsKey& key) override;
  void path(std::string& x, const PathKey& key) override;
  void name(std::string& x, const NameKey& key) override;
  void any(const AnyKey&) override {}
  void any(const QuantityKey&) override {}
  bool when(bool applies) override { return applies; }
  bool gives(std::string_view name) override { return table_.has(name); }

 protected:
  std::optional<std::size_t> choose(const NamedChoice& choice) override;
  std::optional<Refusal> refuse(std::optional<Refusal> refusal) override {
    return std::exchange(refusal_, refusal);
  }

 private:
  bool reads(std::string_view name, Need need);
  template <class T>
  std::optional<T> fallback(Need need, const T& x) {
    return need == Need::required ? std::nullopt : std::optional<T>(x);
  }

  Config& table_;
  std::optional<Refusal> refusal_;
};

/// Reads the fields of a settings struct from its table. `context`: further arguments of its
/// `visit`.
template <class S, class... Context>
void read_fields(Config& table, S& settings, const Context&... context) {
  FieldReader reader(table);
  settings.visit(reader, context...);
}

/// Reads a settings struct from the table of its name in `parent`. Fields keep their values in
/// `settings` if the file does not give them.
template <class S, class... Context>
S read_table(Config& parent, S settings = {}, const Context&... context) {
  Config table = parent.table(S::table);
  read_fields(table, settings, context...);
  return settings;
}

/// Records a mistake for each key of a settings struct that the table gives.
template <class S>
void refuse_fields(Config& table, const Refusal& refusal) {
  FieldReader reader(table, refusal);
  S settings;
  settings.visit(reader);
}

/// Formats a text as a TOML string, quoted and escaped.
std::string toml_string(std::string_view text);

/// Formats texts as a TOML array.
std::string toml_texts(const std::vector<std::string>& texts);

/// Formats a vector as a TOML array, with the shortest digits that read back to the same numbers.
/// Empty if a component is not finite.
std::string toml_vector(const Vec3& v);

}  // namespace tdbd
