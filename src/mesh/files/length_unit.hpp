#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace tdbd::mesh {

/// The length unit of a mesh file.
struct LengthUnit {
  std::string name = "m";  ///< without blanks, as in the header of a file: "mm", "in", "0.0001m"
  double metres = 1.0;     ///< length of one unit, m
  std::optional<int> power = 0;  ///< for a decimal unit: metres = 10^power
};

/// Reads a unit with or without a number: "mm", "1 mm" or "0.1 mm". Throws UnitError if the text is
/// not a positive length.
LengthUnit length_unit(std::string_view text);

/// The unit of this length, m: one with a common name (m, dm, cm, mm, um, in, ft), otherwise a
/// multiple of a metre. The length must be positive.
LengthUnit length_unit_of(double metres);

// The headers of mesh files state the unit. Binary STL begins with "tdbd unit mm", OBJ and OFF have
// the comment "# tdbd unit mm", and PLY has "comment tdbd unit mm". Text STL has no comments: each
// line "solid NAME" ends with " unit=mm".

/// "tdbd unit mm".
std::string unit_comment(const LengthUnit& unit);

/// The unit stated by a comment without its # or `comment`. Nothing for other comments.
std::optional<LengthUnit> unit_of_comment(std::string_view comment);

/// "NAME unit=mm"; just "unit=mm" if there is no name.
std::string name_with_unit(const std::string& name, const LengthUnit& unit);

/// Removes the unit from the name of a solid and returns it. Nothing if the name states no unit.
std::optional<LengthUnit> take_unit_of_name(std::string& name);

/// The unit that the header of a file states, from its first bytes. `extension`: in lower case,
/// with its dot.
std::optional<LengthUnit> stated_unit(std::string_view bytes, std::string_view extension);

/// The same for a file. Nothing if it cannot be read, is no regular file, or states no unit.
std::optional<LengthUnit> stated_unit_of(const std::filesystem::path& file);

/// The length of the unit that a file states, or `otherwise`, m.
double unit_or(const std::filesystem::path& file, double otherwise);

/// Describes the contradiction between a unit given for a file and the one that its header states:
/// "1 m, but the header of part.stl states the unit mm". Empty if they agree within rounding, or if
/// the file states none.
std::string unit_contradiction(const std::filesystem::path& file, double given);
std::string unit_contradiction(const std::filesystem::path& file,
                               const std::optional<LengthUnit>& stated, double given);

/// Reads a decimal number and multiplies it by 10^power. The result is rounded only once, so
/// decimal_number(decimal_text(x, p), p) is x. Nothing unless the whole word is a finite number.
std::optional<double> decimal_number(std::string_view word, int power);

/// The shortest decimal number that decimal_number reads as x: x / 10^power with up to 17 digits.
std::string decimal_text(double x, int power);

}  // namespace tdbd::mesh
