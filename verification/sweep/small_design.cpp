#include "verification/sweep/small_design.hpp"

#include "core/error.hpp"
#include "core/read_file.hpp"
#include "io/whole_file.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::sweep {

namespace fs = std::filesystem;

fs::path empty_folder(const std::string& name) {
  const fs::path folder = fs::path(temporary_folder()) / ("tdbd_sweep_" + name);
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

Design design_from(const fs::path& folder, const std::string& text) {
  write_text(folder / "design.toml", text);
  return read_design((folder / "design.toml").string());
}

std::string small_top() {
  return "[sweep]\ncase = \"" TDBD_SOURCE_DIR
         "/cases/slow-top.toml\"\ncommand = \"rotate\"\n"
         "figures = [\"steps\", \"energy_drift_max\"]\n"
         "[set]\ntime.duration = 2000\n"
         "[[factors]]\nkey = \"time.step\"\nvalues = [0.5, 1.0, 2.0]\n"
         "[[factors]]\nkey = \"integrator.order\"\nvalues = [2, 8]\n";
}

std::string mistake_in(const std::string& text) {
  try {
    design_from(empty_folder("mistake"), text);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

std::string small_hole(const std::string& factors) {
  return "[sweep]\ncase = \"" TDBD_SOURCE_DIR
         "/cases/bit-b-6000psi.toml\"\nfigures = [\"wob_mean_n\", \"removed_volume_m3\", "
         "\"aggressiveness\"]\n"
         "[set]\nrock.edge_length = \"6 mm\"\ntime.revolutions = 0.1\noutput.means_from = \"0.01 "
         "s\"\n" +
         factors;
}

SweepResult swept(const Design& d, const std::filesystem::path& table, int threads, Shard shard) {
  return run_sweep(d, {table, shard, threads});
}

std::string text_of(const std::filesystem::path& file) { return read_file(file, "a file"); }

}  // namespace tdbd::sweep
