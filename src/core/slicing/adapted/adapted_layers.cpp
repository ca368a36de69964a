// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/adapted/adapted_layers.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "slicing/adapted/curve_ends.hpp"
#include "slicing/adapted/curve_length.hpp"
#include "slicing/adapted/curve_untangling.hpp"
#include "slicing/adapted/finished_curve.hpp"
#include "slicing/adapted/steep_faces.hpp"
#include "slicing/adapted/thinnest_bead.hpp"
#include "slicing/adapted/wall_growth.hpp"
#include "slicing/adapted/wall_strand.hpp"

namespace lamina {
namespace {

constexpr double kBelowTop = 1e-6;  // mm: at the very top a plane cuts nothing
constexpr double kMostContours = 1e6;

std::size_t partsOf(double computing_height_mm, double layer_height_mm) {
  if (computing_height_mm == 0.0) return 1;
  const double parts = std::round(computing_height_mm / layer_height_mm);
  if (parts < 1.0 || std::abs(parts * layer_height_mm - computing_height_mm) > 1e-6)
    throw InvalidConfig("adapted.computing_height_mm is " + std::to_string(computing_height_mm) +
                        " mm; must be a multiple of the layer height of " + std::to_string(layer_height_mm) +
                        " mm");
  return static_cast<std::size_t>(parts);
}

void requireOdd(int window) {
  if (window % 2 == 0)
    throw InvalidConfig("adapted.smoothing_window is " + std::to_string(window) + "; must be odd");
}

/// Of flat contours: at the bottom, then a step apart, the last just below the top.
std::vector<double> contourHeights(const Box3& box, const GrowthSteps& steps) {
  const double bottom = box.low.z();
  const double top = box.high.z() - kBelowTop;
  const double first = bottom + steps.first.height_mm;
  const double count = std::floor((top - first) / steps.other.height_mm + 1e-6) + 1.0;
  if (!(count < kMostContours))
    throw InvalidConfig("the part is " + std::to_string(top - bottom) + " mm high and a layer " +
                        std::to_string(steps.other.height_mm) + " mm; expected at most a million layers");
  std::vector<double> heights = {bottom};
  for (double k = 0.0; k < count; ++k) heights.push_back(std::min(first + k * steps.other.height_mm, top));
  if (heights.back() < top) heights.push_back(top);
  return heights;
}

/// The loop of a wall in its highest layer up to the k-th.
const AdaptedCurve& loopOf(const std::vector<AdaptedLayer>& wall, std::size_t k) {
  const AdaptedLayer& layer = wall[std::min(k, wall.size() - 1)];
  return layer.outlines.empty() ? layer.curves.front() : layer.outlines.front();
}

bool isClosed(const std::vector<AdaptedLayer>& wall, std::size_t k) {
  return k < wall.size() && wall[k].outlines.empty();
}

/// How curves are run.
struct Finish {
  AdaptedSettings settings;
  double height_mm = 0.0;  ///< of a layer

  /// Leaving out a loop may leave as much of a gap as a layer may (`requireNoGap`), there and back.
  double mostLoop() const { return 2.0 * (2.0 * height_mm + settings.step_mm); }
};

/// Adds the curve as it is run. One shorter than a step, at the tip of a wall that ends in one, is a dot.
void addFinished(std::vector<AdaptedCurve>& curves, const AdaptedCurve& curve, const Finish& finish) {
  if (curve.points.size() < 2) return;
  const AdaptedSettings& settings = finish.settings;
  AdaptedCurve finished =
      withoutSmallLoops(finishedCurve(curve, settings.step_mm, settings.smoothing_window), finish.mostLoop());
  if (finished.points.size() >= 2 && CurveLength(finished).total() >= settings.step_mm)
    curves.push_back(std::move(finished));
}

/// Curves of the same layer of all walls; walls that need fewer layers end earlier.
AdaptedLayers together(const std::vector<std::vector<AdaptedLayer>>& walls, const Finish& finish) {
  AdaptedLayers result;
  for (const auto& wall : walls) result.layers.resize(std::max(result.layers.size(), wall.size()));
  for (std::size_t k = 0; k < result.layers.size(); ++k) {
    AdaptedLayer& layer = result.layers[k];
    for (const auto& wall : walls)
      for (std::size_t c = 0; k < wall.size() && c < wall[k].curves.size(); ++c)
        addFinished(layer.curves, withoutThinEnds(wall[k].curves[c], kThinnest * finish.height_mm), finish);
    if (std::all_of(walls.begin(), walls.end(), [k](const auto& wall) { return isClosed(wall, k); }))
      continue;
    for (const auto& wall : walls) addFinished(layer.outlines, loopOf(wall, k), finish);
  }
  while (!result.layers.empty() && result.layers.back().curves.empty()) result.layers.pop_back();
  const auto first_open = std::find_if(result.layers.begin(), result.layers.end(),
                                       [](const AdaptedLayer& layer) { return !layer.outlines.empty(); });
  result.completing = static_cast<std::size_t>(result.layers.end() - first_open);
  return result;
}

}  // namespace

AdaptedLayers adaptedLayers(const Mesh& mesh, const SlicingSettings& slicing, const AdaptedSettings& settings,
                            Progress& progress) {
  requireOdd(settings.smoothing_window);
  const std::size_t parts = partsOf(settings.computing_height_mm, slicing.layer_height_mm);
  const GrowthSteps steps{{slicing.first_layer_height_mm, 1},
                          {slicing.layer_height_mm * static_cast<double>(parts), parts},
                          settings.step_mm};
  if (mesh.triangles.empty()) throw InvalidMesh("the mesh has 0 triangles; expected a closed part");
  requireNoSteepFaces(mesh, settings.max_lean_deg);
  const std::vector<double> heights = contourHeights(boundingBox(mesh), steps);
  std::vector<std::vector<AdaptedLayer>> walls;
  for (const WallStrand& strand : wallStrands(mesh, heights, settings.step_mm, progress))
    walls.push_back(growWall(mesh, strand, steps, progress));
  AdaptedLayers layers = together(walls, {settings, slicing.layer_height_mm});
  for (std::size_t k = 0; k < layers.layers.size(); ++k) {
    requireNoCrossing(layers.layers[k].curves, k, mesh);
    requireNoCrossing(layers.layers[k].outlines, k, mesh);
  }
  return layers;
}

}  // namespace lamina
