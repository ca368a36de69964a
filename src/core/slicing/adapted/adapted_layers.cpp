// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/adapted/adapted_layers.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/moving_average.hpp"
#include "lamina/slicing/unsliceable.hpp"
#include "slicing/adapted/curve_ends.hpp"
#include "slicing/adapted/curve_length.hpp"
#include "slicing/adapted/curve_untangling.hpp"
#include "slicing/adapted/thinnest_bead.hpp"
#include "slicing/adapted/wall_growth.hpp"
#include "slicing/adapted/wall_strand.hpp"

namespace lamina {
namespace {

constexpr double kFlat = 1e-6;           // mm within which a corner lies in the bottom or the top
constexpr double kSteepRounding = 1e-6;  // deg

bool isAt(const Mesh& mesh, const Triangle& corner, double z) {
  return std::all_of(corner.begin(), corner.end(),
                     [&](std::uint32_t v) { return std::abs(mesh.vertices[v].z() - z) <= kFlat; });
}

double leanDeg(const Mesh& mesh, const Triangle& corner) {
  const Point3& a = mesh.vertices[corner[0]];
  const Point3 normal = (mesh.vertices[corner[1]] - a).cross(mesh.vertices[corner[2]] - a);
  return toDegrees(std::atan2(std::abs(normal.z()), normal.head<2>().norm()));
}

/// Refuses a part one of whose faces leans too far from the vertical. The flat bottom and the flat top of
/// the part are no walls and may lie as they do.
/// @throws Unsliceable with those faces, naming the greatest lean and where it is
void requireNoSteepFaces(const Mesh& mesh, double max_lean_deg) {
  const Box3 box = boundingBox(mesh);
  Mesh steep;
  double greatest = 0.0;
  Point3 at = Point3::Zero();
  for (const Triangle& corner : mesh.triangles) {
    if (isAt(mesh, corner, box.low.z()) || isAt(mesh, corner, box.high.z())) continue;
    const double lean = leanDeg(mesh, corner);
    if (lean <= max_lean_deg + kSteepRounding) continue;
    steep.triangles.push_back(corner);
    if (lean <= greatest) continue;
    greatest = lean;
    at = (mesh.vertices[corner[0]] + mesh.vertices[corner[1]] + mesh.vertices[corner[2]]) / 3.0;
  }
  if (steep.triangles.empty()) return;
  steep.vertices = mesh.vertices;
  char message[256];
  std::snprintf(
      message, sizeof message,
      "%zu faces lean more from the vertical than adapted.max_lean_deg = %g deg, most by %.1f deg at "
      "(%.2f, %.2f, %.2f) mm; adapted layers need walls",
      steep.triangles.size(), max_lean_deg, greatest, at.x(), at.y(), at.z());
  throw Unsliceable(message, std::move(steep));
}

constexpr double kCoincident = 1e-6;  // mm
constexpr double kOnTheWay = 1e-3;    // mm
constexpr double kClose = 0.1;        // of a step

void append(AdaptedCurve& curve, const Point3& point, const Point3& axis, double height_mm) {
  curve.points.push_back(point);
  curve.axis.push_back(axis);
  curve.height_mm.push_back(height_mm);
}

double distanceFromChord(const Point3& point, const Point3& from, const Point3& to) {
  const Point3 along = to - from;
  const double length = along.norm();
  if (length <= kCoincident) return (point - from).norm();
  return along.cross(point - from).norm() / length;
}

/// Whether the curve does without a point: it is close to the one before it and on the way to the next.
bool isSpare(const Point3& before, const Point3& point, const Point3& next, double close_mm) {
  const double distance = (point - before).norm();
  return distance <= kCoincident ||
         (distance < close_mm && distanceFromChord(point, before, next) <= kOnTheWay);
}

AdaptedCurve withoutSpare(const AdaptedCurve& curve, double close_mm) {
  AdaptedCurve kept;
  kept.is_closed = curve.is_closed;
  const std::size_t count = curve.points.size();
  append(kept, curve.points[0], curve.axis[0], curve.height_mm[0]);
  for (std::size_t i = 1; i < count; ++i) {
    const bool is_end = i + 1 == count && !curve.is_closed;
    const Point3& next = curve.points[(i + 1) % count];
    if (is_end || !isSpare(kept.points.back(), curve.points[i], next, close_mm))
      append(kept, curve.points[i], curve.axis[i], curve.height_mm[i]);
  }
  if (kept.is_closed && kept.points.size() > 3 &&
      (kept.points.back() - kept.points.front()).norm() <= kCoincident) {
    kept.points.pop_back();
    kept.axis.pop_back();
    kept.height_mm.pop_back();
  }
  return kept;
}

AdaptedCurve filled(const AdaptedCurve& curve, double step_mm) {
  AdaptedCurve dense;
  dense.is_closed = curve.is_closed;
  const std::size_t count = curve.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const bool is_end = next == 0 && !curve.is_closed;
    const double length = is_end ? 0.0 : (curve.points[next] - curve.points[i]).norm();
    const double pieces = std::max(1.0, std::ceil(length / step_mm - 1e-9));
    for (double piece = 0.0; piece < pieces; ++piece) {
      const double share = piece / pieces;
      append(dense, (1.0 - share) * curve.points[i] + share * curve.points[next],
             ((1.0 - share) * curve.axis[i] + share * curve.axis[next]).normalized(),
             (1.0 - share) * curve.height_mm[i] + share * curve.height_mm[next]);
    }
  }
  return dense;
}

/// The curve with its positions averaged over a window and no two points farther apart than the step. The
/// average wraps on a closed curve; on an open one the window shrinks evenly towards the ends. Points
/// within a tenth of a step of the one before them are left out where the curve stays the same within 1 µm.
/// @param smoothing_window  odd; 1 is none
AdaptedCurve finishedCurve(const AdaptedCurve& curve, double step_mm, int smoothing_window) {
  AdaptedCurve finished = withoutSpare(curve, kClose * step_mm);
  if (smoothing_window > 1)
    finished.points = movingAverages(finished.points, finished.is_closed ? Course::Closed : Course::Open,
                                     static_cast<std::size_t>(smoothing_window / 2));
  return filled(finished, step_mm);
}

constexpr double kBelowTop = 1e-6;  // mm: at the very top a plane cuts nothing
constexpr double kMostContours = 1e6;

std::size_t partsOf(double computing_height_mm, double layer_height_mm) {
  if (computing_height_mm == 0.0) return 1;
  const double parts = std::round(computing_height_mm / layer_height_mm);
  if (parts < 1.0 || std::abs(parts * layer_height_mm - computing_height_mm) > 1e-6)
    throw InvalidConfig("adapted.computing_height_mm is " + numberText(computing_height_mm) +
                        " mm; must be a multiple of the layer height of " + numberText(layer_height_mm) +
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
    throw InvalidConfig("the part is " + numberText(top - bottom) + " mm high and a layer " +
                        numberText(steps.other.height_mm) + " mm; expected at most a million layers");
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

/// What the layers of a part are grown from.
struct GrownFrom {
  const Mesh& mesh;
  const std::vector<WallStrand>& strands;
  const GrowthSteps& steps;
  const Finish& finish;
  CornerPath corners;
};

/// @throws Unsliceable as `growWall`, or if curves of a layer cross
AdaptedLayers grownLayers(const GrownFrom& from, Progress& progress) {
  std::vector<std::vector<AdaptedLayer>> walls;
  walls.reserve(from.strands.size());
  for (const WallStrand& strand : from.strands)
    walls.push_back(growWall(from.mesh, strand, from.steps, from.corners, progress));
  AdaptedLayers layers = together(walls, from.finish);
  for (std::size_t k = 0; k < layers.layers.size(); ++k) {
    requireNoCrossing(layers.layers[k].curves, k, from.mesh);
    requireNoCrossing(layers.layers[k].outlines, k, from.mesh);
  }
  return layers;
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
  const std::vector<WallStrand> strands = wallStrands(mesh, heights, settings.step_mm, progress);
  const Finish finish{settings, slicing.layer_height_mm};
  // Along an edge that leans more than the faces beside it layers stay behind, and where edges meet a corner
  // may go on along the other one: a part that is refused for that is sliced with its corners cut off.
  try {
    return grownLayers({mesh, strands, steps, finish, CornerPath::along_edge}, progress);
  } catch (const Unsliceable&) {
    return grownLayers({mesh, strands, steps, finish, CornerPath::nearest_wall}, progress);
  }
}

}  // namespace lamina
