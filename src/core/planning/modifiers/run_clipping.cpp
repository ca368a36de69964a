// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/modifiers/run_clipping.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "planning/shortest_piece.hpp"

namespace lamina {
namespace {

/// Pieces of a run, one being made.
class Pieces {
 public:
  explicit Pieces(const FillPath& run) : run_(run) {}

  /// A way that lies in the regions, joined to the one before where that ends.
  void add(const Point2& from, const Point2& to, std::size_t end) {
    if (!is_open_) {
      found_.push_back({{from}, false, run_.role, run_.deposit, {}});
      if (!run_.width_mm.empty()) found_.back().width_mm.push_back(run_.width_mm[end]);
    }
    is_open_ = true;
    found_.back().points.push_back(to);
    if (!run_.width_mm.empty()) found_.back().width_mm.push_back(run_.width_mm[end]);
  }
  void leave() { is_open_ = false; }

  std::vector<FillPath> finish() && {
    if (run_.is_closed && is_open_ && found_.size() > 1 &&
        found_.front().points.front() == run_.points.front())
      joinEnds();
    found_.erase(std::remove_if(found_.begin(), found_.end(),
                                [](const FillPath& piece) { return length(piece.points) < kShortestPiece; }),
                 found_.end());
    return std::move(found_);
  }

 private:
  /// The last piece goes on as the first one.
  void joinEnds() {
    FillPath last = std::move(found_.back());
    found_.pop_back();
    FillPath& first = found_.front();
    last.points.insert(last.points.end(), first.points.begin() + 1, first.points.end());
    if (!last.width_mm.empty())
      last.width_mm.insert(last.width_mm.end(), first.width_mm.begin() + 1, first.width_mm.end());
    first = std::move(last);
  }

  const FillPath& run_;
  bool is_open_ = false;
  std::vector<FillPath> found_;
};

}  // namespace

std::vector<double> crossings(const Point2& from, const Point2& to, const std::vector<Polygon>& borders) {
  std::vector<double> shares;
  const Point2 way = to - from;
  const Box2 box{from.cwiseMin(to), from.cwiseMax(to)};
  for (const Polygon& border : borders)
    for (std::size_t i = 0, j = border.size() - 1; i < border.size(); j = i++) {
      const Point2& a = border[j];
      const Point2& b = border[i];
      if ((a.cwiseMax(b).array() < box.low.array()).any() || (a.cwiseMin(b).array() > box.high.array()).any())
        continue;
      const Point2 edge = b - a;
      const double turn = way.x() * edge.y() - way.y() * edge.x();
      if (turn == 0.0) continue;
      const Point2 gap = a - from;
      const double along = (gap.x() * edge.y() - gap.y() * edge.x()) / turn;
      const double on_edge = (gap.x() * way.y() - gap.y() * way.x()) / turn;
      if (along > 0.0 && along < 1.0 && on_edge >= 0.0 && on_edge <= 1.0) shares.push_back(along);
    }
  std::sort(shares.begin(), shares.end());
  return shares;
}

std::vector<FillPath> clipped(const FillPath& run, const Regions& area) {
  const std::vector<Polygon> borders = outlines(area);
  const std::size_t count = run.points.size();
  const std::size_t motions = run.is_closed ? count : count - 1;
  Pieces pieces(run);
  bool is_whole = true;
  for (std::size_t m = 0; m < motions; ++m) {
    const std::size_t end = (m + 1) % count;
    const Point2& from = run.points[m];
    const Point2& to = run.points[end];
    std::vector<double> shares = crossings(from, to, borders);
    shares.push_back(1.0);
    Point2 begun = from;
    double share = 0.0;
    for (const double next : shares) {
      const Point2 reached = next < 1.0 ? Point2(from + next * (to - from)) : to;
      const bool is_inside = contains(borders, from + 0.5 * (share + next) * (to - from));
      if (is_inside)
        pieces.add(begun, reached, end);
      else
        pieces.leave();
      is_whole = is_whole && is_inside;
      begun = reached;
      share = next;
    }
  }
  if (is_whole) return {run};
  return std::move(pieces).finish();
}

std::vector<FillPath> clipped(const std::vector<FillPath>& runs, const Regions& area) {
  std::vector<FillPath> parts;
  for (const FillPath& run : runs)
    for (FillPath& part : clipped(run, area)) parts.push_back(std::move(part));
  return parts;
}

}  // namespace lamina
