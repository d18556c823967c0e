#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "core/config/config.hpp"

namespace tdbd::bit {

/// Materials by name, for their densities (density_of).
enum class Material { steel, tungsten_carbide, pdc_diamond };

/// Densities in kg/m3: of carbon steel, of cemented carbide with 6 % of cobalt by weight (ASM
/// Handbook, vols. 1 and 2), and of diamond (CRC Handbook: 3.51 g/cm3). They are the defaults of
/// cutters and teeth.
double density_of(Material m);

/// Properties that [areas.NAME] of a bit file gives its parts, besides the criteria that select
/// them (AreaSelector).
struct AreaProperties {
  std::optional<Material> material;
  std::optional<double> density;
  std::optional<Cutting> cutting;
  std::optional<double> share, from_depth, from_time, from_wear;
  std::optional<std::string> worn_names;

  static constexpr std::array<ChoiceKey<Material>::Named, 8> materials{
      {{"steel", Material::steel},
       {"tungsten-carbide", Material::tungsten_carbide},
       {"pdc-diamond", Material::pdc_diamond}}};

  static constexpr TableKey table{
      "areas.NAME",
      "properties of the parts that meet all criteria given here; of several areas the one with "
      "the most specific criterion decides each property"};
  void visit(FieldVisitor& v) {
    v(material, {.name = "material",
                 .values = materials,
                 .computed_default = "the part's own",
                 .meaning = "its density, in place of density: steel 7850, tungsten-carbide "
                            "(cemented, with 6 % of cobalt) 14900, pdc-diamond 3500 kg/m3"});
    v(density, {.name = "density",
                .unit = "kg/m3",
                .computed_default = "the part's own",
                .range = Range::within(0.0, 3e4),
                .meaning = "of the material; parts whose volume counts elsewhere keep density 0"});
    v(cutting,
      {.name = "removal.cutting",
       .values = {{{"yes", Cutting::cuts}, {"rubs", Cutting::rubs}, {"no", Cutting::never}}},
       .computed_default = "the part's own",
       .meaning = "yes: removes rock; rubs: bears on rock by its force law and removes none; no: "
                  "neither"});
    v(share, {.name = "removal.share",
              .computed_default = "1",
              .range = {.lo = 0.0, .hi = 1.0, .ends = Range::Ends::open_lo},
              .meaning = "share of the depth of rock in its way that a part removes in one pass; "
                         "the rest stays in place"});
    v(from_depth,
      {.name = "removal.from_depth",
       .unit = "m",
       .computed_default = "from the beginning",
       .range = Range::positive(),
       .meaning = "the parts neither cut nor rub until the bit has moved down this far"});
    v(from_time, {.name = "removal.from_time",
                  .unit = "s",
                  .computed_default = "from the beginning",
                  .range = Range::positive(),
                  .meaning = "the parts neither cut nor rub before this time of the motion"});
    v(from_wear, {.name = "removal.from_wear",
                  .unit = "m",
                  .computed_default = "from the beginning",
                  .range = Range::positive(),
                  .meaning = "the parts neither cut nor rub until the flat of a cutter has this "
                             "height (wear of the cutter table); the case needs [wear]"});
    v(worn_names, {.name = "removal.worn_names",
                   .computed_default = "*",
                   .meaning = "the cutters to which removal.from_wear applies, by a pattern of the "
                              "names of their parts"});
  }
};

/// Applies density, cutting, share and start from [areas.NAME] of a bit's file to its parts
/// (AreaSelector, AreaProperties). The most specific area that defines a property decides. Parts
/// with density 0, whose volume is counted in another part, keep it, unless they are in
/// `without_density`; parts to which an area gives a density are removed from that list. If fewer
/// parts cut from the start, the gage radius becomes the largest radius that such a part reaches.
///
/// Records as mistakes: those of read_areas; two areas of equal rank that disagree; two starts in
/// one area; a density only for parts of density 0; a face or chamfer that rubs, because their
/// forces come from the rock that a face cuts; a share of parts that remove no rock, or of bodies
/// and shells of cones, which rock never leaves; a start of parts that never cut or rub; a start by
/// the wear of no cutter; and a bit of which no part ever cuts.
void apply_areas(Config& file, Bit& bit, std::vector<std::string>& without_density);

/// Returns the areas that define the properties of single parts which the other tables of an
/// exported bit do not contain: shares and starts, and for a bit with cones also densities and
/// cutting that differ from those of the cones' layouts. TOML; empty if there are none.
std::string areas_text(const Bit& bit);

}  // namespace tdbd::bit
