#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "forces/laws/hanson_hansen.hpp"
#include "forces/laws/laws.hpp"
#include "forces/rock/rock_material.hpp"

namespace tdbd::forces {

/// The force laws: plain structs of coefficients. A law is one header with a struct that has
/// `name`, `knows` (the kinds of part it applies to) and `coefficients`. A law that cuts, forces
/// (3), has `law_force`; a law that presses, forces (4), has `law_pressing` and `presses` (the
/// kinds of part that press). A law that requires the diameter of the cutter has `needs_diameter`.
/// To register a law, add it to this list; README.md describes the five steps.
using Law = std::variant<NoForce, HansonHansen, Detournay, DepthOfCut, Glowka, ThinCut, Friction,
                         Indentation>;

/// The force of the rock on a part, N. A pure function: the caller may evaluate it again at another
/// velocity. If the law does not apply to the kind of part, the force is zero; law_problem reports
/// that when the case is read. Finite for finite inputs, also at rest. The force never pulls the
/// bit into the rock (force . normal <= 0) and never does positive work on it (force . velocity <=
/// 0). Does not allocate. Thesis: app. C.
PartForce force(const Law& law, const PartCut& cut);

/// How a part presses on rock, forces (4). Nothing if the force of the law on this kind of part is
/// a function of the velocity, forces (3), or if the law does not apply to it.
std::optional<Pressing> pressing(const Law& law, const PartCut& cut);

/// A coefficient of a given law; `value` points to it.
struct LawField {
  std::string_view key;
  std::string_view unit;           ///< SI, in the notation of UDUNITS-2
  std::optional<double> fallback;  ///< default, SI; none: required
  Range range;                     ///< SI
  std::string_view meaning;
  bool (*where)(bit::PartKind) = nullptr;  ///< see Coefficient::where
  double* value = nullptr;                 ///< points into the law
};

/// The coefficients of a law, for reading a case or fitting. They point into `law`.
std::vector<LawField> law_fields(Law& law);

/// Whether a coefficient can change the force on parts of this kind. If not, the force is bitwise
/// independent of its value.
inline bool acts_on(const LawField& field, bit::PartKind kind) { return field.where(kind); }

/// The names of all laws: "none", "hanson-hansen", ...
std::vector<std::string_view> law_names();

/// The name of a law.
std::string_view law_name(const Law& law);

/// The law with this name and its default coefficients (0 where there is no default). Throws
/// InputError if there is no such law.
Law law_named(std::string_view name);

/// Whether the force of a law on parts of this kind depends on the strength of the rock. If not,
/// its coefficients are those of one rock.
bool uses_strength(const Law& law, bit::PartKind kind);

/// Whether a law applies to parts of this kind.
bool knows(const Law& law, bit::PartKind kind);

/// Why a law cannot be used for a part of this kind, with the kinds it applies to; empty if it can.
/// `diameter` is that of the part's cutter, m, or 0 if there is none.
std::string law_problem(const Law& law, bit::PartKind kind, double diameter);

/// Coefficients of a law from the literature, for one rock and one tool.
struct Fit {
  std::string_view name;  ///< for example "glowka-berea-0.5in"
  Law law;
  Evidence evidence = Evidence::assumed;
  std::string_view source;
};

/// All fits. They are for atmospheric pressure unless the source states otherwise.
std::span<const Fit> known_fits();

/// The fit with this name. Throws InputError with the list of names if there is none.
const Fit& fit_named(std::string_view name);

}  // namespace tdbd::forces
