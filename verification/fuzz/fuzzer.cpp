#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "fuzz/fuzz_target.hpp"

// The program of libFuzzer. It is called by the name of a target, fuzz_NAME: a link for each leads to it.

namespace {

const tdbd::fuzz::FuzzTarget* target = nullptr;

}  // namespace

// NOLINTBEGIN(readability-identifier-naming): libFuzzer's names
extern "C" int LLVMFuzzerInitialize(const int* /*count*/, char*** arguments) {
  const std::string program = std::filesystem::path((*arguments)[0]).filename().string();
  const std::string name = program.substr(program.find('_') + 1);
  target = tdbd::fuzz::fuzz_target(name);
  if (target != nullptr) return 0;
  std::fprintf(stderr, "found no reader %s, expected to be called as fuzz_NAME\n", name.c_str());
  std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  target->take({reinterpret_cast<const char*>(data), size});
  return 0;
}
// NOLINTEND(readability-identifier-naming)
