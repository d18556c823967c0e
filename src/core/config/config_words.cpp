#include <fmt/format.h>

#include <sstream>

#include "core/config/config.hpp"
#include "core/config/config_document.hpp"

namespace tdbd {
namespace {

constexpr const char* a_word = "a text, a number, or true or false";

/// Returns nothing for a table or an array.
std::optional<ConfigWord> word_of(const toml::node& node) {
  if (!node.is_string() && !node.is_number() && !node.is_boolean()) return std::nullopt;
  const auto text = node.as_string();
  return ConfigWord{text != nullptr ? text->get() : describe(&node), describe(&node)};
}

/// Formats a value of any type as one line of TOML.
std::string one_line(const toml::node& node) {
  std::ostringstream out;
  if (const toml::array* array = node.as_array()) {
    const char* comma = "";
    out << "[";
    for (const toml::node& element : *array) {
      out << comma << one_line(element);
      comma = ", ";
    }
    out << "]";
    return out.str();
  }
  return describe(&node);
}

}  // namespace

ConfigWord Config::word(std::string_view key, const std::optional<ConfigWord>& fallback) {
  const std::string name = full(key);
  const toml::node* node = document_->find(name);
  if (node == nullptr) {
    if (!fallback)
      document_->add_problem(name, "nothing", fmt::format("{} (the key is required)", a_word));
    const ConfigWord word = fallback.value_or(ConfigWord{"", "\"\""});
    document_->values.try_emplace(name, ResolvedValue{word.toml, "", ""});
    return word;
  }
  const std::optional<ConfigWord> word = word_of(*node);
  if (!word) document_->add_problem(name, describe(node), a_word);
  document_->values.try_emplace(name, ResolvedValue{word ? word->toml : "\"\"", "", ""});
  return word.value_or(ConfigWord{"", "\"\""});
}

std::vector<ConfigWord> Config::words(std::string_view key) {
  const std::string name = full(key);
  const toml::node* node = document_->find(name);
  std::vector<ConfigWord> words;
  const toml::array* array = node == nullptr ? nullptr : node->as_array();
  if (array == nullptr || array->empty())
    document_->add_problem(name, array == nullptr ? describe(node) : "no value",
                           fmt::format("an array of at least one value, each {}", a_word));
  if (array != nullptr)
    for (const toml::node& element : *array) {
      const std::optional<ConfigWord> word = word_of(element);
      if (!word) document_->add_problem(name, describe(&element), a_word);
      words.push_back(word.value_or(ConfigWord{"", "\"\""}));
    }
  document_->values.try_emplace(name,
                                ResolvedValue{node == nullptr ? "[]" : one_line(*node), "", ""});
  return words;
}

std::vector<std::string> Config::assignments() {
  std::vector<std::string> all;
  for (const std::string& name : given()) {
    const toml::node* node = document_->find(full(name));
    if (node == nullptr) continue;
    if (node->is_table()) {
      for (const std::string& below : table(name).assignments()) all.push_back(name + "." + below);
      continue;
    }
    const std::string value = one_line(*node);
    document_->values.try_emplace(full(name), ResolvedValue{value, "", ""});
    all.push_back(name + "=" + value);
  }
  return all;
}

}  // namespace tdbd
