#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <numbers>

#include "app/commands.hpp"
#include "bit/mass_properties.hpp"
#include "mesh/files.hpp"
#include "simulation/bit_file.hpp"
#include "simulation/bit_output.hpp"
#include "simulation/output_folder.hpp"

namespace tdbd::app {
namespace {

void print_table(const bit::Bit& b) {
  constexpr double deg = 180.0 / std::numbers::pi;
  fmt::print("{}: {} cutters, {} parts, gage radius {:.3f} mm\n", b.name, b.cutters.size(),
             b.parts.size(), 1e3 * b.gage_radius);
  fmt::print("{:>7} {:>5} {:>9} {:>9} {:>9} {:>9} {:>8} {:>6} {:>6} {:>8}\n", "cutter", "blade",
             "zone", "r mm", "phi deg", "h mm", "prof deg", "back", "side", "dia mm");
  for (const bit::Cutter& c : b.cutters)
    fmt::print("{:>7} {:>5} {:>9} {:>9.3f} {:>9.3f} {:>9.3f} {:>8.2f} {:>6.1f} {:>6.1f} {:>8.2f}\n",
               c.id, c.blade, c.zone, 1e3 * c.tip_radius, deg * c.azimuth, 1e3 * c.tip_height,
               deg * c.profile_angle, deg * c.back_rake, deg * c.side_rake, 1e3 * c.diameter);
  const bit::MassProperties m = bit::mass_properties(b);
  fmt::print(
      "mass {:.2f} kg, centre of mass ({:.2f}, {:.2f}, {:.2f}) mm, inertia about it {:.5f} {:.5f} "
      "{:.5f} kg m2\n",
      m.mass, 1e3 * m.centre.x(), 1e3 * m.centre.y(), 1e3 * m.centre.z(), m.inertia(0, 0),
      m.inertia(1, 1), m.inertia(2, 2));
}

int inspect(const std::string& file, const std::string& folder, bool force) {
  using namespace simulation;
  const bit::Bit b = read_bit(file, bit::DirectionRule::hybrid, bit::InsideRule::down).bit;
  print_table(b);
  if (folder.empty()) return 0;
  const OutputFolder out = prepare(folder, force ? Overwrite::force : Overwrite::no);
  write_bit_files(out.path, b);
  mesh::write_mesh(out.path / "bit.stl", merged_mesh(b, Pose{}, nullptr));
  write_bit_vtp(out.path / "bit.vtp", b, Pose{});
  return 0;
}

}  // namespace

void add_bit(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("bit", "Build and inspect a bit: table, mass properties, meshes");
  auto file = std::make_shared<std::string>();
  auto folder = std::make_shared<std::string>();
  auto force = std::make_shared<bool>(false);
  command->add_option("bit", *file, "the bit file (TOML)")->required();
  command->add_option("-o,--output", *folder, "write bit.json, bit.stl and bit.vtp here");
  command->add_flag("--force", *force, "replace the results in the folder");
  command->footer("Example: tdbd bit cases/bits/bit-b.toml -o out/bit-b");
  command->callback([file, folder, force, &exit_code] {
    exit_code = guarded([&] { return inspect(*file, *folder, *force); });
  });
}

}  // namespace tdbd::app
