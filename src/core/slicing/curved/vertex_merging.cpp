// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/curved/vertex_merging.hpp"

#include <algorithm>

namespace lamina {
namespace {

// Of the edge between them: how far a vertex may collapse from the path of the edge that takes it in.
constexpr double kSameVertex = 2.0;
// Of the offset: how inexact collapses are known.
constexpr double kSlack = 0.03;
// Per millimetre of edge: how much later a neighbour collapses at most where the surface is smooth [mm].
constexpr double kSteepest = 4.0;

class Merging {
 public:
  Merging(const MovingSurface& moving, double offset_mm)
      : moving_(moving),
        offset_(offset_mm),
        result_{std::vector<std::uint32_t>(moving.collapse_mm.size(), MergedVertices::kGone),
                std::vector<Point3>(moving.collapse_mm.size()),
                std::vector<char>(moving.collapse_mm.size(), 0)} {}

  MergedVertices run() && {
    for (std::uint32_t vertex = 0; vertex < result_.root.size(); ++vertex)
      if (isLiving(vertex)) {
        result_.root[vertex] = vertex;
        result_.place[vertex] = moving_.at(vertex, offset_);
      }
    mergeIntoEdges();
    stopBesideLiving();
    mergeTheRest();
    return std::move(result_);
  }

 private:
  bool isLiving(std::uint32_t vertex) const { return moving_.collapse_mm[vertex] >= offset_; }
  bool isOpen(std::uint32_t vertex) const { return result_.root[vertex] == MergedVertices::kGone; }

  bool collapsesOn(std::uint32_t vertex, std::uint32_t on_edge, std::uint32_t from) const {
    if (moving_.motions[vertex].planes >= moving_.motions[on_edge].planes) return false;
    const double collapse = moving_.collapse_mm[vertex];
    const double apart = (moving_.at(vertex, collapse) - moving_.at(on_edge, collapse)).norm();
    const double step = (moving_.surface.vertices[vertex] - moving_.surface.vertices[from]).norm();
    return apart <= kSameVertex * step + kSlack * collapse * moving_.motions[on_edge].per_mm.norm();
  }

  void mergeIntoEdges() {
    std::vector<std::uint32_t> queue;
    for (std::uint32_t vertex = 0; vertex < result_.root.size(); ++vertex)
      if (isLiving(vertex) && moving_.motions[vertex].planes > 1) queue.push_back(vertex);
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (const std::uint32_t next : moving_.neighbours.of(queue[i])) {
        if (!isOpen(next) || !collapsesOn(next, result_.root[queue[i]], queue[i])) continue;
        result_.root[next] = result_.root[queue[i]];
        queue.push_back(next);
      }
  }

  void stopBesideLiving() {
    for (std::uint32_t vertex = 0; vertex < result_.root.size(); ++vertex) {
      if (!isOpen(vertex)) continue;
      Point3 sum = Point3::Zero();
      double count = 0.0;
      for (const std::uint32_t next : moving_.neighbours.of(vertex))
        if (isLiving(next)) {
          sum += crossing(next, vertex);
          ++count;
        }
      if (count == 0.0) continue;
      result_.root[vertex] = vertex;
      result_.place[vertex] = sum / count;
      result_.is_stopped[vertex] = 1;
    }
  }

  /// The place on an edge that collapses at this offset.
  Point3 crossing(std::uint32_t living, std::uint32_t collapsed) const {
    const double edge = (moving_.surface.vertices[living] - moving_.surface.vertices[collapsed]).norm();
    const double spare = std::min(moving_.collapse_mm[living] - offset_, kSteepest * edge);
    const double missing = offset_ - moving_.collapse_mm[collapsed];
    const double t = spare / (spare + missing);
    const Point3 from = moving_.at(living, offset_);
    return from + t * (moving_.at(collapsed, offset_) - from);
  }

  void mergeTheRest() {
    std::vector<std::uint32_t> queue;
    for (std::uint32_t vertex = 0; vertex < result_.root.size(); ++vertex)
      if (!isOpen(vertex)) queue.push_back(vertex);
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (const std::uint32_t next : moving_.neighbours.of(queue[i])) {
        if (!isOpen(next)) continue;
        result_.root[next] = result_.root[queue[i]];
        queue.push_back(next);
      }
  }

  const MovingSurface& moving_;
  double offset_;
  MergedVertices result_;
};

}  // namespace

MergedVertices mergeCollapsed(const MovingSurface& moving, double offset_mm) {
  return Merging(moving, offset_mm).run();
}

}  // namespace lamina
