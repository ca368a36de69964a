// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/job_settings.hpp"

#include <set>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/job/modes/slicing_mode.hpp"
#include "lamina/job/profiles/machine_defaults.hpp"
#include "lamina/picture/thumbnail.hpp"
#include "lamina/planning/plan_consistency.hpp"

namespace lamina {
namespace {

void describe(SettingsSchema& schema, InputSettings& input) {
  schema.choice<LengthUnit>("input.unit", input.units.unit, lengthUnits(),
                            "Unit of mesh files that state none.");
  schema.number("input.scale", input.units.scale, Bounds::above(0.0, 1e6), "Factor on the size of the part.");
  schema.choice<RepairPolicy>("input.repair", input.repair,
                              {{"repair", RepairPolicy::Repair}, {"strict", RepairPolicy::Strict}},
                              "Whether a broken mesh is repaired or refused.");
  schema.number("input.deflection_mm", input.tessellation.deflection_mm, Bounds::above(0.0, 100.0),
                "Farthest that the triangles of a solid (STEP) lie from its curved faces.");
  schema.number("input.deflection_deg", input.tessellation.deflection_deg, Bounds::above(0.0, 90.0),
                "Greatest angle between edges of these triangles along a curve.");
  schema.number("input.extrude_mm", input.extrude_mm, {0.0, 1e6},
                "Height of the part that an outline (SVG) becomes; 0 refuses outlines.");
}

/// Level layers alone have what lies on the bed round the part, below all of it or before it; a brim lies
/// beside the foot of each inclined layer too.
/// @param layers_are  which ones these are
void requireNothingRoundPart(const PlanSettings& settings, const std::string& layers_are,
                             const std::string& reason) {
  const SkirtSettings usual;
  const auto require = [&](bool is_met, const std::string& key_is, const std::string& expected) {
    if (!is_met) throw InvalidConfig(key_is + layers_are + "; expected " + expected + ": " + reason);
  };
  const AdhesionSettings& adhesion = settings.adhesion;
  const int count = settings.skirt.count;
  require(count == 0 || count == usual.count, "skirt.count is " + std::to_string(count),
          "0 or the default " + std::to_string(usual.count));
  require(settings.skirt.layers == usual.layers, "skirt.layers is " + std::to_string(settings.skirt.layers),
          "the default " + std::to_string(usual.layers));
  require(adhesion.raft.layers == 0, "raft.layers is " + std::to_string(adhesion.raft.layers), "0");
  require(adhesion.prime.line == PrimeLine::None, "prime.line is set", "'none'");
}

/// What lies on the bed where layers are not plane.
void requireNothingOnBed(const PlanSettings& settings, const std::string& layers_are) {
  const double brim_mm = settings.adhesion.brim.width_mm;
  if (brim_mm != 0.0)
    throw InvalidConfig("brim.width_mm is " + numberText(brim_mm) + layers_are +
                        "; expected 0: only plane layers have one");
  requireNothingRoundPart(settings, layers_are, "only level layers have one");
}

/// No loop round inclined layers keeps to the bed.
void requireConsistentPlane(const JobSettings& settings) {
  const double angle_deg = settings.slicing.plane.angle_deg;
  if (angle_deg == 0.0 && settings.slicing.mode == "inclined")
    throw InvalidConfig(
        "slicing.mode is 'inclined' with slicing.plane.angle_deg 0; expected an angle above 0");
  if (angle_deg == 0.0) return;
  if (!settings.modifiers.empty())
    throw InvalidConfig("part.modifiers is '" + settings.modifiers + "' with slicing.plane.angle_deg " +
                        numberText(angle_deg) +
                        "; expected none: only level layers have regions of "
                        "their own settings");
  const std::string inclined = " with slicing.plane.angle_deg " + numberText(angle_deg);
  if (settings.planning.first_layer.inset_mm != 0.0)
    throw InvalidConfig("first_layer.inset_mm is " + numberText(settings.planning.first_layer.inset_mm) +
                        inclined + "; expected 0: only a level first layer lies on the bed as a whole");
  if (settings.program.arcs_tolerance_mm > 0.0)
    throw InvalidConfig("program.arcs_tolerance_mm is " + numberText(settings.program.arcs_tolerance_mm) +
                        inclined + "; expected 0: arcs lie in level layers only");
  if (settings.planning.adhesion.brim.width_mm > 0.0 && settings.planning.adhesion.brim.ears)
    throw InvalidConfig(
        "brim.ears is true" + inclined +
        "; expected false: inclined layers cut the outline on the bed in steps, and each would "
        "have ears");
  requireNothingRoundPart(
      settings.planning, inclined,
      "each inclined layer stands on the bed itself, so that nothing lies round or below all "
      "of them; brim.width_mm holds the part down");
  const SupportSettings& supports = settings.planning.supports;
  if (supports.use && supports.kind == SupportKind::Tree)
    throw InvalidConfig("supports.kind is 'tree'" + inclined +
                        "; expected 'lattice': branches grow below level layers only");
}

bool takesFirstLayerHeight(const std::string& mode) {
  return slicingModes().find(mode).first_layer == FirstLayer::OwnHeight;
}

/// What changes sections, and ways within them, is known of plane ones only.
void requirePlainSections(const JobSettings& settings) {
  const auto require = [&](bool is_met, const std::string& key_is, const std::string& expected) {
    if (is_met) return;
    throw InvalidConfig(key_is + " with slicing.mode '" + settings.slicing.mode + "'; expected " + expected +
                        ": known for plane layers only");
  };
  const auto requireNone = [&](const std::string& key, double value) {
    require(value == 0.0, key + " is " + numberText(value), "0");
  };
  const CompensationSettings& compensation = settings.compensation;
  requireNone("compensation.outline_mm", compensation.outline_mm);
  requireNone("compensation.holes_mm", compensation.holes_mm);
  requireNone("first_layer.inset_mm", settings.planning.first_layer.inset_mm);
  requireNone("travel.wipe_mm", settings.planning.travel.wipe_mm);
  require(settings.planning.travel.comb == Combing::None, "travel.comb is not 'none'", "'none'");
  require(settings.planning.travel.hop == Hopping::Always, "travel.hop is not 'always'", "'always'");
}

/// The part is printed larger; what it is deposited on stays as it is.
void requireSizeOfBase(const JobSettings& settings) {
  if (slicingModes().find(settings.slicing.mode).deposited_on == DepositedOn::Bed) return;
  const auto requireNone = [&](const std::string& key, double value) {
    if (value != 0.0)
      throw InvalidConfig(key + " is " + numberText(value) + " with slicing.mode '" + settings.slicing.mode +
                          "'; expected 0: what the part is deposited on does not grow with it");
  };
  requireNone("compensation.shrink_xy", settings.compensation.shrink_xy);
  requireNone("compensation.shrink_z", settings.compensation.shrink_z);
}

/// What means nothing over layers that are not plane, or cannot be done over them.
void requirePlaneLayersFor(const JobSettings& settings) {
  const std::string& mode = settings.slicing.mode;
  if (mode == kAutoMode || hasPlaneLayers(mode)) return;
  requirePlainSections(settings);
  requireSizeOfBase(settings);
  const auto require = [&](bool is_met, const std::string& key_is, const std::string& expected) {
    if (!is_met) throw InvalidConfig(key_is + " with slicing.mode '" + mode + "'; expected " + expected);
  };
  const SlicingSettings usual;
  const SlicingSettings& slicing = settings.slicing;
  require(slicing.plane.angle_deg == 0.0, "slicing.plane.angle_deg is " + numberText(slicing.plane.angle_deg),
          "0: only plane layers are inclined");
  require(slicing.heights == LayerHeights::Equal, "slicing.heights is not 'equal'",
          "'equal': only plane layers have heights of their own");
  require(settings.program.arcs_tolerance_mm == 0.0,
          "program.arcs_tolerance_mm is " + numberText(settings.program.arcs_tolerance_mm) + " mm",
          "0: arcs lie in level layers only");
  require(settings.scan.every_layers == 0,
          "scan.every_layers is " + std::to_string(settings.scan.every_layers),
          "0: only plane layers are scanned");
  require(settings.planning.infill.every_layers == 1,
          "infill.every_layers is " + std::to_string(settings.planning.infill.every_layers),
          "1: only plane layers share an infill");
  require(!settings.drop_voids.is_on, "drop_voids.fill is true",
          "false: voids between drops are filled in level layers");
  require(settings.modifiers.empty(), "part.modifiers is '" + settings.modifiers + "'",
          "none: only level layers have regions of their own settings");
  require(settings.copies.count == 1, "part.copies is " + std::to_string(settings.copies.count),
          "1: the way from copy to copy is known to be clear over plane layers only");
  requireNothingOnBed(settings.planning, " with slicing.mode '" + mode + "'");
  require(!settings.planning.supports.use, "supports.use is true",
          "false: only layers in parallel planes have supports");
  require(infillStrategy(settings.planning.infill.strategy).link != LayerLink::Rising,
          "infill.strategy is '" + settings.planning.infill.strategy + "', which rises from layer to layer,",
          "another strategy");
  const double first = slicing.first_layer_height_mm;
  require(
      takesFirstLayerHeight(mode) || first == usual.first_layer_height_mm || first == slicing.layer_height_mm,
      "slicing.first_layer_height_mm is " + numberText(first) + " mm",
      "slicing.layer_height_mm: all shells are as high");
}

/// A key that asks for something, as refusals name it.
struct AskedKey {
  const char* key_is;
  bool is_asked;
};

/// Those that let runs start or end elsewhere.
std::vector<AskedKey> keysOfEnds(const BeadRunSettings& runs) {
  return {{"starts.rule is not 'keep'", runs.starts.rule != StartRule::Keep},
          {"lead.in is not 'none'", runs.lead.in != LeadShape::None},
          {"lead.out is not 'none'", runs.lead.out != LeadShape::None},
          {"lead.overlap_mm is not 0 mm", runs.lead.overlap_mm != 0.0},
          {"entry.distance_mm is not 0 mm", runs.entry.distance_mm > 0.0}};
}

/// Drops have no runs; wipes are planned along the ends that runs had; and either the toolpath weaves or the
/// controller.
void requireRunsFor(const JobSettings& settings) {
  const BeadRunSettings& runs = settings.runs;
  const std::string& strategy = settings.planning.infill.strategy;
  std::vector<AskedKey> asked = keysOfEnds(runs);
  if (settings.planning.travel.wipe_mm > 0.0)
    for (const auto& [key_is, is_asked] : asked)
      if (is_asked)
        throw InvalidConfig(std::string(key_is) + " with travel.wipe_mm " +
                            numberText(settings.planning.travel.wipe_mm) +
                            " mm; expected 0 mm: wipes stay along the ends that were planned");
  asked.push_back({"levels.values is set", !runs.levels.values.empty()});
  asked.push_back({"weave.kind is not 'none'", runs.weave.kind != WeaveKind::None});
  if (depositsDrops(strategy))
    for (const auto& [key_is, is_asked] : asked)
      if (is_asked)
        throw InvalidConfig(std::string(key_is) + " with infill.strategy '" + strategy +
                            "'; expected a strategy that lays beads: drops have no runs");
  if (runs.weave.kind == WeaveKind::None) return;
  if (settings.program.robot.arc.weave_schedule > 0)
    throw InvalidConfig("weave.kind is not 'none' with robot_program.weave_schedule " +
                        std::to_string(settings.program.robot.arc.weave_schedule) +
                        "; expected one of them: the controller would weave across a woven way");
  if (!settings.program.rapid.weave_data.empty())
    throw InvalidConfig("weave.kind is not 'none' with rapid.weave_data '" +
                        settings.program.rapid.weave_data +
                        "'; expected one of them: the controller would weave across a woven way");
}

}  // namespace

PlanSettings planOfPrinters() {
  PlanSettings settings;
  settings.skins.top_layers = settings.skins.bottom_layers = 4;
  settings.bridges.is_used = true;
  settings.overhangs.is_used = true;
  return settings;
}

CoolingSettings coolingOfPrinters() {
  CoolingSettings settings;
  settings.least_layer_time_s = 5.0;
  return settings;
}

FanSettings fanOfPrinters() {
  FanSettings settings;
  settings.is_used = true;
  return settings;
}

void describe(SettingsSchema& schema, JobSettings& settings) {
  describe(schema, settings.input);
  schema.choice<Placement>("part.placement", settings.placement,
                           {{"centre", Placement::Centre}, {"as_is", Placement::AsIs}},
                           "Put the part in the middle of the bed, or where its file says.");
  describe(schema, settings.copies);
  schema.text("part.modifiers", settings.modifiers,
              "YAML file of regions of the part that have settings of their own; empty for none.");
  describe(schema, settings.plate);
  describe(schema, settings.machine, "Machine that prints the part.");
  describe(schema, settings.capabilities);
  describe(schema, settings.material);
  schema.choice("slicing.mode", settings.slicing.mode, slicingModeNames(),
                "Kind of layers; docs/slicing/modes.md distinguishes them.");
  describe(schema, settings.slicing);
  // Keys that others know them by.
  schema.renamed("first_layer.height_mm", "slicing.first_layer_height_mm");
  schema.renamed("supports.on", "supports.foot");
  describe(schema, settings.automatic);
  describe(schema, settings.adapted);
  describe(schema, settings.curved);
  describe(schema, settings.conformal);
  describe(schema, settings.height_field);
  describe(schema, settings.volumetric);
  describe(schema, settings.directions);
  describe(schema, settings.flattening);
  describe(schema, settings.lifting);
  describe(schema, settings.orientation);
  describe(schema, settings.compensation);
  describe(schema, settings.planning);
  describe(schema, settings.runs);
  describe(schema, settings.flow);
  describe(schema, settings.cooling);
  describe(schema, settings.fan);
  describe(schema, settings.hooks);
  describe(schema, settings.pauses);
  schema.choice("pause.code", settings.program.pause_code,
                {"dialect", "M0", "M226", "M291", "M600", "M601", "PAUSE"},
                "Command that waits for the operator; dialect for that of program.dialect.");
  describe(schema, settings.drop_voids);
  describe(schema, settings.overhang);
  describe(schema, settings.clearance);
  describe(schema, settings.deposition);
  describe(schema, settings.sweep);
  describe(schema, settings.stiffness);
  describe(schema, settings.metrics);
  describe(schema, settings.frames);
  describe(schema, settings.scan);
  describe(schema, settings.motion);
  describe(schema, settings.joints);
  describe(schema, settings.trajectory);
  describe(schema, settings.process);
  describe(schema, settings.program);
  describe(schema, settings.program.five_axis);
  describe(schema, settings.program.rapid);
  describe(schema, settings.program.robot);
}

JobSettings loadJobSettings(const std::string& yaml_path, const std::vector<SettingText>& overrides) {
  JobSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  applySettings(schema, yaml_path, overrides);
  std::set<std::string> typed;
  if (!yaml_path.empty())
    for (const SettingText& setting : settingsFromYaml(readFile(yaml_path, kMostSettingsBytes), yaml_path))
      typed.insert(setting.key);
  for (const SettingText& setting : overrides) typed.insert(setting.key);
  settings.program.is_diameter_given = givesFilamentDiameter(overrides);
  return withMachineDefaults(settings, typed);
}

void validate(const JobSettings& settings) {
  JobSettings checked = settings;
  SettingsSchema schema;
  describe(schema, checked);
  schema.validate();
  requireConsistent(settings.planning);
  requireConsistent(settings.slicing);
  requireConsistent(settings.volumetric);
  requireConsistent(settings.cooling);
  requireConsistent(settings.fan);
  requireConsistent(settings.runs);
  requireConsistent(settings.flow);
  requireConsistent(settings.hooks);
  requireConsistent(settings.pauses);
  requireConsistent(settings.orientation);
  validate(settings.joints);
  requireConsistentPlane(settings);
  requirePlaneLayersFor(settings);
  requireCapable(settings);
  requireRunsFor(settings);
  thumbnailsFrom(settings.program.thumbnails);
  const std::string& strategy = settings.planning.infill.strategy;
  if (settings.slicing.heights != LayerHeights::Equal && depositsDrops(strategy))
    throw InvalidConfig("slicing.heights is not 'equal' with infill.strategy '" + strategy +
                        "'; expected 'equal': all drops are as high");
  if (settings.drop_voids.is_on && !depositsDrops(strategy))
    throw InvalidConfig(
        "drop_voids.fill is true with infill.strategy '" + strategy +
        "', which lays beads; expected false: voids between beads are filled by voids.refill");
}

}  // namespace lamina
