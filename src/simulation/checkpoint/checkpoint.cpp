#include "simulation/checkpoint/checkpoint.hpp"

#include <utility>

#include "simulation/checkpoint/case_tape.hpp"
#include "simulation/checkpoint/state_fields.hpp"
#include "simulation/checkpoint/statistics_fields.hpp"
#include "simulation/start/rock_start.hpp"

namespace tdbd::simulation {

template <class A>
void fields(A& a, Of<A, bit::BodyPoses>& x) {
  a("time", x.time);
  a("X_WB", x.X_WB);
}

template <class A>
void fields(A& a, Of<A, HistoryWindow>& x) {
  a("steps", x.steps);
  a("sum", x.sum);
  a("least", x.least);
  a("greatest", x.greatest);
}

template <class A>
void fields(A& a, Of<A, WrittenSoFar>& x) {
  a("rows", x.rows);
  a("window", x.window);
  a("rock_frames", x.rock_frames);
  a("bit_frames", x.bit_frames);
  a("order", x.order);
  a("profile_rows", x.profile_rows);
}

namespace {

/// The index is not saved: it follows from the surface.
void rebuild(const Case& c, rock::Rock& rock) {
  mesh::refresh_stars(rock.surface);
  rock::Rock indexed = indexed_rock(c, std::move(rock.surface));
  rock.surface = std::move(indexed.surface);
  rock.grid = std::move(indexed.grid);
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const Case& c, const Simulation& s,
                      const WrittenSoFar& written) {
  Tape tape;
  TapeWriter write(tape);
  write("state", s.state);
  write("statistics", s.statistics);
  write("written", written);
  write_tape(path, {c.hash, c.resolved}, std::move(tape));
}

Checkpoint read_checkpoint(const std::filesystem::path& path, const Case& c) {
  Checkpoint saved;
  CaseTape(path, {c.hash, c.resolved}).read([&](TapeReader& read) {
    read("state", saved.state);
    read("statistics", saved.statistics);
    read("written", saved.written);
  });
  rebuild(c, saved.state.rock);
  return saved;
}

}  // namespace tdbd::simulation
