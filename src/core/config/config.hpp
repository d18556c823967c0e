#pragma once

#include <limits>
#include <map>
#include <memory>
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

  bool contains(double x) const { return (ends == Ends::closed ? x >= lo : x > lo) && x <= hi; }
  std::string text() const;  ///< ", > 0", ", in [0, 1]"; empty when there is no limit

  static Range positive() { return {.lo = 0.0, .ends = Ends::open_lo}; }
  static Range non_negative() { return {.lo = 0.0}; }
  static Range within(double lo, double hi) { return {.lo = lo, .hi = hi}; }
};

struct ConfigDocument;  // the file, the keys that were read, and the problems found so far

/// Strict reader of a TOML file. A key is dotted ("motion.whirl.radius") and relative to the table
/// that this Config stands for. A read without a fallback is required. A wrong or missing value
/// never throws at once: the read notes the problem and returns the fallback or a harmless value,
/// so that finish() can report every mistake of the file together.
class Config {
 public:
  /// Parses a file, then applies overrides "key.sub=value" (a TOML value, or else a bare string).
  /// Throws InputError when the file cannot be read or is no TOML (file:line:column).
  static Config read_file(const std::string& path, const std::vector<std::string>& overrides);

  /// Whether the key is given. Does not count as reading it.
  bool has(std::string_view key) const;

  /// Whether the key is given as a text. Does not count as reading it.
  bool is_text(std::string_view key) const;

  /// A string with a unit ("8.5 in") or a number in `si_unit`; returned in `si_unit`.
  double quantity(std::string_view key, const std::string& si_unit, std::optional<double> fallback,
                  Range range = {});
  /// Three quantities.
  Vec3 vector(std::string_view key, const std::string& si_unit, std::optional<Vec3> fallback);
  /// Any number of quantities.
  std::vector<double> list(std::string_view key, const std::string& si_unit,
                           std::optional<std::vector<double>> fallback);
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

  std::shared_ptr<ConfigDocument> document_;
  std::string prefix_;  ///< dotted path of the table that this stands for; empty: the whole file
};

}  // namespace tdbd
