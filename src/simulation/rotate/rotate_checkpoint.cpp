#include "simulation/rotate/rotate_checkpoint.hpp"

#include <utility>

#include "simulation/checkpoint/case_tape.hpp"
#include "simulation/rotate/rotate_fields.hpp"

namespace tdbd::simulation {

void write_rotate_checkpoint(const std::filesystem::path& path, const RotateCase& c,
                             const RotateSimulation& s, const RotateWritten& written) {
  Tape tape;
  TapeWriter write(tape);
  write("simulation", s);
  write("written", written);
  write_tape(path, {c.hash, c.resolved}, std::move(tape));
}

RotateCheckpoint read_rotate_checkpoint(const std::filesystem::path& path, const RotateCase& c) {
  RotateCheckpoint saved;
  CaseTape(path, {c.hash, c.resolved}).read([&](TapeReader& read) {
    read("simulation", saved.simulation);
    read("written", saved.written);
  });
  return saved;
}

}  // namespace tdbd::simulation
