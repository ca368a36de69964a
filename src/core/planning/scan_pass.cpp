// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/scan_pass.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "lamina/toolpath/scan_height.hpp"

namespace lamina {
namespace {

constexpr double kSwathOverlap = 0.05;  // part of a swath that its neighbour sees too

bool deposits(const ToolpathLayer& layer) {
  return std::any_of(layer.paths.begin(), layer.paths.end(),
                     [](const Path& path) { return path.role != PathRole::Travel; });
}

/// What the layer deposits, to the edges of the beads; build aids only where there is nothing else.
Box2 boxToScan(const ToolpathLayer& layer) {
  Box2 part;
  Box2 aids;
  for (const Path& path : layer.paths) {
    if (path.role == PathRole::Travel) continue;
    Box2& box = kindOf(path.role) == RoleKind::BuildAid ? aids : part;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      const double half = 0.5 * path.bead.at(i).width_mm;
      box.include(path.points[i].head<2>() - Point2(half, half));
      box.include(path.points[i].head<2>() + Point2(half, half));
    }
  }
  return part.isEmpty() ? aids : part;
}

/// Places of the middle of the sensor's line, start and end of each swath.
std::vector<Point2> swathEnds(const Box2& box, double swath_mm) {
  const double across = box.size().x();
  const int swaths = std::max(1, static_cast<int>(std::ceil(across / (swath_mm * (1.0 - kSwathOverlap)))));
  std::vector<Point2> ends;
  for (int i = 0; i < swaths; ++i) {
    const double x = box.low.x() + across * (i + 0.5) / swaths;
    ends.emplace_back(x, i % 2 == 0 ? box.low.y() : box.high.y());
    ends.emplace_back(x, i % 2 == 0 ? box.high.y() : box.low.y());
  }
  return ends;
}

Path scanOf(const ToolpathLayer& layer, const ScanSettings& settings, const ScanSight& sight) {
  Box2 box = boxToScan(layer);
  // A surface that is a layer too high or too low is seen by a leaning sensor where it is not planned.
  const Point2 margin =
      Point2(settings.margin_mm, settings.margin_mm) + layer.height_mm * sight.lean.cwiseAbs();
  box = {box.low - margin, box.high + margin};
  const double z = scanHeight(layer, settings.clearance_mm);
  const Point2 line_from_nozzle = sight.offset_mm + (z - layer.z_mm) * sight.lean;
  Path scan;
  scan.role = PathRole::Travel;
  scan.process.is_retracted = true;
  scan.feed_mm_s = settings.feed_mm_s;
  const Path& before = layer.paths.back();
  scan.orientation = before.orientation.at(before.is_closed ? 0 : before.points.size() - 1);
  const Point3 start = before.lastPoint();
  scan.points = {start, {start.x(), start.y(), z}};
  for (const Point2& line : swathEnds(box, settings.swath_mm)) {
    const Point2 nozzle = line - line_from_nozzle;
    scan.points.emplace_back(nozzle.x(), nozzle.y(), z);
  }
  return scan;
}

/// Leads the scan on to where the next layer starts to deposit, in place of that layer's own first travel.
void joinNext(Path& scan, ToolpathLayer& next) {
  const bool travels = next.paths.front().role == PathRole::Travel;
  const Point3 start = travels ? next.paths.front().lastPoint() : next.paths.front().firstPoint();
  scan.points.emplace_back(start.x(), start.y(), scan.points.back().z());
  scan.points.push_back(start);
  if (travels) next.paths.erase(next.paths.begin());
}

}  // namespace

Toolpath withScanPasses(Toolpath toolpath, const ScanSettings& settings, const ScanSight& sight) {
  if (settings.every_layers == 0) return toolpath;
  requireLevelLayers(toolpath, "scan passes");
  if (!(settings.swath_mm > 0.0 && std::isfinite(settings.swath_mm)))
    throw InvalidConfig("length of the sensor's line is " + numberText(settings.swath_mm) +
                        " mm; must be positive");
  auto& layers = toolpath.layers;
  std::size_t end = layers.size();
  while (end > 0 && !deposits(layers[end - 1])) --end;
  for (std::size_t i = 0; i < end; ++i) {
    const bool is_due = (i + 1) % static_cast<std::size_t>(settings.every_layers) == 0 || i + 1 == end;
    if (!is_due || !deposits(layers[i])) continue;
    Path scan = scanOf(layers[i], settings, sight);
    const auto next = std::find_if(layers.begin() + static_cast<std::ptrdiff_t>(i) + 1, layers.end(),
                                   [](const ToolpathLayer& layer) { return !layer.paths.empty(); });
    if (next != layers.end()) joinNext(scan, *next);
    layers[i].paths.push_back(std::move(scan));
  }
  return toolpath;
}

void describe(SettingsSchema& schema, ScanSettings& settings) {
  schema.integer("scan.every_layers", settings.every_layers, {0, 1000000},
                 "A scan with the profile sensor follows each n-th layer and the last; 0 scans none.");
  schema.number("scan.clearance_mm", settings.clearance_mm, Bounds::above(0.0, 100.0),
                "The nozzle flies at least that far above the layer just finished.");
  schema.number("scan.feed_mm_s", settings.feed_mm_s, Bounds::above(0.0, 1000.0), "Speed of the scan.");
  schema.number("scan.swath_mm", settings.swath_mm, Bounds::above(0.0, 1000.0),
                "Length of the sensor's line on the layer.");
  schema.number("scan.margin_mm", settings.margin_mm, {0.0, 100.0}, "Scanned beyond the layer on each side.");
}

}  // namespace lamina
