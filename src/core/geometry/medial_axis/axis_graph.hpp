// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/medial_axis/medial_axis.hpp"

namespace lamina {

/// Pieces of a medial axis as the edges of a graph with numbered vertices.
class AxisGraph {
 public:
  explicit AxisGraph(std::size_t vertices) : ends_(vertices) {}
  /// Makes the graph of an axis, with its nodes as vertices.
  explicit AxisGraph(const MedialAxis& axis);

  /// Adds a vertex without pieces.
  /// @return number of the vertex
  std::size_t addVertex();
  /// Adds a piece.
  /// @param points  from vertex `from` to vertex `to`
  void add(std::size_t from, std::size_t to, std::vector<AxisPoint> points);
  void remove(std::size_t piece);

  /// Replaces a piece by a new one without the first `count` points from its end at `vertex`. The new piece
  /// begins at a new vertex.
  void cutFront(std::size_t piece, std::size_t vertex, std::size_t count);

  std::size_t pieceCount() const { return pieces_.size(); }
  const AxisBranch& piece(std::size_t index) const { return pieces_[index]; }
  /// Number of ends of pieces at the vertex.
  std::size_t degree(std::size_t vertex) const { return ends_[vertex].size(); }
  const std::vector<std::size_t>& piecesAt(std::size_t vertex) const { return ends_[vertex]; }
  /// The first piece at the vertex that is not `other`; `other` if there is none.
  std::size_t pieceAt(std::size_t vertex, std::size_t other) const;
  std::size_t otherEnd(std::size_t piece, std::size_t vertex) const {
    return pieces_[piece].from == vertex ? pieces_[piece].to : pieces_[piece].from;
  }
  /// The points of a piece, from this end vertex to the other.
  std::vector<AxisPoint> pointsFrom(std::size_t piece, std::size_t vertex) const;

  /// All remaining pieces as an axis, joined wherever exactly two ends meet.
  MedialAxis joined() &&;

 private:
  class Walk;

  std::vector<AxisBranch> pieces_;
  /// Pieces at each vertex; twice if a piece begins and ends there.
  std::vector<std::vector<std::size_t>> ends_;
};

}  // namespace lamina
