// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/parameterization/layer_charts.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/parameterization/distortion.hpp"
#include "lamina/parameterization/flattening.hpp"
#include "lamina/parameterization/surface_cut.hpp"
#include "parameterization/chart_placement.hpp"
#include "parameterization/creases.hpp"
#include "parameterization/cutting_field.hpp"
#include "parameterization/net_curvature.hpp"
#include "parameterization/plane_chart.hpp"

namespace lamina {
namespace {

// A bead is about two layer heights wide.
constexpr double kBeadWidths = 2.0;
// Pieces this small as a share of a bead's square, in which no bead finds room, are not cut any more.
constexpr double kLeastShare = 0.1;
constexpr int kDeepestCut = 30;
// Net curvature by that which a cap may have: longer patches may have more.
constexpr double kFarTooRound = 1.3;
// Creases are where to cut if parts between them hold less curvature than the creases, or this little [rad],
// and if they divide a piece into no more parts: more are facets of a round surface.
constexpr double kLittleCurvature = 0.05;
constexpr std::uint32_t kMostParts = 24;
// Parts between creases smaller than this share of a bead's square are none.
constexpr double kLeastPart = 0.01;
// A piece with so much curvature on creases is cut at them without trying to flatten it [rad].
constexpr double kSharplyCreased = 2.0;
// Pieces without area are left out [mm²].
constexpr double kNothing = 1e-9;

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
  const Distortion distortion = measureDistortion(surface, plan);
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

/// Of a square as wide as a bead [mm²].
double beadArea(const LayerSurface& piece) {
  double height = 0.0;
  for (const double one : piece.height_mm) height = std::max(height, one);
  return kBeadWidths * height * kBeadWidths * height;
}

[[noreturn]] void refuse(const Piece& piece, const std::string& reason) {
  const Point3 centre = boundingBox(piece.surface.middle).centre();
  throw InvalidMesh("the layer does not lie flat near (" + written(centre.x()) + ", " + written(centre.y()) +
                    ", " + written(centre.z()) + ") mm: a piece of " +
                    written(surfaceArea(piece.surface.middle)) + " mm2 was cut out " +
                    std::to_string(piece.cuts) + " times, and " + reason);
}

bool divide(const Creases& creases) {
  return creases.parts > 1 && creases.parts <= kMostParts &&
         creases.inside <= std::max(creases.curvature, kLittleCurvature);
}

/// The plan of a piece that is not plane, if it has one that may be used.
/// @throws InvalidMesh if it has none and was cut too often
std::optional<std::vector<Point2>> planOf(const Piece& piece, const MeshTopology& topology,
                                          const Creases& creases, const FlatteningSettings& settings) {
  const Mesh& mesh = piece.surface.middle;
  const bool is_last = piece.cuts >= kDeepestCut;
  if (!topology.has_border) {
    if (is_last) refuse(piece, "still has no border");
    return std::nullopt;
  }
  // Flattening takes long; a piece far too round or creased for it is cut at once.
  if (!is_last && divide(creases) && creases.curvature > kSharplyCreased) return std::nullopt;
  const double too_round = kFarTooRound * greatestFlatCurvature(settings.tolerance);
  if (!is_last && netCurvature(mesh, topology) > too_round) return std::nullopt;
  std::vector<Point2> plan = flatten(mesh, settings);
  const Verdict verdict = judge(mesh, plan, settings.tolerance);
  const double area = surfaceArea(mesh);
  if (verdict.is_plan && (verdict.is_true || area <= beadArea(piece.surface))) return plan;
  if (is_last) refuse(piece, "in its plan " + verdict.reason);
  return std::nullopt;
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

std::vector<Piece> cutAlong(const Creases& creases, const Piece& piece) {
  std::vector<std::vector<std::uint32_t>> triangles(creases.parts);
  for (std::uint32_t t = 0; t < creases.part.size(); ++t) triangles[creases.part[t]].push_back(t);
  std::vector<Piece> parts;
  parts.reserve(creases.parts);
  for (const std::vector<std::uint32_t>& part : triangles)
    parts.push_back({pieceOf(piece.surface, part), piece.cuts + 1});
  return parts;
}

void addCharts(Piece piece, const FlatteningSettings& settings, std::vector<LayerChart>& charts) {
  const Mesh& mesh = piece.surface.middle;
  if (surfaceArea(mesh) <= kNothing) return;
  const MeshTopology topology = pairHalfEdges(mesh);
  Creases creases;
  std::optional<std::vector<Point2>> plan;
  if (topology.has_border) plan = planeParameterization(mesh);
  if (!plan) {
    creases = findCreases(mesh, topology, kLeastPart * beadArea(piece.surface));
    plan = planOf(piece, topology, creases, settings);
  }
  if (plan) {
    charts.push_back({std::move(piece.surface), std::move(*plan)});
    layOverProjection(charts.back());
    return;
  }
  if (surfaceArea(mesh) <= kLeastShare * beadArea(piece.surface)) return;
  for (Piece& part : divide(creases) ? cutAlong(creases, piece) : cutInTwo(piece))
    addCharts(std::move(part), settings, charts);
}

}  // namespace

std::vector<LayerChart> layerCharts(const LayerSurface& layer, const FlatteningSettings& settings) {
  std::vector<LayerChart> charts;
  for (LayerSurface& piece : connectedPieces(layer)) addCharts({std::move(piece), 0}, settings, charts);
  moveApart(charts);
  return charts;
}

}  // namespace lamina
