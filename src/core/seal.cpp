#include "core/seal.hpp"

#include <fmt/format.h>

#include <fstream>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/read_file.hpp"

namespace tdbd {
namespace {

std::string seal_of(std::string_view bytes) {
  return fmt::format("tdbd seal {}\n", fnv1a_hex(bytes));
}

std::string sealed_bytes(const std::filesystem::path& path) {
  try {
    return read_file(path, "a file with a seal");
  } catch (const InputError& e) {
    throw RunError(e.what());
  }
}

}  // namespace

void seal_file(const std::filesystem::path& path) {
  const std::string seal = seal_of(sealed_bytes(path));
  std::ofstream out(path, std::ios::binary | std::ios::app);
  out << seal << std::flush;
  if (!out) throw RunError(fmt::format("cannot write {}", path.string()));
}

void require_seal(const std::filesystem::path& path) {
  const std::string file = sealed_bytes(path);
  const std::string_view bytes = file;
  const std::size_t length = seal_of("").size();
  const std::size_t data = bytes.size() < length ? 0 : bytes.size() - length;
  if (bytes.substr(data) != seal_of(bytes.substr(0, data)))
    throw RunError(fmt::format("{}: the file is incomplete or was changed", path.string()));
}

}  // namespace tdbd
