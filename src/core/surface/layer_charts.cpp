// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/surface/layer_charts.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_topology.hpp"
#include "lamina/surface/flattening.hpp"
#include "lamina/surface/plan_distortion.hpp"
#include "lamina/surface/surface_cut.hpp"
#include "surface/chart_placement.hpp"
#include "surface/cutting_field.hpp"
#include "surface/plane_plan.hpp"

namespace lamina {
namespace {

// A bead is about two layer heights wide.
constexpr double kBeadWidths = 2.0;
constexpr int kDeepestCut = 20;

/// A piece of the layer, and how often it was cut out of a larger one.
struct Piece {
  LayerSurface surface;
  int cuts = 0;
};

std::string written(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.4g", value);
  return digits;
}

/// Whether a plan may be used, and if not, why.
struct Verdict {
  bool is_plan = false;  ///< nothing flipped or overlapping
  bool is_true = false;  ///< lengths within the tolerance
  std::string reason;
};

Verdict judge(const Mesh& surface, const std::vector<Point2>& plan, double tolerance) {
  const PlanDistortion distortion = measureDistortion(surface, plan);
  Verdict verdict;
  if (distortion.flipped > 0) {
    verdict.reason = std::to_string(distortion.flipped) + " of " + std::to_string(surface.triangles.size()) +
                     " triangles are flipped";
    return verdict;
  }
  verdict.is_true =
      distortion.least_stretch >= 1.0 - tolerance && distortion.greatest_stretch <= 1.0 + tolerance;
  verdict.reason = "lengths stretch by factors from " + written(distortion.least_stretch) + " to " +
                   written(distortion.greatest_stretch) + "; expected " + written(1.0 - tolerance) + " to " +
                   written(1.0 + tolerance);
  verdict.is_plan = isInjective(surface, plan);
  if (!verdict.is_plan) verdict.reason = "it overlaps itself";
  return verdict;
}

bool isBeadSized(const LayerSurface& piece) {
  double height = 0.0;
  for (const double one : piece.height_mm) height = std::max(height, one);
  const double width = kBeadWidths * height;
  return surfaceArea(piece.middle) <= width * width;
}

/// The piece's plan, if it has one that may be used.
/// @throws InvalidMesh if it has none and is too small to be cut
std::optional<std::vector<Point2>> planOf(const Piece& piece, const FlatteningSettings& settings) {
  const Mesh& mesh = piece.surface.middle;
  if (!pairHalfEdges(mesh).has_border) return std::nullopt;
  if (auto plan = planOfPlane(mesh)) return plan;
  std::vector<Point2> plan = flatten(mesh, settings);
  const Verdict verdict = judge(mesh, plan, settings.tolerance);
  if (verdict.is_plan && verdict.is_true) return plan;
  const bool is_small = isBeadSized(piece.surface);
  if (verdict.is_plan && is_small) return plan;
  if (!is_small && piece.cuts < kDeepestCut) return std::nullopt;
  const Box3 box = boundingBox(mesh);
  throw InvalidMesh("the layer does not lie flat near (" + written(box.centre().x()) + ", " +
                    written(box.centre().y()) + ", " + written(box.centre().z()) + ") mm: a piece of " +
                    written(surfaceArea(mesh)) + " mm2 was cut out " + std::to_string(piece.cuts) +
                    " times and in its plan " + verdict.reason);
}

/// Both sides of the zero line of the cutting field, in connected pieces.
std::vector<Piece> cutInTwo(const Piece& piece) {
  std::vector<double> field = cuttingField(piece.surface.middle);
  std::vector<Piece> parts;
  for (int side = 0; side < 2; ++side) {
    for (LayerSurface& part : connectedPieces(whereNotNegative(piece.surface, field)))
      parts.push_back({std::move(part), piece.cuts + 1});
    for (double& value : field) value = -value;
  }
  return parts;
}

void addCharts(Piece piece, const FlatteningSettings& settings, std::vector<LayerChart>& charts) {
  if (auto plan = planOf(piece, settings)) {
    charts.push_back({std::move(piece.surface), std::move(*plan)});
    layOverProjection(charts.back());
    return;
  }
  for (Piece& part : cutInTwo(piece)) addCharts(std::move(part), settings, charts);
}

}  // namespace

std::vector<LayerChart> layerCharts(const LayerSurface& layer, const FlatteningSettings& settings) {
  std::vector<LayerChart> charts;
  for (LayerSurface& piece : connectedPieces(layer)) addCharts({std::move(piece), 0}, settings, charts);
  moveApart(charts);
  return charts;
}

}  // namespace lamina
