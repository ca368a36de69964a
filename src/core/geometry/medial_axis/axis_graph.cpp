// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/medial_axis/axis_graph.hpp"

#include <algorithm>
#include <utility>

namespace lamina {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// Joining many pieces one after another must not copy the first of them again and again.
void append(AxisBranch& longer, AxisBranch&& shorter) {
  longer.points.insert(longer.points.end(), shorter.points.begin() + 1, shorter.points.end());
  longer.to = shorter.to;
}

AxisBranch reversed(AxisBranch branch) {
  std::reverse(branch.points.begin(), branch.points.end());
  std::swap(branch.from, branch.to);
  return branch;
}

}  // namespace

AxisGraph::AxisGraph(const MedialAxis& axis) : ends_(axis.nodes.size()) {
  for (const AxisBranch& branch : axis.branches) add(branch.from, branch.to, branch.points);
}

std::size_t AxisGraph::addVertex() {
  ends_.emplace_back();
  return ends_.size() - 1;
}

void AxisGraph::add(std::size_t from, std::size_t to, std::vector<AxisPoint> points) {
  ends_[from].push_back(pieces_.size());
  ends_[to].push_back(pieces_.size());
  pieces_.push_back({from, to, std::move(points)});
}

void AxisGraph::remove(std::size_t piece) {
  for (const std::size_t vertex : {pieces_[piece].from, pieces_[piece].to}) {
    std::vector<std::size_t>& at = ends_[vertex];
    at.erase(std::remove(at.begin(), at.end(), piece), at.end());
  }
  pieces_[piece].points.clear();
}

void AxisGraph::cutFront(std::size_t piece, std::size_t vertex, std::size_t count) {
  AxisBranch branch = pieces_[piece].from == vertex ? pieces_[piece] : reversed(pieces_[piece]);
  remove(piece);
  branch.points.erase(branch.points.begin(), branch.points.begin() + static_cast<std::ptrdiff_t>(count));
  add(addVertex(), branch.to, std::move(branch.points));
}

std::size_t AxisGraph::pieceAt(std::size_t vertex, std::size_t other) const {
  for (const std::size_t piece : ends_[vertex])
    if (piece != other) return piece;
  return other;
}

std::vector<AxisPoint> AxisGraph::pointsFrom(std::size_t piece, std::size_t vertex) const {
  std::vector<AxisPoint> points = pieces_[piece].points;
  if (pieces_[piece].from != vertex) std::reverse(points.begin(), points.end());
  return points;
}

/// Walks chains of pieces from end to end.
class AxisGraph::Walk {
 public:
  explicit Walk(AxisGraph graph)
      : graph_(std::move(graph)), node_of_(graph_.ends_.size(), kNone), is_done_(graph_.pieces_.size()) {}

  MedialAxis walk() {
    // First from ends and junctions; what is left then closes on itself.
    for (const bool is_any : {false, true}) {
      for (std::size_t i = 0; i < graph_.pieces_.size(); ++i) {
        if (graph_.pieces_[i].points.empty()) continue;
        for (const std::size_t start : {graph_.pieces_[i].from, graph_.pieces_[i].to})
          if (!is_done_[i] && (is_any || graph_.degree(start) != 2)) follow(i, start);
      }
    }
    return std::move(axis_);
  }

 private:
  AxisBranch taken(std::size_t piece, std::size_t start) {
    is_done_[piece] = true;
    AxisBranch branch = std::move(graph_.pieces_[piece]);
    return branch.from == start ? branch : reversed(std::move(branch));
  }

  void follow(std::size_t piece, std::size_t start) {
    AxisBranch branch = taken(piece, start);
    while (branch.to != start && graph_.degree(branch.to) == 2) {
      piece = graph_.pieceAt(branch.to, piece);
      if (is_done_[piece]) break;
      append(branch, taken(piece, branch.to));
    }
    branch.from = nodeAt(start, branch.points.front());
    branch.to = nodeAt(branch.to, branch.points.back());
    axis_.branches.push_back(std::move(branch));
  }

  std::size_t nodeAt(std::size_t vertex, const AxisPoint& point) {
    if (node_of_[vertex] == kNone) {
      node_of_[vertex] = axis_.nodes.size();
      axis_.nodes.push_back(point);
    }
    return node_of_[vertex];
  }

  AxisGraph graph_;
  std::vector<std::size_t> node_of_;  ///< by vertex
  std::vector<bool> is_done_;         ///< by piece
  MedialAxis axis_;
};

MedialAxis AxisGraph::joined() && { return Walk(std::move(*this)).walk(); }

}  // namespace lamina
