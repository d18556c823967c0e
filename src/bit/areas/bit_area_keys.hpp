#pragma once

#include "bit/bit.hpp"
#include "core/config/key.hpp"

/// Properties that an area of a bit file gives its parts ([areas.NAME]), besides the keys that
/// select the parts (area_keys.hpp).
namespace tdbd::bit::bit_area_keys {

inline constexpr TableKey table{
    "areas.NAME",
    "properties of the parts that meet all criteria given here; of several areas the one with the "
    "most particular criterion decides each property"};
inline constexpr TableKey areas{"areas", table.meaning};

/// Materials by name, for their densities (density_of).
enum class Material { steel, tungsten_carbide, pdc_diamond };

inline constexpr ChoiceKey<Material> material{
    .name = "material",
    .values = {{{"steel", Material::steel},
                {"tungsten-carbide", Material::tungsten_carbide},
                {"pdc-diamond", Material::pdc_diamond}}},
    .usual = "the part's own",
    .meaning =
        "its density, in place of density: steel 7850, tungsten-carbide (cemented, with 6 % of "
        "cobalt) 14900, pdc-diamond 3500 kg/m3"};

/// Densities in kg/m3: of carbon steel, of cemented carbide with 6 % of cobalt by weight (ASM
/// Handbook, vols. 1 and 2), and of diamond (CRC Handbook: 3.51 g/cm3). They are the defaults of
/// cutters and teeth.
constexpr double density_of(Material m) {
  switch (m) {
    case Material::steel:
      return 7850.0;
    case Material::tungsten_carbide:
      return 14.9e3;
    case Material::pdc_diamond:
      break;
  }
  return 3500.0;
}

inline constexpr QuantityKey density{
    .name = "density",
    .unit = "kg/m3",
    .usual = "the part's own",
    .range = Range::within(0.0, 3e4),
    .meaning = "of the material; parts whose volume counts elsewhere keep density 0"};
inline constexpr ChoiceKey<Cutting> cutting{
    .name = "removal.cutting",
    .values = {{{"yes", Cutting::cuts}, {"rubs", Cutting::rubs}, {"no", Cutting::never}}},
    .usual = "the part's own",
    .meaning =
        "yes: removes rock; rubs: bears on rock by its force law and removes none; no: neither"};
inline constexpr QuantityKey share{
    .name = "removal.share",
    .fallback = 1.0,
    .range = {.lo = 0.0, .hi = 1.0, .ends = Range::Ends::open_lo},
    .meaning =
        "of the depth of rock that a part meets, what it removes in one pass; the rest stays "
        "in place"};
inline constexpr QuantityKey from_depth{
    .name = "removal.from_depth",
    .unit = "m",
    .usual = "from the beginning",
    .range = Range::positive(),
    .meaning = "the parts neither cut nor rub until the bit has gone down so far"};
inline constexpr QuantityKey from_time{
    .name = "removal.from_time",
    .unit = "s",
    .usual = "from the beginning",
    .range = Range::positive(),
    .meaning = "the parts neither cut nor rub before this time of the motion"};
inline constexpr QuantityKey from_wear{
    .name = "removal.from_wear",
    .unit = "m",
    .usual = "from the beginning",
    .range = Range::positive(),
    .meaning =
        "the parts neither cut nor rub until the flat of a cutter is so high (wear of the cutter "
        "table); the case needs [wear]"};
inline constexpr TextKey worn_names{
    .name = "removal.worn_names",
    .usual = "*",
    .meaning =
        "the cutters that removal.from_wear watches, by a pattern of the names of their parts"};

}  // namespace tdbd::bit::bit_area_keys
