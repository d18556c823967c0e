#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "app/arguments.hpp"
#include "core/config/key_table.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace tdbd::app {
namespace {

/// Lower case, with blanks for "_" and "-".
std::string search_form(std::string text) {
  for (char& c : text)
    c = c == '_' || c == '-' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Abbreviations of the field, and the words of keys that they stand for.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> abbreviations{{
    {"doc", "depth cut"},
    {"mse", "specific energy"},
    {"rop", "rate penetration"},
    {"rpm", "rotary speed"},
    {"tob", "torque"},
    {"wob", "weight bit"},
}};

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream in(search_form(text));
  for (std::string word; in >> word;) {
    const auto known =
        std::ranges::find(abbreviations, word, [](const auto& a) { return a.first; });
    std::istringstream meant(known == abbreviations.end() ? word : std::string(known->second));
    for (std::string each; meant >> each;) words.push_back(each);
  }
  return words;
}

bool has_all(const std::string& text, const std::vector<std::string>& words) {
  const std::string where = search_form(text);
  return std::ranges::all_of(
      words, [&](const std::string& word) { return where.find(word) != std::string::npos; });
}

/// What a search finds: tables with only the rows that fit.
struct Found {
  std::vector<KeyTable> by_name, by_meaning, tables;
};

void add_row(std::vector<KeyTable>& found, const KeyTable& table, const KeyRow& row) {
  if (found.empty() || found.back().name != table.name || found.back().command != table.command) {
    found.push_back(table);
    found.back().rows.clear();
  }
  found.back().rows.push_back(row);
}

Found search(std::span<const KeyTable> tables, const std::vector<std::string>& words) {
  Found found;
  for (const KeyTable& table : tables) {
    bool has_row = false;
    for (const KeyRow& row : table.rows) {
      const std::string name = table.name + " " + row.name;
      const bool by_name = has_all(name, words);
      if (!by_name && !has_all(name + " " + row.meaning + " " + row.allowed, words)) continue;
      add_row(by_name ? found.by_name : found.by_meaning, table, row);
      has_row = true;
    }
    if (has_row || !has_all(table.name + " " + table.meaning, words)) continue;
    found.tables.push_back(table);
    found.tables.back().rows.clear();
  }
  return found;
}

/// All words of keys and meanings with at least three letters, each once.
std::set<std::string> vocabulary(std::span<const KeyTable> tables) {
  constexpr std::size_t shortest = 3;
  std::set<std::string> all;
  const auto add = [&all](const std::string& text) {
    std::string word;
    for (const char c : search_form(text) + " ") {
      if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
        word += c;
        continue;
      }
      if (word.size() >= shortest) all.insert(word);
      word.clear();
    }
  };
  for (const KeyTable& table : tables) {
    add(table.name + " " + table.meaning);
    for (const KeyRow& row : table.rows) add(row.name + " " + row.meaning + " " + row.allowed);
  }
  return all;
}

/// The words nearest to this one, at most three, none of which differs by more than a
/// third (nearest_name).
std::vector<std::string> nearest_words(const std::string& word, const std::set<std::string>& all) {
  constexpr std::size_t most = 3;
  std::vector<std::pair<std::size_t, std::string>> by_distance;
  for (const std::string& other : all)
    if (const std::size_t distance = edit_distance(word, other);
        3 * distance <= std::max(word.size(), other.size()))
      by_distance.emplace_back(distance, other);
  std::ranges::sort(by_distance);
  std::vector<std::string> nearest;
  for (std::size_t k = 0; k < std::min(most, by_distance.size()); ++k)
    nearest.push_back(by_distance[k].second);
  return nearest;
}

/// Reports the first word that occurs nowhere, or that no key has all words.
[[noreturn]] void report_nothing(std::span<const KeyTable> tables, const std::string& text,
                                 const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    const Found alone = search(tables, {word});
    if (!alone.by_name.empty() || !alone.by_meaning.empty() || !alone.tables.empty()) continue;
    const std::vector<std::string> nearest = nearest_words(word, vocabulary(tables));
    throw InputError(fmt::format(
        "WORD: found \"{}\", expected a table, or a word of a key or of its meaning{}{}", word,
        nearest.empty() ? "" : ", such as ", fmt::join(nearest, ", ")));
  }
  throw InputError(
      fmt::format("WORD: found \"{}\", expected words that one key has; try fewer", text));
}

/// Shortens a text to the largest number of lines that is printed.
std::string shortened(const std::string& text) {
  const auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n'));
  if (lines <= most_search_lines) return text;
  std::size_t end = 0;
  for (std::size_t k = 0; k + 1 < most_search_lines; ++k) end = text.find('\n', end) + 1;
  return text.substr(0, end) + fmt::format("... and {} more lines; add a word to the search\n",
                                           lines - most_search_lines + 1);
}

}  // namespace

std::string keys_about(std::span<const KeyTable> tables, const std::string& text) {
  const std::vector<std::string> words = words_of(text);
  const Found found = search(tables, words);
  std::string all = keys_as_text(found.by_name);
  for (const std::vector<KeyTable>& more : {found.by_meaning, found.tables})
    if (!more.empty()) all += (all.empty() ? "" : "\n") + keys_as_text(more);
  if (words.empty() || all.empty()) report_nothing(tables, text, words);
  return shortened(all);
}

}  // namespace tdbd::app
