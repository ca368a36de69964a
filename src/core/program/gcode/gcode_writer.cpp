// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/gcode/gcode_writer.hpp"

#include <algorithm>
#include <vector>

#include "geometry/space_vectors.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/one_line.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/shortest_rotation.hpp"
#include "lamina/program/gcode/gcode_dialect.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "lamina/toolpath/process_support.hpp"
#include "lamina/toolpath/wipe.hpp"
#include "program/arc_refusal.hpp"
#include "program/gcode/extrusion.hpp"
#include "program/gcode/fixed_point.hpp"
#include "program/gcode/layer_batches.hpp"
#include "program/gcode/layer_writer.hpp"
#include "program/gcode/process_words.hpp"
#include "program/gcode/start_code.hpp"
#include "program/gcode/tool_offsets.hpp"

namespace lamina {
namespace {

constexpr double kApproach = 1e-6;  // mm

constexpr double kLargestWritten = 1e7;  // mm and mm/s: 10 km, far inside what the counts of units can hold
constexpr double kSameToolAxis = 1e-6;   // rad: what rounding leaves of a rotation
constexpr double kHeldToolAxis = toRadians(0.01);  // rad: as machines without rotary joints hold it

[[noreturn]] void refuse(const Path& path, std::size_t waypoint, const std::string& what) {
  throw InvalidInput(std::string(toString(path.role)) + " path, waypoint " + std::to_string(waypoint) + ": " +
                     what);
}

bool isWritable(const Point3& point) {
  return point.cwiseAbs().maxCoeff() < kLargestWritten && !point.hasNaN();
}

void requireWritable(const Path& path) {
  const std::size_t least = path.deposit == Deposit::Drops ? 1 : 2;
  if (path.points.size() < least)
    refuse(path, path.points.size(), "a path needs at least 2 waypoints, or a drop");
  for (std::size_t i = 0; i < path.points.size(); ++i)
    if (!isWritable(path.points[i])) refuse(path, i, "the position is not a number within 10 km");
  const std::string fault = faultOfEvents(path);
  if (!fault.empty()) refuse(path, 0, fault);
  const auto& feeds = path.feed_mm_s.values();
  for (std::size_t i = 0; i < feeds.size(); ++i)
    if (!(feeds[i] > 0.0 && feeds[i] < kLargestWritten))
      refuse(path, i, "feed is " + numberText(feeds[i]) + " mm/s; must be positive");
  const auto& beads = path.bead.values();
  for (std::size_t i = 0; i < beads.size(); ++i)
    if (!(beads[i].width_mm >= 0.0 && beads[i].height_mm >= 0.0 && crossSection(beads[i]) < kLargestWritten))
      refuse(path, i, "bead width and height must be finite and not negative");
}

/// @param tool_axis  of the head, in the part frame
void requireToolAxis(const Path& path, const Point3& tool_axis) {
  const auto& orientations = path.orientation.values();
  for (std::size_t i = 0; i < orientations.size(); ++i) {
    const Point3 wanted = orientations[i] * Point3::UnitZ();
    const double turn = angleBetween(tool_axis, wanted);
    if (!(turn <= kHeldToolAxis))
      refuse(path, i,
             "the nozzle would have to turn by " + numberText(toDegrees(turn)) +
                 " deg; a three-axis program holds it as at the first waypoint");
  }
}

Point3 toolAxisOf(const Path& path) { return path.orientation.at(0) * Point3::UnitZ(); }

/// @return filament the layer lays [mm]
double checkLayer(const ToolpathLayer& layer, const Point3& tool_axis, double filament_per_volume) {
  double sum = 0.0;
  for (const Path& path : layer.paths) {
    requireWritable(path);
    requireToolAxis(path, tool_axis);
    if (path.deposit == Deposit::Drops) continue;
    const PathExtrusion extrusion(path, filament_per_volume);
    const std::size_t motions = path.motionCount();
    for (std::size_t m = 0; m < motions; ++m) {
      const std::size_t end = path.motionEnd(m);
      sum += extrusion.along((path.points[end] - path.points[m]).norm(), end);
    }
  }
  return sum;
}

std::vector<LayerStart> checkLayers(const Toolpath& toolpath, const Point3& tool_axis,
                                    const ProgramSettings& settings) {
  const double filament_per_volume = filamentPerVolume(settings);
  std::vector<double> filament_mm(toolpath.layers.size());
  NoProgress nobody;
  const auto check = [&](std::size_t l) {
    try {
      filament_mm[l] = checkLayer(toolpath.layers[l], tool_axis, filament_per_volume);
    } catch (const InvalidInput& error) {
      throw InvalidInput("toolpath layer " + std::to_string(l) + ", " + error.what());
    }
  };
  parallelFor(toolpath.layers.size(), check, nobody, "check");

  std::vector<LayerStart> starts(toolpath.layers.size());
  double sum = 0.0;
  for (std::size_t l = 0; l < starts.size(); ++l) {
    starts[l].index = l;
    starts[l].filament_mm = sum;
    sum += filament_mm[l];
  }
  return starts;
}

/// Lets layers know whether material is pulled back where they meet, and with which tool. Layers without
/// paths pass it on.
void connectRetractions(const Toolpath& toolpath, std::vector<LayerStart>& starts) {
  bool next_is_retracted = false;
  for (std::size_t l = starts.size(); l-- > 0;) {
    starts[l].next_is_retracted = next_is_retracted;
    const auto& paths = toolpath.layers[l].paths;
    if (!paths.empty()) next_is_retracted = paths.front().process.is_retracted;
  }
  bool is_retracted = false;
  std::uint32_t tool = 0;
  for (std::size_t l = 0; l < starts.size(); ++l) {
    const auto& paths = toolpath.layers[l].paths;
    starts[l].tool = tool;
    if (paths.empty()) continue;
    tool = paths.back().tool;
    starts[l].is_retracted = is_retracted && paths.front().process.is_retracted;
    is_retracted = paths.back().process.is_retracted;
  }
}

const Path& firstPath(const Toolpath& toolpath) {
  for (const ToolpathLayer& layer : toolpath.layers)
    if (!layer.paths.empty()) return layer.paths.front();
  throw InvalidInput("the toolpath of '" + toolpath.part_name +
                     "' has no path; a program needs at least one motion");
}

/// The first run of drops, if the toolpath lays drops.
/// @throws InvalidInput if it lays beads besides, or drops of several diameters: no dialect distinguishes
/// them
const Path* requireDropsAlike(const Toolpath& toolpath) {
  const Path* first = nullptr;
  bool has_beads = false;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) {
      if (path.role == PathRole::Travel) continue;
      if (path.deposit == Deposit::Bead) has_beads = true;
      if (path.deposit == Deposit::Drops && first == nullptr) first = &path;
      if (path.deposit == Deposit::Drops)
        for (const Bead& drop : path.bead.values())
          if (drop.width_mm != first->bead.at(0).width_mm)
            refuse(path, 0,
                   "the diameter of a drop is " + std::to_string(drop.width_mm) + " mm; must be " +
                       numberText(first->bead.at(0).width_mm) + " mm as that of the first");
    }
  if (first != nullptr && has_beads)
    throw InvalidInput("the toolpath of '" + toolpath.part_name +
                       "' lays both beads and drops; expected one of them");
  return first;
}

/// Of the values of a process, wipes alone have words.
void requireValues(const Toolpath& toolpath, const std::string& dialect) {
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (std::size_t p = 0; p < toolpath.layers[l].paths.size(); ++p)
      for (const ProcessValue& value : toolpath.layers[l].paths[p].values)
        if (value.name != kWipeShare)
          throw InvalidInput("toolpath layer " + std::to_string(l) + ", path " + std::to_string(p) +
                             ": process value '" + value.name + "' cannot be carried by G-code of dialect " +
                             dialect);
}

/// Arcs lie across Z.
void requireArcs(const Toolpath& toolpath, const ProgramFrame& frame, const ProgramSettings& settings,
                 Deposit deposit) {
  if (settings.arcs_tolerance_mm == 0.0) return;
  if (deposit == Deposit::Drops) refuseArcs(settings, "programs of drops");
  const Eigen::Matrix3d linear = frame.program_from_bed.linear() * frame.bed_from_part.linear();
  const Point3 normal = linear * layerNormal(toolpath);
  const bool is_askew = !frame.program_from_bed.linear().isUnitary(kSameToolAxis);
  if (is_askew || normal.head<2>().norm() > kSameToolAxis)
    refuseArcs(settings, "layers that do not lie in a plane of two axes");
}

void requireCarried(const Toolpath& toolpath, Deposit deposit, const std::string& name) {
  using Element = ProcessElement;
  if (deposit == Deposit::Drops) return requireSupported(toolpath, {}, "programs of drops");
  std::vector<Element> elements = {Element::Dwell, Element::Code, Element::MovingCode, Element::Value};
  const GcodeDialect dialect = gcodeDialects().find(name);
  if (dialect.has_fan) elements.push_back(Element::Fan);
  if (dialect.has_pause) elements.push_back(Element::Pause);
  if (dialect.has_tools) elements.push_back(Element::Tool);
  requireSupported(toolpath, elements, "G-code of dialect " + name);
  requireValues(toolpath, name);
}

void requireNoHeat(const std::string& key, double temperature_c, const std::string& dialect) {
  if (temperature_c > 0.0)
    throw InvalidConfig(key + " is " + numberText(temperature_c) + " degrees C with program.dialect '" +
                        dialect + "', which knows no heaters; expected 0");
}

/// @throws InvalidConfig if temperatures are set, or stand in the code, that the dialect does not know
void requireNoHeat(const ProgramSettings& settings) {
  if (gcodeDialects().find(settings.dialect).has_heaters) return;
  requireNoHeat("program.nozzle_temperature_c", settings.nozzle_temperature_c, settings.dialect);
  requireNoHeat("program.bed_temperature_c", settings.bed_temperature_c, settings.dialect);
  for (const char* const command : {"M104 S0", "M109 S0", "M140 S0", "M190 S0"})
    if (settings.end_code.find(command) != std::string::npos)
      throw InvalidConfig(std::string("program.end_code holds '") + command + "' with program.dialect '" +
                          settings.dialect + "', which knows no heaters; expected code of its own");
}

/// Units, coordinates and extrusion of the part.
std::string modes(const GcodeDialect& dialect, bool lays_drops) {
  return lays_drops || !dialect.has_extruder ? "G21\nG90\n" : "G21\nG90\nM83\nG92 E0\n";
}

/// Over the first waypoint at the height the start code ends at, then down: a nozzle that is low before it
/// is there scrapes over clamps and purge lines. A toolpath that begins with a travel downwards has an
/// approach of its own, from a height that clears what stands on the bed: up to it first, then over.
std::string approach(const Path& path, const Point3& first, double feed_mm_s) {
  const auto axis = [](const char* name, double value, double units) {
    char digits[32];
    return name + std::string(digits, writeFixed<3>(digits, toUnits(value, units)));
  };
  const std::string over = axis(" X", first.x(), 1e3) + axis(" Y", first.y(), 1e3);
  const std::string height = axis(" Z", first.z(), 1e3);
  const std::string feed = axis(" F", feed_mm_s, 60e3);
  const bool has_approach =
      path.role == PathRole::Travel && path.firstPoint().z() > path.lastPoint().z() + kApproach;
  if (has_approach) return "G0" + height + feed + "\nG0" + over + "\n";
  return "G0" + over + feed + "\nG0" + height + "\n";
}

std::string dropHeader(const Path& drops, const ProgramSettings& settings) {
  const auto line = [](const std::string& key, double value) {
    char digits[32];
    return ";" + key + "=" + std::string(digits, writeFixed<5>(digits, toUnits(value, 1e5))) + "\n";
  };
  const DropDialect& dialect = settings.drops;
  return line(dialect.diameter_key, drops.bead.at(0).width_mm) +
         line(dialect.height_key, drops.bead.at(0).height_mm) + ";" + dialect.strategy_key + "=" +
         oneLine(settings.strategy) + "\n;" + dialect.units_key + "=mm\n";
}

StatedFrame statedFrame(const Toolpath& toolpath, const ProgramFrame& frame) {
  const Eigen::Quaterniond bed_from_part(frame.bed_from_part.linear());
  StatedFrame stated;
  stated.bed_from_layers = bed_from_part * toolpath.part_from_layers;
  const Point3 tool_axis = bed_from_part * toolAxisOf(firstPath(toolpath));
  // The turn about the tool axis is free: none where it points straight down.
  stated.bed_from_nozzle = shortestRotation(-Point3::UnitZ(), tool_axis) * nozzleDown();
  stated.bed_from_program = frame.program_from_bed.inverse();
  return stated;
}

/// Feed of the first travel, or of the first path if there is no travel.
double approachFeed(const Toolpath& toolpath) {
  for (const ToolpathLayer& layer : toolpath.layers) {
    double greatest_mm_s = 0.0;  // others are ends of runs
    for (const Path& path : layer.paths)
      if (path.role == PathRole::Travel)
        greatest_mm_s = std::max(greatest_mm_s, path.feed_mm_s.at(path.points.size() - 1));
    if (greatest_mm_s > 0.0) return greatest_mm_s;
  }
  const Path& path = firstPath(toolpath);
  return path.feed_mm_s.at(path.points.size() - 1);
}

}  // namespace

void writeGcode(const Toolpath& toolpath, const ProgramFrame& frame, const ProgramSettings& settings,
                const TextSink& sink) {
  const Path& first = firstPath(toolpath);
  const Path* drops = requireDropsAlike(toolpath);
  const GcodeDialect dialect = gcodeDialects().find(settings.dialect);
  const Deposit deposit = drops != nullptr ? Deposit::Drops : Deposit::Bead;
  requireCarried(toolpath, deposit, settings.dialect);
  requireArcs(toolpath, frame, settings, deposit);
  requireNoHeat(settings);
  std::vector<LayerStart> starts = checkLayers(toolpath, toolAxisOf(first), settings);
  connectRetractions(toolpath, starts);
  const std::string start_code = expandCode("program.start_code", settings.start_code, settings, frame);
  const std::string end_code = expandCode("program.end_code", settings.end_code, settings, frame);

  sink("; generated by Lamina\n; part: " + oneLine(toolpath.part_name) + "\n" +
       (drops != nullptr ? dropHeader(*drops, settings) : "") + ";LAYER_COUNT:" +
       std::to_string(toolpath.layers.size()) + "\n" + frameComments(statedFrame(toolpath, frame)) +
       toolOffsetComments(settings, frame) + start_code + modes(dialect, drops != nullptr));
  sink("; start of the part\n" + approach(first,
                                          frame.program_from_bed * (frame.bed_from_part * first.firstPoint()),
                                          approachFeed(toolpath)));
  ProgramSettings written = settings;
  const bool has_filament = drops == nullptr && dialect.has_extruder;
  if (!has_filament) written.retraction_length_mm = 0.0;  // there is nothing to pull back
  const LayerWriter writer(frame, layerNormal(toolpath), written);
  writeLayers(
      toolpath, [&](std::size_t l, std::string& text) { writer.write(toolpath.layers[l], starts[l], text); },
      sink);
  std::string events_at_end;
  for (const ToolpathEvent& event : toolpath.events_at_end) writeEvent(event, settings, events_at_end);
  sink(events_at_end + "; end of the part\n" + end_code);
}

}  // namespace lamina
