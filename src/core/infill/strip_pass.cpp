// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/strip_pass.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

/// A bead's round end is this part of its width from the border: it then leaves hardly anything in the
/// corners and laps over little.
constexpr double kEndGap = 0.325;
/// Steepest border that counts for how far the outlines of the raster lie from the area's.
constexpr double kSteepest = 3.0;
/// A pass is at most this wide, in strips.
constexpr double kWidest = 1.6;
/// Widths change from one motion to the next by at most this part of the strip.
constexpr double kWidthStep = 0.25;

/// What a strip holds at x.
struct Slice {
  double x = 0.0;
  double middle = 0.0;  ///< from the strip's centre line
  double width = 0.0;
};

Slice between(const Slice& a, const Slice& b, double t) {
  return {a.x + t * (b.x - a.x), a.middle + t * (b.middle - a.middle), a.width + t * (b.width - a.width)};
}

/// How far material goes from the centre line of a strip on one side.
struct Reach {
  double filled = 0.0;  ///< to the border of what the pass fills
  double inside = 0.0;  ///< to the outline of the raster: so far centre lines may run

  void limit(double to, double growth) {
    filled = std::min(filled, to + growth);
    inside = std::min(inside, to);
  }
};

/// The middle of what is filled, as far as centre lines may run there.
Slice sliceAt(double x, const Reach& down, const Reach& up) {
  const double middle = 0.5 * (up.filled - down.filled);
  return {x, std::max(-down.inside, std::min(up.inside, middle)), up.filled + down.filled};
}

/// Part of an outline within half a strip: x, and height above or below the centre line.
struct Border {
  Polyline chain;
  double from_x = 0.0;   ///< where it leaves the centre line
  double outward = 1.0;  ///< +1 at the right end of the pass, -1 at the left
  double growth = 0.0;   ///< the material ends so much farther, square to the border

  double grownBy(const Point2& a, const Point2& b) const {
    const double slope = (b.y() - a.y()) / (b.x() - a.x());
    return growth * std::min(std::hypot(1.0, slope), kSteepest);
  }
};

/// Calls `visit(height, a, b)` for each edge of the chain over or under x.
template <class Visit>
void edgesAt(const Polyline& chain, double x, const Visit& visit) {
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const Point2& a = chain[i];
    const Point2& b = chain[i + 1];
    if (a.x() == b.x() || x < std::min(a.x(), b.x()) || x > std::max(a.x(), b.x())) continue;
    visit(a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y()), a, b);
  }
}

class StripSlicer {
 public:
  StripSlicer(const Strips& strips, std::uint32_t left)
      : strips_(strips),
        walk_(strips.walk),
        left_(left),
        right_(walk_.otherEnd(left)),
        half_(walk_.raster().spacing_mm),
        centre_(walk_.pointAt(left).y()) {}

  std::vector<Slice> slices(const PassEndShape& left_end, const PassEndShape& right_end) {
    addEnd(left_, left_end);
    addEnd(right_, right_end);
    addNotches();
    std::vector<Slice> all = branch(left_, left_end);
    std::reverse(all.begin(), all.end());
    for (const double x : mainBreaks())
      all.push_back(sliceAt(x, height(Vertical::Down, x), height(Vertical::Up, x)));
    const std::vector<Slice> beyond = branch(right_, right_end);
    all.insert(all.end(), beyond.begin(), beyond.end());
    return all;
  }

 private:
  static std::size_t sideOf(Vertical direction) { return direction == Vertical::Up ? 0 : 1; }

  Polyline localChain(std::uint32_t crossing, Vertical direction, Vertical side) const {
    Polyline chain = walk_.chain(crossing, direction);
    const double sign = side == Vertical::Up ? 1.0 : -1.0;
    for (Point2& point : chain) point.y() = sign * (point.y() - centre_);
    return chain;
  }

  void addEnd(std::uint32_t crossing, const PassEndShape& end) {
    for (const Vertical side : {Vertical::Up, Vertical::Down}) {
      Border border;
      border.chain = localChain(crossing, side, side);
      border.from_x = border.chain.front().x();
      border.outward = crossing == right_ ? 1.0 : -1.0;
      const bool is_linked = end.kind == (side == Vertical::Up ? PassEnd::LinkAbove : PassEnd::LinkBelow);
      border.growth = (is_linked ? -0.5 : 0.5) * strips_.narrowest_mm;
      if (is_linked) prolong(border);
      borders_[sideOf(side)].push_back(std::move(border));
    }
  }

  /// The link goes on beside the next strip, and reaches into this one until it is half its width away.
  void prolong(Border& border) const {
    const Point2& from = border.chain[border.chain.size() - 2];
    const Point2& to = border.chain.back();
    const double rise = to.y() - from.y();
    if (rise <= 0.0 || to.x() == from.x()) return;
    const double run = -border.grownBy(from, to) * (to.x() - from.x()) / rise;
    border.chain.emplace_back(to + std::min(1.0, 4.0 * half_ / std::abs(run)) * run *
                                       Point2(1.0, rise / (to.x() - from.x())));
  }

  void addNotches() {
    const std::size_t pass = walk_.insideLine(left_);
    auto notch = std::lower_bound(strips_.notches.begin(), strips_.notches.end(), pass,
                                  [](const Notch& n, std::size_t value) { return n.pass < value; });
    for (; notch != strips_.notches.end() && notch->pass == pass; ++notch) {
      const double edge = walk_.pointAt(notch->crossing).y();
      const Vertical side = edge > centre_ ? Vertical::Up : Vertical::Down;
      Border border;
      border.chain = localChain(notch->crossing, notch->direction, side);
      border.growth = 0.5 * strips_.narrowest_mm;
      (notch->is_cap ? caps_ : dips_)[sideOf(side)].push_back(std::move(border));
    }
  }

  /// How far the material of the pass reaches up, or down, from the centre line.
  Reach height(Vertical side, double x) const {
    Reach reach{half_, half_};
    for (const Border& cap : caps_[sideOf(side)])
      edgesAt(cap.chain, x, [&](double y, const Point2& a, const Point2& b) {
        reach.filled = std::max(reach.filled, y + cap.grownBy(a, b));
      });
    for (const Border& dip : dips_[sideOf(side)])
      edgesAt(dip.chain, x,
              [&](double y, const Point2& a, const Point2& b) { reach.limit(y, dip.grownBy(a, b)); });
    for (const Border& border : borders_[sideOf(side)])
      edgesAt(border.chain, x, [&](double y, const Point2& a, const Point2& b) {
        if (border.outward * (0.5 * (a.x() + b.x()) - border.from_x) < 0.0)
          reach.limit(y, border.grownBy(a, b));
      });
    return reach;
  }

  std::vector<double> mainBreaks() const {
    const double low = walk_.pointAt(left_).x();
    const double high = walk_.pointAt(right_).x();
    std::vector<double> breaks = {low, high};
    const auto add = [&](double x) {
      if (x > low && x < high) breaks.push_back(x);
    };
    const double beside = 0.1 * half_;
    for (const std::size_t side : {0, 1}) {
      for (const Border& border : borders_[side]) addBreaks(border, add);
      for (const auto* notches : {&caps_[side], &dips_[side]})
        for (const Border& notch : *notches)
          for (const Point2& point : notch.chain)
            for (const double x : {point.x() - beside, point.x(), point.x() + beside}) add(x);
    }
    std::sort(breaks.begin(), breaks.end());
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    return breaks;
  }

  /// Where the border bends, and where it leaves the edge of the strip.
  template <class Add>
  void addBreaks(const Border& border, const Add& add) const {
    for (std::size_t i = 0; i < border.chain.size(); ++i) {
      const Point2& a = border.chain[i];
      add(a.x());
      if (i + 1 == border.chain.size() || border.chain[i + 1].x() == a.x()) continue;
      const Point2& b = border.chain[i + 1];
      const double edge = half_ - border.grownBy(a, b);
      if ((a.y() - edge) * (b.y() - edge) < 0.0)
        add(a.x() + (edge - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  }

  /// How far the strip goes on beyond the end of its line between its edge and the outline that leaves there;
  /// 0 if it does not.
  double branchLength(const Border& border, Vertical side) const {
    const Point2& back = border.chain.back();
    const bool turns_back = std::abs(back.y()) < 1e-9;
    const double end_x = turns_back ? 0.5 * (border.from_x + back.x()) : back.x();
    const double reach = border.outward * (end_x - border.from_x);
    const std::int64_t edge = walk_.lineOf(left_) + (side == Vertical::Up ? 1 : -1);
    return reach > 0.25 * half_ && walk_.isInside(edge, border.from_x, end_x) ? reach : 0.0;
  }

  std::vector<Slice> branch(std::uint32_t crossing, const PassEndShape& end) const {
    if (end.kind == PassEnd::Turn) return {};
    const std::size_t which = crossing == left_ ? 0 : 1;
    const double up = branchLength(borders_[0][which], Vertical::Up);
    const double down = branchLength(borders_[1][which], Vertical::Down);
    if (up == 0.0 && down == 0.0) return {};
    if (end.kind == PassEnd::Joined && (end.towards == Vertical::Up ? up : down) == 0.0) return {};
    const bool goes_up = up > 0.0 && (down == 0.0 || end.towards == Vertical::Up);
    return branchSlices(borders_[goes_up ? 0 : 1][which], goes_up ? up : down, goes_up ? 1.0 : -1.0);
  }

  std::vector<Slice> branchSlices(const Border& border, double reach, double up) const {
    std::vector<double> along = {0.0, reach};
    for (const Point2& point : border.chain) {
      const double x = border.outward * (point.x() - border.from_x);
      if (x > 0.0 && x < reach) along.push_back(x);
    }
    std::sort(along.begin(), along.end());
    std::vector<Slice> slices;
    for (const double x : along) {
      const double at = border.from_x + border.outward * x;
      // The outline is the floor here, so that it limits how far material goes back to the centre line.
      Reach down;
      edgesAt(border.chain, at, [&](double y, const Point2& a, const Point2& b) {
        if (border.outward * (0.5 * (a.x() + b.x()) - border.from_x) > 0.0)
          down.limit(-y, border.grownBy(a, b));
      });
      down.filled = std::max(down.filled, -half_);
      const Slice slice = sliceAt(at, down, {half_, half_});
      slices.push_back({at, up * slice.middle, slice.width});
    }
    return slices;
  }

  const Strips& strips_;
  const RasterWalk& walk_;
  std::uint32_t left_;
  std::uint32_t right_;
  double half_;
  double centre_;
  std::vector<Border> borders_[2];  ///< above and below: at the left end, and at the right
  std::vector<Border> caps_[2];
  std::vector<Border> dips_[2];
};

/// Shortens the slices to where the pass may end on the right. None are left if it may nowhere.
void cutRight(std::vector<Slice>& slices, const PassEndShape& end, double line_end, double narrowest) {
  if (end.kind == PassEnd::Joined) return;
  const double tip = slices.back().x + 0.5 * narrowest;
  // What must not be negative at the end of a pass.
  const auto room = [&](const Slice& slice) {
    if (end.kind == PassEnd::Turn) return line_end - end.inset_mm - slice.x;
    return std::min(tip - slice.x - kEndGap * slice.width, slice.width - narrowest);
  };
  while (!slices.empty() && room(slices.back()) < 0.0) {
    const Slice last = slices.back();
    slices.pop_back();
    if (slices.empty() || room(slices.back()) < 0.0) continue;
    double enough = 0.0;
    double too_far = 1.0;
    const Slice before = slices.back();
    for (int i = 0; i < 20; ++i) {
      const double middle = 0.5 * (enough + too_far);
      (room(between(before, last, middle)) < 0.0 ? too_far : enough) = middle;
    }
    slices.push_back(between(before, last, enough));
    break;
  }
}

std::vector<Slice> mirrored(const std::vector<Slice>& slices) {
  std::vector<Slice> result;
  result.reserve(slices.size());
  for (auto slice = slices.rbegin(); slice != slices.rend(); ++slice)
    result.push_back({-slice->x, slice->middle, slice->width});
  return result;
}

/// A bead through the middle of the slices.
class PassTracer {
 public:
  PassTracer(double centre_y, double strip, double narrowest)
      : centre_y_(centre_y), strip_(strip), narrowest_(narrowest) {}

  FillPath trace(const std::vector<Slice>& slices) {
    add(middle(slices.front()), clamped(slices.front().width));
    for (std::size_t i = 1; i < slices.size(); ++i) addMotion(slices[i - 1], slices[i]);
    return std::move(path_);
  }

 private:
  Point2 middle(const Slice& slice) const { return {slice.x, centre_y_ + slice.middle}; }
  double clamped(double width) const { return std::clamp(width, narrowest_, kWidest * strip_); }

  void addMotion(const Slice& from, const Slice& to) {
    const double change = std::abs(clamped(to.width) - clamped(from.width));
    const int parts = 1 + static_cast<int>(change / (kWidthStep * strip_) - 1e-9);
    for (int k = 1; k <= parts; ++k) {
      const Point2 a = middle(between(from, to, static_cast<double>(k - 1) / parts));
      const Point2 b = middle(between(from, to, static_cast<double>(k) / parts));
      const double width = between(from, to, (k - 0.5) / parts).width;
      const double length = (b - a).norm();
      if (length < 1e-6) continue;
      // Slices are upright, widths are across the motion.
      const double tilt = std::max(std::abs(b.x() - a.x()) / length, 0.5);
      add(b, clamped(width * tilt));
    }
  }

  void add(const Point2& point, double width) {
    const std::size_t n = path_.points.size();
    const bool goes_on = n >= 2 && std::abs(path_.width_mm.back() - width) < 1e-6 &&
                         std::abs(path_.points[n - 1].y() - point.y()) < 1e-9 &&
                         std::abs(path_.points[n - 2].y() - point.y()) < 1e-9;
    if (goes_on) path_.points.pop_back();
    if (goes_on) path_.width_mm.pop_back();
    path_.points.push_back(point);
    path_.width_mm.push_back(width);
  }

  double centre_y_;
  double strip_;
  double narrowest_;
  FillPath path_;
};

}  // namespace

FillPath passThrough(const Strips& strips, std::uint32_t left, const PassEndShape& left_end,
                     const PassEndShape& right_end) {
  const RasterWalk& walk = strips.walk;
  const double left_x = walk.pointAt(left).x();
  const double right_x = walk.pointAt(walk.otherEnd(left)).x();
  std::vector<Slice> slices = StripSlicer(strips, left).slices(left_end, right_end);
  const Slice& thickest = *std::max_element(slices.begin(), slices.end(),
                                            [](const Slice& a, const Slice& b) { return a.width < b.width; });
  const Slice fallback = thickest;
  cutRight(slices, right_end, right_x, strips.narrowest_mm);
  if (!slices.empty()) {
    slices = mirrored(slices);
    cutRight(slices, left_end, -left_x, strips.narrowest_mm);
    slices = mirrored(slices);
  }
  if (slices.empty()) slices = {fallback};
  const double strip = 2.0 * walk.raster().spacing_mm;
  return PassTracer(walk.pointAt(left).y(), strip, strips.narrowest_mm).trace(slices);
}

std::vector<Notch> findNotches(const RasterWalk& walk) {
  std::vector<Notch> notches;
  const auto count = static_cast<std::uint32_t>(walk.raster().crossings.size());
  for (std::uint32_t c = 0; c < count; ++c) {
    const std::int64_t edge = walk.lineOf(c);
    if (edge % 2 != 0) continue;
    for (const Vertical direction : {Vertical::Up, Vertical::Down}) {
      const std::uint32_t back = walk.next(c, direction);
      const double from = walk.pointAt(c).x();
      const double to = walk.pointAt(back).x();
      if (walk.lineOf(back) != edge || from >= to) continue;
      const bool is_cap = walk.isLeftEnd(c);
      const std::int64_t towards = direction == Vertical::Up ? 1 : -1;
      const std::int64_t line = is_cap ? edge - towards : edge + towards;
      const auto pass = walk.insideLineAt(line, 0.5 * (from + to));
      if (pass) notches.push_back({*pass, c, direction, is_cap});
    }
  }
  std::sort(notches.begin(), notches.end(), [](const Notch& a, const Notch& b) {
    return a.pass != b.pass ? a.pass < b.pass : a.crossing < b.crossing;
  });
  return notches;
}

}  // namespace lamina
