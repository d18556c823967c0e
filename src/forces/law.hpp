#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "forces/laws/depth_of_cut.hpp"
#include "forces/laws/detournay.hpp"
#include "forces/laws/friction.hpp"
#include "forces/laws/glowka.hpp"
#include "forces/laws/hanson_hansen.hpp"
#include "forces/laws/indentation.hpp"
#include "forces/laws/no_force.hpp"
#include "forces/laws/thin_cut.hpp"

namespace tdbd::forces {

/// The force laws: plain structs of coefficients. A law is one header with such a struct, its
/// `name`, `knows` (which kinds of part) and `coefficients`; `law_force` if it cuts, forces (3), and
/// `law_pressing` with `presses` (which kinds of part) if it presses, forces (4); `needs_diameter` if
/// it needs the cutter's. Here it only needs its place in this list; README.md gives the five
/// steps.
using Law = std::variant<NoForce, HansonHansen, Detournay, DepthOfCut, Glowka, ThinCut, Friction,
                         Indentation>;

/// The force of the rock on a part, N. A pure function, so it may be evaluated again at another
/// velocity. A part of a kind that the law does not know gets no force (law_problem warns
/// beforehand). Finite for finite numbers, also at rest. It never pulls the bit into the rock
/// (force . normal <= 0) and never does positive work on it (force . velocity <= 0). Does not
/// allocate. Thesis: app. C.
PartForce force(const Law& law, const PartCut& cut);

/// How a part presses on rock, forces (4); nothing if the law's force on this kind of part is a
/// function of the velocity, forces (3), and for a kind of part that the law does not know.
std::optional<Pressing> pressing(const Law& law, const PartCut& cut);

/// A coefficient of a given law, to be read into `value`.
struct LawField {
  std::string_view key;
  std::string_view unit;           ///< SI, as UDUNITS-2 writes it
  std::optional<double> fallback;  ///< SI; none: required
  Range range;                     ///< SI
  std::string_view meaning;
  bool (*where)(bit::PartKind) = nullptr;  ///< Coefficient::where
  double* value = nullptr;                 ///< in the law
};

/// The coefficients of a law, to be read from a case or fitted; they point into `law`.
std::vector<LawField> law_fields(Law& law);

/// Whether a coefficient may change the force on parts of this kind. On all others the force is the
/// same to the bit whatever its value.
inline bool acts_on(const LawField& field, bit::PartKind kind) { return field.where(kind); }

/// The names of all laws: "none", "hanson-hansen", ...
std::vector<std::string_view> law_names();

/// The name of a law.
std::string_view law_name(const Law& law);

/// The law of this name with its default coefficients (0 where there are none). Throws InputError
/// when there is no such law.
Law law_named(std::string_view name);

/// Whether a law has a force for parts of this kind.
bool knows(const Law& law, bit::PartKind kind);

/// Why a law cannot be used for a part of this kind, with the kinds that it knows; empty if it can.
/// `diameter`: of the part's cutter, m, 0 if there is none.
std::string law_problem(const Law& law, bit::PartKind kind, double diameter);

}  // namespace tdbd::forces
