#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/config/key.hpp"
#include "core/types.hpp"

namespace tdbd {

struct ConfigDocument;  // the file, the keys that were read, and the problems found so far

/// A value whose kind the caller does not know: as a reader writes it, and as TOML.
struct ConfigWord {
  std::string text;  ///< "60 rpm", "0.5", "true"
  std::string toml;  ///< "\"60 rpm\"", "0.5", "true"
};

/// Strict reader of a TOML file. A key is relative to the table that this Config stands for. A wrong
/// or missing value never throws at once: the read notes the problem and returns the fallback or a
/// harmless value, so that finish() can report every mistake of the file together.
class Config {
 public:
  /// Parses a file, then applies overrides "key.sub=value" (a TOML value, or else a bare string).
  /// Throws InputError when the file cannot be read or is no TOML (file:line:column).
  /// `origin`: where the overrides come from, for messages.
  static Config read_file(const std::string& path, const std::vector<std::string>& overrides,
                          const std::string& origin = "--set");

  /// Parses a text as if it stood in a file of this path: messages name that, and paths in the text
  /// are relative to its folder. Throws InputError.
  static Config read_text(const std::string& text, const std::string& path);

  /// Whether the key is given. Does not count as reading it.
  bool has(std::string_view key) const;

  /// Whether the key is given as a text. Does not count as reading it.
  bool is_text(std::string_view key) const;

  /// Reads a declared key. A quantity is a string with a unit ("8.5 in") or a number in the key's
  /// SI unit, and is returned in that unit; a path is returned absolute.
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

  /// Reads a key whose fallback is computed (`usual`); none: the key is required here.
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
    note_former_names(key, key.former);
    std::vector<std::pair<std::string, E>> names;
    for (const auto& named : key.values)
      if (!named.name.empty()) names.emplace_back(std::string(named.name), named.value);
    return choice<E>(key.name, names, fallback);
  }
  std::string read(const NameKey& key, const std::optional<std::string>& fallback);

  /// The keys and tables that the file gives in this table, sorted. Does not count as reading them.
  std::vector<std::string> given() const;

  /// The table, given or not, and the tables of an array of tables, named by the last part of the
  /// key's name.
  Config table(const TableKey& key);
  std::vector<Config> tables(const TableKey& key);
  bool has(const TableKey& key) const;

  // The same by names and units, for keys that no declaration stands for. A key may be dotted
  // ("motion.whirl.radius"); a read without a fallback is required.

  /// A string with a unit ("8.5 in") or a number in `si_unit`; returned in `si_unit`.
  double quantity(std::string_view key, const std::string& si_unit, std::optional<double> fallback,
                  Range range = {});
  /// Three quantities.
  Vec3 vector(std::string_view key, const std::string& si_unit, std::optional<Vec3> fallback);
  /// Any number of quantities.
  std::vector<double> list(std::string_view key, const std::string& si_unit,
                           std::optional<std::vector<double>> fallback);
  /// Any number of texts.
  std::vector<std::string> texts(std::string_view key,
                                 const std::optional<std::vector<std::string>>& fallback);
  /// Any number of pairs of quantities: [[a, b], [c, d], ...].
  std::vector<std::pair<double, double>> pairs(
      std::string_view key, const std::string& si_unit,
      std::optional<std::vector<std::pair<double, double>>> fallback);
  /// 3 x 3 quantities, row by row: [[a, b, c], [d, e, f], [g, h, i]].
  Mat3 matrix(std::string_view key, const std::string& si_unit, std::optional<Mat3> fallback);
  /// A whole number from lo to hi, ends included.
  long integer(std::string_view key, std::optional<long> fallback, long lo, long hi);
  /// true, false, "on" or "off".
  bool flag(std::string_view key, std::optional<bool> fallback);
  std::string text(std::string_view key, std::optional<std::string> fallback);
  /// A text, a number or a flag, and an array of them, as the file has them.
  ConfigWord word(std::string_view key, const std::optional<ConfigWord>& fallback);
  std::vector<ConfigWord> words(std::string_view key);
  /// All values below this table as overrides "a.b=value" for another file.
  std::vector<std::string> assignments();
  /// An existing file or folder, relative to the case file's folder; returned absolute. The empty
  /// text stands for no file, where the fallback allows that.
  std::string path(std::string_view key, std::optional<std::string> fallback);

  /// One of the named values.
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

  /// A table, given or not, sharing this one's problems.
  Config table(std::string_view key);
  /// The elements of an array of tables ([[key]]); none when the key is missing.
  std::vector<Config> tables(std::string_view key);

  /// Notes a mistake that only the caller can see, at the key's line (at this table's line when the
  /// key is empty). A key whose read failed already keeps its first problem alone.
  void problem(std::string_view key, const std::string& found, const std::string& expected);

  /// Notes the mistakes of a file that this one names, whose message tells file and line itself.
  void other_file(const std::string& message);

  /// "FILE:LINE: KEY", as messages begin ("--set: KEY" of an override): for a mistake that shows
  /// only once the file is read.
  std::string place(std::string_view key) const;

  /// How many mistakes were noted so far: a caller's check across keys makes no sense when one of
  /// the keys was wrong.
  std::size_t problem_count() const;

  /// Throws InputError when there were problems, or keys that nobody read; one line for each,
  /// sorted by line: "FILE:LINE: KEY: found F, expected E". Mistakes of other files follow.
  void finish() const;

  /// The same without unread keys of a table that is read later, after which finish() is called.
  void finish_before(const TableKey& later) const;

  /// Throws InputError, as finish() does, when there were problems so far; says nothing about keys
  /// that nobody read. For a mistake that leaves open what the rest of the file means.
  void stop_at_problems() const;

  /// Every value read so far, defaults included, as a TOML file in SI that reads the same.
  std::string resolved() const;

  /// The resolved text with every path replaced by a hash of the file's bytes: equal for equal
  /// content, wherever the files lie.
  std::string fingerprint() const;

  /// Every single quantity read so far, by its dotted key, in SI.
  std::map<std::string, double> quantities() const;

  /// The file itself and those that paths read so far name.
  std::vector<std::string> files() const;

 private:
  Config(std::shared_ptr<ConfigDocument> document, std::string prefix);
  std::size_t choice_index(std::string_view key, const std::vector<std::string>& names,
                           std::optional<std::size_t> fallback);
  std::string full(std::string_view key) const;
  void note_former_names(std::string_view key, const FormerNames& former);

  std::shared_ptr<ConfigDocument> document_;
  std::string prefix_;  ///< dotted path of the table that this stands for; empty: the whole file
};

}  // namespace tdbd
