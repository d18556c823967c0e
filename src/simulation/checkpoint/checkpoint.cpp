#include "simulation/checkpoint/checkpoint.hpp"

#include <fmt/format.h>

#include <sstream>

#include "core/error.hpp"
#include "core/provenance.hpp"
#include "simulation/checkpoint/checkpoint_file.hpp"
#include "simulation/checkpoint/state_fields.hpp"
#include "simulation/checkpoint/statistics_fields.hpp"
#include "simulation/start/rock_start.hpp"

namespace tdbd::simulation {

template <class A>
void fields(A& a, Of<A, WrittenSoFar>& x) {
  a("rows", x.rows);
  a("rock_frames", x.rock_frames);
  a("bit_frames", x.bit_frames);
  a("order", x.order);
}

namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& reason) {
  throw InputError(fmt::format("checkpoint {}: {}", path.string(), reason));
}

/// "step = 0.001" of "step = 0.001  # s".
std::string without_comment(const std::string& line) { return line.substr(0, line.find("  #")); }

/// The first line of a case that is not as it was, with the table it stands in.
std::string first_difference(const std::string& was, const std::string& is) {
  std::istringstream old_text(was), new_text(is);
  std::string expected, found, table;
  while (true) {
    const bool has_old = static_cast<bool>(std::getline(old_text, expected)),
               has_new = static_cast<bool>(std::getline(new_text, found));
    if (!has_old && !has_new) return "the content of an input file";
    if (expected != found || has_old != has_new)
      return fmt::format("{}found {}, expected {}", table,
                         has_new ? without_comment(found) : "nothing more",
                         has_old ? without_comment(expected) : "nothing more");
    if (found.starts_with('[')) table = found + " ";
  }
}

void require_same_case(const std::filesystem::path& path, const CheckpointFile& file,
                       const Case& c) {
  if (file.case_hash == c.hash) return;
  refuse(path, fmt::format("the case has changed since: {}",
                           first_difference(file.case_text, c.resolved)));
}

/// The index is not saved: it follows from the surface.
void rebuild(const Case& c, rock::Rock& rock) {
  mesh::refresh_stars(rock.surface);
  rock::Rock saved = std::move(rock);
  rock = indexed_rock(c, std::move(saved.surface));
  rock.last_part = std::move(saved.last_part);
  rock.touched = std::move(saved.touched);
  rock.touched_list = std::move(saved.touched_list);
  rock.cuts = saved.cuts;
  rock.moved_in = std::move(saved.moved_in);
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const Case& c, const Simulation& s,
                      const WrittenSoFar& written) {
  CheckpointFile file{provenance().version, c.hash, c.resolved, {}};
  TapeWriter write(file.tape);
  write("state", s.state);
  write("statistics", s.statistics);
  write("written", written);
  write_checkpoint_file(path, file);
}

Checkpoint read_checkpoint(const std::filesystem::path& path, const Case& c) {
  const CheckpointFile file = read_checkpoint_file(path);
  if (file.version != provenance().version)
    refuse(path, fmt::format("written by tdbd {}, this is {}", file.version, provenance().version));
  require_same_case(path, file, c);
  Checkpoint saved;
  try {
    TapeReader read(file.tape);
    read("state", saved.state);
    read("statistics", saved.statistics);
    read("written", saved.written);
    read.finish();
  } catch (const RunError& e) {
    refuse(path, e.what());
  }
  rebuild(c, saved.state.rock);
  return saved;
}

}  // namespace tdbd::simulation
