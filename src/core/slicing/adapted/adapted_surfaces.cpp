// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/adapted/adapted_surfaces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/layer_error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/region_triangulation.hpp"
#include "lamina/geometry/spatial/nearest_triangle.hpp"
#include "lamina/parameterization/surface_cut.hpp"
#include "slicing/adapted/harmonic_heights.hpp"
#include "slicing/adapted/thinnest_bead.hpp"

namespace lamina {
namespace {

const std::vector<AdaptedCurve>& loopsOf(const AdaptedLayer& layer) {
  return layer.outlines.empty() ? layer.curves : layer.outlines;
}

std::vector<Polygon> outlinesOf(const AdaptedLayer& layer) {
  std::vector<Polygon> outlines;
  for (const AdaptedCurve& curve : loopsOf(layer)) {
    Polygon outline;
    for (const Point3& point : curve.points) outline.emplace_back(point.head<2>());
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

double heightAt(const AdaptedLayer& layer, const OutlinePlace& place) {
  const std::vector<Point3>& points = loopsOf(layer)[place.outline].points;
  return (1.0 - place.fraction) * points[place.segment].z() +
         place.fraction * points[(place.segment + 1) % points.size()].z();
}

/// The way level from a place on a loop to the tip of a layer whose middle lies on the wall there: down the
/// wall by half the layer, and from there up again across the layer, which need not be level.
Point2 wayToRim(const AdaptedLayer& layer, const OutlinePlace& place, const Point3& normal) {
  const AdaptedCurve& loop = loopsOf(layer)[place.outline];
  const auto ofPoint = [&](std::size_t i) -> Point2 {
    const Point3& axis = loop.axis[i];
    return 0.5 * loop.height_mm[i] * (normal.dot(axis) * normal - axis).head<2>();
  };
  return (1.0 - place.fraction) * ofPoint(place.segment) +
         place.fraction * ofPoint((place.segment + 1) % loop.points.size());
}

constexpr double kFlatArea = 1e-9;  // mm2, twice that of a triangle: what rounding leaves of one that is flat

double signedArea(const Mesh& mesh, const Triangle& corner) {
  const Point2 a = mesh.vertices[corner[0]].head<2>();
  return cross(mesh.vertices[corner[1]].head<2>() - a, mesh.vertices[corner[2]].head<2>() - a);
}

/// Whether a triangle has been turned over by moving vertices. Slivers that were flat before do not count.
bool isFolded(const Mesh& moved, const Mesh& before) {
  return std::any_of(moved.triangles.begin(), moved.triangles.end(), [&](const Triangle& corner) {
    const double area = signedArea(moved, corner);
    return area < -kFlatArea || (area <= 0.0 && signedArea(before, corner) > 0.0);
  });
}

/// Where the nozzle tip passes, and across it.
struct TipSurface {
  Mesh mesh;
  std::vector<Point3> normals;
};

/// Sums of one value per vertex over the corners of each triangle, added up at each of its corners.
template <class OfTriangle>
std::vector<Point3> gathered(const Mesh& mesh, const OfTriangle& ofTriangle) {
  std::vector<Point3> sums(mesh.vertices.size(), Point3::Zero());
  for (const Triangle& corner : mesh.triangles) {
    const Point3 value = ofTriangle(corner);
    for (const std::uint32_t v : corner) sums[v] += value;
  }
  return sums;
}

/// By area, of the triangles round a vertex and round its neighbours: a vertex of the border may have but one
/// triangle, too thin to have a direction.
std::vector<Point3> normalsOf(const Mesh& mesh) {
  const std::vector<Point3> near = gathered(mesh, [&mesh](const Triangle& corner) {
    const Point3& a = mesh.vertices[corner[0]];
    return Point3((mesh.vertices[corner[1]] - a).cross(mesh.vertices[corner[2]] - a));
  });
  std::vector<Point3> normals = gathered(mesh, [&near](const Triangle& corner) {
    return Point3(near[corner[0]] + near[corner[1]] + near[corner[2]]);
  });
  for (Point3& normal : normals) normal.normalize();
  return normals;
}

/// Across the layer: where a wall leans outwards, the rim reaches out over the layer below, and the way back
/// to it is longer than the layer is high.
double heightOver(const NearestTriangle& below, const Point3& point, const Point3& normal) {
  return std::max(0.0, normal.dot(point - below.nearest(point).point));
}

/// The curves lie at the layer's top. Bounded by them, it would lack a wedge along all walls that lean
/// inwards, and stick out of those that lean outwards: its rim is moved to where the wall is half way down.
TipSurface tipSurface(const AdaptedLayer& layer, double step_mm) {
  RegionTriangulation region = triangulated(outlinesOf(layer), step_mm);
  std::vector<double> border;
  for (const OutlinePlace& place : region.border) border.push_back(heightAt(layer, place));
  const std::vector<double> heights = harmonicHeights(region, border);
  TipSurface tip;
  for (std::size_t i = 0; i < heights.size(); ++i)
    tip.mesh.vertices.emplace_back(region.points[i].x(), region.points[i].y(), heights[i]);
  tip.mesh.triangles = std::move(region.triangles);
  tip.normals = normalsOf(tip.mesh);
  Mesh moved = tip.mesh;
  for (std::size_t i = 0; i < region.border.size(); ++i)
    moved.vertices[i].head<2>() += wayToRim(layer, region.border[i], tip.normals[i]);
  // At sharp edges and where points lie close together the rim may pass its neighbours: it stays there.
  if (!isFolded(moved, tip.mesh)) tip.mesh = std::move(moved);
  return tip;
}

/// @param below  none for the lowest layer
LayerSurface surfaceOn(const TipSurface* below, double bottom_mm, const TipSurface& tip) {
  std::optional<NearestTriangle> ground;
  if (below != nullptr) ground.emplace(below->mesh);
  LayerSurface surface;
  surface.tip = tip.mesh.vertices;
  surface.normal = tip.normals;
  surface.middle = tip.mesh;
  for (std::size_t v = 0; v < surface.tip.size(); ++v) {
    const Point3& point = surface.tip[v];
    const double height = ground ? heightOver(*ground, point, surface.normal[v]) : point.z() - bottom_mm;
    surface.height_mm.push_back(height);
    surface.middle.vertices[v] = point - 0.5 * height * surface.normal[v];
  }
  return surface;
}

/// What is left of a layer that lies on the one below it in parts.
LayerSurface whereThick(const LayerSurface& surface, const AdaptedLayer& layer) {
  double most = 0.0;
  for (const AdaptedCurve& curve : layer.curves)
    most = std::max(most, *std::max_element(curve.height_mm.begin(), curve.height_mm.end()));
  std::vector<double> room = surface.height_mm;
  for (double& height : room) height -= kThinnest * most;
  return whereNotNegative(surface, room);
}

double highestTip(const AdaptedLayer& layer) {
  double highest_mm = -std::numeric_limits<double>::infinity();
  for (const AdaptedCurve& curve : layer.curves)
    for (const Point3& point : curve.points) highest_mm = std::max(highest_mm, point.z());
  return highest_mm;
}

}  // namespace

std::vector<LayerSurface> adaptedSurfaces(const AdaptedLayers& layers, double bottom_mm, double step_mm,
                                          Progress& progress) {
  std::vector<TipSurface> tips(layers.layers.size());
  parallelFor(
      tips.size(),
      [&](std::size_t k) {
        try {
          tips[k] = tipSurface(layers.layers[k], step_mm);
        } catch (...) {
          rethrowAt(layerPlace(k, highestTip(layers.layers[k])));
        }
      },
      progress, "span");
  std::vector<LayerSurface> surfaces(tips.size());
  parallelFor(
      tips.size(),
      [&](std::size_t k) {
        surfaces[k] = surfaceOn(k > 0 ? &tips[k - 1] : nullptr, bottom_mm, tips[k]);
        if (!layers.layers[k].outlines.empty()) surfaces[k] = whereThick(surfaces[k], layers.layers[k]);
      },
      progress, "thickness");
  return surfaces;
}

}  // namespace lamina
