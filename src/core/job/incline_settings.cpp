// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/incline_settings.hpp"

#include <memory>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr char kNoMachine[] = "none";

void describeMap(SettingsSchema& schema, InclineSettings& settings) {
  schema.choice<InclineMap>("incline.map", settings.map,
                            {{"rotation", InclineMap::Rotation},
                             {"shear", InclineMap::Shear},
                             {"scale", InclineMap::Scale},
                             {"matrix", InclineMap::Matrix}},
                            "What is done to the part.");
  schema.number("incline.angle_deg", settings.angle_deg, {-360.0, 360.0},
                "Angle of the rotation, right-handed.");
  schema.text("incline.axis", settings.axis, "Axis of the rotation: x, y, z or ux,uy,uz.");
  schema.text("incline.shear", settings.shear,
              "Of the shear: axis moved, axis along, factor; y,z,1.0 for y += 1.0 z.");
  schema.numbers("incline.factors", settings.factors, 3, "Of the scale in x,y,z.");
  schema.numbers("incline.matrix", settings.matrix, 12, "Rows of three factors and a translation.");
  schema.number(
      "incline.belt_deg", settings.belt_deg, {0.0, 90.0},
      "Write for a belt printer whose gantry leans by so much, y up the gantry, z the belt; 0 for none.");
}

void describePlace(SettingsSchema& schema, InclineSettings& settings) {
  schema.numbers("incline.table_position_mm", settings.table_position_mm, 2,
                 "Where the middle of the part comes: x,y.");
  schema.numbers("incline.offset_mm", settings.offset_mm, 3, "Move the part by x,y,z after the lift.");
  schema.number("incline.layer_height_mm", settings.layer_height_mm, {0.0, 100.0},
                "Height of the lowest deposition; 0 takes what the program reports.");
  schema.choice<Lift>("incline.lift", settings.transform.lift,
                      {{"layer", Lift::ToFirstLayer}, {"none", Lift::None}},
                      "Put the lowest deposition one layer above the bed, or leave the height.");
  schema.choice<ToolAxisRule>(
      "incline.tool_axis", settings.transform.tool_axis_rule,
      {{"normal", ToolAxisRule::AlongNormal}, {"machine", ToolAxisRule::AsMachine}},
      "Refuse a machine that does not hold its nozzle along the layers' normal, or take it as it is.");
  schema.renamed("incline.jet", "incline.tool_axis");
  schema.numbers("incline.limits_mm", settings.limits_mm, 6,
                 "Of the nozzle: lowest x,y,z, highest x,y,z; empty takes those of the machine, or "
                 "0,0,0,1300,2500,1000.");
}

void describeCode(SettingsSchema& schema, InclineSettings& settings) {
  RewriteSettings& transform = settings.transform;
  schema.text("incline.begin_code", transform.begin_code, "G-code put after the comments at the head.");
  schema.text("incline.end_code", transform.end_code, "G-code put at the end.");
  schema.numbers("incline.final_position_mm", settings.final_position_mm, 3,
                 "Where the nozzle goes at the end: x,y,z.");
  schema.number("incline.final_feed_mm_min", transform.final_feed_mm_min, {1.0, 1e6}, "Feed of that move.");
  schema.integer("incline.decimals", settings.decimals, {-1.0, 6.0},
                 "Of coordinates; -1 takes 3, or 2 as the listing.");
  schema.number("incline.chord_tolerance_mm", transform.chord_tolerance_mm, {1e-4, 10.0},
                "How far chords may be off an arc.");
}

void describeReading(SettingsSchema& schema, InclineSettings& settings) {
  RewriteSettings& transform = settings.transform;
  schema.choice<RewriteMode>("incline.mode", transform.mode,
                             {{"corrected", RewriteMode::Corrected}, {"listing", RewriteMode::Listing}},
                             "Corrected, or as the published listing.");
  schema.choice<Homing>("incline.homing", transform.homing,
                        {{"annul", Homing::Annulled}, {"keep", Homing::Kept}}, "What becomes of G28.");
  schema.choice<BuildAids>("incline.build_aids", transform.build_aids,
                           {{"keep", BuildAids::Kept}, {"drop", BuildAids::Dropped}},
                           "What becomes of skirt, brim, raft, support and priming tower.");
  schema.choice<ExtrusionRule>("incline.extrusion_rule", transform.extrusion_rule,
                               {{"volume", ExtrusionRule::ByVolume},
                                {"length", ExtrusionRule::ByLength},
                                {"keep", ExtrusionRule::Kept}},
                               "What E follows where lengths change.");
  schema.choice<InclineExtrusion>("incline.extrusion", settings.extrusion,
                                  {{"as_stated", InclineExtrusion::AsStated},
                                   {"absolute", InclineExtrusion::Absolute},
                                   {"relative", InclineExtrusion::Relative}},
                                  "What E is until M82 or M83 reports.");
  schema.renamedChoice("incline.extrusion", "as_told", "as_stated");
}

/// Refuses what is set for another map, and expects what this one needs.
void requireOwn(const InclineSettings& settings) {
  const InclineSettings usual;
  const auto require = [&](InclineMap of, const std::string& key, bool is_given) {
    if (is_given == (settings.map == of)) return;
    throw InvalidConfig(is_given ? key + " is set, which is for another incline.map; expected it to be empty"
                                 : key + " is empty; expected it beside that incline.map");
  };
  require(InclineMap::Scale, "incline.factors", !settings.factors.empty());
  require(InclineMap::Shear, "incline.shear", !settings.shear.empty());
  require(InclineMap::Matrix, "incline.matrix", !settings.matrix.empty());
  if (settings.map != InclineMap::Rotation &&
      (settings.angle_deg != usual.angle_deg || settings.axis != usual.axis))
    throw InvalidConfig("incline.angle_deg and incline.axis are for incline.map rotation only");
}

Point3 pointOf(const std::vector<double>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

std::vector<double> numbersIn(const std::string& key, const std::string& text, std::size_t count) {
  std::vector<double> numbers;
  SettingsSchema schema;
  schema.numbers(key, numbers, count, "");
  schema.set(key, text);
  return numbers;
}

Point3 axisOf(const std::string& text) {
  if (text == "x") return Point3::UnitX();
  if (text == "y") return Point3::UnitY();
  if (text == "z") return Point3::UnitZ();
  if (text.find(',') == std::string::npos)
    throw InvalidConfig("incline.axis is '" + text + "'; must be x, y, z or three numbers");
  return pointOf(numbersIn("incline.axis", text, 3));
}

AffineMap shearOf(const std::string& text) {
  const bool has_axes = text.size() > 4 && text[1] == ',' && text[3] == ',';
  const auto isAxis = [](char c) { return c >= 'x' && c <= 'z'; };
  if (!has_axes || !isAxis(text[0]) || !isAxis(text[2]))
    throw InvalidConfig("incline.shear is '" + text + "'; must be such as y,z,1.0 for y += 1.0 z");
  return shear(text[0] - 'x', text[2] - 'x', numbersIn("incline.shear", text.substr(4), 1).at(0));
}

AffineMap matrixOf(const std::vector<double>& numbers) {
  Eigen::Affine3d matrix = Eigen::Affine3d::Identity();
  for (std::size_t i = 0; i < 12; ++i)
    matrix(static_cast<Eigen::Index>(i / 4), static_cast<Eigen::Index>(i % 4)) = numbers[i];
  return AffineMap(matrix);
}

AffineMap mapOf(const InclineSettings& settings) {
  requireOwn(settings);
  switch (settings.map) {
    case InclineMap::Scale:
      return scaling(pointOf(settings.factors));
    case InclineMap::Shear:
      return shearOf(settings.shear);
    case InclineMap::Matrix:
      return matrixOf(settings.matrix);
    case InclineMap::Rotation:
      break;
  }
  return rotation(axisOf(settings.axis), settings.angle_deg);
}

/// Of the machine or the belt, if coordinates of the bed are not what the machine takes.
std::shared_ptr<const SpaceMap> axesOf(const InclineSettings& settings,
                                       const std::optional<BuildSpace>& space) {
  const Eigen::Affine3d askew = space ? space->program_from_bed : Eigen::Affine3d::Identity();
  const bool is_askew = askew.matrix() != Eigen::Matrix4d::Identity();
  if (is_askew && settings.belt_deg != 0.0)
    throw InvalidConfig("incline.belt_deg is " + numberText(settings.belt_deg) + " and machine '" +
                        space->name + "' has axes of its own; expected one of them");
  if (is_askew) return std::make_shared<AffineMap>(askew);
  if (settings.belt_deg == 0.0) return nullptr;
  if (settings.belt_deg < 15.0)
    throw InvalidConfig("incline.belt_deg is " + numberText(settings.belt_deg) +
                        "; must be 0 or in [15, 90]");
  return std::make_shared<AffineMap>(beltAxes(settings.belt_deg));
}

/// In the listing nothing is checked against a machine unless one is named.
std::optional<Box3> limitsOf(const InclineSettings& settings, const std::optional<BuildSpace>& space) {
  const std::vector<double>& limits = settings.limits_mm;
  if (space && !limits.empty())
    throw InvalidConfig("incline.limits_mm is set, and machine '" + space->name +
                        "' has limits of its own; expected one of them");
  if (space) return machineRoom(*space);
  if (!limits.empty()) return Box3{pointOf(limits), pointOf({limits.begin() + 3, limits.end()})};
  if (settings.transform.mode == RewriteMode::Corrected) return largeGantryRoom();
  return std::nullopt;
}

}  // namespace

void describe(SettingsSchema& schema, InclineSettings& settings) {
  std::vector<std::string> names = machineNames();
  names.insert(names.begin(), kNoMachine);
  schema.choice("machine.name", settings.machine.name, names, "Machine whose limits and axes hold.");
  schema.text("machine.urdf", settings.machine.urdf,
              "File that describes the machine; empty takes the named one.");
  describeMap(schema, settings);
  describePlace(schema, settings);
  describeCode(schema, settings);
  describeReading(schema, settings);
}

InclineSettings loadInclineSettings(const std::string& yaml_path, const std::vector<SettingText>& overrides) {
  InclineSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  applySettings(schema, yaml_path, overrides);
  return settings;
}

std::optional<BuildSpace> buildSpaceOf(const InclineSettings& settings) {
  if (settings.machine.name == kNoMachine && settings.machine.urdf.empty()) return std::nullopt;
  return buildSpaceOf(settings.machine);
}

InclineJob inclineJob(const InclineSettings& settings, const std::string& program,
                      const std::string& output) {
  const std::optional<BuildSpace> space = buildSpaceOf(settings);
  InclineJob job;
  job.program = program;
  job.output = output;
  job.map = std::make_shared<AffineMap>(mapOf(settings));
  job.axes = axesOf(settings, space);
  job.settings = settings.transform;
  RewriteSettings& transform = job.settings;
  transform.limits_mm = limitsOf(settings, space);
  if (space) transform.tool_axis = toolAxis(*space);
  if (settings.decimals >= 0) transform.decimals = settings.decimals;
  if (settings.layer_height_mm > 0.0) transform.layer_height_mm = settings.layer_height_mm;
  if (!settings.offset_mm.empty()) transform.offset_mm = pointOf(settings.offset_mm);
  if (!settings.table_position_mm.empty())
    transform.table_position_mm = Point2(settings.table_position_mm[0], settings.table_position_mm[1]);
  if (!settings.final_position_mm.empty()) transform.final_position_mm = pointOf(settings.final_position_mm);
  if (settings.extrusion != InclineExtrusion::AsStated)
    transform.initial_extrusion =
        settings.extrusion == InclineExtrusion::Absolute ? ExtrusionMode::Absolute : ExtrusionMode::Relative;
  return job;
}

}  // namespace lamina
