#pragma once

#include <string_view>

#include "bit/files/file_checks.hpp"
#include "bit/pdc/pdc_design.hpp"
#include "core/config/field.hpp"

/// The settings of [design]: a layout of PDC cutters that is generated from rules.
namespace tdbd::bit {

/// [design].
struct DesignSettings {
  double first_radius = 0.0, spiral = 0.0, clearance = PdcDesign::usual_clearance;

  static constexpr TableKey table{
      "design", "a layout of PDC cutters generated from rules, in place of a cutter table"};
  void visit(FieldVisitor& v) {
    v(first_radius, {.name = "first_radius",
                     .unit = "m",
                     .need = Need::required,
                     .range = bit_length_or_none,
                     .meaning = "of the tip nearest to the axis"});
    v(spiral,
      {.name = "spiral", .unit = "rad", .meaning = "angle by which a blade trails at the gage"});
    v(clearance, {.name = "clearance",
                  .unit = "m",
                  .range = bit_length,
                  .meaning = "smallest gap between two cutters"});
  }
};

/// [design.profile].
struct ProfileSettings {
  ProfileDesign profile{.gage_length = 0.05};
  double shoulder_radius = 0.0;

  static constexpr TableKey table{"design.profile",
                                  "the profile of the tips: cone, nose, shoulder, gage"};
  void visit(FieldVisitor& v) {
    const bool by_radius = v.gives("shoulder_radius");
    const Need need_of_angle = by_radius ? Need::defaulted : Need::required;
    v(profile.cone_angle, {.name = "cone_angle",
                           .unit = "rad",
                           .need = Need::required,
                           .range = Range::non_negative(),
                           .meaning = "of the cone with the horizontal"});
    v(profile.nose_place, {.name = "nose_place",
                           .unit = "m",
                           .need = Need::required,
                           .range = bit_length,
                           .meaning = "radius at which the nose's arc has its lowest point"});
    v(profile.nose_radius, {.name = "nose_radius",
                            .unit = "m",
                            .need = Need::required,
                            .range = bit_length,
                            .meaning = "of the nose's arc"});
    v(profile.shoulder_angle, {.name = "shoulder_angle",
                               .unit = "rad",
                               .need = need_of_angle,
                               .computed_default = "required without shoulder_radius",
                               .range = Range::non_negative(),
                               .meaning = "at which the shoulder's arc begins"});
    v(shoulder_radius, {.name = "shoulder_radius",
                        .unit = "m",
                        .need = Need::optional,
                        .computed_default = "in place of shoulder_angle",
                        .range = bit_length,
                        .meaning = "of the shoulder's arc"});
    v(profile.gage_length,
      {.name = "gage_length", .unit = "m", .range = bit_length_or_none, .meaning = "of the gage"});
  }
};

/// [[design.blades]].
struct DesignBladeSettings {
  BladeDesign blade;

  static constexpr TableKey table{"design.blades", "a blade of the layout", Repeats::yes};
  void visit(FieldVisitor& v) {
    bool backups = false;
    v(blade.azimuth,
      {.name = "azimuth", .unit = "rad", .need = Need::required, .meaning = "on the bit's axis"});
    v(blade.start, {.name = "start",
                    .unit = "m",
                    .range = bit_length_or_none,
                    .meaning = "radius from which the blade carries cutters"});
    v(backups,
      {.name = "backups", .meaning = "whether backup cutters stand behind its face cutters"});
    if (backups) blade.backups = Backups::behind_face_cutters;
  }
};

/// A quantity by place along the profile. Each value defaults to that of the previous place.
struct PlaceValues {
  std::string_view first_name;
  std::string_view unit;
  Need need = Need::required;
  Range range = {};
  double first = 0.0, nose = 0.0, shoulder = 0.0, gage = 0.0;

  void visit(FieldVisitor& v) {
    constexpr std::string_view before = "that of the place before";
    v(first, {.name = first_name,
              .unit = unit,
              .need = need,
              .range = range,
              .meaning = "the first region"});
    const auto next = [&](double& x, std::string_view name, double value,
                          std::string_view meaning) {
      x = value;
      v(x, {.name = name,
            .unit = unit,
            .computed_default = before,
            .range = range,
            .meaning = meaning});
    };
    next(nose, "nose", first, "from the nose on");
    next(shoulder, "shoulder", nose, "from the shoulder on");
    next(gage, "gage", shoulder, "on the gage");
  }
};
struct DiameterByPlace : PlaceValues {
  static constexpr TableKey table{"design.diameter", "of cutters, by region, one value in each"};
  DiameterByPlace() : PlaceValues{"cone", "m", Need::required, Range::positive()} {}
};
struct OverlapByPlace : PlaceValues {
  static constexpr TableKey table{"design.overlap",
                                  "least overlap of neighbours on the profile, over a diameter"};
  OverlapByPlace() : PlaceValues{"axis", "1"} {}
};
struct BackRakeByPlace : PlaceValues {
  static constexpr TableKey table{"design.back_rake", "of cutters, linear between the places"};
  BackRakeByPlace() : PlaceValues{"axis", "rad"} {}
};
struct SideRakeByPlace : PlaceValues {
  static constexpr TableKey table{"design.side_rake", "of cutters, linear between the places"};
  SideRakeByPlace() : PlaceValues{"axis", "rad", Need::defaulted} {}
};
struct WearByPlace : PlaceValues {
  static constexpr TableKey table{"design.wear",
                                  "height of the wear flats, linear between the places"};
  WearByPlace() : PlaceValues{"axis", "m", Need::defaulted} {}
};

/// [design.backup]: cutters behind face cutters.
struct BackupSettings {
  BackupRow row;

  static constexpr TableKey table{"design.backup", "cutters behind face cutters"};
  void visit(FieldVisitor& v) {
    v(row.from, {.name = "from",
                 .unit = "m",
                 .range = bit_length_or_none,
                 .meaning = "smallest radius of the face cutters that get one"});
    v(row.to,
      {.name = "to", .unit = "m", .range = Range::positive(), .meaning = "largest radius of them"});
    v(row.under_exposure, {.name = "under_exposure",
                           .unit = "m",
                           .range = bit_length_or_none,
                           .meaning = "how far it stays inside the profile"});
    v(row.behind, {.name = "behind",
                   .unit = "m",
                   .range = bit_length,
                   .meaning = "from face to face along the circle"});
  }
};

/// [design.gage]: cutters on every blade's gage.
struct GageRowSettings {
  GageRow row;

  static constexpr TableKey table{"design.gage", "cutters on every blade's gage"};
  void visit(FieldVisitor& v) {
    v(row.cutters, {.name = "cutters", .hi = 100, .meaning = "on each blade"});
    v(row.start, {.name = "start",
                  .range = Range::non_negative(),
                  .meaning = "from the gage's lower end to the first, over a diameter"});
    v(row.spacing,
      {.name = "spacing", .range = Range::positive(), .meaning = "between them, over a diameter"});
  }
};

}  // namespace tdbd::bit
