#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "core/error.hpp"
#include "fuzz/readers.hpp"
#include "fuzz/scratch_folder.hpp"
#include "simulation/checkpoint/checkpoint_file.hpp"
#include "simulation/checkpoint/state_fields.hpp"
#include "simulation/checkpoint/statistics_fields.hpp"

namespace tdbd::fuzz {
namespace {

/// As many whole values as `bytes` begins with and `most` allows; they are taken away from it.
template <class T>
std::vector<T> column_of(std::string_view& bytes, std::size_t most) {
  std::vector<T> column(std::min(most, bytes.size() / sizeof(T)));
  const std::size_t size = column.size() * sizeof(T);
  if (size > 0) std::memcpy(column.data(), bytes.data(), size);
  bytes.remove_prefix(size);
  return column;
}

/// Three lengths of 16 bits, then reals, wholes and ints of these lengths; the rest are the bytes.
simulation::Tape tape_of(std::string_view bytes) {
  std::vector<std::uint16_t> lengths = column_of<std::uint16_t>(bytes, 3);
  lengths.resize(3);
  simulation::Tape tape;
  tape.reals = column_of<double>(bytes, lengths[0]);
  tape.wholes = column_of<std::int64_t>(bytes, lengths[1]);
  tape.ints = column_of<std::int32_t>(bytes, lengths[2]);
  tape.bytes.assign(bytes.begin(), bytes.end());
  return tape;
}

}  // namespace

void take_checkpoint(std::string_view bytes) {
  try {
    simulation::read_checkpoint_file(scratch_file("fuzzed.nc", bytes));
  } catch (const RunError&) {  // refused
  }
}

void take_tape(std::string_view bytes) {
  const simulation::Tape tape = tape_of(bytes);
  simulation::State state;
  simulation::Statistics statistics;
  try {
    simulation::TapeReader read(tape);
    read("state", state);
    read("statistics", statistics);
    read.finish();
  } catch (const RunError&) {  // refused
  }
}

}  // namespace tdbd::fuzz
