#include "reference/compare/comparison_files.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/provenance.hpp"
#include "io/whole_file.hpp"

namespace tdbd::reference {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::array file_names{"comparison.csv", "parts.csv",   "comparison.nc",
                                "case.toml",      "timing.json", "comparison.json"};

/// A cell that may contain commas.
std::string quoted(const std::string& text) {
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

Json values_of(const Findings& f) {
  Json values = Json::object();
  for (std::size_t i = 0; i < quantity_count; ++i)
    if (f.says[i].value) values[fmt::format("{}", quantity_texts()[i].name)] = *f.says[i].value;
  return values;
}

Json reasons_of(const Findings& f) {
  Json reasons = Json::object();
  for (std::size_t i = 0; i < quantity_count; ++i)
    if (!f.says[i].value) reasons[fmt::format("{}", quantity_texts()[i].name)] = f.says[i].reason;
  return reasons;
}

Json units_of(std::span<const QuantityText> texts) {
  Json units = Json::object();
  for (const QuantityText& q : texts) units[fmt::format("{}", q.name)] = q.unit;
  return units;
}

/// The findings grouped by part, in the order in which the model lists the parts.
Json parts_of(const Findings& f) {
  Json parts = Json::object();
  for (const PartFinding& p : f.parts) {
    Json& part = parts[p.part];
    part["radius_m"] = p.radius;
    part[fmt::format("{}", text_of(p.quantity).name)] = p.value;
  }
  return parts;
}

}  // namespace

std::string comparison_csv(const Comparison& all) {
  std::string text = "model,quantity,unit,value,reason\n";
  for (const Answer& a : all.answers)
    for (std::size_t i = 0; i < quantity_count; ++i) {
      const QuantityResult& s = a.findings.says[i];
      const QuantityText& q = quantity_texts()[i];
      text +=
          fmt::format("{},{},{},{},{}\n", a.model->name, q.name, q.unit,
                      s.value ? fmt::format("{}", *s.value) : "", s.value ? "" : quoted(s.reason));
    }
  return text;
}

std::string parts_csv(const Comparison& all) {
  std::string text = "model,part,radius_m,quantity,unit,value\n";
  for (const Answer& a : all.answers)
    for (const PartFinding& p : a.findings.parts)
      text += fmt::format("{},{},{},{},{},{}\n", a.model->name, p.part, p.radius,
                          text_of(p.quantity).name, text_of(p.quantity).unit, p.value);
  return text;
}

std::string comparison_json(const CompareCase& c, const Comparison& all) {
  Json json{{"case", fs::path(c.ours.path).filename().string()},
            {"case_hash", c.ours.hash},
            {"version", provenance().version},
            {"commit", provenance().commit},
            {"advance_m_per_revolution", c.advance},
            {"rotary_speed_rad_per_s", c.ours.motion.rotary_speed},
            {"gage_radius_m", c.ours.bit.gage_radius},
            {"reference_weight_n", all.weight},
            {"reference_weight_from", all.weight_from},
            {"units", units_of(quantity_texts())},
            {"part_units", units_of(part_quantity_texts())},
            {"models", Json::array()},
            {"not_asked", all.excluded_models}};
  for (const Answer& a : all.answers)
    json["models"].push_back({{"name", a.model->name},
                              {"title", a.model->title},
                              {"reference", a.model->reference},
                              {"steps", a.findings.cost.steps},
                              {"notes", a.findings.notes},
                              {"says", values_of(a.findings)},
                              {"cannot_say", reasons_of(a.findings)},
                              {"parts", parts_of(a.findings)}});
  return json.dump(1) + "\n";
}

std::string timing_json(const Comparison& all) {
  Json models = Json::object();
  for (const Answer& a : all.answers) {
    const Cost& cost = a.findings.cost;
    models[fmt::format("{}", a.model->name)] = {
        {"cpu_s", cost.cpu}, {"simulated_s", cost.simulated}, {"steps", cost.steps}};
  }
  return Json{{"models", models}}.dump(1) + "\n";
}

void check_folder(const fs::path& folder, Overwrite overwrite) {
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw InputError(fmt::format("{}: found a file, expected a folder", folder.string()));
  if (overwrite == Overwrite::no && fs::exists(folder) && !fs::is_empty(folder))
    throw InputError(fmt::format(
        "{}: found a folder that is not empty, expected a new one, or --force", folder.string()));
}

void write_comparison(const fs::path& folder, const CompareCase& c, const Comparison& all) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(fmt::format("{}: {}", folder.string(), error.message()));
  for (const char* name : file_names) fs::remove(folder / name);
  write_text(folder / "case.toml", c.resolved);
  write_text(folder / "comparison.csv", comparison_csv(all));
  write_text(folder / "parts.csv", parts_csv(all));
  write_comparison_netcdf(folder / "comparison.nc", all);
  write_text(folder / "timing.json", timing_json(all));
  write_text(folder / "comparison.json", comparison_json(c, all));
}

}  // namespace tdbd::reference
