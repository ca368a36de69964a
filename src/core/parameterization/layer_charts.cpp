// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/parameterization/layer_charts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/decimals.hpp"
#include "creases.hpp"
#include "cutting_field.hpp"
#include "geometry/boxes.hpp"
#include "geometry/mesh/area_vector.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/geometry/shortest_rotation.hpp"
#include "lamina/parameterization/distortion.hpp"
#include "lamina/parameterization/flattening.hpp"
#include "lamina/parameterization/layer_surface.hpp"
#include "lamina/parameterization/surface_cut.hpp"
#include "net_curvature.hpp"

namespace lamina {
namespace {

// Vertices may lie off the plane by this share of the surface's size, which changes lengths by its square.
constexpr double kFlatness = 1e-6;

constexpr int kShownDigits = 4;  // of numbers in messages

bool isPlane(const Mesh& surface, const Point3& normal) {
  const Box3 box = boundingBox(surface);
  const double reach = kFlatness * box.size().norm();
  const double level = normal.dot(surface.vertices[surface.triangles[0][0]]);
  for (const Triangle& corner : surface.triangles) {
    for (const std::uint32_t vertex : corner)
      if (std::abs(normal.dot(surface.vertices[vertex]) - level) > reach) return false;
    if (normal.dot(areaVector(surface, corner)) < 0.0) return false;
  }
  return true;
}

/// The parameterization of a surface that is plane already, the same shape to rounding; nothing if it is not
/// plane. A level one keeps its x and y.
std::optional<std::vector<Point2>> planeParameterization(const Mesh& surface) {
  Point3 sum = Point3::Zero();
  for (const Triangle& corner : surface.triangles) sum += areaVector(surface, corner);
  if (!(sum.norm() > 0.0)) return std::nullopt;
  const Point3 normal = sum.normalized();
  if (!isPlane(surface, normal)) return std::nullopt;
  const bool is_level = std::hypot(normal.x(), normal.y()) <= kFlatness && normal.z() > 0.0;
  const Eigen::Matrix3d turn = is_level ? Eigen::Matrix3d(Eigen::Matrix3d::Identity())
                                        : shortestRotation(normal, Point3::UnitZ()).toRotationMatrix();
  std::vector<Point2> parameterization;
  parameterization.reserve(surface.vertices.size());
  for (const Point3& vertex : surface.vertices) parameterization.emplace_back((turn * vertex).head<2>());
  return parameterization;
}

using Complex = std::complex<double>;

// Between charts that were moved [mm].
constexpr double kGap = 10.0;
// Charts are level to this, beyond rounding errors [mm].
constexpr double kLevel = 1e-6;
// A fit that reaches less than this share of a perfect one gives no direction.
constexpr double kLeastFit = 0.05;

std::vector<double> areaOfVertices(const Mesh& mesh) {
  std::vector<double> area(mesh.vertices.size(), 0.0);
  for (const Triangle& corner : mesh.triangles) {
    const Point3 ab = mesh.vertices[corner[1]] - mesh.vertices[corner[0]];
    const Point3 ac = mesh.vertices[corner[2]] - mesh.vertices[corner[0]];
    for (const std::uint32_t vertex : corner) area[vertex] += ab.cross(ac).norm();
  }
  return area;
}

struct Centres {
  Point2 parameters = Point2::Zero();
  Point3 surface = Point3::Zero();
};

Centres centresOf(const LayerChart& chart, const std::vector<double>& weight) {
  Centres centres;
  double sum = 0.0;
  for (std::size_t i = 0; i < weight.size(); ++i) {
    centres.parameters += weight[i] * chart.parameterization[i];
    centres.surface += weight[i] * chart.surface.middle.vertices[i];
    sum += weight[i];
  }
  if (sum > 0.0) {
    centres.parameters /= sum;
    centres.surface /= sum;
  }
  return centres;
}

/// How the parameterization must be turned, a number of length 1.
Complex turnOf(const LayerChart& chart, const std::vector<double>& weight, const Centres& centres) {
  Complex fit = 0.0, towards_x = 0.0, towards_y = 0.0;
  double size = 0.0;
  for (std::size_t i = 0; i < weight.size(); ++i) {
    const Point2 place = chart.parameterization[i] - centres.parameters;
    const Point3 above = chart.surface.middle.vertices[i] - centres.surface;
    const Complex back = weight[i] * Complex(place.x(), -place.y());
    fit += back * Complex(above.x(), above.y());
    towards_x += back * above.x();
    towards_y += back * above.y();
    size += weight[i] * place.squaredNorm();
  }
  Complex turn = fit;
  if (!(std::abs(turn) > kLeastFit * size)) turn = towards_x;
  if (!(std::abs(turn) > kLeastFit * size)) turn = Complex(0.0, 1.0) * towards_y;
  if (!(std::abs(turn) > kLeastFit * size)) return 1.0;
  return turn / std::abs(turn);
}

Box2 boxOf(const LayerChart& chart) { return boundingBox(std::vector<Polygon>{chart.parameterization}); }

/// The height of a chart that is level and lies where its surface does [mm].
std::optional<double> levelOf(const LayerChart& chart) {
  const std::vector<Point3>& vertices = chart.surface.middle.vertices;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (std::abs(vertices[i].z() - vertices[0].z()) > kLevel ||
        (vertices[i].head<2>() - chart.parameterization[i]).norm() > kLevel)
      return std::nullopt;
  return vertices[0].z();
}

/// What a chart takes up of the parameter plane.
struct Ground {
  Box2 box;
  std::optional<double> level;
};

/// Charts of one level do not lie on each other, whatever their boxes do.
bool collide(const Ground& a, const Ground& b) {
  if (a.level && b.level && std::abs(*a.level - *b.level) <= kLevel) return false;
  return areOverlapping(a.box, b.box);
}

/// Turns and moves a parameterization to where the surface lies seen along z: least squares over the area,
/// without mirroring. Where that gives no direction, as below a surface that faces down, the direction in
/// which the surface runs towards x comes to lie along x, or, if it does not run there, the one towards y
/// along y.
void layOverProjection(LayerChart& chart) {
  const std::vector<double> weight = areaOfVertices(chart.surface.middle);
  const Centres centres = centresOf(chart, weight);
  const Complex turn = turnOf(chart, weight, centres);
  for (Point2& place : chart.parameterization) {
    const Complex turned =
        turn * Complex(place.x() - centres.parameters.x(), place.y() - centres.parameters.y());
    place = {turned.real() + centres.surface.x(), turned.imag() + centres.surface.y()};
  }
}

/// Moves parameterizations such that no two of their boxes overlap: those in the way of earlier ones go into
/// rows beyond the others in y, 10 mm apart. Level charts at the same height stay where they are, in each
/// other's holes too.
void moveApart(std::vector<LayerChart>& charts) {
  std::vector<Ground> taken;
  std::vector<LayerChart*> in_the_way;
  Box2 all;
  double moved_area = 0.0;
  for (LayerChart& chart : charts) {
    const Box2 box = boxOf(chart);
    const Ground ground{box, levelOf(chart)};
    if (std::any_of(taken.begin(), taken.end(),
                    [&](const Ground& other) { return collide(ground, other); })) {
      in_the_way.push_back(&chart);
      moved_area += (box.size().x() + kGap) * (box.size().y() + kGap);
      continue;
    }
    taken.push_back(ground);
    all.include(box.low);
    all.include(box.high);
  }
  const double end = all.low.x() + std::max(all.size().x(), std::sqrt(moved_area));
  Point2 free(all.low.x(), all.high.y() + kGap);
  double row_height = 0.0;
  for (LayerChart* chart : in_the_way) {
    const Box2 box = boxOf(*chart);
    if (free.x() > all.low.x() && free.x() + box.size().x() > end) {
      free = {all.low.x(), free.y() + row_height + kGap};
      row_height = 0.0;
    }
    const Point2 shift = free - box.low;
    for (Point2& place : chart->parameterization) place += shift;
    free.x() += box.size().x() + kGap;
    row_height = std::max(row_height, box.size().y());
  }
}

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

/// Whether a parameterization may be used, and if not, why.
struct Verdict {
  bool is_injective = false;  ///< nothing flipped or overlapping
  bool is_true = false;       ///< lengths within the tolerance
  std::string reason;
};

Verdict judge(const Mesh& surface, const std::vector<Point2>& parameterization, double tolerance) {
  const Distortion distortion = measureDistortion(surface, parameterization);
  Verdict verdict;
  if (distortion.flipped > 0) {
    verdict.reason = std::to_string(distortion.flipped) + " of " + std::to_string(surface.triangles.size()) +
                     " triangles are flipped";
    return verdict;
  }
  verdict.is_true =
      distortion.least_stretch >= 1.0 - tolerance && distortion.greatest_stretch <= 1.0 + tolerance;
  verdict.reason = "lengths stretch by factors from " +
                   significantText(distortion.least_stretch, kShownDigits) + " to " +
                   significantText(distortion.greatest_stretch, kShownDigits) + "; expected " +
                   significantText(1.0 - tolerance, kShownDigits) + " to " +
                   significantText(1.0 + tolerance, kShownDigits);
  verdict.is_injective = isInjective(surface, parameterization);
  if (!verdict.is_injective) verdict.reason = "it overlaps itself";
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
  throw InvalidMesh("the layer does not lie flat near (" + significantText(centre.x(), kShownDigits) + ", " +
                    significantText(centre.y(), kShownDigits) + ", " +
                    significantText(centre.z(), kShownDigits) + ") mm: a piece of " +
                    significantText(surfaceArea(piece.surface.middle), kShownDigits) + " mm2 was cut out " +
                    std::to_string(piece.cuts) + " times, and " + reason);
}

bool divide(const Creases& creases) {
  return creases.parts > 1 && creases.parts <= kMostParts &&
         creases.inside <= std::max(creases.curvature, kLittleCurvature);
}

/// The parameterization of a piece that is not plane, if it has one that may be used.
/// @throws InvalidMesh if it has none and was cut too often
std::optional<std::vector<Point2>> parameterizationOf(const Piece& piece, const MeshTopology& topology,
                                                      const Creases& creases,
                                                      const FlatteningSettings& settings) {
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
  std::vector<Point2> parameterization = flatten(mesh, settings);
  const Verdict verdict = judge(mesh, parameterization, settings.tolerance);
  const double area = surfaceArea(mesh);
  if (verdict.is_injective && (verdict.is_true || area <= beadArea(piece.surface))) return parameterization;
  if (is_last) refuse(piece, "in its parameterization " + verdict.reason);
  return std::nullopt;
}

/// What is done of a layer, for all its pieces.
class Ticks {
 public:
  Ticks(double area_mm2, Progress& progress) : area_mm2_(area_mm2), progress_(progress) {}

  /// @throws Cancelled
  void heed() const { throwIfCancelled(progress_, kStage); }

  void finish(double area_mm2) {
    done_mm2_ += area_mm2;
    if (area_mm2_ > 0.0) progress_.report(kStage, std::min(1.0, done_mm2_ / area_mm2_));
  }

 private:
  static constexpr const char* kStage = "flatten";

  double area_mm2_;
  Progress& progress_;
  double done_mm2_ = 0.0;
};

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

void addCharts(Piece piece, const FlatteningSettings& settings, Ticks& ticks,
               std::vector<LayerChart>& charts) {
  ticks.heed();
  const Mesh& mesh = piece.surface.middle;
  const double area_mm2 = surfaceArea(mesh);
  if (area_mm2 <= kNothing) return;
  const MeshTopology topology = pairHalfEdges(mesh);
  Creases creases;
  std::optional<std::vector<Point2>> parameterization;
  if (topology.has_border) parameterization = planeParameterization(mesh);
  if (!parameterization) {
    creases = findCreases(mesh, topology, kLeastPart * beadArea(piece.surface));
    parameterization = parameterizationOf(piece, topology, creases, settings);
  }
  if (parameterization) {
    charts.push_back({std::move(piece.surface), std::move(*parameterization)});
    layOverProjection(charts.back());
    ticks.finish(area_mm2);
    return;
  }
  if (area_mm2 <= kLeastShare * beadArea(piece.surface)) return ticks.finish(area_mm2);
  ticks.heed();
  for (Piece& part : divide(creases) ? cutAlong(creases, piece) : cutInTwo(piece))
    addCharts(std::move(part), settings, ticks, charts);
}

}  // namespace

std::vector<LayerChart> layerCharts(const LayerSurface& layer, const FlatteningSettings& settings,
                                    Progress& progress) {
  Ticks ticks(surfaceArea(layer.middle), progress);
  std::vector<LayerChart> charts;
  for (LayerSurface& piece : connectedPieces(layer))
    addCharts({std::move(piece), 0}, settings, ticks, charts);
  moveApart(charts);
  return charts;
}

std::vector<LayerChart> layerCharts(const LayerSurface& layer, const FlatteningSettings& settings) {
  NoProgress progress;
  return layerCharts(layer, settings, progress);
}

}  // namespace lamina
