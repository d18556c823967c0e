#include "calibration/laboratory/laboratory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "calibration/fit/problem.hpp"
#include "calibration/predict/prediction.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "io/whole_file.hpp"
#include "simulation/case/force_settings.hpp"

namespace tdbd::calibration {
namespace {

/// [laboratory]: tests that a synthetic laboratory makes.
struct LaboratorySettings {
  std::string law;
  std::vector<std::string> bits;  ///< by default all
  std::vector<double> pressures, rates;
  double rotary_speed = 0.0;
  std::uint64_t seed = 1;

  static constexpr TableKey table{"laboratory", "tests that a synthetic laboratory makes"};
  void visit(FieldVisitor& v) {
    visit_law(v);
    v(bits,
      {.name = "bits", .computed_default = "all of [bits]", .meaning = "the bits that are tested"});
    v(pressures, {.name = "pressures",
                  .unit = "Pa",
                  .need = Need::required,
                  .meaning = "of the bottom hole; one test for each bit and one"});
    v(rates, {.name = "rates",
              .unit = "m/s",
              .need = Need::required,
              .meaning = "of penetration, one reading each in every test"});
    v(rotary_speed, {.name = "rotary_speed",
                     .unit = "rad/s",
                     .need = Need::required,
                     .range = Range::positive(),
                     .meaning = "of all tests"});
    v(seed, {.name = "seed", .meaning = "of the noise"});
  }
  void visit_law(FieldVisitor& v) {
    v.name(law, {.name = "law",
                 .names = &forces::law_names,
                 .need = Need::required,
                 .meaning = "the true force law; its coefficients are in [truth]"});
  }
};

/// `tdbd keys` lists what a table [truth] may have.
struct AnyTruth {
  static constexpr TableKey table{"truth", "KEY = value: the true coefficients"};
  void visit(FieldVisitor& v) {
    v.any({.name = "KEY",
           .kind = "that of the coefficient",
           .computed_default = "the coefficient's",
           .meaning = "a coefficient of the law, as in [forces]"});
  }
};
struct AnyAreaTruth {
  static constexpr TableKey table{"areas.NAME.truth",
                                  "KEY = value: the true coefficients of the area"};
  void visit(FieldVisitor& v) {
    v.any({.name = "KEY",
           .kind = "that of the coefficient",
           .computed_default = "that of the parts in no area",
           .meaning = "a coefficient of the law, as in [forces]"});
  }
};

static constexpr TableKey truth_areas_table{
    "areas.NAME",
    "parts of the bits that meet all criteria and have true coefficients of their own"};

forces::Law read_truth(Config& c, const std::string& name) {
  forces::Law law = forces::law_named(name);
  Config given = c.table(AnyTruth::table);
  for (const forces::LawField& f : forces::law_fields(law))
    *f.value = given.read(simulation::key_of(f), f.fallback);
  return law;
}

void check_list(Config& top, const char* key, const std::vector<double>& values, Range range) {
  if (values.empty()) top.problem(key, "none", "at least one");
  for (const double v : values)
    if (!range.contains(v))
      top.problem(key, fmt::format("{:.6g}", v), fmt::format("values{}", range.text()));
}

/// One test per bit and pressure, one reading per rate.
std::vector<Record> plan(const std::vector<std::string>& names,
                         const std::vector<double>& all_pressures,
                         const std::vector<double>& all_rates, double speed) {
  std::vector<Record> records;
  for (const std::string& name : names)
    for (const double p : all_pressures)
      for (const double rate : all_rates) {
        Record r;
        r.test = fmt::format("{}-{:.4g}MPa", name, p / forces::MPa);
        r.tool = name;
        r.pressure = p;
        r.speed = speed;
        r.rate = rate;
        r.depth = rate * 2.0 * std::numbers::pi / speed;
        records.push_back(r);
      }
  return records;
}

std::vector<std::string> names_of(const std::vector<Tool>& tools) {
  std::vector<std::string> names;
  names.reserve(tools.size());
  for (const Tool& t : tools) names.push_back(t.name);
  return names;
}

void require_known(Config& top, const std::vector<std::string>& chosen,
                   const std::vector<std::string>& known) {
  for (const std::string& name : chosen)
    if (std::ranges::find(known, name) == known.end())
      top.problem("bits", fmt::format("'{}'", name),
                  fmt::format("one of {}", fmt::join(known, ", ")));
}

}  // namespace

std::vector<KeyTable> laboratory_tables() {
  const std::string command = "laboratory";
  return {table_of<LaboratorySettings>(command, LaboratorySettings::table),
          table_of<AnyTruth>(command, AnyTruth::table),
          table_of<bit::CutterAreaSelector>(command, truth_areas_table),
          table_of<AnyAreaTruth>(command, AnyAreaTruth::table)};
}

LaboratoryCase read_laboratory(const std::string& path, const std::vector<std::string>& overrides) {
  Config c = Config::read_file(path, overrides);
  LaboratoryCase result;
  CalibrationCase& setup = result.setup;
  setup.path = path;
  Config top = c.table(LaboratorySettings::table);
  LaboratorySettings settings;
  FieldReader reader(top);
  settings.visit_law(reader);
  setup.law = read_truth(c, settings.law);
  setup.tools = read_tools(c);
  setup.areas = read_area_laws(c, setup.law, setup.tools, AreaValues::truth, setup.unknowns);
  setup.rock = read_test_rock(c);
  setup.grid = read_grid(c);
  setup.noise = read_table<Noise>(c);
  const auto known = settings.bits = names_of(setup.tools);
  settings.visit(reader);
  setup.fit = settings.bits;
  require_known(top, setup.fit, known);
  check_list(top, "pressures", settings.pressures, Range::non_negative());
  check_list(top, "rates", settings.rates, Range::positive());
  setup.records.rows = plan(setup.fit, settings.pressures, settings.rates, settings.rotary_speed);
  result.seed = settings.seed;
  c.finish();
  result.setup.files = c.files();
  for (const ConfigDoubt& d : c.doubts()) setup.doubts.push_back(d.place + ": " + d.text);
  return result;
}

std::vector<Record> drill(const LaboratoryCase& c, const CutStore& cuts) {
  Random random{c.seed};
  const CalibrationCase& setup = c.setup;
  std::vector<Record> records = setup.records.rows;
  const std::vector<forces::Law> laws = laws_of_mixes(setup.areas, setup.law);
  std::map<std::string, double> factors;
  for (Record& r : records) {
    if (!factors.contains(r.test)) factors[r.test] = setup.noise.test * normal(random);
    const Sample sample = sample_of(setup, cuts, r);
    const Loads loads = mean_loads(laws, sample), slopes = depth_slopes(laws, sample);
    const double rate_error = setup.noise.rop * normal(random);
    for (const std::size_t k : {axial, turning}) {
      const double noise =
          factors[r.test] + slopes[k] * rate_error + setup.noise.reading * normal(random);
      r.readings[k].value = loads[k] * std::exp(noise);
    }
  }
  return records;
}

std::string records_csv(const std::vector<Record>& records) {
  std::string text =
      "test,bit,pressure [Pa],rotary_speed [rad/s],rate_of_penetration [m/s],wob [N],tob [N m]\n";
  for (const Record& r : records)
    text += fmt::format("{},{},{},{},{},{},{}\n", r.test, r.tool, r.pressure, r.speed, r.rate,
                        *r.readings[axial].value, *r.readings[turning].value);
  return text;
}

namespace {

namespace fs = std::filesystem;

/// Throws if the file must not be written: it is an input, or it exists and may not be overwritten.
void require_writable_output(const fs::path& file, const LaboratoryOptions& o,
                             const std::vector<std::string>& inputs) {
  if (!fs::exists(file)) return;
  for (const std::string& input : inputs)
    if (fs::equivalent(file, input))
      throw InputError(file.string() + ": found an input itself, expected another file to write");
  if (o.overwrite == Overwrite::no)
    throw FolderError(fmt::format("{}: exists; --force overwrites", file.string()));
}

}  // namespace

void write_records(const LaboratoryCase& c, const LaboratoryOptions& o) {
  const ThreadLimit limit(o.threads);
  const fs::path file = fs::absolute(o.file).lexically_normal();
  require_writable_output(file, o, c.setup.files);
  const fs::path cuts = o.cuts.empty() ? file.parent_path() / "cuts" : o.cuts;
  const CutStore store = find_cuts(c.setup, cuts, o.progress);
  fs::create_directories(file.parent_path());
  write_text(file, records_csv(drill(c, store)));
}

}  // namespace tdbd::calibration
