// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/remaining_motion.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"
#include "lamina/toolpath/waypoint_text.hpp"
#include "program/rapid/rapid_words.hpp"
#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

/// From the start of a motion on, as an open path.
Path cutPath(const Path& path, std::size_t motion) {
  std::vector<std::size_t> waypoints = {motion};
  waypoints.reserve(path.motionCount() - motion + 1);
  for (std::size_t m = motion; m < path.motionCount(); ++m) waypoints.push_back(path.motionEnd(m));
  Path rest = path;
  rest.is_closed = false;
  rest.points.clear();
  rest.points.reserve(waypoints.size());
  for (const std::size_t waypoint : waypoints) rest.points.push_back(path.points[waypoint]);
  rest.orientation = picked(path.orientation, waypoints);
  rest.bead = picked(path.bead, waypoints);
  rest.feed_mm_s = picked(path.feed_mm_s, waypoints);
  for (ProcessValue& value : rest.values) value.value = picked(value.value, waypoints);
  rest.events.clear();
  for (const PathEvent& placed : path.events)
    if (placed.motion >= motion) rest.events.push_back({placed.motion - motion, placed.event});
  return rest;
}

/// Puts the rest of a motion together, path by path, with the joints of each.
class RemainingMotion {
 public:
  RemainingMotion(const StatedMotion& motion, const WaypointIndex& from) : motion_(motion), from_(from) {
    rest_.between = motion.between;
    rest_.joints.tool_axis_tolerance = motion.joints.tool_axis_tolerance;
    rest_.joints.faults = motion.joints.faults;
    rest_.toolpath.part_name = motion.toolpath.part_name;
    rest_.toolpath.part_from_layers = motion.toolpath.part_from_layers;
    rest_.toolpath.events_at_end = motion.toolpath.events_at_end;
  }

  StatedMotion run() {
    for (std::size_t l = 0; l < motion_.toolpath.layers.size(); ++l) {
      const ToolpathLayer& layer = motion_.toolpath.layers[l];
      std::vector<Path> paths;
      for (std::size_t p = 0; p < layer.paths.size(); ++p) {
        addPath({l, p, 0}, paths);
        station_ += layer.paths[p].motionCount() + 1;
      }
      if (!paths.empty()) rest_.toolpath.layers.push_back({layer.z_mm, layer.height_mm, std::move(paths)});
    }
    if (rest_.toolpath.layers.empty())
      throw InvalidInput("nothing is deposited from " + toText(from_) +
                         " on; expected a waypoint before the end of the last path that deposits");
    return std::move(rest_);
  }

 private:
  void addPath(const WaypointIndex& at, std::vector<Path>& paths) {
    const bool is_before = at.layer < from_.layer || (at.layer == from_.layer && at.path < from_.path);
    if (is_before) return;
    const Path& path = motion_.toolpath.layers[at.layer].paths[at.path];
    const bool is_cut = at.layer == from_.layer && at.path == from_.path && from_.waypoint > 0;
    const std::size_t begin = is_cut ? from_.waypoint : 0;
    const bool is_first = rest_.toolpath.layers.empty() && paths.empty();
    if (begin >= path.motionCount() || (is_first && path.role == PathRole::Travel)) return;
    const Path rest = is_cut ? cutPath(path, begin) : path;
    for (std::size_t s = begin; s <= path.motionCount(); ++s) {
      const std::size_t waypoint = s == begin ? 0 : rest.motionEnd(s - begin - 1);
      rest_.joints.at.push_back({rest_.toolpath.layers.size(), paths.size(), waypoint});
      rest_.joints.values.push_back(motion_.joints.values[station_ + s]);
      rest_.lines.push_back(motion_.lines[station_ + s]);
    }
    paths.push_back(rest);
  }

  const StatedMotion& motion_;
  const WaypointIndex& from_;
  StatedMotion rest_;
  std::size_t station_ = 0;  ///< of the path's first waypoint among the joints
};

std::string stemOf(const std::string& file) { return lowerCase(std::filesystem::path(file).stem().string()); }

/// Waypoints that the lines of one file state.
struct LineRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

LineRange linesOf(const StatedMotion& motion, const StatedLine& line) {
  const LineRange all{0, motion.lines.size()};
  if (line.file.empty() && motion.files.size() <= 1) return all;
  std::vector<std::string> names;
  names.reserve(motion.files.size());
  for (std::size_t f = 0; f < motion.files.size(); ++f) {
    const StatedFile& file = motion.files[f];
    if (!line.file.empty() && stemOf(file.name) == stemOf(line.file))
      return {file.first, f + 1 < motion.files.size() ? motion.files[f + 1].first : all.end};
    names.push_back(std::filesystem::path(file.name).filename().string());
  }
  const std::string moves = "the files with moves of the part: " + listed(names);
  if (line.file.empty())
    throw InvalidInput("the program has several files, in which line " + std::to_string(line.number) +
                       " stands more than once; expected --of-file with one of " + moves);
  throw InvalidInput("the program has no file '" + line.file + "' that moves; expected one of " + moves);
}

}  // namespace

WaypointIndex waypointOfLayer(const StatedMotion& motion, std::size_t layer) {
  const std::size_t count = motion.toolpath.layers.size();
  if (layer >= count)
    throw InvalidInput("layer " + std::to_string(layer) + " is asked for; the program has layers 0 to " +
                       std::to_string(count - 1));
  return {layer, 0, 0};
}

WaypointIndex waypointAtHeight(const StatedMotion& motion, double height_mm) {
  constexpr double kSameHeight = 1e-6;  // mm
  const auto& layers = motion.toolpath.layers;
  for (std::size_t l = 0; l < layers.size(); ++l)
    if (layers[l].z_mm >= height_mm - kSameHeight) return {l, 0, 0};
  throw InvalidInput("the height " + numberText(height_mm) + " mm is above all layers; expected " +
                     numberText(layers.empty() ? 0.0 : layers.back().z_mm) + " mm at most");
}

WaypointIndex waypointAtLine(const StatedMotion& motion, const StatedLine& line) {
  const LineRange range = linesOf(motion, line);
  const auto begin = motion.lines.begin();
  const auto found = std::lower_bound(begin + static_cast<std::ptrdiff_t>(range.begin),
                                      begin + static_cast<std::ptrdiff_t>(range.end), line.number);
  if (found == motion.lines.end())
    throw InvalidInput("no move comes from line " + std::to_string(line.number) +
                       " on; the last one is on line " +
                       std::to_string(motion.lines.empty() ? 0 : motion.lines.back()));
  const auto index = static_cast<std::size_t>(found - begin);
  const WaypointIndex& at = motion.joints.at[index];
  const bool is_begin = index == 0 || motion.joints.at[index - 1].layer != at.layer ||
                        motion.joints.at[index - 1].path != at.path;
  return is_begin ? at : motion.joints.at[index - 1];
}

StatedMotion remainingMotion(const StatedMotion& motion, const WaypointIndex& from) {
  return RemainingMotion(motion, from).run();
}

}  // namespace lamina
