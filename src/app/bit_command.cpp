#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <numbers>

#include "app/commands.hpp"
#include "bit/mass_properties.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "mesh/measures.hpp"
#include "simulation/bit_export.hpp"
#include "simulation/bit_export_solids.hpp"
#include "simulation/bit_file.hpp"
#include "simulation/bit_output.hpp"
#include "simulation/bit_report.hpp"
#include "simulation/cone_report.hpp"
#include "simulation/output_folder.hpp"
#include "simulation/part_keys.hpp"

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
}

void print_parts(const bit::Bit& b) {
  fmt::print("{:<24} {:>12} {:>6} {:>9} {:>12} {:>10}\n", "part", "kind", "cuts", "triangles",
             "volume mm3", "mass g");
  for (const bit::Part& p : b.parts) {
    const double volume = mesh::enclosed_volume(p.mesh_P);
    fmt::print("{:<24} {:>12} {:>6} {:>9} {:>12.3f} {:>10.3f}\n", p.name,
               simulation::kind_name(p.kind), p.cutting == bit::Cutting::cuts ? "yes" : "no",
               p.mesh_P.triangles.size(), 1e9 * volume, 1e3 * p.density * volume);
  }
}

void print_mass(const bit::Bit& b, const std::vector<std::string>& without_density) {
  if (!without_density.empty())
    return fmt::print("mass not known: no density of {}\n", simulation::listed(without_density));
  const bit::MassProperties m = bit::mass_properties(b);
  fmt::print(
      "mass {:.2f} kg, centre of mass ({:.2f}, {:.2f}, {:.2f}) mm, inertia about it {:.5f} {:.5f} "
      "{:.5f} kg m2\n",
      m.mass, 1e3 * m.centre.x(), 1e3 * m.centre.y(), 1e3 * m.centre.z(), m.inertia(0, 0),
      m.inertia(1, 1), m.inertia(2, 2));
}

struct Choices {
  std::string file, folder, format = "ply", solids = "stl";
  bool force = false;
  bool report = false;
  std::string penetration = "5 mm";
};

/// Of --penetration, m per revolution.
double penetration(const Choices& choices) {
  try {
    const double advance = to_si(choices.penetration, "m");
    if (advance > 0.0) return advance;
  } catch (const UnitError&) {
  }
  throw InputError(fmt::format("--penetration: found '{}', expected a length > 0 with its unit",
                               choices.penetration));
}

int inspect(const Choices& choices) {
  using namespace simulation;
  const double advance = penetration(choices);
  const BitFile read = read_bit(choices.file, bit::DirectionRule::hybrid, bit::InsideRule::down,
                                choices.report ? Densities::demanded : Densities::as_given);
  const bit::Bit& b = read.bit;
  print_table(b);
  print_parts(b);
  print_mass(b, read.without_density);
  fmt::print("{}", cones_text(b));
  if (choices.folder.empty()) {
    if (choices.report) throw InputError("--report: found no folder, expected one: -o FOLDER");
    return 0;
  }
  const OutputFolder out =
      prepare(choices.folder, choices.force ? Overwrite::force : Overwrite::no);
  write_bit_files(out.path, b);
  write_profile(out.path, b);
  write_cutter_table(out.path, b);
  if (choices.report) write_analysis(out.path, b, advance);
  export_bit(out.path, b, choices.format);
  export_solids(out.path, b, choices.solids);
  write_bit_vtp(out.path / "bit.vtp", b, Pose{});
  return 0;
}

}  // namespace

void add_bit(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("bit", "Build and inspect a bit: table, mass properties, meshes");
  auto choices = std::make_shared<Choices>();
  command->add_option("bit", choices->file, "the bit file (TOML)")->required();
  command->add_option("-o,--output", choices->folder,
                      "write bit.toml with parts/, solids.toml with bit.stl, bit.json, "
                      "cutters.csv, profile.csv and "
                      "bit.vtp here");
  command->add_option("--format", choices->format, "of the parts' meshes: ply, off, obj or stl")
      ->check(CLI::IsMember({"ply", "off", "obj", "stl"}))
      ->capture_default_str();
  command
      ->add_option("--solids", choices->solids,
                   "of the whole bit in one file: stl or obj (named), ply or off")
      ->check(CLI::IsMember({"stl", "obj", "ply", "off"}))
      ->capture_default_str();
  command->add_flag("--report", choices->report, "also write analysis.json, a designer's figures");
  command->add_option("--penetration", choices->penetration, "of the report, per revolution")
      ->capture_default_str();
  command->add_flag("--force", choices->force, "replace the results in the folder");
  command->footer("Example: tdbd bit cases/bits/bit-b.toml -o out/bit-b");
  command->callback(
      [choices, &exit_code] { exit_code = guarded([&] { return inspect(*choices); }); });
}

}  // namespace tdbd::app
