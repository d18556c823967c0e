#include "core/error.hpp"
#include "fuzz/readers.hpp"
#include "fuzz/scratch_folder.hpp"
#include "io/checkpoint.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::fuzz {

void take_checkpoint(std::string_view bytes) {
  try {
    read_checkpoint_file(scratch_file("fuzzed.bin", bytes));
  } catch (const RunError&) {  // refused
  }
}

void take_archive(std::string_view bytes) {
  simulation::State state;
  simulation::Statistics statistics;
  try {
    ArchiveReader read(bytes);
    read(state, statistics);
    read.require_end();
  } catch (const RunError&) {  // refused
  }
}

}  // namespace tdbd::fuzz
