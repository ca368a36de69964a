// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/zigzag.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

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

  std::vector<FillPath> build(const RasterFrame& frame) { return inFrame(climbingRuns(), frame); }

  /// Joined further, by ways along the outlines.
  std::vector<FillPath> buildJoined(const RasterFrame& frame, double longest_mm) {
    return inFrame(joined(climbingRuns(), longest_mm), frame);
  }

 private:
  /// A run in the raster frame, and the crossings at its ends.
  struct RasterRun {
    Polyline points;
    std::uint32_t first = kNone;
    std::uint32_t last = kNone;
  };

  /// A way along an outline from the end of one run to that of another.
  struct EndLink {
    double length_mm = 0.0;
    std::uint32_t from = kNone;  ///< crossing
    std::uint32_t to = kNone;    ///< the next one along the outline
  };

  std::vector<RasterRun> climbingRuns() {
    std::vector<RasterRun> runs;
    is_done_.assign(raster_.sorted.size() / 2, false);
    for (std::size_t line = 0; line < is_done_.size(); ++line) {
      if (is_done_[line]) continue;
      const std::uint32_t left = raster_.sorted[2 * line];
      const std::uint32_t right = raster_.sorted[2 * line + 1];
      RasterRun run = trace(countLines(right) > countLines(left) ? right : left);
      if (length(run.points) > kShortestLine) runs.push_back(std::move(run));
    }
    return runs;
  }

  static std::vector<FillPath> inFrame(std::vector<RasterRun> runs, const RasterFrame& frame) {
    std::vector<FillPath> turned(runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
      turned[i].points.reserve(runs[i].points.size());
      for (const Point2& point : runs[i].points) {
        const Point2 there = frame.outOfRaster(point);
        if (turned[i].points.empty() || turned[i].points.back() != there) turned[i].points.push_back(there);
      }
    }
    return turned;
  }

  /// Shortest first.
  /// @param run_at  of each crossing, the run that ends there, or `kNone`
  std::vector<EndLink> endLinks(const std::vector<std::uint32_t>& run_at, double longest_mm) const {
    std::vector<EndLink> links;
    for (std::uint32_t c = 0; c < raster_.crossings.size(); ++c) {
      const std::uint32_t next = onward(c);
      if (run_at[c] == kNone || run_at[next] == kNone || run_at[c] == run_at[next]) continue;
      const double length_mm = linkLength(c, next, longest_mm);
      if (length_mm <= longest_mm) links.push_back({length_mm, c, next});
    }
    std::stable_sort(links.begin(), links.end(),
                     [](const EndLink& a, const EndLink& b) { return a.length_mm < b.length_mm; });
    return links;
  }

  /// No line ends between the ends that are joined, so that no way lies on another.
  std::vector<RasterRun> joined(std::vector<RasterRun> runs, double longest_mm) const {
    std::vector<std::uint32_t> run_at(raster_.crossings.size(), kNone);
    for (std::uint32_t i = 0; i < runs.size(); ++i) run_at[runs[i].first] = run_at[runs[i].last] = i;
    for (const EndLink& link : endLinks(run_at, longest_mm)) {
      const std::uint32_t before = run_at[link.from];
      const std::uint32_t after = run_at[link.to];
      if (before == kNone || after == kNone || before == after) continue;
      run_at[link.from] = run_at[link.to] = kNone;
      runs[before] = joinedBy(link, std::move(runs[before]), std::move(runs[after]));
      runs[after] = {};
      run_at[runs[before].first] = run_at[runs[before].last] = before;
    }
    runs.erase(
        std::remove_if(runs.begin(), runs.end(), [](const RasterRun& run) { return run.points.empty(); }),
        runs.end());
    return runs;
  }

  RasterRun joinedBy(const EndLink& link, RasterRun before, RasterRun after) const {
    if (before.last != link.from) before = turned(std::move(before));
    if (after.first != link.to) after = turned(std::move(after));
    const Crossing& start = raster_.crossings[link.from];
    const std::size_t count = pointsBetween(start, raster_.crossings[link.to]);
    for (std::size_t step = 0; step < count; ++step) before.points.push_back(outlinePoint(start, step));
    std::move(after.points.begin(), after.points.end(), std::back_inserter(before.points));
    before.last = after.last;
    return before;
  }

  static RasterRun turned(RasterRun run) {
    std::reverse(run.points.begin(), run.points.end());
    std::swap(run.first, run.last);
    return run;
  }

  /// The next crossing along its outline.
  std::uint32_t onward(std::uint32_t c) const {
    if (c + 1 < raster_.crossings.size() && raster_.crossings[c + 1].outline == raster_.crossings[c].outline)
      return c + 1;
    const auto is_before = [](const Crossing& crossing, std::uint32_t outline) {
      return crossing.outline < outline;
    };
    const auto first = std::lower_bound(raster_.crossings.begin(), raster_.crossings.end(),
                                        raster_.crossings[c].outline, is_before);
    return static_cast<std::uint32_t>(first - raster_.crossings.begin());
  }

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
    if (std::abs(climb) != 1 || linkLength(from, to, longest_link_) > longest_link_) return;
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

  /// No more than it takes to know that it is too long.
  double linkLength(std::uint32_t from, std::uint32_t to, double longest_mm) const {
    const Crossing& start = raster_.crossings[from];
    const std::size_t count = pointsBetween(start, raster_.crossings[to]);
    Point2 last = pointAt(from);
    double sum = 0.0;
    for (std::size_t step = 0; step < count && sum <= longest_mm; ++step) {
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

  RasterRun trace(std::uint32_t c) {
    RasterRun run;
    run.first = c;
    const auto add = [&](const Point2& point) { run.points.push_back(point); };
    for (std::uint32_t next = kNone; c != kNone; c = next) {
      next = following(c);
      is_done_[lineOf(c)] = true;
      run.last = otherEnd(c);
      add(pointAt(c));
      add(pointAt(run.last));
      if (next != kNone) forEachOnLink(run.last, next, add);
    }
    return run;
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

std::vector<FillPath> joinedRasterRuns(const Regions& regions, const InfillRequest& request,
                                       double longest_mm) {
  const RasterFrame frame(request.angle_rad);
  const Raster raster = rasterise(regions, request.spacing_mm, frame);
  return RunBuilder(raster, longestLink(request, request.spacing_mm) * request.spacing_mm)
      .buildJoined(frame, longest_mm);
}

}  // namespace lamina
