#pragma once

#include "simulation/step/simulation.hpp"
#include "sweep/point/kept.hpp"

namespace tdbd::sweep {

/// Whether points begin with what others made.
enum class Keeping { on, off };

/// What points need before their first step. Most share bit and rock, and to read and make these
/// takes longer than all else; so the newest few stay. Threads may use it at once.
struct Starts {
  explicit Starts(Keeping keeping);
  Kept<bit::BitFile> files;                 ///< by all arguments of their reader
  Kept<rock::CuttingBit> bits;              ///< by Case::bit_hash
  Kept<simulation::StartSurface> surfaces;  ///< by start_surface_key
};

/// simulation::read_case of a sweep, during which files do not change.
simulation::Case read_case(const std::string& path, const std::vector<std::string>& overrides,
                           Starts& kept);

/// simulation::start of the case, to the bit. `room` is a bit to be overwritten: its memory serves
/// again.
simulation::Simulation start(const simulation::Case& c, Starts& kept, rock::CuttingBit room);

}  // namespace tdbd::sweep
