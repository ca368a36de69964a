// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/conformal/hidden_faces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>

#include "geometry/spatial/box_tree.hpp"

namespace lamina {
namespace {

constexpr double kDrawnIn = 1e-3;  // of the way from a corner to the middle
constexpr double kSame = 1e-9;     // of the size of the mesh: no farther before a face is the face itself

using Corners = std::array<Point3, 3>;

/// A mesh turned so that it is seen from above.
class Seen {
 public:
  Seen(const Mesh& mesh, const Point3& direction)
      : mesh_(mesh),
        turn_(Eigen::Quaterniond::FromTwoVectors(direction, Point3::UnitZ()).toRotationMatrix()),
        tree_(boxes()) {
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

}  // namespace

std::vector<Sight> sightOf(const Mesh& mesh, const TriangleNumbers& faces, const Point3& direction) {
  std::vector<Sight> sights;
  if (faces.empty()) return sights;
  const Seen seen(mesh, direction);
  sights.reserve(faces.size());
  for (const std::uint32_t face : faces) sights.push_back(sightOf(seen, seen.corners(face)));
  return sights;
}

}  // namespace lamina
