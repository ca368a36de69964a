// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/variable_width_pass.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace lamina {
namespace {

/// What a variable-width line holds at x.
struct VariableWidthSlice {
  double x = 0.0;
  double middle = 0.0;  ///< from the variable-width line's centre line
  double width = 0.0;
};

/// Steepest border that counts for how far the outlines of the raster lie from the area's.
constexpr double kSteepest = 3.0;
/// Steepest border between which and the variable-width line a bead is fitted, as the cosine of its slope:
/// beyond, it keeps more of its width up to its end, or it would leave the corners empty.
constexpr double kFlankCosine = 0.7;
/// Slices follow each other so densely that they miss no bend of this size, or stand so near to each other,
/// in half variable-width lines.
constexpr double kBend = 0.06;
constexpr double kShortestStep = 0.2;

/// A straight border beside a slice.
struct Flank {
  double height = 0.0;  ///< at the slice, from the centre line
  double cosine = 1.0;  ///< of its slope
};

/// How far material goes from the centre line of a variable-width line on one side.
struct Reach {
  std::vector<Flank> filled;  ///< borders of what the pass fills
  double inside = 0.0;        ///< to the outline of the raster: so far centre lines may run
};

/// The disc between the borders: where a bead touches them, it neither leaves a gap nor laps over.
VariableWidthSlice sliceAt(double x, const Reach& down, const Reach& up) {
  VariableWidthSlice slice{x, 0.0, std::numeric_limits<double>::infinity()};
  for (const Flank& d : down.filled)
    for (const Flank& u : up.filled) {
      const double sum = d.cosine + u.cosine;
      const double width = 2.0 * (u.height + d.height) * u.cosine * d.cosine / sum;
      if (width < slice.width) slice = {x, (u.height * u.cosine - d.height * d.cosine) / sum, width};
    }
  slice.middle = std::max(-down.inside, std::min(up.inside, slice.middle));
  return slice;
}

/// Part of an outline within half a variable-width line: x, and height above or below the centre line.
struct Border {
  Polyline chain;
  double from_x = 0.0;   ///< where it leaves the centre line
  double outward = 1.0;  ///< +1 at the right end of the pass, -1 at the left
  double growth = 0.0;   ///< the material ends so much farther, square to the border

  double grownBy(const Point2& a, const Point2& b) const {
    const double slope = (b.y() - a.y()) / (b.x() - a.x());
    return growth * std::min(std::hypot(1.0, slope), kSteepest);
  }

  /// Where the material ends over or under an edge that is y high there.
  Flank flank(double y, const Point2& a, const Point2& b) const {
    return {y + grownBy(a, b), std::max(kFlankCosine, std::abs(b.x() - a.x()) / (b - a).norm())};
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

class VariableWidthSlicer {
 public:
  VariableWidthSlicer(const VariableWidthLines& lines, std::uint32_t left)
      : lines_(lines),
        walk_(lines.walk),
        left_(left),
        right_(walk_.otherEnd(left)),
        half_(walk_.raster().spacing_mm),
        centre_(walk_.pointAt(left).y()) {}

  std::vector<VariableWidthSlice> slices(const PassEndShape& left_end, const PassEndShape& right_end) {
    addEnd(left_, left_end);
    addEnd(right_, right_end);
    addNotches();
    std::vector<VariableWidthSlice> all = branch(left_, left_end);
    std::reverse(all.begin(), all.end());
    appendMain(all);
    const std::vector<VariableWidthSlice> beyond = branch(right_, right_end);
    all.insert(all.end(), beyond.begin(), beyond.end());
    return all;
  }

 private:
  VariableWidthSlice mainSlice(double x) const {
    return sliceAt(x, height(Vertical::Down, x), height(Vertical::Up, x));
  }

  void appendMain(std::vector<VariableWidthSlice>& all) const {
    const std::vector<double> breaks = mainBreaks();
    all.push_back(mainSlice(breaks.front()));
    for (std::size_t i = 1; i < breaks.size(); ++i) {
      const VariableWidthSlice from = all.back();
      appendBetween(from, mainSlice(breaks[i]), all);
    }
  }

  /// Slices up to `to` so near to each other that the variable-width line is straight between them: where
  /// discs begin to touch other borders, it bends.
  void appendBetween(const VariableWidthSlice& from, const VariableWidthSlice& to,
                     std::vector<VariableWidthSlice>& all) const {
    const double x = 0.5 * (from.x + to.x);
    const VariableWidthSlice slice = mainSlice(x);
    const double bend = std::max(std::abs(slice.width - 0.5 * (from.width + to.width)),
                                 std::abs(slice.middle - 0.5 * (from.middle + to.middle)));
    if (bend > kBend * half_ && to.x - from.x > kShortestStep * half_) {
      appendBetween(from, slice, all);
      appendBetween(slice, to, all);
    } else {
      all.push_back(to);
    }
  }

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
      border.growth = (is_linked ? -0.5 : 0.5) * lines_.narrowest_mm;
      if (is_linked) prolong(border);
      borders_[sideOf(side)].push_back(std::move(border));
    }
  }

  /// The link goes on beside the next variable-width line, and reaches into this one until it is half its
  /// width away.
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
    auto notch = std::lower_bound(lines_.notches.begin(), lines_.notches.end(), pass,
                                  [](const Notch& n, std::size_t value) { return n.pass < value; });
    for (; notch != lines_.notches.end() && notch->pass == pass; ++notch) {
      const double edge = walk_.pointAt(notch->crossing).y();
      const Vertical side = edge > centre_ ? Vertical::Up : Vertical::Down;
      Border border;
      border.chain = localChain(notch->crossing, notch->direction, side);
      border.growth = 0.5 * lines_.narrowest_mm;
      (notch->is_cap ? caps_ : dips_)[sideOf(side)].push_back(std::move(border));
    }
  }

  /// How far the material of the pass reaches up, or down, from the centre line.
  Reach height(Vertical side, double x) const {
    Reach reach{{}, half_};
    Flank edge{half_, 1.0};
    for (const Border& cap : caps_[sideOf(side)])
      edgesAt(cap.chain, x, [&](double y, const Point2& a, const Point2& b) {
        edge.height = std::max(edge.height, y + cap.grownBy(a, b));
      });
    reach.filled = {edge};
    for (const Border& dip : dips_[sideOf(side)])
      edgesAt(dip.chain, x, [&](double y, const Point2& a, const Point2& b) {
        reach.inside = std::min(reach.inside, y);
        reach.filled.push_back({y + dip.grownBy(a, b), 1.0});
      });
    for (const Border& border : borders_[sideOf(side)]) {
      edgesAt(border.chain, x, [&](double y, const Point2& a, const Point2& b) {
        if (border.outward * (0.5 * (a.x() + b.x()) - border.from_x) >= 0.0) return;
        reach.inside = std::min(reach.inside, y);
        reach.filled.push_back(border.flank(y, a, b));
      });
      if (const auto ahead = flankAhead(border, x)) reach.filled.push_back(*ahead);
    }
    return reach;
  }

  /// A border that will come in from the edge of the variable-width line: a bead makes room for it before it
  /// gets there.
  static std::optional<Flank> flankAhead(const Border& border, double x) {
    const Point2& a = border.chain[border.chain.size() - 2];
    const Point2& b = border.chain.back();
    if (border.outward * (b.x() - a.x()) >= 0.0 || border.outward * (b.x() - x) <= 0.0) return std::nullopt;
    const double slope = (b.y() - a.y()) / (b.x() - a.x());
    if (slope * border.outward >= 0.0) return std::nullopt;
    return border.flank(b.y() + (x - b.x()) * slope, a, b);
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

  /// Where the border bends, and where it leaves the edge of the variable-width line.
  template <class Add>
  void addBreaks(const Border& border, const Add& add) const {
    for (std::size_t i = 0; i < border.chain.size(); ++i) {
      const Point2& a = border.chain[i];
      add(a.x());
      if (i + 1 == border.chain.size() || border.chain[i + 1].x() == a.x()) continue;
      const Point2& b = border.chain[i + 1];
      const Flank flank = border.flank(0.0, a, b);
      const double edge = half_ - flank.height;
      const double x_at_edge = a.x() + (edge - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
      if ((a.y() - edge) * (b.y() - edge) < 0.0) add(x_at_edge);
      const double touched = half_ / flank.cosine - flank.height;
      if (i + 2 == border.chain.size() && (b.y() - a.y()) > 0.0)
        add(a.x() + (touched - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  }

  /// Where the variable-width line ends that goes on beyond the end of its line, between its edge and the
  /// outline that leaves there; nothing if it does not.
  std::optional<double> branchEnd(const Border& border, Vertical side) const {
    const Point2& back = border.chain.back();
    const bool turns_back = std::abs(back.y()) < 1e-9;
    const double end_x = turns_back ? 0.5 * (border.from_x + back.x()) : back.x();
    const std::int64_t edge = walk_.lineOf(left_) + (side == Vertical::Up ? 1 : -1);
    if (border.outward * (end_x - border.from_x) <= 0.25 * half_) return std::nullopt;
    if (!walk_.isInside(edge, border.from_x, end_x)) return std::nullopt;
    return end_x;
  }

  std::vector<VariableWidthSlice> branch(std::uint32_t crossing, const PassEndShape& end) const {
    if (end.kind == PassEnd::Turn) return {};
    const std::size_t which = crossing == left_ ? 0 : 1;
    const std::optional<double> up = branchEnd(borders_[0][which], Vertical::Up);
    const std::optional<double> down = branchEnd(borders_[1][which], Vertical::Down);
    if (!up && !down) return {};
    if (end.kind == PassEnd::Joined && !(end.towards == Vertical::Up ? up : down)) return {};
    const bool goes_up = up && (!down || end.towards == Vertical::Up);
    return branchSlices(borders_[goes_up ? 0 : 1][which], goes_up ? *up : *down, goes_up ? 1.0 : -1.0);
  }

  /// The places are those of the chain's points to the last bit: beyond its last one there is no outline.
  std::vector<VariableWidthSlice> branchSlices(const Border& border, double end_x, double up) const {
    std::vector<double> along = {border.from_x, end_x};
    for (const Point2& point : border.chain)
      if (border.outward * (point.x() - border.from_x) > 0.0 && border.outward * (end_x - point.x()) > 0.0)
        along.push_back(point.x());
    std::sort(along.begin(), along.end(),
              [&border](double a, double b) { return border.outward * a < border.outward * b; });
    std::vector<VariableWidthSlice> slices;
    slices.reserve(along.size());
    for (const double at : along) {
      // The outline is the floor here, so that it limits how far material goes back to the centre line.
      Reach down{{{0.0, 1.0}}, 0.0};
      edgesAt(border.chain, at, [&](double y, const Point2& a, const Point2& b) {
        if (border.outward * (0.5 * (a.x() + b.x()) - border.from_x) <= 0.0) return;
        down.inside = std::min(down.inside, -y);
        Flank floor = border.flank(-y, a, b);
        floor.height = std::max(floor.height, -half_);
        down.filled.push_back(floor);
      });
      const VariableWidthSlice slice = sliceAt(at, down, {{{half_, 1.0}}, half_});
      slices.push_back({at, up * slice.middle, slice.width});
    }
    return slices;
  }

  const VariableWidthLines& lines_;
  const RasterWalk& walk_;
  std::uint32_t left_;
  std::uint32_t right_;
  double half_;
  double centre_;
  std::vector<Border> borders_[2];  ///< above and below: at the left end, and at the right
  std::vector<Border> caps_[2];
  std::vector<Border> dips_[2];
};

/// A bead's round end is this part of its width from the border: it then leaves hardly anything in the
/// corners and laps over little.
constexpr double kEndGap = 0.325;
/// A pass is at most this wide, in variable-width lines.
constexpr double kWidest = 1.6;
/// Widths change from one motion to the next by at most this part of the variable-width line.
constexpr double kWidthStep = 0.25;

VariableWidthSlice between(const VariableWidthSlice& a, const VariableWidthSlice& b, double t) {
  return {a.x + t * (b.x - a.x), a.middle + t * (b.middle - a.middle), a.width + t * (b.width - a.width)};
}

/// Shortens the slices to where the pass may end on the right. None are left if it may nowhere.
void cutRight(std::vector<VariableWidthSlice>& slices, const PassEndShape& end, double line_end,
              double narrowest) {
  if (end.kind == PassEnd::Joined) return;
  const double tip = slices.back().x + 0.5 * narrowest;
  // What must not be negative at the end of a pass.
  const auto room = [&](const VariableWidthSlice& slice) {
    if (end.kind == PassEnd::Turn) return line_end - end.inset_mm - slice.x;
    return std::min(tip - slice.x - kEndGap * slice.width, slice.width - narrowest);
  };
  while (!slices.empty() && room(slices.back()) < 0.0) {
    const VariableWidthSlice last = slices.back();
    slices.pop_back();
    if (slices.empty() || room(slices.back()) < 0.0) continue;
    double enough = 0.0;
    double too_far = 1.0;
    const VariableWidthSlice before = slices.back();
    for (int i = 0; i < 20; ++i) {
      const double middle = 0.5 * (enough + too_far);
      (room(between(before, last, middle)) < 0.0 ? too_far : enough) = middle;
    }
    slices.push_back(between(before, last, enough));
    break;
  }
}

std::vector<VariableWidthSlice> mirrored(const std::vector<VariableWidthSlice>& slices) {
  std::vector<VariableWidthSlice> result;
  result.reserve(slices.size());
  for (auto slice = slices.rbegin(); slice != slices.rend(); ++slice)
    result.push_back({-slice->x, slice->middle, slice->width});
  return result;
}

/// A bead through the middle of the slices.
class PassTracer {
 public:
  PassTracer(double centre_y, double line_width, double narrowest)
      : centre_y_(centre_y), line_width_(line_width), narrowest_(narrowest) {}

  FillPath trace(const std::vector<VariableWidthSlice>& slices) {
    add(middle(slices.front()), clamped(slices.front().width));
    for (std::size_t i = 1; i < slices.size(); ++i) addMotion(slices[i - 1], slices[i]);
    return std::move(path_);
  }

 private:
  Point2 middle(const VariableWidthSlice& slice) const { return {slice.x, centre_y_ + slice.middle}; }
  double clamped(double width) const { return std::clamp(width, narrowest_, kWidest * line_width_); }

  void addMotion(const VariableWidthSlice& from, const VariableWidthSlice& to) {
    const double change = std::abs(clamped(to.width) - clamped(from.width));
    const int parts = 1 + static_cast<int>(change / (kWidthStep * line_width_) - 1e-9);
    for (int k = 1; k <= parts; ++k) {
      const Point2 a = middle(between(from, to, static_cast<double>(k - 1) / parts));
      const Point2 b = middle(between(from, to, static_cast<double>(k) / parts));
      if ((b - a).norm() < 1e-6) continue;
      add(b, clamped(between(from, to, (k - 0.5) / parts).width));
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
  double line_width_;
  double narrowest_;
  FillPath path_;
};

/// What the variable-width line round the line that begins at `left` holds, from left to right. Beside a
/// border that cuts into it the slices are those of the largest discs there: a bead through them touches the
/// border and neither leaves a gap nor laps over.
std::vector<VariableWidthSlice> slicesOf(const VariableWidthLines& lines, std::uint32_t left,
                                         const PassEndShape& left_end, const PassEndShape& right_end) {
  return VariableWidthSlicer(lines, left).slices(left_end, right_end);
}

}  // namespace

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

FillPath passThrough(const VariableWidthLines& lines, std::uint32_t left, const PassEndShape& left_end,
                     const PassEndShape& right_end) {
  const RasterWalk& walk = lines.walk;
  const double left_x = walk.pointAt(left).x();
  const double right_x = walk.pointAt(walk.otherEnd(left)).x();
  std::vector<VariableWidthSlice> slices = slicesOf(lines, left, left_end, right_end);
  const VariableWidthSlice& thickest = *std::max_element(
      slices.begin(), slices.end(),
      [](const VariableWidthSlice& a, const VariableWidthSlice& b) { return a.width < b.width; });
  const VariableWidthSlice fallback = thickest;
  cutRight(slices, right_end, right_x, lines.narrowest_mm);
  if (!slices.empty()) {
    slices = mirrored(slices);
    cutRight(slices, left_end, -left_x, lines.narrowest_mm);
    slices = mirrored(slices);
  }
  if (slices.empty()) slices = {fallback};
  const double line_width = 2.0 * walk.raster().spacing_mm;
  return PassTracer(walk.pointAt(left).y(), line_width, lines.narrowest_mm).trace(slices);
}

}  // namespace lamina
