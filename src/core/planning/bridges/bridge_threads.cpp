// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/bridges/bridge_threads.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "infill/rectilinear/raster.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

constexpr double kTouch = 1e-3;           // mm: above what areas are off by
constexpr double kFromWalls = 0.49;       // spacings: the outermost threads lie half a spacing from them
constexpr double kShortestThread = 0.05;  // mm
constexpr double kCut = 0.5;              // spacings: a joint adds as much as both of its threads lose
constexpr double kLeastHeld = 1.0;        // spacings: half of it is left where a joint cuts a thread
constexpr double kFarthest = 2.0;         // spacings along the threads, from one joined end to the other

/// From one place of a line to another [mm, raster frame].
using Stretch = std::pair<double, double>;

/// The lines of a raster, asked for by number.
class StretchesOf {
 public:
  StretchesOf(const Regions& regions, double spacing_mm, const RasterFrame& frame)
      : raster_(rasterise(regions, spacing_mm, frame)) {}

  const Raster& raster() const { return raster_; }

  std::vector<Stretch> on(std::int64_t line) const {
    std::vector<Stretch> stretches;
    const auto row = static_cast<std::size_t>(line - raster_.lowest);
    if (line < raster_.lowest || row + 1 >= raster_.line_begin.size()) return stretches;
    for (std::uint32_t i = raster_.line_begin[row]; i + 1 < raster_.line_begin[row + 1]; i += 2)
      stretches.emplace_back(xOf(i), xOf(i + 1));
    return stretches;
  }

 private:
  double xOf(std::uint32_t sorted) const { return raster_.crossings[raster_.sorted[sorted]].x; }

  Raster raster_;
};

/// One thread, and how much of either end lies on what holds it.
struct Thread {
  std::int64_t line = 0;
  Stretch at;
  Stretch held_mm;
};

/// Which end of a thread.
enum class ThreadEnd { First, Second };

double endOf(const Stretch& stretch, ThreadEnd end) {
  return end == ThreadEnd::First ? stretch.first : stretch.second;
}

ThreadEnd otherThan(ThreadEnd end) { return end == ThreadEnd::First ? ThreadEnd::Second : ThreadEnd::First; }

/// The one that begins before or at x, or a little beyond, and goes on after it.
std::optional<Stretch> goingOn(const std::vector<Stretch>& stretches, double x, double slack) {
  for (const Stretch& each : stretches)
    if (each.first <= x + slack && each.second > x + slack) return each;
  return std::nullopt;
}

/// The same to the other side.
std::optional<Stretch> comingFrom(const std::vector<Stretch>& stretches, double x, double slack) {
  for (const Stretch& each : stretches)
    if (each.second >= x - slack && each.first < x - slack) return each;
  return std::nullopt;
}

/// How far a thread goes on from a place where it meets what holds it.
/// @param held_mm  that it could, to another gap or to a wall
double anchored(double anchor_mm, double held_mm, bool is_gap_beyond) {
  return std::min(anchor_mm, is_gap_beyond ? 0.5 * held_mm : held_mm);
}

class ThreadLayer {
 public:
  ThreadLayer(const Region& piece, const Regions& below, const Regions& inside, const ThreadLayout& layout)
      : layout_(layout),
        lines_(linesAcross(piece, layout)),
        piece_({piece}, lines_.spacing_mm, lines_.frame),
        below_(below, lines_.spacing_mm, lines_.frame),
        inside_(offset(inside, -kFromWalls * lines_.spacing_mm), lines_.spacing_mm, lines_.frame) {}

  std::vector<FillPath> lay() const {
    std::vector<Thread> threads;
    const auto rows = static_cast<std::int64_t>(piece_.raster().line_begin.size()) - 1;
    for (std::int64_t row = 0; row < rows; ++row) addLine(piece_.raster().lowest + row, threads);
    std::vector<FillPath> runs;
    runs.reserve(threads.size());
    std::vector<bool> is_laid(threads.size(), false);
    for (std::size_t i = 0; i < threads.size(); ++i)
      if (!is_laid[i]) runs.push_back(joinedFrom(i, threads, is_laid));
    return runs;
  }

 private:
  /// Lines that share out the width of a piece evenly.
  struct Lines {
    double spacing_mm;
    RasterFrame frame;
  };

  static Lines linesAcross(const Region& piece, const ThreadLayout& layout) {
    const RasterFrame upright(layout.angle_rad);
    Polygon turned;
    for (const Point2& point : piece.outer) turned.push_back(upright.intoRaster(point));
    const Box2 box = boundingBox({turned});
    const double width = box.size().y();
    const double spacing = width / std::max(1.0, std::round(width / layout.pitch_mm));
    return {spacing, RasterFrame(layout.angle_rad, box.low.y() + 0.5 * spacing)};
  }

  void addLine(std::int64_t line, std::vector<Thread>& threads) const {
    const std::vector<Stretch> below = below_.on(line);
    const std::vector<Stretch> inside = inside_.on(line);
    const std::size_t before = threads.size();
    for (const Stretch& free : piece_.on(line))
      for (const Stretch& room : inside) {
        if (room.second <= free.first || room.first >= free.second) continue;
        const Stretch thread = {std::max(begin(free, below, room), room.first),
                                std::min(end(free, below, room), room.second)};
        const double held_mm = std::max(0.0, thread.second - free.second);
        if (threads.size() > before && thread.first <= threads.back().at.second) {
          threads.back().at.second = thread.second;
          threads.back().held_mm.second = held_mm;
        } else {
          threads.push_back({line, thread, {std::max(0.0, free.first - thread.first), held_mm}});
        }
      }
    const auto is_short = [](const Thread& thread) {
      return thread.at.second - thread.at.first < kShortestThread;
    };
    threads.erase(
        std::remove_if(threads.begin() + static_cast<std::ptrdiff_t>(before), threads.end(), is_short),
        threads.end());
  }

  /// To and fro, as far as neighbours end beside each other on what holds them.
  FillPath joinedFrom(std::size_t first, const std::vector<Thread>& threads,
                      std::vector<bool>& is_laid) const {
    FillPath run;
    run.role = PathRole::Bridge;
    std::optional<std::size_t> next = neighbour(first, ThreadEnd::Second, threads, is_laid);
    ThreadEnd leaves = ThreadEnd::Second;
    if (!next) {
      next = neighbour(first, ThreadEnd::First, threads, is_laid);
      if (next) leaves = ThreadEnd::First;
    }
    run.points.push_back(pointAt(threads[first], otherThan(leaves), 0.0));
    for (std::size_t thread = first;;) {
      is_laid[thread] = true;
      run.points.push_back(pointAt(threads[thread], leaves, next ? kCut : 0.0));
      if (!next) return run;
      thread = *next;
      run.points.push_back(pointAt(threads[thread], leaves, kCut));
      leaves = otherThan(leaves);
      next = neighbour(thread, leaves, threads, is_laid);
    }
  }

  /// A thread of the next line that may be joined to that end.
  std::optional<std::size_t> neighbour(std::size_t thread, ThreadEnd end, const std::vector<Thread>& threads,
                                       const std::vector<bool>& is_laid) const {
    const Thread& from = threads[thread];
    if (!isHeld(from, end)) return std::nullopt;
    for (std::size_t i = thread + 1; i < threads.size() && threads[i].line <= from.line + 1; ++i)
      if (threads[i].line > from.line && !is_laid[i] && isHeld(threads[i], end) &&
          std::abs(endOf(threads[i].at, end) - endOf(from.at, end)) <= kFarthest * lines_.spacing_mm)
        return i;
    return std::nullopt;
  }

  /// So that it can be cut there.
  bool isHeld(const Thread& thread, ThreadEnd end) const {
    return endOf(thread.held_mm, end) >= kLeastHeld * lines_.spacing_mm;
  }

  /// @param cut  by which the thread is shorter, in spacings
  Point2 pointAt(const Thread& thread, ThreadEnd end, double cut) const {
    const double inwards = end == ThreadEnd::First ? cut : -cut;
    return lines_.frame.outOfRaster({endOf(thread.at, end) + inwards * lines_.spacing_mm,
                                     static_cast<double>(thread.line) * lines_.spacing_mm});
  }

  /// What was too narrow for a piece lies between it and what holds it.
  double slack() const { return 0.5 * layout_.pitch_mm; }

  double begin(const Stretch& free, const std::vector<Stretch>& below, const Stretch& room) const {
    const std::optional<Stretch> held = comingFrom(below, free.first, slack());
    if (!held) return free.first;
    return free.first -
           anchored(layout_.anchor_mm, free.first - held->first, held->first > room.first + kTouch);
  }

  double end(const Stretch& free, const std::vector<Stretch>& below, const Stretch& room) const {
    const std::optional<Stretch> held = goingOn(below, free.second, slack());
    if (!held) return free.second;
    return free.second +
           anchored(layout_.anchor_mm, held->second - free.second, held->second < room.second - kTouch);
  }

  ThreadLayout layout_;
  Lines lines_;
  StretchesOf piece_;
  StretchesOf below_;
  StretchesOf inside_;
};

/// A region drawn along a way to both sides.
Regions drawnOut(const Region& region, const Point2& way) {
  std::vector<Polygon> polygons = outlines({region});
  const std::size_t count = polygons.size();
  for (std::size_t o = 0; o < count; ++o)
    for (std::size_t i = 0, j = polygons[o].size() - 1; i < polygons[o].size(); j = i++) {
      const Point2& a = polygons[o][j];
      const Point2& b = polygons[o][i];
      Polygon drawn{a - way, a + way, b + way, b - way};
      if (signedArea(drawn) < 0.0) std::reverse(drawn.begin(), drawn.end());
      polygons.push_back(std::move(drawn));
    }
  return unite(polygons);
}

}  // namespace

std::vector<FillPath> bridgeThreads(const Region& piece, const Regions& below, const Regions& inside,
                                    const ThreadLayout& layout) {
  return ThreadLayer(piece, below, inside, layout).lay();
}

Regions coveredByThreads(const Region& piece, const Regions& inside, const ThreadLayout& layout) {
  const Point2 way = layout.anchor_mm * Point2(std::cos(layout.angle_rad), std::sin(layout.angle_rad));
  Regions covered = intersection(drawnOut(piece, way), inside);
  if (covered.size() < 2) return covered;
  // Beyond a wall no thread goes on.
  const auto isApart = [&piece](const Region& region) { return intersection({region}, {piece}).empty(); };
  covered.erase(std::remove_if(covered.begin(), covered.end(), isApart), covered.end());
  return covered;
}

}  // namespace lamina
