// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh/hull_faces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "lamina/base/angle.hpp"

namespace lamina {
namespace {

constexpr double kOnFace = 1e-9;                // of the size of all points
constexpr double kSamePlane = toRadians(1e-2);  // rad

using Corners = std::array<std::size_t, 3>;

/// A triangle of the hull so far, and the points outside of it that no other has.
struct Facet {
  Corners corners{};
  Point3 normal = Point3::Zero();
  double offset = 0.0;
  std::vector<std::size_t> outside;
  bool is_gone = false;
};

class Quickhull {
 public:
  explicit Quickhull(const std::vector<Point3>& points) : points_(points) {
    Box<Point3> box;
    for (const Point3& point : points) box.include(point);
    tolerance_ = kOnFace * box.size().norm();
  }

  const std::vector<Facet>& facets() {
    if (begin())
      for (std::size_t next = 0; next < facets_.size(); ++next)
        while (!facets_[next].is_gone && !facets_[next].outside.empty()) addFarthestOf(next);
    return facets_;
  }

  double areaOf(const Facet& facet) const {
    return 0.5 * (points_[facet.corners[1]] - points_[facet.corners[0]])
                     .cross(points_[facet.corners[2]] - points_[facet.corners[0]])
                     .norm();
  }

 private:
  using Edge = std::pair<std::size_t, std::size_t>;

  /// What removed facets leave.
  struct Gap {
    std::vector<Edge> horizon;       ///< edges around it
    std::vector<std::size_t> freed;  ///< points outside of them
  };

  double above(const Facet& facet, std::size_t point) const {
    return facet.normal.dot(points_[point]) - facet.offset;
  }

  std::size_t add(const Corners& corners) {
    Facet facet;
    facet.corners = corners;
    const Point3& a = points_[corners[0]];
    facet.normal = (points_[corners[1]] - a).cross(points_[corners[2]] - a).normalized();
    facet.offset = facet.normal.dot(a);
    facets_.push_back(std::move(facet));
    const std::size_t index = facets_.size() - 1;
    for (int i = 0; i < 3; ++i)
      facet_of_[{corners[static_cast<std::size_t>(i)], corners[static_cast<std::size_t>((i + 1) % 3)]}] =
          index;
    return index;
  }

  template <class Measure>
  std::size_t farthest(const Measure& measure) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < points_.size(); ++i)
      if (measure(points_[i]) > measure(points_[best])) best = i;
    return best;
  }

  /// A tetrahedron of points that are far apart; false if there is none.
  bool begin() {
    if (points_.size() < 4) return false;
    const std::size_t a = farthest([](const Point3& p) { return -p.x(); });
    const std::size_t b = farthest([&](const Point3& p) { return (p - points_[a]).squaredNorm(); });
    const Point3 along = points_[b] - points_[a];
    const std::size_t c =
        farthest([&](const Point3& p) { return along.cross(p - points_[a]).squaredNorm(); });
    const Point3 normal = along.cross(points_[c] - points_[a]);
    if (!(normal.norm() > tolerance_ * along.norm())) return false;
    const std::size_t d = farthest([&](const Point3& p) { return std::abs(normal.dot(p - points_[a])); });
    const double height = normal.dot(points_[d] - points_[a]) / normal.norm();
    if (!(std::abs(height) > tolerance_)) return false;
    const auto [first, second] = height > 0.0 ? std::make_pair(c, b) : std::make_pair(b, c);
    add({a, first, second});
    add({a, second, d});
    add({second, first, d});
    add({first, a, d});
    std::vector<std::size_t> all(points_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    share(all, 0);
    return true;
  }

  /// Gives each point to the first facet from `first` on that it lies above; the others are inside.
  void share(const std::vector<std::size_t>& points, std::size_t first) {
    for (const std::size_t point : points)
      for (std::size_t f = first; f < facets_.size(); ++f)
        if (above(facets_[f], point) > tolerance_) {
          facets_[f].outside.push_back(point);
          break;
        }
  }

  void addFarthestOf(std::size_t facet) {
    const std::vector<std::size_t>& outside = facets_[facet].outside;
    const std::size_t apex = *std::max_element(
        outside.begin(), outside.end(),
        [&](std::size_t a, std::size_t b) { return above(facets_[facet], a) < above(facets_[facet], b); });
    Gap gap = removeSeenFrom(apex, facet);
    const std::size_t first = facets_.size();
    for (const auto& [from, to] : gap.horizon) add({from, to, apex});
    gap.freed.erase(std::remove(gap.freed.begin(), gap.freed.end(), apex), gap.freed.end());
    share(gap.freed, first);
  }

  /// Removes what the apex lies above, all of which hangs together.
  Gap removeSeenFrom(std::size_t apex, std::size_t facet) {
    Gap gap;
    std::vector<std::size_t> seen = {facet};
    facets_[facet].is_gone = true;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      Facet& gone = facets_[seen[k]];
      gap.freed.insert(gap.freed.end(), gone.outside.begin(), gone.outside.end());
      gone.outside = {};
      for (int i = 0; i < 3; ++i) {
        const Edge edge{gone.corners[static_cast<std::size_t>(i)],
                        gone.corners[static_cast<std::size_t>((i + 1) % 3)]};
        const std::size_t beside = facet_of_.at({edge.second, edge.first});
        if (facets_[beside].is_gone) continue;
        if (above(facets_[beside], apex) > tolerance_) {
          facets_[beside].is_gone = true;
          seen.push_back(beside);
        }
      }
    }
    for (const std::size_t gone : seen)
      for (int i = 0; i < 3; ++i) {
        const Corners& corners = facets_[gone].corners;
        const Edge edge{corners[static_cast<std::size_t>(i)], corners[static_cast<std::size_t>((i + 1) % 3)]};
        if (!facets_[facet_of_.at({edge.second, edge.first})].is_gone) gap.horizon.push_back(edge);
      }
    return gap;
  }

  const std::vector<Point3>& points_;
  double tolerance_ = 0.0;
  std::vector<Facet> facets_;
  std::map<Edge, std::size_t> facet_of_;  ///< on the left of each directed edge
};

}  // namespace

std::vector<HullFace> hullFaces(const std::vector<Point3>& points) {
  Quickhull hull(points);
  std::vector<HullFace> triangles;
  for (const Facet& facet : hull.facets())
    if (!facet.is_gone && hull.areaOf(facet) > 0.0) triangles.push_back({facet.normal, hull.areaOf(facet)});
  std::stable_sort(triangles.begin(), triangles.end(),
                   [](const HullFace& a, const HullFace& b) { return a.area_mm2 > b.area_mm2; });
  // Only faces of about the same x of their normal can be one.
  std::multimap<double, std::size_t> by_x;
  std::vector<HullFace> faces;
  for (const HullFace& triangle : triangles) {
    const double x = triangle.normal.x();
    auto same = by_x.lower_bound(x - kSamePlane);
    while (same != by_x.end() && same->first <= x + kSamePlane &&
           (faces[same->second].normal - triangle.normal).norm() > kSamePlane)
      ++same;
    if (same != by_x.end() && same->first <= x + kSamePlane) {
      faces[same->second].area_mm2 += triangle.area_mm2;
      continue;
    }
    by_x.emplace(x, faces.size());
    faces.push_back(triangle);
  }
  std::stable_sort(faces.begin(), faces.end(),
                   [](const HullFace& a, const HullFace& b) { return a.area_mm2 > b.area_mm2; });
  return faces;
}

}  // namespace lamina
