// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scaffold/layer_assembly.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lamina {
namespace {

constexpr double kJoined = 1e-9;  // mm

double firstHeight(const ScaffoldSettings& settings) {
  return settings.first_layer_height_mm > 0.0 ? settings.first_layer_height_mm : settings.layer_height_mm;
}

}  // namespace

std::vector<double> layerTops(const ScaffoldSettings& settings) {
  const double first = firstHeight(settings);
  const double others = (settings.height_mm - first) / settings.layer_height_mm;
  const auto count = static_cast<std::size_t>(std::max(0.0, std::round(others)));
  std::vector<double> tops;
  for (std::size_t layer = 0; layer <= count; ++layer)
    tops.push_back(first + static_cast<double>(layer) * settings.layer_height_mm);
  return tops;
}

Bead scaffoldBead(const ScaffoldSettings& settings, double layer_height_mm, double fill) {
  return beadOfArea(fill * settings.bead_width_mm * layer_height_mm, layer_height_mm);
}

LayerAssembly::LayerAssembly(const ScaffoldSettings& settings, const Point2& middle, double fill)
    : settings_(settings), middle_(middle), fill_(fill) {}

void LayerAssembly::add(double top_mm, const std::vector<ScaffoldRun>& runs) {
  ToolpathLayer layer;
  layer.z_mm = top_mm;
  layer.height_mm = toolpath_.layers.empty() ? top_mm : settings_.layer_height_mm;
  for (const ScaffoldRun& run : runs) {
    Path deposited = path(run, layer);
    travelTo(deposited.firstPoint(), layer);
    layer.paths.push_back(std::move(deposited));
  }
  toolpath_.layers.push_back(std::move(layer));
}

Toolpath LayerAssembly::finish(const std::string& part_name) {
  toolpath_.part_name = part_name;
  return std::move(toolpath_);
}

/// The nozzle rises first, and leaves the part before a layer if it shall.
void LayerAssembly::travelTo(const Point3& start, ToolpathLayer& layer) {
  const bool begins_layer = layer.paths.empty();
  if (begins_layer && toolpath_.layers.empty()) return;
  const auto& paths = begins_layer ? toolpath_.layers.back().paths : layer.paths;
  const Point3 last = paths.back().lastPoint();
  Path travel;
  travel.role = PathRole::Travel;
  travel.feed_mm_s = settings_.travel_feed_mm_s;
  travel.points = {last};
  if (begins_layer) {
    travel.points.emplace_back(last.x(), last.y(), start.z());
    if (settings_.away_mm > 0.0)
      travel.points.emplace_back(settings_.corner_x_mm - settings_.away_mm, middle_.y(), start.z());
  }
  if ((travel.points.back() - start).norm() > kJoined) travel.points.push_back(start);
  if (travel.points.size() > 1) layer.paths.push_back(std::move(travel));
}

Path LayerAssembly::path(const ScaffoldRun& run, const ToolpathLayer& layer) const {
  Path path;
  path.role = run.role;
  path.is_closed = run.is_closed;
  path.feed_mm_s = settings_.feed_mm_s;
  for (const Point2& point : run.points)
    path.points.emplace_back(middle_.x() + point.x(), middle_.y() + point.y(), layer.z_mm);
  const Bead nominal = scaffoldBead(settings_, layer.height_mm, fill_);
  if (run.section.empty()) {
    path.bead = nominal;
    return path;
  }
  std::vector<Bead> beads;
  beads.reserve(run.section.size());
  for (const double part : run.section)
    beads.push_back(beadOfArea(part * crossSection(nominal), layer.height_mm));
  path.bead = AlongPath<Bead>(std::move(beads));
  return path;
}

}  // namespace lamina
