// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/pattern/pattern_cut.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/polygon/plane_vectors.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {
namespace {

/// The edge of an outline that starts at the point of that index.
struct OutlineEdge {
  std::uint32_t outline = 0;
  std::uint32_t edge = 0;
};

/// The edges of outlines by the cells of a grid they pass through: about as many cells as edges, but enough
/// for most to have none.
class EdgeCells {
 public:
  explicit EdgeCells(const std::vector<Polygon>& outlines);

  /// Calls `visit(edge)` for all edges in the cells that the segment passes through; for an edge in several
  /// of them as often.
  template <class Visit>
  void visitNear(const Point2& from, const Point2& to, const Visit& visit) const {
    forCells(from, to, [&](std::size_t cell) {
      for (std::uint32_t i = begin_[cell]; i < begin_[cell + 1]; ++i) visit(edges_[i]);
    });
  }

  /// The cell of a point if no edge passes through it: between two points of one such cell there is none.
  std::optional<std::size_t> clearCell(const Point2& point) const {
    const Point2 at = (point - origin_) / cell_mm_;
    if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() < columns_ && at.y() < rows_)) return std::nullopt;
    const std::size_t cell = static_cast<std::size_t>(at.y()) * static_cast<std::size_t>(columns_) +
                             static_cast<std::size_t>(at.x());
    if (begin_[cell] < begin_[cell + 1]) return std::nullopt;
    return cell;
  }

  /// Whether no edge passes through a straight line between points of two clear cells, as there is none in
  /// any cell round the first; false also where that is in doubt.
  bool isClearBetween(std::size_t cell, std::size_t next) const {
    if (!is_clear_around_[cell]) return false;
    const auto columns = static_cast<std::size_t>(columns_);
    const std::size_t row = cell / columns, next_row = next / columns;
    const std::size_t column = cell % columns, next_column = next % columns;
    return next_row + 1 >= row && row + 1 >= next_row && next_column + 1 >= column &&
           column + 1 >= next_column;
  }

 private:
  std::vector<bool> clearAround() const;

  /// Row by row.
  template <class Visit>
  void forCells(const Point2& from, const Point2& to, const Visit& visit) const {
    const Point2 a = (from - origin_) / cell_mm_;
    const Point2 along = (to - from) / cell_mm_;
    const int first_row = clampedFloor(std::min(a.y(), a.y() + along.y()) - kSlack, rows_);
    const int last_row = clampedFloor(std::max(a.y(), a.y() + along.y()) + kSlack, rows_);
    for (int row = std::max(first_row, 0); row <= std::min(last_row, rows_ - 1); ++row) {
      double start = 0.0, end = 1.0;  // the part of the segment in this row
      if (std::abs(along.y()) > kSlack) {
        const double one = (row - kSlack - a.y()) / along.y();
        const double other = (row + 1 + kSlack - a.y()) / along.y();
        start = std::clamp(std::min(one, other), 0.0, 1.0);
        end = std::clamp(std::max(one, other), 0.0, 1.0);
      }
      const double x = a.x() + start * along.x();
      const double y = a.x() + end * along.x();
      const int first = std::max(clampedFloor(std::min(x, y) - kSlack, columns_), 0);
      const int last = std::min(clampedFloor(std::max(x, y) + kSlack, columns_), columns_ - 1);
      for (int column = first; column <= last; ++column)
        visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
              static_cast<std::size_t>(column));
    }
  }

  static int clampedFloor(double position, int count) {
    return static_cast<int>(std::clamp(std::floor(position), -1.0, static_cast<double>(count)));
  }

  static constexpr double kSlack = 1e-6;  ///< cells, far above rounding
  Point2 origin_ = Point2::Zero();
  double cell_mm_ = 1.0;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::uint32_t> begin_;  ///< where each cell's edges begin, and an end
  std::vector<OutlineEdge> edges_;
  std::vector<bool> is_clear_around_;  ///< of each cell: whether it and its neighbours have no edge
};

constexpr double kFewestCellsAcross = 32.0;
constexpr double kMostCellsAcross = 4096.0;

template <class Visit>
void forEdges(const std::vector<Polygon>& outlines, const Visit& visit) {
  for (std::uint32_t o = 0; o < outlines.size(); ++o)
    for (std::uint32_t i = 0; i < outlines[o].size(); ++i)
      visit(OutlineEdge{o, i}, outlines[o][i], outlines[o][i + 1 < outlines[o].size() ? i + 1 : 0]);
}

EdgeCells::EdgeCells(const std::vector<Polygon>& outlines) {
  const Box2 box = boundingBox(outlines);
  std::size_t count = 0;
  for (const Polygon& outline : outlines) count += outline.size();
  const Point2 size = box.isEmpty() ? Point2(Point2::Zero()) : Point2(box.size());
  if (!box.isEmpty()) origin_ = box.low;
  const double across = std::sqrt(static_cast<double>(std::max<std::size_t>(count, 1)));
  cell_mm_ = std::max({size.maxCoeff() / std::clamp(across, kFewestCellsAcross, kMostCellsAcross), 1e-6});
  columns_ = 1 + static_cast<int>(size.x() / cell_mm_);
  rows_ = 1 + static_cast<int>(size.y() / cell_mm_);
  begin_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  forEdges(outlines, [&](const OutlineEdge&, const Point2& from, const Point2& to) {
    forCells(from, to, [&](std::size_t cell) { ++begin_[cell + 1]; });
  });
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  edges_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  forEdges(outlines, [&](const OutlineEdge& edge, const Point2& from, const Point2& to) {
    forCells(from, to, [&](std::size_t cell) { edges_[next[cell]++] = edge; });
  });
  is_clear_around_ = clearAround();
}

std::vector<bool> EdgeCells::clearAround() const {
  std::vector<bool> is_clear(begin_.size() - 1, true);
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      const auto cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                        static_cast<std::size_t>(column);
      if (begin_[cell] == begin_[cell + 1]) continue;
      for (int r = std::max(row - 1, 0); r <= std::min(row + 1, rows_ - 1); ++r)
        for (int c = std::max(column - 1, 0); c <= std::min(column + 1, columns_ - 1); ++c)
          is_clear[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
                   static_cast<std::size_t>(c)] = false;
    }
  return is_clear;
}

constexpr double kAside = 1e-7;  // mm; far above rounding, far below what a machine resolves
constexpr int kAttempts = 8;
/// Pieces shorter than this are points [mm].
constexpr double kShortestPiece = 1e-4;

/// Where a motion of a curve crosses an edge.
struct BorderCut {
  double at = 0.0;  ///< along the motion, from 0 to 1
  bool is_entering = false;
  Point2 point;
  OutlinePoint place;
};

class PieceCutter {
 public:
  PieceCutter(const EdgeCells& cells, const std::vector<Polygon>& outlines)
      : cells_(cells), outlines_(outlines) {}

  /// None if what is inside is in doubt.
  /// @param is_inside  of the first point
  std::optional<std::vector<RunOnOutlines>> pieces(const Polyline& curve, bool is_inside) {
    pieces_.clear();
    depth_ = is_inside ? 1 : 0;
    if (is_inside) pieces_.push_back({{curve.front()}, std::nullopt, std::nullopt});
    std::optional<std::size_t> cell = cells_.clearCell(curve.front());
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const std::optional<std::size_t> next = cells_.clearCell(curve[i]);
      const bool is_clear = next && cell && (*next == *cell || cells_.isClearBetween(*cell, *next));
      if (!is_clear) {
        findCuts(curve[i - 1], curve[i]);
        for (const BorderCut& cut : cuts_) pass(cut);
      }
      cell = next;
      if (depth_ > 0) pieces_.back().points.push_back(curve[i]);
    }
    if (depth_ != (is_inside ? 1 : 0)) return std::nullopt;
    return std::move(pieces_);
  }

 private:
  void pass(const BorderCut& cut) {
    depth_ += cut.is_entering ? 1 : -1;
    if (cut.is_entering && depth_ == 1) pieces_.push_back({{cut.point}, cut.place, std::nullopt});
    if (cut.is_entering || depth_ != 0) return;
    pieces_.back().points.push_back(cut.point);
    pieces_.back().last = cut.place;
  }

  void findCuts(const Point2& from, const Point2& to) {
    cuts_.clear();
    cells_.visitNear(from, to, [&](const OutlineEdge& edge) { addCut(from, to, edge); });
    // An edge may lie in several cells.
    std::sort(cuts_.begin(), cuts_.end(), [](const BorderCut& a, const BorderCut& b) {
      if (a.at != b.at) return a.at < b.at;
      if (a.place.outline != b.place.outline) return a.place.outline < b.place.outline;
      return a.place.edge < b.place.edge;
    });
    cuts_.erase(std::unique(cuts_.begin(), cuts_.end(),
                            [](const BorderCut& a, const BorderCut& b) {
                              return a.place.outline == b.place.outline && a.place.edge == b.place.edge;
                            }),
                cuts_.end());
  }

  /// A point on a line counts as to the left of it, so that crossings of neighbouring edges and motions
  /// agree.
  void addCut(const Point2& from, const Point2& to, const OutlineEdge& edge) {
    const Polygon& outline = outlines_[edge.outline];
    const Point2& a = outline[edge.edge];
    const Point2& b = outline[edge.edge + 1 < outline.size() ? edge.edge + 1 : 0];
    if ((side(from, to, a) >= 0.0) == (side(from, to, b) >= 0.0)) return;
    const double before = side(a, b, from);
    const double after = side(a, b, to);
    if ((before >= 0.0) == (after >= 0.0)) return;
    BorderCut cut;
    cut.at = std::clamp(before / (before - after), 0.0, 1.0);
    cut.is_entering = after >= 0.0;
    cut.point = from + cut.at * (to - from);
    cut.place = {edge.outline, edge.edge, (cut.point - a).norm()};
    cuts_.push_back(cut);
  }

  const EdgeCells& cells_;
  const std::vector<Polygon>& outlines_;
  std::vector<BorderCut> cuts_;  ///< of one motion, in order
  std::vector<RunOnOutlines> pieces_;
  int depth_ = 0;  ///< 1 inside
};

Polyline aside(Polyline curve, int attempt) {
  for (Point2& point : curve) point += attempt * kAside * Point2(0.6, 0.8);
  return curve;
}

class PatternCutter {
 public:
  explicit PatternCutter(const std::vector<Polygon>& outlines) : outlines_(outlines), cells_(outlines) {}

  PatternPieces cut(const PatternCurves& curves) {
    PatternPieces result;
    for (const Polyline& curve : curves.open)
      if (curve.size() > 1) addPieces(result, piecesOf(curve, false));
    for (const Polygon& loop : curves.closed)
      if (loop.size() > 2) addLoop(result, loop);
    return result;
  }

 private:
  /// Nothing of a curve that stays in doubt.
  std::vector<RunOnOutlines> piecesOf(const Polyline& curve, bool is_inside) const {
    PieceCutter cutter(cells_, outlines_);
    for (int attempt = 0; attempt < kAttempts; ++attempt)
      if (auto pieces = cutter.pieces(attempt == 0 ? curve : aside(curve, attempt), is_inside))
        return *pieces;
    return {};
  }

  static void addPieces(PatternPieces& result, std::vector<RunOnOutlines> pieces) {
    for (RunOnOutlines& piece : pieces)
      if (length(piece.points) > kShortestPiece) result.open.push_back(std::move(piece));
  }

  void addLoop(PatternPieces& result, const Polygon& loop) const {
    const bool is_inside = contains(outlines_, loop.front());
    Polyline unrolled = loop;
    unrolled.push_back(loop.front());
    std::vector<RunOnOutlines> pieces = piecesOf(unrolled, is_inside);
    if (pieces.size() == 1 && !pieces.front().first) {
      result.closed.push_back(loop);
      return;
    }
    if (is_inside && pieces.size() > 1) {
      // The loop was opened inside: its last piece goes on with the first.
      RunOnOutlines& last = pieces.back();
      last.points.insert(last.points.end(), pieces.front().points.begin() + 1, pieces.front().points.end());
      last.last = pieces.front().last;
      pieces.erase(pieces.begin());
    }
    addPieces(result, std::move(pieces));
  }

  const std::vector<Polygon>& outlines_;
  EdgeCells cells_;
};

}  // namespace

PatternPieces cutToOutlines(const PatternCurves& curves, const std::vector<Polygon>& outlines) {
  if (outlines.empty()) return {};
  return PatternCutter(outlines).cut(curves);
}

}  // namespace lamina
