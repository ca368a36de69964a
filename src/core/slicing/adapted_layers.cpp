// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/adapted_layers.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "slicing/finished_curve.hpp"
#include "slicing/steep_faces.hpp"
#include "slicing/wall_growth.hpp"
#include "slicing/wall_strand.hpp"

namespace lamina {
namespace {

constexpr double kBeneathTop = 1e-6;  // mm: at the very top a plane cuts nothing
constexpr double kMostLevels = 1e6;

/// What is computed: levels and the steps between them.
struct GrowthPlan {
  std::vector<double> heights;  // of the flat contours, the last just beneath the top
  std::vector<GrowthStep>
      steps;  // one per flat contour above the lowest, but for a last one that is only the top
  std::vector<GrowthStep> completing;
};

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

GrowthPlan planFor(const Box3& box, const SlicingSettings& slicing, std::size_t parts) {
  const double fine = slicing.layer_height_mm;
  const GrowthStep step{fine * static_cast<double>(parts), parts};
  const double bottom = box.low.z();
  const double top = box.high.z() - kBeneathTop;
  if (!((top - bottom) / step.height_mm < kMostLevels))
    throw InvalidConfig("the part is " + std::to_string(top - bottom) + " mm high and a layer " +
                        std::to_string(step.height_mm) + " mm; expected at most a million layers");
  GrowthPlan plan;
  plan.heights = {bottom};
  for (double z = bottom + slicing.first_layer_height_mm; z <= top + 2.0 * kBeneathTop;
       z = bottom + slicing.first_layer_height_mm + static_cast<double>(plan.steps.size()) * step.height_mm) {
    plan.heights.push_back(std::min(z, top));
    plan.steps.push_back(plan.steps.empty() ? GrowthStep{slicing.first_layer_height_mm, 1} : step);
  }
  if (plan.heights.back() < top) plan.heights.push_back(top);
  plan.completing = {step};
  if (parts > 1) plan.completing.push_back({fine, 1});
  return plan;
}

/// Curves of the same layer of all walls; walls that need fewer layers for their top end earlier.
AdaptedLayers together(std::vector<WallGrowth> walls, const AdaptedSettings& settings) {
  AdaptedLayers result;
  for (WallGrowth& wall : walls) {
    result.layers.resize(std::max(result.layers.size(), wall.layers.size()));
    result.completing = std::max(result.completing, wall.completing);
    for (std::size_t k = 0; k < wall.layers.size(); ++k)
      for (const AdaptedCurve& curve : wall.layers[k])
        result.layers[k].curves.push_back(finishedCurve(curve, settings.step_mm, settings.smoothing_window));
  }
  return result;
}

}  // namespace

AdaptedLayers adaptedLayers(const Mesh& mesh, const SlicingSettings& slicing, const AdaptedSettings& settings,
                            Progress& progress) {
  requireOdd(settings.smoothing_window);
  const std::size_t parts = partsOf(settings.computing_height_mm, slicing.layer_height_mm);
  if (mesh.triangles.empty()) throw InvalidMesh("the mesh has 0 triangles; expected a closed part");
  requireNoSteepFaces(mesh, settings.max_lean_deg);
  const GrowthPlan plan = planFor(boundingBox(mesh), slicing, parts);
  std::vector<WallGrowth> walls;
  for (const WallStrand& strand : wallStrands(mesh, plan.heights, settings.step_mm, progress))
    walls.push_back(growWall(strand, plan.steps, plan.completing, progress));
  return together(std::move(walls), settings);
}

}  // namespace lamina
