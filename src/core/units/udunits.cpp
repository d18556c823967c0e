#include <udunits2.h>

#include <array>
#include <cstdlib>
#include <mutex>
#include <utility>

#include "core/error.hpp"
#include "core/units/unit_database.hpp"

namespace tdbd::units {

namespace {

/// UDUNITS-2 is not thread-safe. Every public function of this file must lock this mutex.
using UnitsLock = std::lock_guard<std::recursive_mutex>;

std::recursive_mutex& units_mutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

/// Memory that UDUNITS-2 may need for its database and for a text, bytes. It crashes if an
/// allocation fails.
constexpr std::size_t memory_of_database = 8'000'000, memory_of_text = 1'000'000;

using LibraryUnit = std::unique_ptr<ut_unit, decltype(&ut_free)>;

LibraryUnit parse_unit(ut_system* system, const std::string& text) {
  require_allocatable(memory_of_text);
  return {ut_parse(system, text.c_str(), UT_ASCII), &ut_free};
}

/// Adds a name that UDUNITS-2 lacks. A name that already exists keeps its meaning.
void add_alias(ut_system* system, const char* name, const std::string& definition) {
  if (parse_unit(system, name)) return;
  const LibraryUnit unit = parse_unit(system, definition);
  ut_map_name_to_unit(name, UT_ASCII, unit.get());
}

/// Reads the database of the library. UDUNITS2_XML_PATH could change units unnoticed, so it is used
/// only if there is no such database.
ut_system* read_database() {
  constexpr const char* variable = "UDUNITS2_XML_PATH";
  const char* elsewhere = std::getenv(variable);
  if (elsewhere == nullptr) return ut_read_xml(nullptr);
  const std::string path = elsewhere;
  unsetenv(variable);
  ut_system* system = ut_read_xml(nullptr);
  setenv(variable, path.c_str(), 1);
  return system != nullptr ? system : ut_read_xml(nullptr);
}

ut_system* load_units() {
  require_allocatable(memory_of_database);
  ut_set_error_message_handler(&ut_ignore);
  ut_system* system = read_database();
  if (system == nullptr) throw RunError("units: the database of UDUNITS-2 cannot be read");
  add_alias(system, "deg", "arc_degree");
  add_alias(system, "rev", "revolution");
  add_alias(system, "rpm", "revolution/minute");
  add_alias(system, "lbf", "pound_force");
  add_alias(system, "klbf", "1000 pound_force");
  add_alias(system, "psi", "pound_force/inch^2");
  add_alias(system, "ppg", "pound/(231 inch^3)");
  return system;
}

/// Loaded once and kept until the program ends.
ut_system* unit_system() {
  static ut_system* const system = load_units();
  return system;
}

void add_power(const ut_unit* base, int power, void* powers) {
  const char* symbol = ut_get_symbol(base, UT_ASCII);
  const char* name = symbol != nullptr ? symbol : ut_get_name(base, UT_ASCII);
  (*static_cast<UnitPowers*>(powers))[name != nullptr ? name : "?"] += power;
}

/// Collects the powers of a unit, which is a base unit, a product of powers of base units, or one
/// of these scaled and shifted.
ut_visitor powers_visitor() {
  ut_visitor visitor{};
  visitor.visit_basic = [](const ut_unit* base, void* powers) {
    add_power(base, 1, powers);
    return UT_SUCCESS;
  };
  visitor.visit_product = [](const ut_unit*, int count, const ut_unit* const* bases,
                             const int* exponents, void* powers) {
    for (int i = 0; i < count; ++i) add_power(bases[i], exponents[i], powers);
    return UT_SUCCESS;
  };
  visitor.visit_galilean = [](const ut_unit*, double, const ut_unit* inner, double, void* powers) {
    const ut_visitor again = powers_visitor();
    return ut_accept_visitor(inner, &again, powers);
  };
  visitor.visit_timestamp = [](const ut_unit*, const ut_unit*, double, void* powers) {
    ++(*static_cast<UnitPowers*>(powers))["date"];
    return UT_SUCCESS;
  };
  visitor.visit_logarithmic = [](const ut_unit*, double, const ut_unit*, void* powers) {
    ++(*static_cast<UnitPowers*>(powers))["logarithm"];
    return UT_SUCCESS;
  };
  return visitor;
}

class UdunitsUnit final : public Unit {
 public:
  explicit UdunitsUnit(LibraryUnit unit) : unit_(std::move(unit)) {}

  ~UdunitsUnit() override {
    const UnitsLock lock(units_mutex());
    unit_.reset();
  }

  UnitPowers powers() const override {
    const UnitsLock lock(units_mutex());
    const ut_visitor visitor = powers_visitor();
    UnitPowers found;
    ut_accept_visitor(unit_.get(), &visitor, &found);
    return found;
  }

  double convert(double x, const Unit& to) const override {
    const UnitsLock lock(units_mutex());
    ut_unit* const wanted = static_cast<const UdunitsUnit&>(to).unit_.get();
    const std::unique_ptr<cv_converter, decltype(&cv_free)> converter{
        ut_get_converter(unit_.get(), wanted), &cv_free};
    return cv_convert_double(converter.get(), x);
  }

  std::string definition() const override {
    const UnitsLock lock(units_mutex());
    std::array<char, 128> buffer{};
    const int n = ut_format(unit_.get(), buffer.data(), buffer.size(), UT_ASCII | UT_DEFINITION);
    return n > 0 ? std::string(buffer.data()) : std::string();
  }

 private:
  LibraryUnit unit_;
};

}  // namespace

std::unique_ptr<Unit> find_in_udunits(const std::string& name) {
  const UnitsLock lock(units_mutex());
  LibraryUnit unit = parse_unit(unit_system(), name);
  if (!unit) return nullptr;
  return std::make_unique<UdunitsUnit>(std::move(unit));
}

}  // namespace tdbd::units
