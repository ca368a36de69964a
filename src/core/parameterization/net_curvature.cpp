// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameterization/net_curvature.hpp"
#include "geometry/space_vectors.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

namespace lamina {
namespace {

double angleAt(const Mesh& mesh, HalfEdge corner) {
  const Point3& at = mesh.vertices[originOf(mesh, corner)];
  const Point3 one = mesh.vertices[originOf(mesh, nextInTriangle(corner))] - at;
  const Point3 other = mesh.vertices[originOf(mesh, previousInTriangle(corner))] - at;
  return angleBetween(one, other);
}

}  // namespace

std::vector<double> insideCurvature(const Mesh& mesh, const MeshTopology& topology) {
  std::vector<double> lacking(mesh.vertices.size(), 2.0 * M_PI);
  std::vector<char> is_inside(mesh.vertices.size(), 1);
  const auto half_edges = static_cast<HalfEdge>(3 * mesh.triangles.size());
  for (HalfEdge side = 0; side < half_edges; ++side) {
    lacking[originOf(mesh, side)] -= angleAt(mesh, side);
    if (topology.opposite[side] != kNoHalfEdge) continue;
    is_inside[originOf(mesh, side)] = 0;
    is_inside[originOf(mesh, nextInTriangle(side))] = 0;
  }
  for (std::size_t i = 0; i < lacking.size(); ++i)
    if (!is_inside[i]) lacking[i] = 0.0;
  return lacking;
}

double netCurvature(const Mesh& mesh, const MeshTopology& topology) {
  const std::vector<double> curvature = insideCurvature(mesh, topology);
  return std::accumulate(curvature.begin(), curvature.end(), 0.0);
}

double greatestFlatCurvature(double tolerance) {
  const double stretch = (1.0 + tolerance) / (1.0 - tolerance);
  double low = 0.0;
  double high = M_PI;
  for (int i = 0; i < 50; ++i) {
    const double t = 0.5 * (low + high);
    (t < stretch * std::sin(t) ? low : high) = t;
  }
  return 2.0 * M_PI * (1.0 - std::cos(low));
}

}  // namespace lamina
