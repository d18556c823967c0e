#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

#include "core/error.hpp"
#include "fuzz/readers.hpp"
#include "fuzz/scratch_folder.hpp"
#include "mesh/files/solids.hpp"

namespace tdbd::fuzz {
namespace {

/// What every reader of meshes leads to: facets, triangles and the bodies they belong to.
void take_mesh(const char* name, std::string_view bytes) {
  try {
    mesh::read_solids(scratch_file(name, bytes), 1e-3);
  } catch (const InputError&) {  // refused
  }
}

}  // namespace

void take_stl(std::string_view bytes) { take_mesh("fuzzed.stl", bytes); }

void take_binary_stl(std::string_view bytes) {
  static_assert(std::endian::native == std::endian::little);
  constexpr std::size_t header = 80, facet = 50;
  std::string file(bytes);
  const std::size_t start = header + sizeof(std::uint32_t);
  const std::size_t facets = file.size() > start ? (file.size() - start) / facet : 0;
  file.resize(start + facets * facet);
  const auto count = static_cast<std::uint32_t>(facets);
  std::memcpy(file.data() + header, &count, sizeof count);
  take_mesh("fuzzed.stl", file);
}

void take_ply(std::string_view bytes) { take_mesh("fuzzed.ply", bytes); }
void take_obj(std::string_view bytes) { take_mesh("fuzzed.obj", bytes); }
void take_off(std::string_view bytes) { take_mesh("fuzzed.off", bytes); }

}  // namespace tdbd::fuzz
