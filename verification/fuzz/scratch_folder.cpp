#include "fuzz/scratch_folder.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace tdbd::fuzz {
namespace {

namespace fs = std::filesystem;

struct ScratchFolder {
  fs::path path;

  ScratchFolder() {
    const fs::path memory = "/dev/shm";
    path = (fs::is_directory(memory) ? memory : fs::temp_directory_path()) /
           ("tdbd_fuzz_" + std::to_string(getpid()));
    fs::remove_all(path);
    fs::copy(TDBD_SOURCE_DIR "/verification/fuzz/files", path);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
};

}  // namespace

std::string scratch_path(std::string_view name) {
  static const ScratchFolder folder;
  return (folder.path / name).string();
}

std::string scratch_file(std::string_view name, std::string_view bytes) {
  const std::string path = scratch_path(name);
  std::ofstream(path, std::ios::binary)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return path;
}

}  // namespace tdbd::fuzz
