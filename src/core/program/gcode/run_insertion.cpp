// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/gcode/run_insertion.hpp"

#include <algorithm>
#include <cstdio>

#include "lamina/base/error.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "program/gcode/deposit_lines.hpp"
#include "program/gcode/extrusion.hpp"
#include "program/gcode/fixed_point.hpp"

namespace lamina {
namespace {

std::string fixed3(double value) {
  char text[32];
  return {text, writeFixed<3>(text, toUnits(value, 1e3))};
}

std::string fixed5(double value) {
  char text[32];
  return {text, writeFixed<5>(text, toUnits(value, 1e5))};
}

/// Writes the runs of one layer.
class BlockWriter {
 public:
  BlockWriter(const LayerEnd& end, const InsertionSettings& settings)
      : end_(end), settings_(settings), nozzle_(end.nozzle), height_mm_(end.height_mm) {
    text_ = ";void fill\n;TYPE:gap_fill\n";
    if (end.is_filament_absolute) text_ += "M83\n";
  }

  void add(const Path& path) {
    travelTo(path.points.front());
    const PathExtrusion extrusion(path, filamentPerVolume(settings_.program));
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const std::size_t end = path.motionEnd(m);
      const Point3& to = path.points[end];
      if (height_mm_) writeHeight(path.bead.at(end).height_mm);
      text_ += "G1 X" + fixed3(to.x()) + " Y" + fixed3(to.y()) + " E" +
               fixed5(extrusion.along((to - path.points[m]).norm(), end)) + " F" +
               fixed3(60.0 * path.feed_mm_s.at(end)) + "\n";
    }
    nozzle_ = path.lastPoint();
  }

  std::string finish() && {
    travelTo(end_.nozzle);
    if (end_.is_filament_absolute) text_ += "M82\nG92 E" + fixed5(end_.filament_mm) + "\n";
    text_ += "G1 F" + fixed3(60.0 * end_.feed_mm_s) + "\n";
    if (height_mm_) writeHeight(*end_.height_mm);
    if (!end_.type.empty()) text_.append(end_.type).append("\n");
    return text_ + ";end of void fill\n";
  }

 private:
  void writeHeight(double height_mm) {
    if (fixed5(height_mm) == fixed5(*height_mm_)) return;
    height_mm_ = height_mm;
    text_ += ";HEIGHT:" + fixed5(height_mm) + "\n";
  }

  void travelTo(const Point3& to) {
    const bool is_long = (to - nozzle_).norm() > settings_.retraction_threshold_mm;
    const bool is_retracted = is_long && settings_.program.retraction_length_mm > 0.0;
    const double over = std::max(nozzle_.z(), to.z()) + (is_long ? settings_.hop_mm : 0.0);
    if (is_retracted) retract(-settings_.program.retraction_length_mm);
    const std::string feed = " F" + fixed3(60.0 * settings_.travel_feed_mm_s) + "\n";
    if (over > nozzle_.z()) text_ += "G0 Z" + fixed3(over) + feed;
    text_ += "G0 X" + fixed3(to.x()) + " Y" + fixed3(to.y()) + " Z" + fixed3(over) + feed;
    if (over > to.z()) text_ += "G0 Z" + fixed3(to.z()) + feed;
    if (is_retracted) retract(settings_.program.retraction_length_mm);
    nozzle_ = to;
  }

  void retract(double length_mm) {
    text_ += "G1 E" + fixed5(length_mm) + " F" + fixed3(60.0 * settings_.program.retraction_feed_mm_s) + "\n";
  }

  const LayerEnd& end_;
  const InsertionSettings& settings_;
  Point3 nozzle_;
  std::optional<double> height_mm_;  ///< that holds, if the program reports heights
  std::string text_;
};

std::string blockOf(const std::vector<Path>& runs, const LayerEnd& end, const InsertionSettings& settings) {
  BlockWriter writer(end, settings);
  for (const Path& run : runs) writer.add(run);
  return std::move(writer).finish();
}

}  // namespace

std::string insertRuns(std::string_view program, const Toolpath& toolpath,
                       const std::vector<std::vector<Path>>& runs, const InsertionSettings& settings) {
  requireLevelLayers(toolpath, "adding runs to a program");
  if (runs.size() != toolpath.layers.size())
    throw InvalidInput("runs are given for " + std::to_string(runs.size()) + " layers; the program has " +
                       std::to_string(toolpath.layers.size()));
  const bool is_idle =
      std::all_of(runs.begin(), runs.end(), [](const std::vector<Path>& layer) { return layer.empty(); });
  if (is_idle) return std::string(program);
  const std::vector<LayerEnd> ends = layerEnds(program, toolpath);
  std::string result;
  std::size_t layer = 0;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < program.size();) {
    const std::size_t end = std::min(program.find('\n', begin), program.size() - 1);
    result.append(program.substr(begin, end + 1 - begin));
    ++number;
    for (; layer < ends.size() && ends[layer].line <= number; ++layer) {
      if (runs[layer].empty() || ends[layer].line == 0) continue;
      if (result.back() != '\n') result += '\n';
      result += blockOf(runs[layer], ends[layer], settings);
    }
    begin = end + 1;
  }
  return result;
}

}  // namespace lamina
