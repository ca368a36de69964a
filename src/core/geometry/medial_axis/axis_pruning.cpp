// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <utility>

#include "geometry/medial_axis/axis_graph.hpp"
#include "lamina/geometry/medial_axis/medial_axis.hpp"

namespace lamina {
namespace {

constexpr std::size_t kNoArc = static_cast<std::size_t>(-1);
constexpr double kGrowth = 1e-6;  // mm: less is no growth but rounding

/// From a tip to where the radius grows no more.
struct Tail {
  std::vector<std::size_t> whole;  ///< pieces that belong to it
  std::size_t end = kNoArc;        ///< vertex where it ends, unless within a piece
  std::size_t last = kNoArc;       ///< piece within which it ends
  std::size_t last_points = 0;     ///< of that piece
  AxisPoint tip;
  AxisPoint inmost;
  double length_mm = 0.0;

  bool isWorthless(const AxisPruning& pruning) const {
    const double growth = inmost.radius_mm - tip.radius_mm;
    return length_mm - growth <= pruning.least_reach_mm ||
           growth >= length_mm * std::sin(0.5 * pruning.widest_corner_rad);
  }
};

class Pruner {
 public:
  Pruner(const MedialAxis& axis, const AxisPruning& pruning) : graph_(axis), pruning_(pruning) {}

  MedialAxis prune() {
    const std::size_t count = graph_.pieceCount();
    for (std::size_t i = 0; i < count; ++i)
      for (const std::size_t vertex : {graph_.piece(i).from, graph_.piece(i).to}) tips_.push_back(vertex);
    while (!tips_.empty()) {
      const std::size_t vertex = tips_.back();
      tips_.pop_back();
      if (graph_.degree(vertex) == 1) shorten(vertex);
    }
    return std::move(graph_).joined();
  }

 private:
  Tail tailFrom(std::size_t vertex) const {
    Tail tail;
    std::size_t piece = graph_.pieceAt(vertex, kNoArc);
    tail.end = vertex;
    tail.tip = tail.inmost = graph_.pointsFrom(piece, vertex).front();
    while (piece != kNoArc) {
      const std::vector<AxisPoint> points = graph_.pointsFrom(piece, tail.end);
      for (std::size_t k = 1; k < points.size(); ++k) {
        if (points[k].radius_mm <= points[k - 1].radius_mm + kGrowth && hasLength(points, k)) {
          if (k > 1) tail.last = piece, tail.last_points = k;
          return tail;
        }
        tail.length_mm += (points[k].point - points[k - 1].point).norm();
        tail.inmost = points[k];
      }
      tail.whole.push_back(piece);
      tail.end = graph_.otherEnd(piece, tail.end);
      piece = graph_.degree(tail.end) == 2 ? graph_.pieceAt(tail.end, piece) : kNoArc;
    }
    return tail;
  }

  static bool hasLength(const std::vector<AxisPoint>& points, std::size_t k) {
    return (points[k].point - points[k - 1].point).norm() > kGrowth;
  }

  void shorten(std::size_t vertex) {
    const Tail tail = tailFrom(vertex);
    if ((tail.whole.empty() && tail.last == kNoArc) || !tail.isWorthless(pruning_)) return;
    for (const std::size_t piece : tail.whole) graph_.remove(piece);
    if (tail.last != kNoArc) {
      graph_.cutFront(tail.last, tail.end, tail.last_points - 1);
      return;  // the new tip is where the radius is largest
    }
    if (graph_.degree(tail.end) == 0)
      graph_.add(tail.end, tail.end, {tail.inmost});
    else
      tips_.push_back(tail.end);
  }

  AxisGraph graph_;
  AxisPruning pruning_;
  std::vector<std::size_t> tips_;  ///< vertices to look at; others than tips are skipped
};

}  // namespace

MedialAxis pruned(const MedialAxis& axis, const AxisPruning& pruning) {
  return Pruner(axis, pruning).prune();
}

}  // namespace lamina
