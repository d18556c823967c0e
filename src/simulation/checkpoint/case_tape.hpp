#pragma once

#include <filesystem>
#include <string>

#include "simulation/checkpoint/tape.hpp"

namespace tdbd::simulation {

/// The case that a tape is of: another one does not go on from it.
struct CaseMark {
  const std::string& hash;  ///< Case::hash, RotateCase::hash
  const std::string& text;  ///< Case::resolved, RotateCase::resolved
};

/// Writes a tape as a checkpoint: complete, on the disk, or not at all. Throws RunError.
void write_tape(const std::filesystem::path& path, const CaseMark& c, Tape tape);

/// A tape from the file of a checkpoint.
class CaseTape {
 public:
  /// Throws RunError if the file cannot be read, is torn or was changed, and InputError if it is of another version of
  /// tdbd or another case: of a case that changed since it names the first line that did.
  CaseTape(const std::filesystem::path& path, const CaseMark& c);

  /// read(TapeReader&) reads all of it. Throws InputError if that is not what it holds.
  template <class Read>
  void read(Read&& read) const {
    try {
      TapeReader reader(tape_);
      read(reader);
      reader.finish();
    } catch (const RunError& e) {
      refuse(e.what());
    }
  }

 private:
  [[noreturn]] void refuse(const std::string& reason) const;

  std::filesystem::path path_;
  Tape tape_;
};

}  // namespace tdbd::simulation
