#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "reference/compare/comparison_files.hpp"

namespace tdbd::reference {
namespace {

/// A column of the table: a quantity in a suitable unit.
struct TableColumn {
  Quantity quantity;
  const char* head;
  double scale;
  const char* form;
};

constexpr std::array table_columns{
    TableColumn{Quantity::weight, "WOB kN", 1e-3, "{:.3f}"},
    TableColumn{Quantity::torque, "TOB N m", 1.0, "{:.2f}"},
    TableColumn{Quantity::work_of_a_turn_torque, "work/2pi", 1.0, "{:.2f}"},
    TableColumn{Quantity::rate_at_weight, "m/h at W", 3600.0, "{:.3f}"},
    TableColumn{Quantity::torque_at_weight, "N m at W", 1.0, "{:.2f}"},
    TableColumn{Quantity::rate_of_penetration, "ROP m/h", 3600.0, "{:.3f}"},
    TableColumn{Quantity::whirl_radius, "whirl mm", 1e3, "{:.4f}"},
    TableColumn{Quantity::imbalance, "imbal. %", 100.0, "{:.2f}"},
    TableColumn{Quantity::side_force, "side kN", 1e-3, "{:.3f}"},
    TableColumn{Quantity::removed_per_revolution, "cm3/rev", 1e6, "{:.3f}"},
    TableColumn{Quantity::cone_speed_ratio, "cone/bit", 1.0, "{:.4f}"},
    TableColumn{Quantity::teeth_in_contact, "teeth", 1.0, "{:.2f}"},
    TableColumn{Quantity::torque_noise, "noise %", 100.0, "{:.2f}"},
};

std::string cell(const QuantityResult& s, const TableColumn& column) {
  if (!s.value) return "-";
  return fmt::format(fmt::runtime(column.form), column.scale * *s.value);
}

/// CPU time per second of drilling; for a steady model, which has no time, per state.
std::string cost_cell(const Cost& cost) {
  if (cost.simulated > 0.0) return fmt::format("{:.3g} s/s", cost.cpu / cost.simulated);
  return fmt::format("{:.3g} s", cost.cpu);
}

/// The part of a level with the largest value of a quantity.
const PartFinding* largest_of(const Findings& f, PartLevel level, PartQuantity quantity) {
  const PartFinding* largest = nullptr;
  for (const PartFinding& p : f.parts)
    if (p.quantity == quantity && level_of(p) == level &&
        (largest == nullptr || p.value > largest->value))
      largest = &p;
  return largest;
}

/// A column of the table of teeth: the part with the largest load.
struct LoadColumn {
  const char* head;
  PartLevel level;
  PartQuantity quantity;
};

constexpr std::array load_columns{
    LoadColumn{"row, mean kN", PartLevel::row, PartQuantity::weight},
    LoadColumn{"tooth, mean kN", PartLevel::tooth, PartQuantity::weight},
    LoadColumn{"tooth, a step's kN", PartLevel::tooth, PartQuantity::largest_weight},
};

/// For each model with teeth, the rows and teeth with the largest loads.
std::string teeth_table(const Comparison& all) {
  std::string rows;
  for (const Answer& a : all.answers) {
    if (largest_of(a.findings, PartLevel::tooth, PartQuantity::weight) == nullptr) continue;
    rows += fmt::format("{:<20}", a.model->name);
    for (const LoadColumn& c : load_columns)
      if (const PartFinding* p = largest_of(a.findings, c.level, c.quantity))
        rows += fmt::format("{:>24}{:>8.3f}", p->part, 1e-3 * p->value);
    rows += '\n';
  }
  if (rows.empty()) return rows;
  std::string text = fmt::format("{:<20}", "carries most");
  for (const LoadColumn& c : load_columns) text += fmt::format("{:>32}", c.head);
  return text + '\n' + rows;
}

}  // namespace

std::string comparison_table(const Comparison& all) {
  std::string text = fmt::format("{:<20}", "model");
  for (const TableColumn& c : table_columns) text += fmt::format("{:>10}", c.head);
  text += fmt::format("{:>12}\n", "cost");
  for (const Answer& a : all.answers) {
    text += fmt::format("{:<20}", a.model->name);
    for (const TableColumn& c : table_columns)
      text += fmt::format("{:>10}", cell(saying(a.findings, c.quantity), c));
    text += fmt::format("{:>12}\n", cost_cell(a.findings.cost));
  }
  return text + teeth_table(all);
}

}  // namespace tdbd::reference
