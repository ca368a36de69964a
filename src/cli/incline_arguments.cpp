// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "incline_arguments.hpp"

#include <map>
#include <memory>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"

namespace lamina::cli {
namespace {

template <class Enum>
void addChoice(CLI::App& subcommand, const std::string& name, Enum& field,
               const std::map<std::string, Enum>& choices, const std::string& meaning) {
  std::vector<std::string> names;
  names.reserve(choices.size());
  for (const auto& choice : choices) names.push_back(choice.first);
  const auto choose = [&field, choices](const std::string& chosen) { field = choices.at(chosen); };
  subcommand.add_option_function<std::string>(name, choose, meaning)->check(CLI::IsMember(names));
}

CLI::Option* addNumbers(CLI::App& subcommand, const std::string& name, std::vector<double>& field,
                        const std::string& meaning, int count) {
  return subcommand.add_option(name, field, meaning)->delimiter(',')->expected(count);
}

Point3 pointOf(const std::vector<double>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

/// Numbers with commas between them.
std::vector<double> numbersOf(const std::string& option, const std::string& text, std::size_t count) {
  std::vector<double> numbers;
  for (const std::string& part : CLI::detail::split(text, ',')) {
    double number = 0.0;
    if (!CLI::detail::lexical_cast(part, number)) break;
    numbers.push_back(number);
  }
  if (numbers.size() == count) return numbers;
  throw InvalidConfig(option + " is '" + text + "'; must be " + std::to_string(count) +
                      " numbers with commas between them");
}

Point3 axisOf(const std::string& text) {
  if (text == "x") return Point3::UnitX();
  if (text == "y") return Point3::UnitY();
  if (text == "z") return Point3::UnitZ();
  if (text.find(',') == std::string::npos)
    throw InvalidConfig("--axis is '" + text + "'; must be x, y, z or three numbers");
  return pointOf(numbersOf("--axis", text, 3));
}

AffineMap shearOf(const std::string& text) {
  const bool has_axes = text.size() > 4 && text[1] == ',' && text[3] == ',';
  if (!has_axes || text[0] < 'x' || text[0] > 'z' || text[2] < 'x' || text[2] > 'z')
    throw InvalidConfig("--shear is '" + text + "'; must be such as y,z,1.0 for y += 1.0 z");
  return shear(text[0] - 'x', text[2] - 'x', numbersOf("--shear", text.substr(4), 1)[0]);
}

AffineMap matrixOf(const std::vector<double>& numbers) {
  Eigen::Affine3d matrix = Eigen::Affine3d::Identity();
  for (std::size_t i = 0; i < 12; ++i)
    matrix(static_cast<Eigen::Index>(i / 4), static_cast<Eigen::Index>(i % 4)) = numbers[i];
  return AffineMap(matrix);
}

AffineMap mapOf(const InclineArguments& arguments) {
  const std::string& map = arguments.map;
  const auto require = [&](const std::string& of, const std::string& option, bool is_given) {
    if (is_given == (map == of)) return;
    throw InvalidConfig(
        "--map is " + map +
        (is_given ? "; " + option + " is for " + of + " only" : "; expected " + option + " beside it"));
  };
  if (map != "rotation" && (arguments.angle_deg || !arguments.axis.empty()))
    throw InvalidConfig("--map is " + map + "; --angle-deg and --axis are for rotation only");
  require("scale", "--factors", !arguments.factors.empty());
  require("shear", "--shear", !arguments.shear.empty());
  require("matrix", "--matrix", !arguments.matrix.empty());
  if (map == "scale") return scaling(pointOf(arguments.factors));
  if (map == "shear") return shearOf(arguments.shear);
  if (map == "matrix") return matrixOf(arguments.matrix);
  return rotation(axisOf(arguments.axis.empty() ? "x" : arguments.axis), arguments.angle_deg.value_or(45.0));
}

/// In the listing nothing is checked against a machine unless one is named.
void setLimits(const InclineArguments& arguments, TransformSettings& settings) {
  if (!arguments.limits.empty()) {
    settings.limits_mm =
        Box3{pointOf(arguments.limits), pointOf({arguments.limits.begin() + 3, arguments.limits.end()})};
  } else if (settings.mode == RewriteMode::Corrected) {
    settings.limits_mm = largeGantryRoom();
  }
}

void addMapOptions(CLI::App& subcommand, InclineArguments& arguments) {
  const std::string group = "Map";
  subcommand.add_option("--map", arguments.map, "rotation, shear, scale or matrix")
      ->check(CLI::IsMember({"rotation", "shear", "scale", "matrix"}))
      ->capture_default_str()
      ->group(group);
  subcommand.add_option("--angle-deg", arguments.angle_deg, "Angle of the rotation, right-handed: 45")
      ->check(CLI::Range(-360.0, 360.0))
      ->group(group);
  subcommand.add_option("--axis", arguments.axis, "Axis of the rotation, x, y, z or ux,uy,uz: x")
      ->group(group);
  subcommand.add_option("--shear", arguments.shear, "Axis moved, axis along, factor: y,z,1.0 for y += 1.0 z")
      ->group(group);
  addNumbers(subcommand, "--factors", arguments.factors, "Of the scale in x,y,z", 3)->group(group);
  addNumbers(subcommand, "--matrix", arguments.matrix, "Rows of three factors and a translation", 12)
      ->group(group);
  subcommand
      .add_option("--belt-deg", arguments.belt_deg,
                  "Write for a belt printer whose gantry leans by so much: y up the gantry, z the belt")
      ->check(CLI::Range(15.0, 90.0))
      ->group(group);
}

void addPlaceOptions(CLI::App& subcommand, InclineArguments& arguments) {
  const std::string group = "Place";
  CLI::Option* table = addNumbers(subcommand, "--table-position", arguments.table_position,
                                  "Where the middle of the part comes: x,y", 2);
  CLI::Option* offset =
      addNumbers(subcommand, "--offset", arguments.offset, "Move the part by x,y,z after the lift", 3);
  table->group(group);
  offset->group(group)->excludes(table);
  subcommand
      .add_option("--layer-height", arguments.layer_height_mm,
                  "Height of the lowest deposition; as the program tells")
      ->check(CLI::PositiveNumber)
      ->group(group);
  addChoice<Lift>(subcommand, "--lift", arguments.settings.lift,
                  {{"layer", Lift::ToFirstLayer}, {"none", Lift::None}},
                  "Put the lowest deposition one layer above the bed (default), or leave the height");
  CLI::Option* machine = subcommand.add_option("--machine", arguments.machine, "Machine whose limits hold");
  machine->group(group);
  addNumbers(subcommand, "--limits", arguments.limits,
             "Of the nozzle: lowest x,y,z, highest x,y,z; 0,0,0,1300,2500,1000", 6)
      ->group(group)
      ->excludes(machine);
}

void addCodeOptions(CLI::App& subcommand, InclineArguments& arguments) {
  const std::string group = "Code";
  TransformSettings& settings = arguments.settings;
  subcommand.add_option("--begin-code", arguments.begin_code, "File to put after the comments at the head")
      ->group(group);
  subcommand.add_option("--end-code", arguments.end_code, "File to put at the end")->group(group);
  addNumbers(subcommand, "--final-position", arguments.final_position,
             "Where the nozzle goes at the end: x,y,z", 3)
      ->group(group);
  subcommand.add_option("--final-feed", settings.final_feed_mm_min, "Feed of that move [mm/min]")
      ->capture_default_str()
      ->group(group);
  subcommand.add_option("--decimals", arguments.decimals, "Of coordinates; 3, or 2 as the listing")
      ->check(CLI::Range(0, 6))
      ->group(group);
  subcommand.add_option("--chord-tolerance", settings.chord_tolerance_mm, "Of arcs made chords [mm]")
      ->capture_default_str()
      ->group(group);
}

void addReadingOptions(CLI::App& subcommand, InclineArguments& arguments) {
  TransformSettings& settings = arguments.settings;
  addChoice<RewriteMode>(subcommand, "--mode", settings.mode,
                         {{"corrected", RewriteMode::Corrected}, {"listing", RewriteMode::Listing}},
                         "corrected (default), or as the published listing");
  addChoice<Homing>(subcommand, "--homing", settings.homing,
                    {{"annul", Homing::Annulled}, {"keep", Homing::Kept}},
                    "What becomes of G28: annulled (default) or kept");
  addChoice<BuildAids>(
      subcommand, "--build-aids", settings.build_aids,
      {{"keep", BuildAids::Kept}, {"drop", BuildAids::Dropped}},
      "What becomes of skirt, brim, raft, support and priming tower: kept (default) or dropped");
  addChoice<ExtrusionRule>(subcommand, "--extrusion-rule", settings.extrusion_rule,
                           {{"volume", ExtrusionRule::ByVolume},
                            {"length", ExtrusionRule::ByLength},
                            {"keep", ExtrusionRule::Kept}},
                           "What E follows where lengths change: volume (default), length, or nothing");
  subcommand.add_option("--extrusion", arguments.extrusion, "absolute or relative E, until M82 or M83 tells")
      ->check(CLI::IsMember({"absolute", "relative"}));
}

}  // namespace

void addOptions(CLI::App& subcommand, InclineArguments& arguments) {
  subcommand.add_option("program", arguments.program, "Program (.gcode)")->required();
  subcommand.add_option("-o,--output", arguments.output,
                        "Program to write (.gcode); <program>_rotate.gcode beside the program if not given");
  addMapOptions(subcommand, arguments);
  addPlaceOptions(subcommand, arguments);
  addCodeOptions(subcommand, arguments);
  addReadingOptions(subcommand, arguments);
}

InclineJob jobFrom(const InclineArguments& arguments) {
  InclineJob job;
  job.program = arguments.program;
  job.output = arguments.output;
  job.machine = arguments.machine;
  job.map = std::make_shared<AffineMap>(mapOf(arguments));
  if (arguments.belt_deg > 0.0) job.axes = std::make_shared<AffineMap>(beltAxes(arguments.belt_deg));
  job.settings = arguments.settings;
  TransformSettings& settings = job.settings;
  if (arguments.decimals >= 0) settings.decimals = arguments.decimals;
  if (arguments.layer_height_mm > 0.0) settings.layer_height_mm = arguments.layer_height_mm;
  if (!arguments.offset.empty()) settings.offset_mm = pointOf(arguments.offset);
  if (!arguments.table_position.empty())
    settings.table_position_mm = Point2(arguments.table_position[0], arguments.table_position[1]);
  if (!arguments.final_position.empty()) settings.final_position_mm = pointOf(arguments.final_position);
  if (!arguments.begin_code.empty()) settings.begin_code = readFile(arguments.begin_code);
  if (!arguments.end_code.empty()) settings.end_code = readFile(arguments.end_code);
  if (!arguments.extrusion.empty())
    settings.initial_extrusion =
        arguments.extrusion == "absolute" ? ExtrusionMode::Absolute : ExtrusionMode::Relative;
  setLimits(arguments, settings);
  return job;
}

}  // namespace lamina::cli
