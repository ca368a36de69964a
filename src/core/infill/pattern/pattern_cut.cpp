// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/pattern/pattern_cut.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"
#include "geometry/spatial/edge_grid.hpp"

namespace lamina {
namespace {

constexpr double kAside = 1e-7;  // mm; far above rounding, far below what a machine resolves
constexpr int kAttempts = 8;
constexpr double kFewestCellsAcross = 32.0;  // long curves pass simple outlines too
/// Pieces shorter than this are points [mm].
constexpr double kShortestPiece = 1e-4;

/// Where a motion of a curve crosses an edge.
struct BorderCut {
  double at = 0.0;  ///< along the motion, from 0 to 1
  bool is_entering = false;
  Point2 point;
  OutlinePoint place;
};

struct OutlineEdge {
  std::uint32_t outline = 0;
  std::uint32_t edge = 0;
};

/// The edges of outlines, by their places.
class OutlineGrid {
 public:
  explicit OutlineGrid(const std::vector<Polygon>& outlines) {
    std::vector<std::pair<Point2, Point2>> ends;
    for (std::uint32_t o = 0; o < outlines.size(); ++o)
      for (std::uint32_t i = 0; i < outlines[o].size(); ++i) {
        edges_.push_back({o, i});
        ends.emplace_back(outlines[o][i], outlines[o][i + 1 < outlines[o].size() ? i + 1 : 0]);
      }
    grid_ = EdgeGrid(ends, kFewestCellsAcross);
  }

  /// Calls `visit(edge)` for all edges in the cells that the segment passes through; for an edge in several
  /// of them as often.
  template <class Visit>
  void visitNear(const Point2& from, const Point2& to, const Visit& visit) const {
    if (grid_.isEmpty()) return;
    grid_.forCellsAlong(from, to, [&](std::size_t column, std::size_t row) {
      return grid_.forEdgesIn(column, row, [&](std::size_t i) {
        visit(edges_[i]);
        return true;
      });
    });
  }

  std::optional<std::size_t> clearCell(const Point2& point) const { return grid_.clearCell(point); }

  /// Whether no edge passes through a straight line between points of two clear cells; false also where that
  /// is in doubt.
  bool isClearBetween(std::size_t cell, std::size_t next) const {
    return cell == next || (grid_.areNeighbours(cell, next) && grid_.isClearAround(cell));
  }

 private:
  std::vector<OutlineEdge> edges_;
  EdgeGrid grid_;
};

class PieceCutter {
 public:
  PieceCutter(const OutlineGrid& cells, const std::vector<Polygon>& outlines)
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
      const bool is_clear = next && cell && cells_.isClearBetween(*cell, *next);
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

  const OutlineGrid& cells_;
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
  OutlineGrid cells_;
};

}  // namespace

PatternPieces cutToOutlines(const PatternCurves& curves, const std::vector<Polygon>& outlines) {
  if (outlines.empty()) return {};
  return PatternCutter(outlines).cut(curves);
}

}  // namespace lamina
