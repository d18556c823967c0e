#pragma once

namespace tdbd {

/// Version and build of the program, written into every summary.
struct Provenance {
  const char* version;
  const char* commit;
  const char* compiler;
  const char* flags;
};

const Provenance& provenance();

}  // namespace tdbd
