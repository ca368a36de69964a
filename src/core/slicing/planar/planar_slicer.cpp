// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/planar/planar_slicer.hpp"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "lamina/base/parallel.hpp"
#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {
namespace {

/// Which triangles cross which horizontal planes, by ranks instead of heights: a vertex of rank r lies above
/// the planes 0 ... r - 1 and on or below the others, so that a triangle crosses the planes from its lowest
/// rank to below its highest.
struct PlaneIndex {
  std::vector<std::uint32_t> rank;       ///< one per vertex
  std::vector<std::size_t> begin;        ///< of plane i's triangles; one more than there are planes
  std::vector<std::uint32_t> triangles;  ///< ascending within each plane

  bool isAbove(std::uint32_t vertex, std::uint32_t plane) const { return rank[vertex] > plane; }
};

/// Number of planes below a height. Guesses by the mean distance, which is right for equal layers, and
/// searches otherwise.
class Ranking {
 public:
  explicit Ranking(const std::vector<double>& heights) : heights_(heights) {
    if (heights.size() > 1 && heights.back() > heights.front())
      planes_per_mm_ = static_cast<double>(heights.size() - 1) / (heights.back() - heights.front());
  }

  std::uint32_t operator()(double z) const {
    if (!(heights_.front() < z)) return 0;
    if (heights_.back() < z) return static_cast<std::uint32_t>(heights_.size());
    const auto guess = static_cast<std::size_t>((z - heights_.front()) * planes_per_mm_);
    for (std::size_t rank = std::max<std::size_t>(guess, 1); rank < std::min(guess + 3, heights_.size());
         ++rank)
      if (heights_[rank - 1] < z && z <= heights_[rank]) return static_cast<std::uint32_t>(rank);
    return static_cast<std::uint32_t>(std::lower_bound(heights_.begin(), heights_.end(), z) -
                                      heights_.begin());
  }

 private:
  const std::vector<double>& heights_;
  double planes_per_mm_ = 0.0;
};

struct RankRange {
  std::uint32_t low;
  std::uint32_t high;
};

RankRange ranksOf(const Triangle& t, const std::vector<std::uint32_t>& rank) {
  const auto [low, high] = std::minmax({rank[t[0]], rank[t[1]], rank[t[2]]});
  return {low, high};
}

/// @param heights  z of the planes [mm], ascending
PlaneIndex indexPlanes(const Mesh& mesh, const std::vector<double>& heights) {
  PlaneIndex index;
  index.begin.assign(heights.size() + 1, 0);
  if (heights.empty()) return index;
  const Ranking ranking(heights);
  index.rank.reserve(mesh.vertices.size());
  for (const Point3& vertex : mesh.vertices) index.rank.push_back(ranking(vertex.z()));

  // Each triangle is counted where it begins and where it ends; the running sum is the number at each plane.
  std::vector<std::int64_t> change(heights.size() + 1, 0);
  for (const Triangle& t : mesh.triangles) {
    const RankRange range = ranksOf(t, index.rank);
    ++change[range.low];
    --change[range.high];
  }
  std::int64_t at_plane = 0;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    at_plane += change[i];
    index.begin[i + 1] = index.begin[i] + static_cast<std::size_t>(at_plane);
  }
  index.triangles.resize(index.begin.back());
  std::vector<std::size_t> end(index.begin.begin(), index.begin.end() - 1);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const RankRange range = ranksOf(mesh.triangles[t], index.rank);
    for (std::uint32_t plane = range.low; plane < range.high; ++plane) index.triangles[end[plane]++] = t;
  }
  return index;
}

/// What a thread needs to trace one plane after another without allocating.
struct Scratch {
  std::vector<std::uint32_t> traced_at;  // per triangle: the last plane it was traced at, plus one
  std::vector<Point2> points;
};

/// Follows the contours of one plane from triangle to triangle. A contour enters a triangle across the
/// half-edge that runs down through the plane and leaves it across the one that runs up, so that material
/// lies on its left.
class SectionTracer {
 public:
  SectionTracer(const Mesh& mesh, const MeshTopology& topology, const PlaneIndex& index, double height,
                std::uint32_t plane)
      : mesh_(mesh), topology_(topology), index_(index), height_(height), plane_(plane) {}

  Section trace(Scratch& scratch) const {
    Section section;
    const std::uint32_t* const first = index_.triangles.data() + index_.begin[plane_];
    const std::uint32_t* const last = index_.triangles.data() + index_.begin[plane_ + 1];
    if (topology_.has_border) {
      for (const std::uint32_t* t = first; t != last; ++t) {
        const HalfEdge entry = entryOf(*t);
        if (topology_.opposite[entry] == kNoHalfEdge) addOpenContour(entry, scratch, section);
      }
    }
    for (const std::uint32_t* t = first; t != last; ++t)
      if (scratch.traced_at[*t] != plane_ + 1) addContour(entryOf(*t), scratch, section);
    return section;
  }

 private:
  HalfEdge entryOf(std::uint32_t triangle) const {
    const Triangle& t = mesh_.triangles[triangle];
    for (std::uint32_t k = 0; k < 2; ++k)
      if (index_.isAbove(t[k], plane_) && !index_.isAbove(t[k + 1], plane_)) return 3 * triangle + k;
    return 3 * triangle + 2;
  }

  HalfEdge exitOf(HalfEdge entry) const {
    const HalfEdge previous = previousInTriangle(entry);
    return index_.isAbove(originOf(mesh_, previous), plane_) ? nextInTriangle(entry) : previous;
  }

  const Point3& originPoint(HalfEdge half_edge) const { return mesh_.vertices[originOf(mesh_, half_edge)]; }

  /// Always computed from the lower vertex, so that a vertex on the plane is met exactly, whichever edge
  /// leads there.
  Point2 crossing(const Point3& low, const Point3& high) const {
    const double part = (height_ - low.z()) / (high.z() - low.z());
    return {low.x() + part * (high.x() - low.x()), low.y() + part * (high.y() - low.y())};
  }

  /// Adds the points from `start` on until the contour returns there or meets a border.
  void follow(HalfEdge start, Scratch& scratch) const {
    std::vector<Point2>& points = scratch.points;
    HalfEdge entry = start;
    do {
      scratch.traced_at[triangleOf(entry)] = plane_ + 1;
      const HalfEdge exit = exitOf(entry);
      const Point2 point = crossing(originPoint(exit), originPoint(nextInTriangle(exit)));
      if (points.empty() || points.back() != point) points.push_back(point);
      entry = topology_.opposite[exit];
    } while (entry != start && entry != kNoHalfEdge);
  }

  void addContour(HalfEdge start, Scratch& scratch, Section& section) const {
    std::vector<Point2>& points = scratch.points;
    points.clear();
    follow(start, scratch);
    while (points.size() > 1 && points.back() == points.front()) points.pop_back();
    const bool has_third = std::any_of(points.begin(), points.end(), [&points](const Point2& point) {
      return point != points[0] && point != points[1];
    });
    if (has_third) section.contours.emplace_back(points);
  }

  void addOpenContour(HalfEdge start, Scratch& scratch, Section& section) const {
    scratch.points.assign(1, crossing(originPoint(nextInTriangle(start)), originPoint(start)));
    follow(start, scratch);
    if (scratch.points.size() > 1) section.open_contours.emplace_back(scratch.points);
  }

  const Mesh& mesh_;
  const MeshTopology& topology_;
  const PlaneIndex& index_;
  double height_;
  std::uint32_t plane_;
};

}  // namespace

std::vector<Section> sliceMesh(const Mesh& mesh, const std::vector<double>& heights, Progress& progress) {
  return sliceMesh(mesh, pairHalfEdges(mesh), heights, progress);
}

std::vector<Section> sliceMesh(const Mesh& mesh, const MeshTopology& topology,
                               const std::vector<double>& heights, Progress& progress) {
  throwIfCancelled(progress, "slice");
  const PlaneIndex index = indexPlanes(mesh, heights);
  std::vector<Section> sections(heights.size());
  tbb::enumerable_thread_specific<Scratch> scratches([&mesh] {
    return Scratch{std::vector<std::uint32_t>(mesh.triangles.size(), 0), {}};
  });
  const auto trace = [&](std::size_t i) {
    const SectionTracer tracer(mesh, topology, index, heights[i], static_cast<std::uint32_t>(i));
    sections[i] = tracer.trace(scratches.local());
  };
  parallelFor(heights.size(), trace, progress, "slice");
  return sections;
}

}  // namespace lamina
