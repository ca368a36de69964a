// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scaffold/filled_shape.hpp"

#include <cmath>
#include <iterator>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/infill/strategy.hpp"
#include "scaffold/gyroid.hpp"
#include "scaffold/layer_assembly.hpp"

namespace lamina {
namespace {

constexpr int kAllThatFit = 1 << 30;

/// What a layer is filled with.
struct LayerFill {
  const ScaffoldSettings& settings;
  std::size_t layer;
  double top_mm;
  double density;
  double pitch_mm;  ///< between lines at density 1
};

InfillRequest requestOf(const LayerFill& fill) {
  InfillRequest request;
  request.pitch_mm = fill.pitch_mm;
  request.spacing_mm = fill.pitch_mm / fill.density;
  request.layer = fill.layer;
  request.turn_rad = fill.layer % 2 == 0 ? 0.0 : 0.5 * M_PI;
  request.angle_rad = fill.settings.angle_deg * M_PI / 180.0 + request.turn_rad;
  request.settings.perimeters.end_gap = 0.0;
  return request;
}

std::vector<ScaffoldRun> runsFrom(std::vector<FillPath> paths, double pitch_mm) {
  std::vector<ScaffoldRun> runs;
  for (FillPath& path : paths) {
    ScaffoldRun run{std::move(path.points), path.is_closed, path.role, std::move(path.width_mm)};
    for (double& part : run.section) part /= pitch_mm;
    runs.push_back(std::move(run));
  }
  return runs;
}

std::vector<ScaffoldRun> perimeterRuns(const Regions& regions, const LayerFill& fill) {
  InfillRequest request = requestOf(fill);
  request.spacing_mm = fill.pitch_mm;
  request.settings.perimeters.count = fill.settings.perimeters;
  return runsFrom(infillStrategy("perimeters").fill(regions, request), fill.pitch_mm);
}

std::vector<ScaffoldRun> rings(const Regions& regions, const LayerFill& fill) {
  InfillRequest request = requestOf(fill);
  if (!isSolid(request)) request.settings.perimeters.count = kAllThatFit;
  std::vector<FillPath> paths = infillStrategy("perimeters").fill(regions, request);
  for (FillPath& path : paths) path.role = PathRole::Infill;
  return runsFrom(std::move(paths), fill.pitch_mm);
}

std::vector<ScaffoldRun> gyroidRuns(const Regions& regions, const LayerFill& fill) {
  const GyroidSlice slice{gyroidPeriod(fill.density / fill.pitch_mm), fill.top_mm,
                          fill.settings.angle_deg * M_PI / 180.0};
  std::vector<ScaffoldRun> runs;
  for (const Region& region : offset(regions, -0.5 * fill.pitch_mm))
    for (Polyline& line : gyroidLines(slice, region.outer)) runs.push_back({std::move(line)});
  return runs;
}

std::vector<ScaffoldRun> fillRuns(const Regions& regions, const LayerFill& fill) {
  const bool is_full = fill.density >= 1.0;
  switch (fill.settings.fill) {
    case ScaffoldFill::Concentric:
      return rings(regions, fill);
    case ScaffoldFill::Gyroid:
      // A gyroid has no solid form.
      if (!is_full) return gyroidRuns(regions, fill);
      break;
    case ScaffoldFill::Rectilinear:
      break;
  }
  return runsFrom(infillStrategy("zigzag").fill(regions, requestOf(fill)), fill.pitch_mm);
}

/// A full layer's pitch: what a stadium fills of the layer, or the width of a bead.
double pitchOf(const ScaffoldSettings& settings) {
  return settings.full_spacing == FullSpacing::Width
             ? settings.bead_width_mm
             : planWidth({settings.bead_width_mm, settings.layer_height_mm});
}

double fillOf(const ScaffoldSettings& settings) {
  if (settings.bead_fill > 0.0) return settings.bead_fill;
  return planWidth({settings.bead_width_mm, settings.layer_height_mm}) / settings.bead_width_mm;
}

}  // namespace

Toolpath filledShape(const std::string& name, const Polygon& outline, const ScaffoldSettings& settings) {
  const Box2 box = boundingBox({outline});
  const Point2 corner(settings.corner_x_mm, settings.corner_y_mm);
  LayerAssembly assembly(settings, corner - box.low, fillOf(settings));
  const std::vector<double> tops = layerTops(settings);
  const auto solid = static_cast<std::size_t>(settings.solid_layers);
  const double pitch = pitchOf(settings);
  for (std::size_t layer = 0; layer < tops.size(); ++layer) {
    const bool is_solid = layer < solid || layer + solid >= tops.size();
    const LayerFill fill{settings, layer, tops[layer], is_solid ? 1.0 : settings.density, pitch};
    std::vector<ScaffoldRun> runs;
    if (settings.perimeters > 0) runs = perimeterRuns({{outline, {}}}, fill);
    std::vector<ScaffoldRun> inner = fillRuns(offset({{outline, {}}}, -settings.perimeters * pitch), fill);
    std::move(inner.begin(), inner.end(), std::back_inserter(runs));
    if (runs.empty())
      throw InvalidConfig("scaffold.bead_width_mm is " + std::to_string(settings.bead_width_mm) +
                          " mm; a shape of " + std::to_string(box.size().x()) + " x " +
                          std::to_string(box.size().y()) + " mm has no room for a bead of that width");
    assembly.add(tops[layer], runs);
  }
  return assembly.finish(name);
}

}  // namespace lamina
