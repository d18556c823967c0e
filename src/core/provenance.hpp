#pragma once

namespace tdbd {

/// Where a result came from: written into every summary.
struct Provenance {
  const char* version;
  const char* commit;
  const char* compiler;
  const char* flags;
};

const Provenance& provenance();

}  // namespace tdbd
