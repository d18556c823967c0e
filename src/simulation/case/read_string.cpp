#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core/config/csv.hpp"
#include "core/error.hpp"
#include "core/types.hpp"
#include "simulation/case/read_chain.hpp"

namespace tdbd::simulation {
namespace {

void doubt_buckling(const Config& c, const DoubtfulChain& d, std::vector<CaseWarning>& warnings) {
  if (d.hole_diameter == 0.0) return;
  const char* key = d.string.hole_diameter > 0.0 ? "string.hole_diameter" : "string.model";
  for (const StaticLoad& l : d.loads) {
    for (int e = 0; e < d.chain.count(); ++e) {
      const double top = e * d.chain.elements.length, bottom = top + d.chain.elements.length;
      const string::Section& here =
          *string::spans_between(d.string.sections, top, bottom)[0].section;
      const double side =
          string::tangent_at(d.string.survey, bottom).head<2>().norm() * here.weight;
      const double clearance = std::max(0.5 * d.hole_diameter - here.contact_radius, 1e-3);
      const double limit = 2.0 * std::sqrt(here.bending_rigidity * side / clearance);
      if (side == 0.0 || l.load.tension[at(e)] > -limit) continue;
      warnings.push_back(
          {c.place(key), key,
           fmt::format("{}: compressed with {:.3g} kN at {:.0f} m, beyond sinusoidal buckling at "
                       "{:.3g} kN, which is not modelled",
                       l.name, -1e-3 * l.load.tension[at(e)], top, 1e-3 * limit)});
      break;
    }
  }
}

/// m/s; torsional waves are slower than axial waves.
double slowest_wave(const std::vector<string::Section>& sections) {
  double slowest = std::numeric_limits<double>::infinity();
  for (const string::Section& s : sections)
    if (s.inertia > 0.0) slowest = std::min(slowest, string::torsional_wave_speed(s));
  return slowest;
}

void doubt_elements(const Config& c, const DoubtfulChain& d, std::vector<CaseWarning>& warnings) {
  constexpr double elements_per_wavelength = 10.0;
  constexpr const char* key = "string.element_length";
  const double wave = slowest_wave(d.string.sections) / elements_per_wavelength;
  const double length = d.chain.elements.length, resolved = wave / length;
  if (d.chain.count() < 2 || d.passing_frequency <= resolved) return;
  warnings.push_back(
      {c.place(key), key,
       fmt::format(
           "elements of {:.3g} m resolve waves up to {:.3g} Hz, {} elements to a wavelength; "
           "the blades of the bit pass at {:.3g} Hz: use at most {:.3g} m",
           length, resolved, elements_per_wavelength, d.passing_frequency,
           wave / d.passing_frequency)});
}

}  // namespace

std::vector<StaticLoad> static_loads(const string::Chain& chain, double hanging,
                                     const string::SteadyMotion& start) {
  string::Chain c = chain;
  c.axial_damping = c.torsional_damping = 0.0;
  c.threshold = 0.0;
  std::vector<StaticLoad> loads;
  const auto add = [&](const char* name, const string::SteadyMotion& m) {
    loads.push_back({name, string::steady_load(c, m)});
  };
  if (c.directions != string::Directions::torsion) {
    add("pull_up", {-1.0, 0.0, hanging, 0.0});
    add("slack_off", {1.0, 0.0, hanging, 0.0});
  }
  if (c.directions != string::Directions::axial) add("rotate", {0.0, 1.0, hanging, 0.0});
  if (start.pull != hanging || start.torque != 0.0)
    add("drill", {0.0, 1.0, start.pull, start.torque});
  return loads;
}

ChainModes chain_modes(const string::Chain& chain, double mass, double inertia) {
  constexpr int count = 3;
  std::vector<double> masses = chain.elements.mass, inertias = chain.elements.inertia;
  masses.back() = mass;
  inertias.back() = inertia;
  ChainModes m;
  if (chain.directions != string::Directions::torsion)
    m.axial = string::lowest_modes(chain.elements.axial, masses, count);
  if (chain.directions != string::Directions::axial)
    m.torsional = string::lowest_modes(chain.elements.torsional, inertias, count);
  return m;
}

CourantNumbers courant_numbers(const std::vector<string::Section>& sections, double element_length,
                               double step) {
  CourantNumbers fastest;  // m/s
  for (const string::Section& s : sections) {
    if (s.mass > 0.0) fastest.axial = std::max(fastest.axial, string::axial_wave_speed(s));
    if (s.inertia > 0.0)
      fastest.torsional = std::max(fastest.torsional, string::torsional_wave_speed(s));
  }
  const double per_step = step / element_length;
  return {fastest.axial * per_step, fastest.torsional * per_step};
}

std::vector<CaseWarning> chain_warnings(const Config& c, const DoubtfulChain& doubtful) {
  std::vector<CaseWarning> warnings;
  doubt_buckling(c, doubtful, warnings);
  doubt_elements(c, doubtful, warnings);
  return warnings;
}

namespace {

using std::numbers::pi;
using string::Section;

/// Makes a section that is given by its rigidities and masses.
Section products_of(Config& c, const SectionSettings& given) {
  Section s = given.products;
  s.contact_radius = given.diameters.contact > 0.0 ? 0.5 * given.diameters.contact : 1.0;
  const auto require_positive = [&](const char* key, double rigidity) {
    if (c.has(key) && rigidity == 0.0) c.problem(key, "0", "a rigidity > 0");
  };
  require_positive("axial_rigidity", s.axial_rigidity);
  require_positive("torsional_rigidity", s.torsional_rigidity);
  return s;
}

Section pipe_of(Config& c, const SectionSettings& s, const string::Surroundings& around) {
  const string::Diameters& d = s.diameters;
  if (c.has("outer_diameter") && d.inner >= d.outer)
    c.problem("inner_diameter", fmt::format("{:.6g} m", d.inner),
              fmt::format("less than the outer diameter, {:.6g} m", d.outer));
  if (d.contact < d.outer)
    c.problem("contact_diameter", fmt::format("{:.6g} m", d.contact),
              fmt::format("at least the outer diameter, {:.6g} m", d.outer));
  const double density = s.moduli.density;
  if (around.mud_density >= density)
    c.problem("density",
              fmt::format("{:.6g} kg/m3 in mud of {:.6g} kg/m3", density, around.mud_density),
              "a string that sinks");
  return string::pipe(1.0, d, s.moduli, s.linear_mass, around);
}

std::vector<Section> read_sections(Config& whole, const string::Surroundings& around) {
  std::vector<Section> sections;
  for (Config c : whole.tables(SectionSettings::table)) {
    const bool by_products = c.has("axial_rigidity") || c.has("torsional_rigidity");
    SectionSettings given;
    read_fields(c, given, by_products ? SectionBy::products : SectionBy::diameters);
    Section s = by_products ? products_of(c, given) : pipe_of(c, given, around);
    s.length = given.length;
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
  SurveySettings s;
  read_fields(c, s);
  if (!c.has("file")) return s.stations;
  try {
    return stations_of_file(s.file);
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
  const char* key = c.has("file") ? "file" : "inclination";
  const std::string found =
      fmt::format("a dogleg of {:.3g} deg in 30 m above station {}", severity, worst.station);
  if (severity > most)
    c.problem(key, found, fmt::format("at most {} deg in 30 m: check the stations", most));
  else if (severity > doubtful)
    warnings.push_back({c.place(key), fmt::format("{}.{}", SurveySettings::table.name, key),
                        found + ": check the stations"});
}

string::Survey read_survey(Config& whole, double length, std::vector<CaseWarning>& warnings) {
  if (!whole.has(SurveySettings::table)) return string::vertical();
  Config c = whole.table(SurveySettings::table);
  const std::size_t mistakes = c.problem_count();
  const string::Stations stations = read_stations(c);
  if (c.problem_count() != mistakes) return string::vertical();
  const char* key = c.has("file") ? "file" : "measured_depth";
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

/// Friction in motion cannot be larger than at rest. `mistakes`: number before the coefficients
/// were read.
void check_friction(Config& c, const FrictionCoefficients& f, std::size_t mistakes) {
  if (f.sliding > f.resting && c.problem_count() == mistakes)
    c.problem("dynamic", fmt::format("{:.6g}", f.sliding),
              fmt::format("at most the coefficient at rest, {:.6g}", f.resting));
}

/// Reads friction by depth, downward: a cased hole above, the open hole below.
std::vector<string::FrictionBelow> read_friction(Config& c) {
  std::size_t mistakes = c.problem_count();
  FrictionCoefficients open;
  read_fields(c, open);
  check_friction(c, open, mistakes);
  std::vector<string::FrictionBelow> by_depth;
  double from = 0.0;
  for (Config cased : c.tables(FrictionAbove::table)) {
    mistakes = c.problem_count();
    FrictionAbove f{.coefficients = open};
    read_fields(cased, f);
    check_friction(cased, f.coefficients, mistakes);
    if (!(f.depth > from))
      cased.problem("depth", fmt::format("{:.6g} m after {:.6g} m", f.depth, from),
                    "ascending depths");
    by_depth.push_back({from, f.coefficients.resting, f.coefficients.sliding});
    from = f.depth;
  }
  by_depth.push_back({from, open.resting, open.sliding});
  return by_depth;
}

}  // namespace

StringModel read_string_model(Config& string) {
  FieldReader reader(string);
  ChainSettings settings;
  settings.visit_model(reader);
  return settings.model;
}

string::Material material_of(MaterialName name) {
  switch (name) {
    case MaterialName::aluminium:
      return {71e9, 26.7e9, 2800.0};
    case MaterialName::titanium:
      return {114e9, 43e9, 4430.0};
    default:
      return {};
  }
}

StringPlan read_string_plan(Config& whole, double step, std::vector<CaseWarning>& warnings) {
  Config c = whole.table(ChainSettings::table);
  ChainSettings chain;
  read_fields(c, chain);
  Gravity gravity;
  read_fields(c, gravity);
  const auto damping = read_table<StringDamping>(c);
  StringPlan p;
  p.sections = read_sections(c, {damping.mud_density, gravity.gravity});
  p.survey = read_survey(c, string::total_length(p.sections), warnings);
  Config friction = c.table(StringDamping::table);
  p.friction = read_friction(friction);
  p.threshold = damping.threshold;
  p.axial_damping = damping.axial_damping;
  p.torsional_damping = damping.torsional_damping;
  p.axial_loss_time = damping.axial_loss_time;
  bool two_levels = false;
  for (const string::FrictionBelow& f : p.friction) two_levels |= f.resting > f.sliding;
  TorsionalLoss loss{two_levels ? 0.1 * step : 0.0};
  read_fields(friction, loss);
  p.torsional_loss_time = loss.time;
  p.hole_diameter = chain.hole_diameter;
  if (p.sections.empty())
    whole.problem("string.sections", "no section", "at least one [[string.sections]]");
  return p;
}

}  // namespace tdbd::simulation
