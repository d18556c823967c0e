#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <numbers>

#include "app/arguments.hpp"
#include "app/terminal.hpp"
#include "bit/bit.hpp"
#include "bit/files/bit_export.hpp"
#include "bit/files/bit_file.hpp"
#include "bit/files/file_checks.hpp"
#include "bit/report/bit_output.hpp"
#include "bit/report/bit_report.hpp"
#include "bit/report/body_report.hpp"
#include "bit/report/cone_report.hpp"
#include "core/error.hpp"
#include "io/output_folder.hpp"
#include "mesh/measures.hpp"
#include "simulation/case/case_kind.hpp"

namespace tdbd::app {
namespace {

void print_table(const bit::Bit& b) {
  constexpr double deg = 180.0 / std::numbers::pi;
  print_out("{}: {} cutters, {} parts, gage radius {:.3f} mm\n", b.name, b.cutters.size(),
            b.parts.size(), 1e3 * b.gage_radius);
  print_out("{:>7} {:>5} {:>9} {:>9} {:>9} {:>9} {:>8} {:>6} {:>6} {:>8}\n", "cutter", "blade",
            "zone", "r mm", "phi deg", "h mm", "prof deg", "back", "side", "dia mm");
  for (const bit::Cutter& c : b.cutters)
    print_out("{:>7} {:>5} {:>9} {:>9.3f} {:>9.3f} {:>9.3f} {:>8.2f} {:>6.1f} {:>6.1f} {:>8.2f}\n",
              c.id, c.blade, c.zone, 1e3 * c.tip_radius, deg * c.azimuth, 1e3 * c.tip_height,
              deg * c.profile_angle, deg * c.back_rake, deg * c.side_rake, 1e3 * c.diameter);
}

void print_parts(const bit::Bit& b) {
  print_out("{:<24} {:>12} {:>6} {:>9} {:>12} {:>10}\n", "part", "kind", "cuts", "triangles",
            "volume mm3", "mass g");
  for (const bit::Part& p : b.parts) {
    const double volume = mesh::enclosed_volume(p.mesh_P);
    print_out("{:<24} {:>12} {:>6} {:>9} {:>12.3f} {:>10.3f}\n", p.name, bit::kind_name(p.kind),
              bit::cutting_name(bit::final_cutting(p)), p.mesh_P.triangles.size(), 1e9 * volume,
              1e3 * p.density * volume);
  }
}

void print_mass(const bit::Bit& b, const std::vector<std::string>& without_density) {
  if (!without_density.empty())
    return print_out("mass unknown: no density for {}\n", bit::listed(without_density));
  const bit::MassProperties m = bit::mass_properties(b);
  print_out(
      "mass {:.2f} kg, centre of mass ({:.2f}, {:.2f}, {:.2f}) mm, inertia about it {:.5f} {:.5f} "
      "{:.5f} kg m2\n",
      m.mass, 1e3 * m.centre.x(), 1e3 * m.centre.y(), 1e3 * m.centre.z(), m.inertia(0, 0),
      m.inertia(1, 1), m.inertia(2, 2));
}

void print_bit(const bit::BitFile& read) {
  print_table(read.bit);
  print_parts(read.bit);
  print_mass(read.bit, read.without_density);
  print_out("{}", bit::cones_text(read.bit));
}

struct BitChoices {
  std::string file, folder, format = "ply", solids = "stl";
  bool force = false;
  bool report = false;
  bool quiet = false;
  std::string penetration = "5 mm";
  std::string speed = "120 rpm";
  std::vector<double> cone_speeds;
};

int inspect_bit(const BitChoices& choices) {
  simulation::require_kind(choices.file, {}, {simulation::CaseKind::bit});
  const double advance =
      option_quantity("--penetration", choices.penetration, "m", Range::positive(), "a length");
  const double bit_speed =
      option_quantity("--speed", choices.speed, "rad/s", Range::positive(), "a rotary speed");
  const bit::BitFile read =
      bit::read_bit(choices.file, bit::DirectionRule::hybrid, bit::InsideRule::down,
                    choices.report ? bit::Densities::required : bit::Densities::as_given);
  const bit::Bit& b = read.bit;
  const bit::ReportOptions options{advance, bit_speed, choices.cone_speeds};
  const bit::ConeOperation operation = bit::cone_operation(b, choices.cone_speeds, advance);
  if (!choices.quiet) {
    print_bit(read);
    print_out("{}{}{}", bit::assumptions_text(b, bit_speed),
              bit::overlaps_text(b, bit::cutter_overlaps(b)), bit::enclosed_text(b));
    if (choices.report)
      print_out("{}{}{}", bit::areas_report(b), bit::tracking_text(b, operation),
                bit::body_text(b, advance));
  }
  if (choices.folder.empty()) {
    if (choices.report) throw InputError("--report: found no folder, expected one: -o FOLDER");
    return 0;
  }
  const OutputFolder out =
      prepare(choices.folder, overwrite_of(choices.force), read.files, ResultKind::bit);
  bit::export_bit(out.path, b, choices.format);  // first: bit.toml marks the folder
  bit::write_bit_files(out.path, b);
  bit::write_profile(out.path, b);
  bit::write_cutter_table(out.path, b);
  if (choices.report) bit::write_analysis(out.path, b, options);
  bit::export_solids(out.path, b, choices.solids);
  bit::write_bit_vtp(out.path / "bit.vtp", b, Pose{});
  return 0;
}

}  // namespace

void add_bit(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("bit", "Build and inspect a bit: table, mass properties, meshes");
  auto choices = std::make_shared<BitChoices>();
  command->add_option("bit", choices->file, "the bit file (TOML)")
      ->required()
      ->type_name(a_toml_file);
  command
      ->add_option("-o,--output", choices->folder,
                   "write bit.toml with parts/, solids.toml with bit.stl, bit.json, "
                   "cutters.csv, profile.csv and "
                   "bit.vtp here")
      ->type_name(a_folder);
  command
      ->add_option("--format", choices->format, "format of the part meshes: ply, off, obj or stl")
      ->check(CLI::IsMember({"ply", "off", "obj", "stl"}))
      ->capture_default_str();
  command
      ->add_option("--solids", choices->solids,
                   "format of the file with all solids: stl or obj (with names), ply or off")
      ->check(CLI::IsMember({"stl", "obj", "ply", "off"}))
      ->capture_default_str();
  command->add_flag("--report", choices->report, "also write analysis.json, data for bit design");
  command
      ->add_option("--penetration", choices->penetration, "advance per revolution, for the report")
      ->capture_default_str();
  command
      ->add_option("--speed", choices->speed,
                   "rotary speed of the bit, for the printed assumptions about cones")
      ->capture_default_str();
  command
      ->add_option("--cone-speeds", choices->cone_speeds,
                   "ratio of cone speed to bit speed for each cone, for the report: "
                   "1.47,1.47,1.47; default: pure rolling of the gage rows")
      ->delimiter(',');
  command->add_flag("--force", choices->force, "replace the results in the folder");
  command->add_flag("--quiet", choices->quiet, "print no tables");
  command->footer("Example: tdbd bit cases/bits/bit-b.toml -o out/bit-b");
  command->callback(
      [choices, &exit_code] { exit_code = guarded([&] { return inspect_bit(*choices); }); });
}

}  // namespace tdbd::app
