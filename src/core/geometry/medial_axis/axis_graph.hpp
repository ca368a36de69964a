// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/medial_axis/medial_axis.hpp"

namespace lamina {

/// Pieces of a medial axis between numbered vertices, and how they hang together.
class AxisGraph {
 public:
  explicit AxisGraph(std::size_t vertices) : ends_(vertices) {}
  /// The pieces of an axis; its nodes are the vertices.
  explicit AxisGraph(const MedialAxis& axis);

  /// A vertex without pieces; its number.
  std::size_t addVertex();
  /// @param points  from the one vertex to the other
  void add(std::size_t from, std::size_t to, std::vector<AxisPoint> points);
  void remove(std::size_t piece);

  /// Takes the first points of a piece away, counted from one of its vertices, where another vertex takes the
  /// place of that one.
  void cutFront(std::size_t piece, std::size_t vertex, std::size_t count);

  std::size_t pieceCount() const { return pieces_.size(); }
  const AxisBranch& piece(std::size_t index) const { return pieces_[index]; }
  /// Number of pieces' ends at the vertex.
  std::size_t degree(std::size_t vertex) const { return ends_[vertex].size(); }
  const std::vector<std::size_t>& piecesAt(std::size_t vertex) const { return ends_[vertex]; }
  /// The first piece at the vertex that is not `other`; `other` if there is none.
  std::size_t pieceAt(std::size_t vertex, std::size_t other) const;
  std::size_t otherEnd(std::size_t piece, std::size_t vertex) const {
    return pieces_[piece].from == vertex ? pieces_[piece].to : pieces_[piece].from;
  }
  /// In the direction that starts at that vertex.
  std::vector<AxisPoint> pointsFrom(std::size_t piece, std::size_t vertex) const;

  /// All that is left, joined wherever two ends meet alone.
  MedialAxis joined() &&;

 private:
  class Walk;

  std::vector<AxisBranch> pieces_;
  std::vector<std::vector<std::size_t>> ends_;  ///< pieces at each vertex; twice if it closes there
};

}  // namespace lamina
