// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/adapted/adapted_surfaces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

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

/// Where the nozzle tip passes.
Mesh tipMesh(const AdaptedLayer& layer, double step_mm) {
  RegionTriangulation region = triangulated(outlinesOf(layer), step_mm);
  std::vector<double> border;
  for (const OutlinePlace& place : region.border) border.push_back(heightAt(layer, place));
  const std::vector<double> heights = harmonicHeights(region, border);
  Mesh mesh;
  for (std::size_t i = 0; i < heights.size(); ++i)
    mesh.vertices.emplace_back(region.points[i].x(), region.points[i].y(), heights[i]);
  mesh.triangles = std::move(region.triangles);
  return mesh;
}

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

/// @param below  none for the lowest layer
LayerSurface surfaceOn(const Mesh* below, double bottom_mm, const Mesh& tip) {
  std::optional<NearestTriangle> places;
  if (below != nullptr) places.emplace(*below);
  LayerSurface surface;
  surface.tip = tip.vertices;
  surface.normal = normalsOf(tip);
  surface.middle = tip;
  for (std::size_t v = 0; v < tip.vertices.size(); ++v) {
    const Point3& point = tip.vertices[v];
    const double height = places ? places->nearest(point).distance_mm : point.z() - bottom_mm;
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
  std::vector<Mesh> tips(layers.layers.size());
  parallelFor(
      tips.size(),
      [&](std::size_t k) {
        try {
          tips[k] = tipMesh(layers.layers[k], step_mm);
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
