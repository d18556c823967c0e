#include "simulation/checkpoint/case_tape.hpp"

#include <fmt/format.h>

#include <sstream>
#include <utility>

#include "core/error.hpp"
#include "core/provenance.hpp"
#include "simulation/checkpoint/checkpoint_file.hpp"

namespace tdbd::simulation {
namespace {

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

}  // namespace

void write_tape(const std::filesystem::path& path, const CaseMark& c, Tape tape) {
  write_checkpoint_file(path, {provenance().version, c.hash, c.text, std::move(tape)});
}

CaseTape::CaseTape(const std::filesystem::path& path, const CaseMark& c) : path_(path) {
  CheckpointFile file = read_checkpoint_file(path);
  if (file.version != provenance().version)
    refuse(fmt::format("written by tdbd {}, this is {}", file.version, provenance().version));
  if (file.case_hash != c.hash)
    refuse(fmt::format("the case has changed since: {}", first_difference(file.case_text, c.text)));
  tape_ = std::move(file.tape);
}

void CaseTape::refuse(const std::string& reason) const {
  throw InputError(fmt::format("checkpoint {}: {}", path_.string(), reason));
}

}  // namespace tdbd::simulation
