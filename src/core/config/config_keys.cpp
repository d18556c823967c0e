#include <fmt/format.h>

#include "core/config/config.hpp"
#include "core/config/config_document.hpp"

namespace tdbd {
namespace {

std::string text_of(std::string_view text) { return std::string(text); }

Vec3 vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

/// "whirl" of "motion.whirl".
std::string_view last_part(const TableKey& key) { return key.name.substr(key.name.rfind('.') + 1); }

}  // namespace

/// Notes every use of a former name, and that the key itself is not missing then.
void Config::note_former_names(std::string_view key, const FormerNames& former) {
  for (const std::string_view name : former) {
    if (name.empty() || !has(name)) continue;
    problem(name, fmt::format("\"{}\"", name), fmt::format("its new name \"{}\"", key));
    document_->renamed.insert(full(key));
  }
}

double Config::read(const QuantityKey& key, std::optional<double> fallback) {
  note_former_names(key, key.former);
  return quantity(key, text_of(key.unit), fallback, key.range);
}

Vec3 Config::read(const VectorKey& key) {
  return read(key, key.fallback ? std::optional(vector_of(*key.fallback)) : std::nullopt);
}

Vec3 Config::read(const VectorKey& key, const std::optional<Vec3>& fallback) {
  note_former_names(key, key.former);
  return vector(key, text_of(key.unit), fallback);
}

std::vector<double> Config::read(const ListKey& key, std::optional<std::vector<double>> fallback) {
  note_former_names(key, key.former);
  return list(key, text_of(key.unit), std::move(fallback));
}

std::vector<std::pair<double, double>> Config::read(
    const PairsKey& key, std::optional<std::vector<std::pair<double, double>>> fallback) {
  note_former_names(key, key.former);
  return pairs(key, text_of(key.unit), std::move(fallback));
}

Mat3 Config::read(const MatrixKey& key, const std::optional<Mat3>& fallback) {
  note_former_names(key, key.former);
  return matrix(key, text_of(key.unit), fallback);
}

std::vector<std::string> Config::read(const TextsKey& key,
                                      const std::optional<std::vector<std::string>>& fallback) {
  note_former_names(key, key.former);
  return texts(key, fallback);
}

long Config::read(const IntegerKey& key, std::optional<long> fallback) {
  note_former_names(key, key.former);
  return integer(key, fallback, key.lo, key.hi);
}

bool Config::read(const FlagKey& key, std::optional<bool> fallback) {
  note_former_names(key, key.former);
  return flag(key, fallback);
}

std::string Config::read(const TextKey& key) {
  note_former_names(key, key.former);
  return text(key, key.fallback ? std::optional(text_of(*key.fallback)) : std::nullopt);
}

std::string Config::read(const PathKey& key) {
  note_former_names(key, key.former);
  return path(key, std::nullopt);
}

std::string Config::read(const NameKey& key, const std::optional<std::string>& fallback) {
  note_former_names(key, key.former);
  std::vector<std::pair<std::string, std::string>> names;
  for (const std::string_view name : key.names()) names.emplace_back(text_of(name), text_of(name));
  return choice<std::string>(key, names, fallback);
}

Config Config::table(const TableKey& key) { return table(last_part(key)); }

std::vector<Config> Config::tables(const TableKey& key) { return tables(last_part(key)); }

bool Config::has(const TableKey& key) const { return has(last_part(key)); }

}  // namespace tdbd
