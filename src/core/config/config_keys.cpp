#include <fmt/format.h>

#include "core/config/config.hpp"
#include "core/config/config_document.hpp"

namespace tdbd {
namespace {

std::string text_of(std::string_view text) { return std::string(text); }

Vec3 vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

/// The last name of a key: "whirl" for "motion.whirl".
std::string_view last_part(const TableKey& key) { return key.name.substr(key.name.rfind('.') + 1); }

}  // namespace

double Config::read(const QuantityKey& key, std::optional<double> fallback) {
  return quantity(key, text_of(key.unit), fallback, key.range);
}

Vec3 Config::read(const VectorKey& key) {
  return read(key, key.fallback ? std::optional(vector_of(*key.fallback)) : std::nullopt);
}

Vec3 Config::read(const VectorKey& key, const std::optional<Vec3>& fallback) {
  return vector(key, text_of(key.unit), fallback);
}

std::vector<double> Config::read(const ListKey& key, std::optional<std::vector<double>> fallback) {
  return list(key, text_of(key.unit), std::move(fallback));
}

std::vector<std::pair<double, double>> Config::read(
    const PairsKey& key, std::optional<std::vector<std::pair<double, double>>> fallback) {
  return pairs(key, text_of(key.unit), std::move(fallback));
}

Mat3 Config::read(const MatrixKey& key, const std::optional<Mat3>& fallback) {
  return matrix(key, text_of(key.unit), fallback);
}

std::vector<std::string> Config::read(const TextsKey& key,
                                      const std::optional<std::vector<std::string>>& fallback) {
  return texts(key, fallback);
}

long Config::read(const IntegerKey& key, std::optional<long> fallback) {
  return integer(key, fallback, key.lo, key.hi);
}

bool Config::read(const FlagKey& key, std::optional<bool> fallback) { return flag(key, fallback); }

std::string Config::read(const TextKey& key) {
  return text(key, key.fallback ? std::optional(text_of(*key.fallback)) : std::nullopt);
}

std::string Config::read(const PathKey& key) { return path(key, std::nullopt); }

std::string Config::read(const NameKey& key, const std::optional<std::string>& fallback) {
  std::vector<std::pair<std::string, std::string>> names;
  for (const std::string_view name : key.names()) names.emplace_back(text_of(name), text_of(name));
  return choice<std::string>(key, names, fallback);
}

Config Config::table(const TableKey& key) { return table(last_part(key)); }

std::vector<Config> Config::tables(const TableKey& key) { return tables(last_part(key)); }

bool Config::has(const TableKey& key) const { return has(last_part(key)); }

/// Whether to read the key. Records a mistake if it is given and refused.
bool FieldReader::reads(std::string_view name, Need need) {
  if (refusal_ && table_.has(name))
    table_.problem(name, text_of(refusal_->found), text_of(refusal_->expected));
  return !refusal_ && (need != Need::optional || table_.has(name));
}

void FieldReader::operator()(double& x, const QuantityKey& key) {
  if (reads(key, key.need)) x = table_.read(key, fallback(key.need, x));
}

void FieldReader::operator()(Vec3& x, const VectorKey& key) {
  if (reads(key, key.need)) x = table_.read(key, fallback(key.need, x));
}

void FieldReader::operator()(std::vector<double>& x, const ListKey& key) {
  if (reads(key, key.need)) x = table_.read(key, fallback(key.need, x));
}

void FieldReader::operator()(std::vector<std::pair<double, double>>& x, const PairsKey& key) {
  if (reads(key, key.need)) x = table_.read(key, fallback(key.need, x));
}

void FieldReader::operator()(Mat3& x, const MatrixKey& key) {
  if (reads(key, key.need)) x = table_.read(key, fallback(key.need, x));
}

void FieldReader::operator()(std::vector<std::string>& x, const TextsKey& key) {
  if (reads(key, key.need)) x = table_.read(key, fallback(key.need, x));
}

void FieldReader::operator()(long& x, const IntegerKey& key) {
  if (reads(key, key.need)) x = table_.read(key, fallback(key.need, x));
}

void FieldReader::operator()(bool& x, const FlagKey& key) {
  if (reads(key, key.need)) x = table_.read(key, fallback(key.need, x));
}

void FieldReader::operator()(std::string& x, const TextKey& key) {
  if (reads(key, key.need)) x = table_.text(key, fallback(key.need, x));
}

void FieldReader::operator()(ConfigWord& x, const WordKey& key) {
  if (reads(key.name, key.need)) x = table_.word(key, fallback(key.need, x));
}

void FieldReader::operator()(std::vector<ConfigWord>& x, const WordsKey& key) {
  if (reads(key, key.need)) x = table_.words(key);
}

void FieldReader::path(std::string& x, const PathKey& key) {
  if (reads(key, key.need)) x = table_.path(key, fallback(key.need, x));
}

void FieldReader::name(std::string& x, const NameKey& key) {
  if (reads(key, key.need)) x = table_.read(key, fallback(key.need, x));
}

std::optional<std::size_t> FieldReader::choose(const NamedChoice& choice) {
  if (!reads(choice.name, choice.need)) return std::nullopt;
  std::vector<std::pair<std::string, std::size_t>> names;
  for (std::size_t i = 0; i < choice.names.size(); ++i) names.emplace_back(choice.names[i], i);
  const bool required = choice.need == Need::required;
  return table_.choice<std::size_t>(choice.name, names, required ? std::nullopt : choice.index);
}

}  // namespace tdbd
