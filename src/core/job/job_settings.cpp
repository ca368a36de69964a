// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/job_settings.hpp"

#include "lamina/base/error.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/planning/plan_consistency.hpp"

namespace lamina {
namespace {

void describe(SettingsSchema& schema, InputSettings& input) {
  schema.choice<LengthUnit>("input.unit", input.units.unit, lengthUnits(),
                            "Unit of mesh files that state none.");
  schema.number("input.scale", input.units.scale, {0.0, 1e6, true}, "Factor on the size of the part.");
  schema.choice<RepairPolicy>("input.repair", input.repair,
                              {{"repair", RepairPolicy::Repair}, {"strict", RepairPolicy::Strict}},
                              "Whether a broken mesh is repaired or refused.");
}

/// Over inclined layers no line of a sensor lies level, and no loop round them keeps to the bed.
void requireConsistentPlane(const JobSettings& settings) {
  const double angle_deg = settings.slicing.plane.angle_deg;
  if (angle_deg == 0.0 && settings.slicing.mode == SlicingMode::Inclined)
    throw InvalidConfig(
        "slicing.mode is 'inclined' with slicing.plane.angle_deg 0; expected an angle above 0");
  if (angle_deg == 0.0) return;
  const std::string inclined = " with slicing.plane.angle_deg " + std::to_string(angle_deg);
  if (settings.scan.every_layers != 0)
    throw InvalidConfig("scan.every_layers is " + std::to_string(settings.scan.every_layers) + inclined +
                        "; expected 0: only level layers are scanned");
  const SkirtSettings usual;
  const int count = settings.planning.skirt.count;
  if (count != 0 && count != usual.count)
    throw InvalidConfig("skirt.count is " + std::to_string(count) + inclined +
                        "; expected 0 or the default " + std::to_string(usual.count) +
                        ": only level layers have a skirt");
}

/// Over layers that are not plane nothing is scanned, and drops have no voids in a plan.
void requireLevelLayersFor(const JobSettings& settings) {
  const SlicingMode mode = settings.slicing.mode;
  if (hasPlaneLayers(mode) || mode == SlicingMode::Auto) return;
  const std::string with = std::string(" with slicing.mode '") + toString(mode) + "'; expected ";
  if (settings.slicing.plane.angle_deg != 0.0)
    throw InvalidConfig("slicing.plane.angle_deg is " + std::to_string(settings.slicing.plane.angle_deg) +
                        with + "0: only plane layers are inclined");
  if (settings.scan.every_layers != 0)
    throw InvalidConfig("scan.every_layers is " + std::to_string(settings.scan.every_layers) + with +
                        "0: only level layers are scanned");
  if (settings.drop_voids.is_on)
    throw InvalidConfig("drop_voids.fill is true" + with +
                        "false: voids between drops are filled in level layers");
}

}  // namespace

void describe(SettingsSchema& schema, JobSettings& settings) {
  describe(schema, settings.input);
  schema.choice<Placement>("part.placement", settings.placement,
                           {{"centre", Placement::Centre}, {"as_is", Placement::AsIs}},
                           "Put the part in the middle of the bed, or where its file says.");
  describe(schema, settings.copies);
  describe(schema, settings.machine, "Machine that prints the part.");
  describe(schema, settings.slicing);
  describe(schema, settings.adapted);
  describe(schema, settings.curved);
  describe(schema, settings.conformal);
  describe(schema, settings.height_field);
  describe(schema, settings.flattening);
  describe(schema, settings.lifting);
  describe(schema, settings.orientation);
  describe(schema, settings.planning);
  describe(schema, settings.drop_voids);
  describe(schema, settings.overhang);
  describe(schema, settings.clearance);
  describe(schema, settings.frames);
  describe(schema, settings.scan);
  describe(schema, settings.motion);
  describe(schema, settings.program);
}

JobSettings loadJobSettings(const std::string& yaml_path, const std::vector<SettingText>& overrides) {
  JobSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  applySettings(schema, yaml_path, overrides);
  return settings;
}

void validate(const JobSettings& settings) {
  JobSettings checked = settings;
  SettingsSchema schema;
  describe(schema, checked);
  schema.validate();
  requireConsistent(settings.planning);
  validate(settings.orientation);
  requireConsistentPlane(settings);
  requireLevelLayersFor(settings);
  const std::string& strategy = settings.planning.infill.strategy;
  if (settings.drop_voids.is_on && infillStrategy(strategy).deposit != Deposit::Drops)
    throw InvalidConfig(
        "drop_voids.fill is true with infill.strategy '" + strategy +
        "', which lays beads; expected false: voids between beads are filled by voids.refill");
}

}  // namespace lamina
