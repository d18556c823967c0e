#include <string>
#include <vector>

#include "bit/files/bit_file.hpp"
#include "calibration/case/calibration_case.hpp"
#include "core/error.hpp"
#include "fuzz/readers.hpp"
#include "fuzz/scratch_folder.hpp"
#include "simulation/case/case.hpp"
#include "simulation/rotate/rotate_case.hpp"

namespace tdbd::fuzz {
namespace {

/// Many more words than a user gives would only make each of them seldom.
constexpr std::size_t most_words = 16;

std::vector<std::string> lines_of(std::string_view bytes) {
  std::vector<std::string> lines;
  while (lines.size() < most_words) {
    const std::size_t end = bytes.find('\n');
    lines.emplace_back(bytes.substr(0, end));
    if (end == std::string_view::npos) return lines;
    bytes.remove_prefix(end + 1);
  }
  return lines;
}

}  // namespace

void take_case(std::string_view bytes) {
  const std::string path = scratch_path("fuzzed.toml");
  try {
    simulation::read_case(Config::read_text(std::string(bytes), path), path);
  } catch (const InputError&) {  // refused
  }
}

void take_rotate_case(std::string_view bytes) {
  try {
    simulation::read_rotate_case(scratch_file("fuzzed.toml", bytes), {});
  } catch (const InputError&) {  // refused
  }
}

void take_calibration(std::string_view bytes) {
  try {
    calibration::read_calibration(scratch_file("fuzzed.toml", bytes), {});
  } catch (const InputError&) {  // refused
  }
}

void take_bit(std::string_view bytes) {
  try {
    bit::read_bit(scratch_file("fuzzed.toml", bytes), bit::DirectionRule::hybrid,
                  bit::InsideRule::down);
  } catch (const InputError&) {  // refused
  }
}

void take_set_words(std::string_view bytes) {
  try {
    simulation::read_case(scratch_path("tooth-case.toml"), lines_of(bytes));
  } catch (const InputError&) {  // refused
  }
}

}  // namespace tdbd::fuzz
