// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/bridges/bridge_direction.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/polygon/plane_vectors.hpp"
#include "infill/rectilinear/raster.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/geometry/polygon/simplify.hpp"
#include "planning/overhangs/border_distance.hpp"

namespace lamina {
namespace {

constexpr double kSimplification = 0.03;  // pitches
constexpr double kEquallyHeld = 0.03;     // of the length
constexpr double kSameDirection = kDegree;
constexpr double kSameSpan = 1e-6;     // mm
constexpr int kDirectionsAround = 36;  // every 5 deg
constexpr std::size_t kMostChordEnds = 12;
constexpr std::size_t kMostLines = 96;
constexpr std::size_t kFewLines = 16;
constexpr std::size_t kFirstEdges = 4;  // of a first look
constexpr int kFirstDirections = 12;
constexpr double kHopeless = 0.5;  // of the least share held, at a first look

double inHalfTurn(double angle) {
  const double turned = std::fmod(angle, M_PI);
  return turned < 0.0 ? turned + M_PI : turned;
}

double directionOf(const Point2& way) { return inHalfTurn(std::atan2(way.y(), way.x())); }

bool isSameDirection(double a, double b) {
  const double apart = std::abs(a - b);
  return std::min(apart, M_PI - apart) < kSameDirection;
}

void addDirection(std::vector<double>& directions, double angle) {
  const auto isSame = [angle](double other) { return isSameDirection(angle, other); };
  if (std::none_of(directions.begin(), directions.end(), isSame)) directions.push_back(angle);
}

/// Lines across a piece in one direction, as far as both of their ends are held.
struct HeldLines {
  double angle;
  double share;  ///< of the length of all lines
  double spacing_mm;
  double bottom_mm;                                      ///< of the raster
  std::vector<std::pair<std::int64_t, double>> middles;  ///< line of the raster, and place on it
};

/// A piece over nothing, and round it a border of which every edge is held by the layer below or is not.
class HeldPiece {
 public:
  HeldPiece(const Region& piece, const Regions& below, const BridgeSearch& search)
      : search_(search), below_regions_(&below), below_(below, search.anchor_mm) {
    for (const Polygon& outline : simplify(outlines({piece}), kSimplification * search.pitch_mm))
      (signedArea(outline) > 0.0 ? piece_.outer : piece_.holes.emplace_back()) = outline;
    for (const Region& region : offset({piece_}, 0.5 * search.anchor_mm)) {
      Region& divided = border_.emplace_back();
      divided.outer = dividedBorder(region.outer);
      for (const Polygon& hole : region.holes) divided.holes.push_back(dividedBorder(hole));
    }
  }

  bool isHeldSomewhere() const {
    return std::any_of(is_held_.begin(), is_held_.end(), [](const std::vector<bool>& outline) {
      return std::find(outline.begin(), outline.end(), true) != outline.end();
    });
  }

  /// Of the piece's edges, the longest first.
  std::vector<double> edgeDirections() const {
    std::vector<std::pair<double, double>> by_length;  // negative, and the angle
    for (const Polygon& outline : outlines({piece_}))
      for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const Point2 edge = outline[i] - outline[j];
        if (edge.norm() > search_.pitch_mm) by_length.emplace_back(-edge.norm(), directionOf(edge));
      }
    std::sort(by_length.begin(), by_length.end());
    std::vector<double> directions;
    for (const auto& edge : by_length) addDirection(directions, edge.second);
    return directions;
  }

  /// Of the chords between the ends of what is held of the border.
  std::vector<double> chordDirections() const {
    std::vector<double> directions;
    const Polygon ends = heldEnds();
    for (std::size_t i = 0; i < ends.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if ((ends[i] - ends[j]).norm() > search_.pitch_mm)
          addDirection(directions, directionOf(ends[i] - ends[j]));
    return directions;
  }

  /// What is held by lines in that direction, of which there are no more than that.
  HeldLines along(double angle, std::size_t most_lines) const {
    const RasterFrame upright(angle);
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Point2& point : piece_.outer) {
      const double y = upright.intoRaster(point).y();
      low = std::min(low, y);
      high = std::max(high, y);
    }
    HeldLines found{angle, 0.0, 0.0, 0.0, {}};
    if (!(high - low > 0.0)) return found;
    const double lines = std::clamp(std::ceil((high - low) / search_.pitch_mm), 1.0, double(most_lines));
    found.spacing_mm = (high - low) / lines;
    found.bottom_mm = low + 0.5 * found.spacing_mm;
    const RasterFrame frame(angle, found.bottom_mm);
    const Raster outer = rasterise(border_, found.spacing_mm, frame);
    if (!holdsAny(outer)) return found;
    const Raster inner = rasterise({piece_}, found.spacing_mm, frame);
    double length = 0.0, held = 0.0;
    for (std::size_t i = 0; i + 1 < inner.sorted.size(); i += 2) {
      const Crossing& from = inner.crossings[inner.sorted[i]];
      const double way = inner.crossings[inner.sorted[i + 1]].x - from.x;
      length += way;
      if (!isHeldAt(outer, from.line, from.x + 0.5 * way)) continue;
      held += way;
      found.middles.emplace_back(from.line, from.x + 0.5 * way);
    }
    found.share = length > 0.0 ? held / length : 0.0;
    return found;
  }

  /// What the border encloses over nothing, walls among it.
  Regions open() const { return difference(border_, *below_regions_); }

  /// The longest of the held lines, from border to border.
  static double longestSpan(const HeldLines& lines, const Regions& open) {
    if (lines.middles.empty()) return 0.0;
    const Raster free = rasterise(open, lines.spacing_mm, RasterFrame(lines.angle, lines.bottom_mm));
    double longest = 0.0;
    for (const auto& [line, x] : lines.middles) longest = std::max(longest, lengthAt(free, line, x));
    return longest;
  }

 private:
  /// The outline with points where it enters and leaves the layer below; notes which edges lie over that.
  Polygon dividedBorder(const Polygon& outline) {
    Polygon divided;
    std::vector<bool> held;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Point2& from = outline[i];
      const Point2 way = outline[i + 1 < outline.size() ? i + 1 : 0] - from;
      const std::vector<double> cuts = crossingsOf(from, way);
      for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
        divided.emplace_back(from + cuts[c] * way);
        held.push_back(below_.isInside(from + 0.5 * (cuts[c] + cuts[c + 1]) * way));
      }
    }
    is_held_.push_back(std::move(held));
    return divided;
  }

  /// Along the edge, 0 and 1 among them, in order.
  std::vector<double> crossingsOf(const Point2& from, const Point2& way) const {
    std::vector<double> cuts{0.0, 1.0};
    const Point2 to = from + way;
    below_.visitEdges(from.cwiseMin(to), from.cwiseMax(to), [&](const Point2& a, const Point2& b) {
      if (!areCrossing(from, to, a, b)) return;
      const double before = side(a, b, from);
      cuts.push_back(std::clamp(before / (before - side(a, b, to)), 0.0, 1.0));
    });
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    return cuts;
  }

  /// Where held stretches of the border begin and end; of too many the first ones.
  Polygon heldEnds() const {
    Polygon ends;
    const std::vector<Polygon> borders = outlines(border_);
    for (std::size_t o = 0; o < borders.size(); ++o)
      for (std::size_t i = 0, j = borders[o].size() - 1; i < borders[o].size(); j = i++)
        if (is_held_[o][i] != is_held_[o][j] && ends.size() < kMostChordEnds) ends.push_back(borders[o][i]);
    return ends;
  }

  using LineEnds = std::pair<const Crossing*, const Crossing*>;

  /// The ends of the line inside that holds x; null if none does.
  static LineEnds endsAt(const Raster& raster, std::int64_t line, double x) {
    const auto row = static_cast<std::size_t>(line - raster.lowest);
    if (line < raster.lowest || row + 1 >= raster.line_begin.size()) return {};
    for (std::uint32_t i = raster.line_begin[row]; i + 1 < raster.line_begin[row + 1]; i += 2) {
      const Crossing& from = raster.crossings[raster.sorted[i]];
      const Crossing& to = raster.crossings[raster.sorted[i + 1]];
      if (from.x <= x && x <= to.x) return {&from, &to};
    }
    return {};
  }

  bool isHeld(const Crossing& end) const { return is_held_[end.outline][end.edge]; }

  /// Whether any line of the border's raster ends on held edges.
  bool holdsAny(const Raster& raster) const {
    for (std::size_t row = 0; row + 1 < raster.line_begin.size(); ++row)
      for (std::uint32_t i = raster.line_begin[row]; i + 1 < raster.line_begin[row + 1]; i += 2)
        if (isHeld(raster.crossings[raster.sorted[i]]) && isHeld(raster.crossings[raster.sorted[i + 1]]))
          return true;
    return false;
  }

  /// Whether the line of the border's raster that holds x ends on held edges.
  bool isHeldAt(const Raster& raster, std::int64_t line, double x) const {
    const auto [from, to] = endsAt(raster, line, x);
    return from != nullptr && isHeld(*from) && isHeld(*to);
  }

  static double lengthAt(const Raster& raster, std::int64_t line, double x) {
    const auto [from, to] = endsAt(raster, line, x);
    return from != nullptr ? to->x - from->x : 0.0;
  }

  BridgeSearch search_;
  const Regions* below_regions_;
  BorderDistance below_;
  Region piece_;
  Regions border_;
  std::vector<std::vector<bool>> is_held_;  ///< edges of the border's outlines
};

/// Few directions with few lines: whether any can be enough.
bool isHopeless(const HeldPiece& piece, const std::vector<double>& edges, const std::vector<double>& chords,
                double least_held) {
  std::vector<double> angles(
      edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(std::min(edges.size(), kFirstEdges)));
  angles.insert(angles.end(), chords.begin(), chords.end());
  for (int i = 0; i < kFirstDirections; ++i) angles.push_back(M_PI * i / kFirstDirections);
  return std::none_of(angles.begin(), angles.end(), [&](double angle) {
    return piece.along(angle, kFewLines).share >= kHopeless * least_held;
  });
}

}  // namespace

BridgeDirection bridgeDirection(const Region& piece, const Regions& below, const BridgeSearch& search) {
  const HeldPiece held(piece, below, search);
  if (!held.isHeldSomewhere()) return {};
  std::vector<double> angles = held.edgeDirections();
  const std::vector<double> chords = held.chordDirections();
  if (isHopeless(held, angles, chords, search.least_held)) return {};
  for (const double chord : chords) addDirection(angles, chord);
  for (int i = 0; i < kDirectionsAround; ++i) addDirection(angles, M_PI * i / kDirectionsAround);
  std::vector<HeldLines> found;
  double most = 0.0;
  for (const double angle : angles) {
    found.push_back(held.along(angle, kMostLines));
    most = std::max(most, found.back().share);
  }
  const Regions open = held.open();
  BridgeDirection best;
  for (const HeldLines& each : found) {
    if (!(each.share > 0.0 && each.share >= most - kEquallyHeld)) continue;
    const double span_mm = HeldPiece::longestSpan(each, open);
    if (best.held == 0.0 || span_mm < best.span_mm - kSameSpan) best = {each.angle, each.share, span_mm};
  }
  return best;
}

BridgeDirection bridgeAlong(double angle_rad, const Region& piece, const Regions& below,
                            const BridgeSearch& search) {
  const HeldPiece held(piece, below, search);
  const HeldLines lines = held.along(inHalfTurn(angle_rad), kMostLines);
  return {lines.angle, lines.share, HeldPiece::longestSpan(lines, held.open())};
}

}  // namespace lamina
