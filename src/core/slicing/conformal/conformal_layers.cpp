// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/conformal/conformal_layers.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/mesh/area_vector.hpp"
#include "geometry/spatial/box_tree.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/geometry/mesh/subdivision.hpp"
#include "lamina/geometry/shortest_rotation.hpp"
#include "lamina/parameterization/layer_volume.hpp"
#include "lamina/parameterization/surface_cut.hpp"
#include "lamina/slicing/conformal/facing_surface.hpp"
#include "slicing/curved/unreached_surface.hpp"
#include "slicing/positive_length.hpp"

namespace lamina {
namespace {

/// How much of a face lies open to what comes straight from a direction.
enum class Sight : std::uint8_t { Open, Partial, Hidden };

constexpr const char* kChoosing = "choose faces";

constexpr double kDrawnIn = 1e-3;  // of the way from a corner to the middle
constexpr double kSame = 1e-9;     // of the size of the mesh: no farther before a face is the face itself

using Corners = std::array<Point3, 3>;

/// A mesh turned so that it is seen from above.
class Seen {
 public:
  Seen(const Mesh& mesh, const Point3& direction)
      : mesh_(mesh), turn_(shortestRotation(direction, Point3::UnitZ()).toRotationMatrix()), tree_(boxes()) {
    Box3 all{turn_ * mesh.vertices.front(), turn_ * mesh.vertices.front()};
    for (const Point3& vertex : mesh.vertices) {
      all.low = all.low.cwiseMin(turn_ * vertex);
      all.high = all.high.cwiseMax(turn_ * vertex);
    }
    highest_ = all.high.z();
    same_mm_ = kSame * all.size().norm();
  }

  Corners corners(std::uint32_t face) const {
    const Triangle& corner = mesh_.triangles[face];
    return {turn_ * mesh_.vertices[corner[0]], turn_ * mesh_.vertices[corner[1]],
            turn_ * mesh_.vertices[corner[2]]};
  }

  bool isHidden(const Point3& point) const {
    bool is_hidden = false;
    tree_.visitOverlapping({point, {point.x(), point.y(), highest_}}, [&](std::uint32_t face) {
      is_hidden = is_hidden || liesOver(corners(face), point);
    });
    return is_hidden;
  }

 private:
  std::vector<Box3> boxes() const {
    std::vector<Box3> boxes(mesh_.triangles.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      const Corners at = corners(i);
      boxes[i] = {at[0].cwiseMin(at[1]).cwiseMin(at[2]), at[0].cwiseMax(at[1]).cwiseMax(at[2])};
    }
    return boxes;
  }

  bool liesOver(const Corners& at, const Point3& point) const {
    std::array<double, 3> part{};  // twice the areas of the triangles beside the corners
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3 from = at[(k + 1) % 3] - point;
      const Point3 to = at[(k + 2) % 3] - point;
      part[k] = from.x() * to.y() - from.y() * to.x();
    }
    const auto [least, most] = std::minmax_element(part.begin(), part.end());
    const double whole = part[0] + part[1] + part[2];
    if (whole == 0.0 || (*least < 0.0 && *most > 0.0)) return false;
    const double z = (part[0] * at[0].z() + part[1] * at[1].z() + part[2] * at[2].z()) / whole;
    return z > point.z() + same_mm_;
  }

  const Mesh& mesh_;
  Eigen::Matrix3d turn_;
  BoxTree tree_;
  double highest_ = 0.0;
  double same_mm_ = 0.0;
};

Sight sightOf(const Seen& seen, const Corners& at) {
  const Point3 middle = (at[0] + at[1] + at[2]) / 3.0;
  std::size_t hidden = seen.isHidden(middle) ? 1 : 0;
  for (std::size_t k = 0; k < 3; ++k)
    for (const Point3& point : {at[k], Point3(0.5 * (at[k] + at[(k + 1) % 3]))})
      hidden += seen.isHidden(point + kDrawnIn * (middle - point)) ? 1 : 0;
  constexpr std::size_t kRays = 7;
  if (hidden == 0) return Sight::Open;
  return hidden == kRays ? Sight::Hidden : Sight::Partial;
}

/// Which faces have other faces of the mesh before them, seen from far off in a direction: of each face, rays
/// from its middle, its corners and the middles of its sides, all drawn in by a thousandth. A face within
/// overlapping bodies is hidden by that of the outer one.
///
/// @param faces      of the mesh, none without area
/// @param direction  of unit length; from the mesh to where it is seen from
/// @return for each of the faces; n log n in the faces of the mesh where few lie over each other
/// @throws Cancelled
std::vector<Sight> sightOf(const Mesh& mesh, const TriangleNumbers& faces, const Point3& direction,
                           Progress& progress) {
  if (faces.empty()) return {};
  const Seen seen(mesh, direction);
  std::vector<Sight> sights(faces.size());
  const auto see = [&](std::size_t i) { sights[i] = sightOf(seen, seen.corners(faces[i])); };
  parallelFor(faces.size(), see, progress, kChoosing);
  return sights;
}

// Of a layer: how much of another one a thickness may hold by rounding.
constexpr double kRounding = 1e-9;

Point3 directionOf(const ConformalSettings& settings) {
  if (settings.direction.empty()) return Point3::UnitZ();
  const Point3 direction(settings.direction.at(0), settings.direction.at(1), settings.direction.at(2));
  if (!(direction.norm() > 0.0)) throw InvalidConfig("conformal.direction is 0, 0, 0; expected a direction");
  return direction.normalized();
}

/// The faces that look in the direction.
TriangleNumbers facesTowards(const Mesh& mesh, const ConformalSettings& settings) {
  const Point3 direction = directionOf(settings);
  const double least = std::cos(settings.max_tilt_deg * kDegree) - kRounding;
  TriangleNumbers chosen;
  for (std::uint32_t number = 0; number < mesh.triangles.size(); ++number) {
    const Triangle& corner = mesh.triangles[number];
    const Point3& a = mesh.vertices[corner[0]];
    const Point3 doubled = (mesh.vertices[corner[1]] - a).cross(mesh.vertices[corner[2]] - a);
    if (doubled.norm() > 0.0 && doubled.dot(direction) >= least * doubled.norm()) chosen.push_back(number);
  }
  if (chosen.empty())
    throw Unsliceable("no face looks within " + numberText(settings.max_tilt_deg) +
                          " degrees (conformal.max_tilt_deg) of (" + numberText(direction.x()) + ", " +
                          numberText(direction.y()) + ", " + numberText(direction.z()) +
                          "); there is nothing to lay layers on",
                      mesh);
  return chosen;
}

/// A mesh, and those of its faces that are coated.
struct CoatedFaces {
  Mesh mesh;
  TriangleNumbers faces;
  double hidden_mm2 = 0.0;  ///< of what looks in the direction, below other faces
};

/// The nozzle comes from the direction, and cannot come to what lies below other faces. A mesh with faces
/// that are hidden in part is divided, so that they end where they are.
CoatedFaces coatedFaces(const Mesh& mesh, const ConformalSettings& settings, Progress& progress) {
  const Point3 direction = directionOf(settings);
  CoatedFaces coated{mesh, facesTowards(mesh, settings)};
  std::vector<Sight> sights = sightOf(coated.mesh, coated.faces, direction, progress);
  if (std::count(sights.begin(), sights.end(), Sight::Partial) > 0) {
    coated.mesh = subdivide(mesh, settings.longest_edge_mm).mesh;
    coated.faces = facesTowards(coated.mesh, settings);
    sights = sightOf(coated.mesh, coated.faces, direction, progress);
  }
  TriangleNumbers open;
  for (std::size_t i = 0; i < sights.size(); ++i)
    if (sights[i] == Sight::Open)
      open.push_back(coated.faces[i]);
    else
      coated.hidden_mm2 += triangleArea(coated.mesh, coated.faces[i]);
  if (open.empty())
    throw Unsliceable("all " + numberText(coated.hidden_mm2) +
                          " mm2 of faces that look in conformal.direction lie below others; expected some "
                          "that the nozzle can come to from there",
                      mesh);
  coated.faces = std::move(open);
  return coated;
}

/// No point of the part is farther from the base.
double farthestFrom(const Mesh& base, const Mesh& part) {
  const NearestTriangle nearest(base);
  double farthest = 0.0;
  for (const Triangle& triangle : part.triangles)
    for (const std::uint32_t corner : triangle)
      farthest = std::max(farthest, nearest.nearest(part.vertices[corner]).distance_mm);
  return farthest;
}

LayerSurface insideOf(const SignedDistance& part, const Box3& box, double margin_mm,
                      const LayerSurface& shell) {
  std::vector<double> field;
  field.reserve(shell.middle.vertices.size());
  for (const Point3& vertex : shell.middle.vertices) {
    // Nothing that a triangle with this corner reaches is inside.
    const double beyond = (vertex - vertex.cwiseMax(box.low).cwiseMin(box.high)).norm();
    field.push_back(beyond > margin_mm ? -beyond : part.at(vertex).inside_mm);
  }
  return whereNotNegative(shell, field);
}

void requireFilled(const ConformalLayers& result, const Mesh& part, const Mesh& base,
                   const ConformalSettings& settings) {
  const double gap = 1.0 - result.deposited_mm3 / result.part_mm3;
  if (100.0 * std::abs(gap) <= settings.largest_gap_percent) return;
  TriangleNumbers all(part.triangles.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  Mesh region = patchOf(part, unreached(part, all, base, 2.0 * result.layer_height_mm));
  const double beyond_mm2 = surfaceArea(region);
  throw Unsliceable("layers on the base fill " + numberText(result.deposited_mm3) + " mm³ of the part's " +
                        numberText(result.part_mm3) + " mm³; expected within " +
                        numberText(settings.largest_gap_percent) + " % (conformal.largest_gap_percent). " +
                        numberText(beyond_mm2) +
                        " mm² of its surface lie beyond the base's edges, behind it or beside it",
                    std::move(region));
}

}  // namespace

ConformalLayers coatingLayers(const Mesh& mesh, const ConformalSettings& settings, double layer_height_mm,
                              Progress& progress) {
  requirePositive("slicing.layer_height_mm", layer_height_mm);
  requirePositive("conformal.thickness_mm", settings.thickness_mm);
  const double count = std::ceil(settings.thickness_mm / layer_height_mm - kRounding);
  const CoatedFaces coated = coatedFaces(mesh, settings, progress);
  const Mesh rest = patchOf(coated.mesh, remainder(coated.mesh, coated.faces, {}));
  const SignedDistance part(mesh);
  std::optional<NearestTriangle> nearest_rest;
  if (!rest.triangles.empty()) nearest_rest.emplace(rest);
  ConformalLayers result;
  result.hidden_mm2 = coated.hidden_mm2;
  result.layer_height_mm = settings.thickness_mm / count;
  ShellLimits limits;
  limits.part = &part;
  limits.part_side = PartSide::Outside;
  limits.rest = nearest_rest ? &*nearest_rest : nullptr;
  limits.farthest_mm = settings.thickness_mm;
  limits.step_mm = result.layer_height_mm;
  const ShellPropagation propagation({patchOf(coated.mesh, coated.faces), {}}, settings.longest_edge_mm,
                                     limits, progress);
  result.layers = propagation.shells(result.layer_height_mm, NozzleSide::Ahead, progress);
  result.deposited_mm3 = volume(result.layers);
  return result;
}

ConformalLayers layersOnBase(const Mesh& part, const Mesh& base, const ConformalSettings& settings,
                             double layer_height_mm, Progress& progress) {
  requirePositive("slicing.layer_height_mm", layer_height_mm);
  ConformalLayers result;
  result.layer_height_mm = layer_height_mm;
  result.part_mm3 = volume(part);
  if (!(result.part_mm3 > 0.0))
    throw InvalidMesh("the part holds " + numberText(result.part_mm3) + " mm³; expected a positive volume");
  const ShellSource source{patchOf(base, facesTowards(base, settings)), {}};
  ShellLimits limits;
  limits.farthest_mm = farthestFrom(source.surface, part);
  limits.step_mm = layer_height_mm;
  const ShellPropagation propagation(source, settings.longest_edge_mm, limits, progress);
  const SignedDistance inside(part);
  const Box3 box = boundingBox(part);
  std::vector<LayerSurface> shells = propagation.shells(layer_height_mm, NozzleSide::Ahead, progress);
  const auto cut = [&](std::size_t i) {
    shells[i] = insideOf(inside, box, 4.0 * settings.longest_edge_mm, shells[i]);
  };
  parallelFor(shells.size(), cut, progress, "cut shells");
  for (LayerSurface& shell : shells)
    if (!shell.middle.triangles.empty()) result.layers.push_back(std::move(shell));
  result.deposited_mm3 = volume(result.layers);
  requireFilled(result, part, source.surface, settings);
  return result;
}

}  // namespace lamina
