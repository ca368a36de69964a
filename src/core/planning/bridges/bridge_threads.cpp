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
    std::vector<FillPath> threads;
    const auto rows = static_cast<std::int64_t>(piece_.raster().line_begin.size()) - 1;
    for (std::int64_t row = 0; row < rows; ++row) addLine(piece_.raster().lowest + row, threads);
    return threads;
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

  void addLine(std::int64_t line, std::vector<FillPath>& threads) const {
    const std::vector<Stretch> below = below_.on(line);
    const std::vector<Stretch> inside = inside_.on(line);
    std::vector<Stretch> merged;
    for (const Stretch& free : piece_.on(line))
      for (const Stretch& room : inside) {
        if (room.second <= free.first || room.first >= free.second) continue;
        const Stretch thread = {std::max(begin(free, below, room), room.first),
                                std::min(end(free, below, room), room.second)};
        if (!merged.empty() && thread.first <= merged.back().second)
          merged.back().second = thread.second;
        else
          merged.push_back(thread);
      }
    const double y = static_cast<double>(line) * lines_.spacing_mm;
    for (const Stretch& thread : merged) {
      if (thread.second - thread.first < kShortestThread) continue;
      FillPath path;
      path.role = PathRole::Bridge;
      path.points = {lines_.frame.outOfRaster({thread.first, y}),
                     lines_.frame.outOfRaster({thread.second, y})};
      threads.push_back(std::move(path));
    }
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
