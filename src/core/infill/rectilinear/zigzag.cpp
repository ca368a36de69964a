// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/zigzag.hpp"

#include <cmath>

#include "infill/rectilinear/raster.hpp"
#include "infill/rectilinear/raster_direction.hpp"
#include "infill/rectilinear/variable_width_runs.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFF;
/// Lines shorter than this are points [mm].
constexpr double kShortestLine = 1e-4;

/// Joins the lines of a raster into runs that climb from line to line.
class RunBuilder {
 public:
  RunBuilder(const Raster& raster, double longest_link_mm)
      : raster_(raster), longest_link_(longest_link_mm), position_(raster.sorted.size()) {
    for (std::uint32_t i = 0; i < raster.sorted.size(); ++i) position_[raster.sorted[i]] = i;
    findLinks();
  }

  std::vector<FillPath> build(const RasterFrame& frame) {
    std::vector<FillPath> runs;
    is_done_.assign(raster_.sorted.size() / 2, false);
    for (std::size_t line = 0; line < is_done_.size(); ++line) {
      if (is_done_[line]) continue;
      const std::uint32_t left = raster_.sorted[2 * line];
      const std::uint32_t right = raster_.sorted[2 * line + 1];
      FillPath run;
      run.points = trace(countLines(right) > countLines(left) ? right : left, frame);
      if (length(run.points) > kShortestLine) runs.push_back(std::move(run));
    }
    return runs;
  }

 private:
  /// Walking along an outline, a crossing and the next one bound a link if they lie on neighbouring lines. At
  /// most one link leads up from a crossing.
  void findLinks() {
    up_.assign(raster_.crossings.size(), kNone);
    std::uint32_t begin = 0;
    while (begin < raster_.crossings.size()) {
      std::uint32_t end = begin;
      while (end < raster_.crossings.size() &&
             raster_.crossings[end].outline == raster_.crossings[begin].outline)
        ++end;
      for (std::uint32_t c = begin; c < end; ++c) link(c, c + 1 < end ? c + 1 : begin);
      begin = end;
    }
  }

  void link(std::uint32_t from, std::uint32_t to) {
    const std::int64_t climb = raster_.crossings[to].line - raster_.crossings[from].line;
    if (std::abs(climb) != 1 || linkLength(from, to) > longest_link_) return;
    up_[climb > 0 ? from : to] = climb > 0 ? to : from;
  }

  Point2 pointAt(std::uint32_t c) const {
    const Crossing& crossing = raster_.crossings[c];
    return {crossing.x, static_cast<double>(crossing.line) * raster_.spacing_mm};
  }

  /// Number of the outline's points between two crossings that follow each other.
  std::size_t pointsBetween(const Crossing& from, const Crossing& to) const {
    const std::size_t size = raster_.outlines[from.outline].size();
    return to.edge >= from.edge ? to.edge - from.edge : to.edge + size - from.edge;
  }

  const Point2& outlinePoint(const Crossing& from, std::size_t step) const {
    const Polygon& outline = raster_.outlines[from.outline];
    const std::size_t i = from.edge + 1 + step;
    return outline[i < outline.size() ? i : i - outline.size()];
  }

  double linkLength(std::uint32_t from, std::uint32_t to) const {
    const Crossing& start = raster_.crossings[from];
    const std::size_t count = pointsBetween(start, raster_.crossings[to]);
    Point2 last = pointAt(from);
    double sum = 0.0;
    for (std::size_t step = 0; step < count && sum <= longest_link_; ++step) {
      sum += (outlinePoint(start, step) - last).norm();
      last = outlinePoint(start, step);
    }
    return sum + (pointAt(to) - last).norm();
  }

  std::uint32_t otherEnd(std::uint32_t c) const { return raster_.sorted[position_[c] ^ 1U]; }
  std::size_t lineOf(std::uint32_t c) const { return position_[c] / 2; }

  /// The crossing at which a run goes on after the line it entered at `c`.
  std::uint32_t following(std::uint32_t c) const {
    const std::uint32_t next = up_[otherEnd(c)];
    return next == kNone || is_done_[lineOf(next)] ? kNone : next;
  }

  std::size_t countLines(std::uint32_t c) const {
    std::size_t count = 0;
    for (; c != kNone; c = following(c)) ++count;
    return count;
  }

  Polyline trace(std::uint32_t c, const RasterFrame& frame) {
    Polyline points;
    const auto add = [&](const Point2& point) {
      const Point2 turned = frame.outOfRaster(point);
      if (points.empty() || points.back() != turned) points.push_back(turned);
    };
    for (std::uint32_t next = kNone; c != kNone; c = next) {
      next = following(c);
      is_done_[lineOf(c)] = true;
      add(pointAt(c));
      add(pointAt(otherEnd(c)));
      if (next != kNone) forEachOnLink(otherEnd(c), next, add);
    }
    return points;
  }

  /// The points of the outline from a crossing to another.
  /// @param to  on the line above
  template <class Visit>
  void forEachOnLink(std::uint32_t from, std::uint32_t to, const Visit& visit) const {
    const bool is_along_walk = climbs(raster_.crossings[from]);
    const Crossing& start = raster_.crossings[is_along_walk ? from : to];
    const std::size_t count = pointsBetween(start, raster_.crossings[is_along_walk ? to : from]);
    for (std::size_t step = 0; step < count; ++step)
      visit(outlinePoint(start, is_along_walk ? step : count - 1 - step));
  }

  bool climbs(const Crossing& crossing) const {
    return outlinePoint(crossing, 0).y() > raster_.outlines[crossing.outline][crossing.edge].y();
  }

  const Raster& raster_;
  double longest_link_;
  std::vector<std::uint32_t> position_;  ///< of a crossing among the sorted ones
  std::vector<std::uint32_t> up_;        ///< the crossing on the line above that the outline leads to
  std::vector<bool> is_done_;            ///< line by line
};

}  // namespace

std::vector<FillPath> zigzag(const Regions& regions, const InfillRequest& request) {
  if (isSolid(request))
    return inBestDirection(offset(regions, -0.5 * narrowestBead(request)), request, variableWidthRuns);
  return inBestDirection(offset(regions, -0.5 * request.pitch_mm), request, rasterRuns);
}

std::vector<FillPath> rasterRuns(const Regions& regions, const InfillRequest& request) {
  const RasterFrame frame(request.angle_rad);
  const Raster raster = rasterise(regions, request.spacing_mm, frame);
  return RunBuilder(raster, longestLink(request, request.spacing_mm) * request.spacing_mm).build(frame);
}

}  // namespace lamina
