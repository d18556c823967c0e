#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <utility>

#include "app/arguments.hpp"
#include "app/terminal.hpp"
#include "bit/bit.hpp"
#include "bit/cutter/cutter.hpp"
#include "bit/files/bit_export.hpp"
#include "bit/files/bit_file.hpp"
#include "bit/files/file_checks.hpp"
#include "bit/report/bit_facts.hpp"
#include "bit/report/bit_output.hpp"
#include "bit/report/bit_report.hpp"
#include "bit/report/body_report.hpp"
#include "bit/report/cone_report.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "io/output_folder.hpp"
#include "simulation/case/case_kind.hpp"

namespace tdbd::app {
namespace {

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

struct BitChoices {
  std::string file, folder, format = "ply", solids = "stl", unit = "mm";
  std::vector<std::string> overrides;
  bool force = false, binary = false, united = false;
  bool report = false;
  bool quiet = false;
  bool cutters = false, parts = false;
  std::string penetration = "5 mm";
  std::string speed = "120 rpm";
  std::vector<double> cone_speeds;
};

void print_doubts(const std::vector<bit::BitDoubt>& doubts) {
  for (const bit::BitDoubt& d : doubts) print_warning(d.place + ": " + d.text);
}

/// How to list what is not printed, because it may have hundreds of rows.
void print_how_to_list(const bit::Bit& b, const BitChoices& choices) {
  std::string options;
  if (!choices.cutters && !b.cutters.empty()) options += " --cutters";
  if (!choices.parts) options += " --parts";
  if (!options.empty()) print_out("to list all:{}\n", options);
}

void print_bit(const bit::BitFile& read, const BitChoices& choices,
               const bit::ReportOptions& options) {
  const bit::Bit& b = read.bit;
  print_out("{}", bit::facts_text(b, options.advance));
  print_mass(b, read.without_density);
  print_out("{}{}{}{}", bit::cones_text(b), bit::assumptions_text(b, options.bit_speed),
            bit::overlaps_text(b, bit::cutter_overlaps(b)), bit::enclosed_text(b));
  if (b.cutter_source == bit::CutterSource::table && !b.cutters.empty())
    print_out(
        "doubts about the table of cutters: {}\n",
        read.doubts.empty() ? "none" : fmt::format("{}, on standard error", read.doubts.size()));
  if (choices.cutters && !b.cutters.empty()) print_out("{}", bit::cutters_text(b));
  if (choices.parts) print_out("{}{}", bit::parts_text(b), bit::areas_report(b));
  if (choices.report)
    print_out("{}",
              bit::tracking_text(b, bit::cone_operation(b, options.cone_speeds, options.advance)));
  print_how_to_list(b, choices);
}

bit::ExportOptions export_options(const BitChoices& choices) {
  bit::ExportOptions o;
  o.parts = choices.format;
  o.solids = choices.solids;
  o.stl = choices.binary ? mesh::StlKind::binary : mesh::StlKind::text;
  try {
    o.unit = mesh::length_unit(choices.unit);
  } catch (const UnitError&) {
    throw InputError(
        fmt::format("--unit: found '{}', expected a length unit like 'mm' or 'in'", choices.unit));
  }
  if (choices.binary && choices.solids != "stl")
    throw InputError(
        fmt::format("--binary: found --solids {}, expected --solids stl", choices.solids));
  return o;
}

/// What the command writes about the mesh files.
std::string export_text(const BitChoices& choices, const bit::ExportOptions& o) {
  const std::string solids = bit::unit_of_format(o, o.solids).name;
  return fmt::format("wrote bit.{} in {}{}{}, parts/ in {}\n", o.solids, solids,
                     choices.binary ? " (binary)" : "",
                     choices.united ? fmt::format(", bit-united.{} in {}", o.solids, solids) : "",
                     bit::unit_of_format(o, o.parts).name);
}

int inspect_bit(const BitChoices& choices) {
  simulation::require_kind(choices.file, {}, {simulation::CaseKind::bit});
  const double advance =
      option_quantity("--penetration", choices.penetration, "m", Range::positive(), "a length");
  const double bit_speed =
      option_quantity("--speed", choices.speed, "rad/s", Range::positive(), "a rotary speed");
  const bit::BitFile read =
      bit::read_bit(choices.file, bit::DirectionRule::hybrid, bit::InsideRule::down,
                    choices.report ? bit::Densities::required : bit::Densities::as_given,
                    choices.overrides, "--set");
  const bit::Bit& b = read.bit;
  const bit::ReportOptions options{advance, bit_speed, choices.cone_speeds};
  bit::cone_operation(b, choices.cone_speeds, advance);  // rejects wrong speeds
  print_doubts(read.doubts);
  if (!choices.quiet) print_bit(read, choices, options);
  if (choices.folder.empty()) {
    const std::pair<bool, const char*> needs_folder[] = {
        {choices.report, "--report"}, {choices.binary, "--binary"}, {choices.united, "--united"}};
    for (const auto& [given, option] : needs_folder)
      if (given)
        throw InputError(fmt::format("{}: found no folder, expected one: -o FOLDER", option));
    return 0;
  }
  const bit::ExportOptions formats = export_options(choices);
  const mesh::TriangleMesh united =
      choices.united ? bit::united_parts(b, formats) : mesh::TriangleMesh();
  const OutputFolder out =
      prepare(choices.folder, overwrite_of(choices.force), read.files, ResultKind::bit);
  bit::export_bit(out.path, b, formats);  // first: bit.toml marks the folder
  bit::write_bit_files(out.path, b);
  bit::write_profile(out.path, b);
  bit::write_cutter_table(out.path, b);
  if (choices.report) bit::write_analysis(out.path, b, options);
  bit::export_solids(out.path, b, formats);
  if (choices.united) bit::export_united(out.path, b, united, formats);
  bit::write_bit_vtp(out.path / "bit.vtp", b, Pose{});
  if (!choices.quiet) print_out("{}", export_text(choices, formats));
  return 0;
}

}  // namespace

void add_bit(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("bit", "Build and inspect a bit: facts, balance, mass properties, meshes");
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
  add_set(*command, choices->overrides, "override a key of the bit file");
  command->add_flag("--cutters", choices->cutters, "print one row for each cutter");
  command->add_flag("--parts", choices->parts,
                    "print one row for each part, and what areas of the bit file define");
  command
      ->add_option("--unit", choices->unit,
                   "length unit of STL, OBJ and OFF files, which their headers state; PLY is in m")
      ->capture_default_str();
  command->add_flag("--binary", choices->binary, "write bit.stl as binary, without names");
  command->add_flag("--united", choices->united,
                    "also write bit-united.stl (format as --solids): one solid of all parts");
  command->add_flag("--report", choices->report, "also write analysis.json, data for bit design");
  command
      ->add_option("--penetration", choices->penetration,
                   "advance per revolution, for balance and report")
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
  command->add_flag("--quiet", choices->quiet, "print nothing");
  command->footer(
      "Other rakes on the shoulder: --set adjust.zone.shoulder.back_rake='5 deg' (added to those "
      "of\n"
      "the table); of some cutters: --set adjust.cutter.1-6.back_rake='5 deg'. With -o, "
      "cutters.csv has\nthe changed table. "
      "`tdbd keys cutter-table` lists the columns of a table, `tdbd new bit NAME` writes one.\n"
      "Example: tdbd bit cases/bits/bit-b.toml -o out/bit-b");
  command->callback(
      [choices, &exit_code] { exit_code = guarded([&] { return inspect_bit(*choices); }); });
}

}  // namespace tdbd::app
