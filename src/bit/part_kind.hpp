#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace tdbd::bit {

/// The kind of a part. It selects data (name, colour, force law), not a class. Thesis: 3.1.
enum class PartKind { face, chamfer, cse, cutter_body, gage_pad, bit_body, cone, tooth };

/// Every kind, in the order of the enumeration.
inline constexpr std::array part_kinds{
    PartKind::face,     PartKind::chamfer,  PartKind::cse,  PartKind::cutter_body,
    PartKind::gage_pad, PartKind::bit_body, PartKind::cone, PartKind::tooth};

/// The name of a kind in words, for messages: "face", "cutter body", "gage pad", ... The other two
/// spellings are derived from it.
std::string_view kind_words(PartKind kind);

/// A kind's name in results and bit files: "face", "cutter-body", "gage-pad", ...
std::string kind_name(PartKind kind);

/// A kind's key in a case: "face", "cutter_body", "gage_pad", ...
std::string kind_key(PartKind kind);

/// The names of all kinds (kind_name), and the kind with a given name; PartKind::face for an
/// unknown name.
std::vector<std::string_view> part_kind_names();
PartKind part_kind_named(std::string_view name);

/// Whether a part of this kind belongs to a cutter.
constexpr bool belongs_to_a_cutter(PartKind kind) {
  return kind == PartKind::face || kind == PartKind::chamfer || kind == PartKind::cse ||
         kind == PartKind::cutter_body;
}

/// Whether a part of this kind is a surface of a cutter other than its face and chamfer.
constexpr bool is_side_of_a_cutter(PartKind kind) {
  return kind == PartKind::cse || kind == PartKind::cutter_body;
}

/// Whether a part removes rock. Thesis: 3.1. A part that rubs moves no rock, so rock may be inside
/// it; the force law of its kind acts on the surface of that rock
/// (rock/section/rubbing_contact.hpp). For the clearance of a bit body from the rock that the
/// cutters leave, see body/rubbing.hpp.
enum class Cutting { cuts, rubs, never };

/// "yes", "rubs" or "no".
std::string cutting_name(Cutting cutting);

}  // namespace tdbd::bit
