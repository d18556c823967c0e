#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "core/config/csv.hpp"
#include "core/error.hpp"
#include "simulation/case/chain_keys.hpp"
#include "simulation/case/read_chain.hpp"

namespace tdbd::simulation {
namespace {

using std::numbers::pi;
using string::Section;

string::Material material_of(section_keys::MaterialName name) {
  switch (name) {
    case section_keys::MaterialName::aluminium:
      return {71e9, 26.7e9, 2800.0};
    case section_keys::MaterialName::titanium:
      return {114e9, 43e9, 4430.0};
    default:
      return {};
  }
}

/// A section by its products.
Section read_products(Config& c) {
  using namespace section_keys;
  Section s;
  s.axial_rigidity = c.read(axial_rigidity, 1.0);
  s.torsional_rigidity = c.read(torsional_rigidity, 1.0);
  s.mass = c.read(mass_per_length, 0.0);
  s.inertia = c.read(inertia_per_length, 0.0);
  s.weight = c.read(weight_per_length, 0.0);
  s.contact_radius = c.has(contact_diameter) ? 0.5 * c.read(contact_diameter) : 1.0;
  for (const QuantityKey& key : {axial_rigidity, torsional_rigidity})
    if (c.has(key) && c.read(key, 1.0) == 0.0) c.problem(key, "0", "a rigidity that holds, > 0");
  for (const QuantityKey& key : {outer_diameter, inner_diameter, linear_mass})
    if (c.has(key)) {
      c.read(key);
      c.problem(key, "rigidities as well", "a section by diameters or by its rigidities");
    }
  return s;
}

Section read_pipe(Config& c, const string::Surroundings& around) {
  using namespace section_keys;
  string::Diameters d;
  d.outer = c.read(outer_diameter);
  d.inner = c.read(inner_diameter);
  d.contact = c.read(contact_diameter, d.outer);
  string::Material m = material_of(c.read(material));
  m.young = c.read(young, m.young);
  m.shear = c.read(shear, m.shear);
  m.density = c.read(density, m.density);
  const double mass = c.has(linear_mass) ? c.read(linear_mass) : 0.0;
  if (c.has(outer_diameter) && d.inner >= d.outer)
    c.problem(inner_diameter, fmt::format("{:.6g} m", d.inner),
              fmt::format("less than the outer diameter, {:.6g} m", d.outer));
  if (d.contact < d.outer)
    c.problem(contact_diameter, fmt::format("{:.6g} m", d.contact),
              fmt::format("at least the outer diameter, {:.6g} m", d.outer));
  if (around.mud_density >= m.density)
    c.problem(density,
              fmt::format("{:.6g} kg/m3 in mud of {:.6g} kg/m3", m.density, around.mud_density),
              "a string that sinks");
  return string::pipe(1.0, d, m, mass, around);
}

std::vector<Section> read_sections(Config& whole, const string::Surroundings& around) {
  std::vector<Section> sections;
  for (Config c : whole.tables(section_keys::table)) {
    const double length = c.read(section_keys::length);
    const bool by_products =
        c.has(section_keys::axial_rigidity) || c.has(section_keys::torsional_rigidity);
    Section s = by_products ? read_products(c) : read_pipe(c, around);
    s.length = length;
    sections.push_back(s);
  }
  return sections;
}

string::Stations stations_of_file(const std::string& file) {
  const CsvTable t = read_csv(file);
  const std::size_t measured = csv_column(t, "md_m"), leaning = csv_column(t, "inc_deg"),
                    north = csv_column(t, "azi_deg");
  string::Stations s;
  for (const auto& row : t.rows) {
    s.depths.push_back(row[measured]);
    s.inclinations.push_back(row[leaning] * pi / 180.0);
    s.azimuths.push_back(row[north] * pi / 180.0);
  }
  return s;
}

string::Stations read_stations(Config& c) {
  using namespace survey_keys;
  if (!c.has(file)) return {c.read(measured_depth), c.read(inclination), c.read(azimuth)};
  for (const ListKey& key : {measured_depth, inclination, azimuth})
    if (c.has(key)) {
      c.read(key);
      c.problem(key, "a file as well", "a file or the lists");
    }
  try {
    return stations_of_file(c.read(file));
  } catch (const InputError& e) {
    c.other_file(e.what());
    return {{0.0}, {0.0}, {0.0}};
  }
}

void check_doglegs(Config& c, const string::Stations& stations,
                   std::vector<CaseWarning>& warnings) {
  constexpr double most = 30.0, doubtful = 15.0;  // deg in 30 m
  const string::Dogleg worst = string::worst_dogleg(stations);
  const double severity = worst.severity * 180.0 / pi * 30.0;
  const auto key = c.has(survey_keys::file) ? std::string_view(survey_keys::file)
                                            : std::string_view(survey_keys::inclination);
  const std::string found =
      fmt::format("a dogleg of {:.3g} deg in 30 m above station {}", severity, worst.station);
  if (severity > most)
    c.problem(key, found, fmt::format("at most {} deg in 30 m: check the stations", most));
  else if (severity > doubtful)
    warnings.push_back({c.place(key), fmt::format("{}.{}", survey_keys::table.name, key),
                        found + ": check the stations"});
}

string::Survey read_survey(Config& whole, double length, std::vector<CaseWarning>& warnings) {
  if (!whole.has(survey_keys::table)) return string::vertical();
  Config c = whole.table(survey_keys::table);
  const std::size_t mistakes = c.problem_count();
  const string::Stations stations = read_stations(c);
  if (c.problem_count() != mistakes) return string::vertical();
  const auto key = c.has(survey_keys::file) ? std::string_view(survey_keys::file)
                                            : std::string_view(survey_keys::measured_depth);
  if (const std::string why = string::survey_problem(stations); !why.empty()) {
    c.problem(key, why, "stations of a well");
    return string::vertical();
  }
  if (length > 1.01 * stations.depths.back())
    c.problem(key,
              fmt::format("stations down to {:.6g} m for a string of {:.6g} m",
                          stations.depths.back(), length),
              "a survey that reaches the bit, to 1 %");
  check_doglegs(c, stations, warnings);
  return string::make_survey(stations);
}

/// Coefficients at rest and in motion of one table.
string::FrictionBelow read_coefficients(Config& c, const string::FrictionBelow& usual) {
  using namespace string_friction_keys;
  string::FrictionBelow f;
  const std::size_t mistakes = c.problem_count();
  f.resting = c.read(resting, usual.resting);
  f.sliding = c.read(sliding, c.has(resting) ? f.resting : std::min(usual.sliding, f.resting));
  if (f.sliding > f.resting && c.problem_count() == mistakes)
    c.problem(sliding, fmt::format("{:.6g}", f.sliding),
              fmt::format("at most the coefficient at rest, {:.6g}", f.resting));
  return f;
}

/// Friction by depth, downward: a cased hole above, the open hole below.
std::vector<string::FrictionBelow> read_friction(Config& c) {
  using namespace string_friction_keys;
  const string::FrictionBelow open = read_coefficients(c, {});
  std::vector<string::FrictionBelow> by_depth;
  double from = 0.0;
  for (Config cased : c.tables(above)) {
    const double to = cased.read(string_friction_keys::depth);
    string::FrictionBelow f = read_coefficients(cased, open);
    f.depth = from;
    if (!(to > from))
      cased.problem(string_friction_keys::depth, fmt::format("{:.6g} m after {:.6g} m", to, from),
                    "ascending depths");
    by_depth.push_back(f);
    from = to;
  }
  by_depth.push_back({from, open.resting, open.sliding});
  return by_depth;
}

}  // namespace

StringPlan read_string_plan(Config& whole, double step, std::vector<CaseWarning>& warnings) {
  using namespace string_friction_keys;
  Config c = whole.table(chain_keys::table), friction = c.table(string_friction_keys::table);
  StringPlan p;
  const string::Surroundings around{friction.read(mud_density), c.read(chain_keys::gravity)};
  p.sections = read_sections(c, around);
  p.survey = read_survey(c, string::total_length(p.sections), warnings);
  p.friction = read_friction(friction);
  p.threshold = friction.read(threshold);
  p.axial_damping = friction.read(axial_damping);
  p.torsional_damping = friction.read(torsional_damping);
  p.axial_loss_time = friction.read(axial_loss_time);
  bool two_levels = false;
  for (const string::FrictionBelow& f : p.friction) two_levels |= f.resting > f.sliding;
  p.torsional_loss_time = friction.read(torsional_loss_time, two_levels ? 0.1 * step : 0.0);
  if (c.has(chain_keys::hole_diameter)) p.hole_diameter = c.read(chain_keys::hole_diameter);
  if (p.sections.empty())
    whole.problem("string.sections", "no section", "at least one [[string.sections]]");
  return p;
}

}  // namespace tdbd::simulation
