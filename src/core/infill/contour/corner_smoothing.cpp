// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/corner_smoothing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/polygon/chain_splitting.hpp"
#include "geometry/polygon/plane_vectors.hpp"
#include "lamina/base/angle.hpp"

namespace lamina {
namespace {

/// Turns of this much are corners.
constexpr double kCorner = toRadians(30.0);
/// Windows shorter than this, and points nearer to each other, make no curve [mm].
constexpr double kShortestSide = 1e-6;

/// A run measured by arc length. Of a closed one, positions go round.
class MeasuredRun {
 public:
  explicit MeasuredRun(const FillPath& run) : run_(run) {
    at_.push_back(0.0);
    for (std::size_t i = 0; i < motionCount(); ++i)
      at_.push_back(at_.back() + (end(i) - run.points[i]).norm());
  }

  std::size_t motionCount() const { return run_.points.size() - (run_.is_closed ? 0 : 1); }
  double length() const { return at_.back(); }
  double positionOf(std::size_t point) const { return at_[point]; }

  Point2 pointAt(double position) const {
    const double inside = wrapped(position);
    const std::size_t motion = motionAt(inside);
    const double length = at_[motion + 1] - at_[motion];
    const double part = length > 0.0 ? (inside - at_[motion]) / length : 0.0;
    return run_.points[motion] + part * (end(motion) - run_.points[motion]);
  }
  double widthAt(double position) const { return run_.width_mm[endIndex(motionAt(wrapped(position)))]; }

  /// By how much the run turns at a point [rad].
  double turnAt(std::size_t point) const {
    const std::size_t count = run_.points.size();
    if (!run_.is_closed && (point == 0 || point + 1 == count)) return 0.0;
    const Point2 in = run_.points[point] - run_.points[(point + count - 1) % count];
    const Point2 out = run_.points[(point + 1) % count] - run_.points[point];
    return std::abs(turn(in, out));
  }

 private:
  std::size_t endIndex(std::size_t motion) const { return motion + 1 < run_.points.size() ? motion + 1 : 0; }
  const Point2& end(std::size_t motion) const { return run_.points[endIndex(motion)]; }
  double wrapped(double position) const {
    if (!run_.is_closed) return std::clamp(position, 0.0, length());
    const double rest = std::fmod(position, length());
    return rest < 0.0 ? rest + length() : rest;
  }
  std::size_t motionAt(double position) const {
    const auto after = std::upper_bound(at_.begin() + 1, at_.end() - 1, position);
    return static_cast<std::size_t>(after - at_.begin()) - 1;
  }

  const FillPath& run_;
  std::vector<double> at_;  ///< of each point, and the length
};

/// The stretch of a run that a curve replaces.
struct Window {
  double middle_mm = 0.0;
  double reach_mm = 0.0;  ///< to either side
};

std::vector<Window> windowsOf(const MeasuredRun& run, const FillPath& path, double length) {
  std::vector<Window> windows;
  for (std::size_t i = 0; i < path.points.size(); ++i)
    if (run.turnAt(i) >= kCorner) windows.push_back({run.positionOf(i), 0.5 * length});
  const std::size_t count = windows.size();
  const std::vector<Window> asked = windows;
  for (std::size_t i = 0; i < count; ++i) {
    double before = windows[i].middle_mm;
    double after = run.length() - windows[i].middle_mm;
    if (i > 0 || path.is_closed) {
      const double there = i > 0 ? asked[i - 1].middle_mm : asked.back().middle_mm - run.length();
      before = 0.5 * (windows[i].middle_mm - there);
    }
    if (i + 1 < count || path.is_closed) {
      const double there = i + 1 < count ? asked[i + 1].middle_mm : asked.front().middle_mm + run.length();
      after = 0.5 * (there - windows[i].middle_mm);
    }
    windows[i].reach_mm = std::min({windows[i].reach_mm, before, after});
  }
  windows.erase(std::remove_if(windows.begin(), windows.end(),
                               [](const Window& window) { return window.reach_mm < kShortestSide; }),
                windows.end());
  return windows;
}

/// Slope at a knot between two steps of one unit each: none at an extremum, else their harmonic mean.
double monotoneSlope(double before, double after) {
  return before * after > 0.0 ? 2.0 * before * after / (before + after) : 0.0;
}

Point2 monotoneSlope(const Point2& before, const Point2& after) {
  return {monotoneSlope(before.x(), after.x()), monotoneSlope(before.y(), after.y())};
}

/// A cubic from one point to another, its slopes there given per unit.
struct Cubic {
  Point2 from;
  Point2 to;
  Point2 slope_from;
  Point2 slope_to;

  Point2 at(double t) const {
    const double s = 1.0 - t;
    return s * s * (1.0 + 2.0 * t) * from + t * t * (3.0 - 2.0 * t) * to + s * s * t * slope_from -
           t * t * s * slope_to;
  }
};

Cubic curveOf(const MeasuredRun& run, const Window& window) {
  const double start = window.middle_mm - window.reach_mm;
  const double end = window.middle_mm + window.reach_mm;
  const Point2 before = run.pointAt(start - window.reach_mm);
  const Point2 from = run.pointAt(start);
  const Point2 to = run.pointAt(end);
  const Point2 after = run.pointAt(end + window.reach_mm);
  return {from, to, monotoneSlope(from - before, to - from), monotoneSlope(to - from, after - to)};
}

class Smoothing {
 public:
  Smoothing(const FillPath& run, const SmoothingSettings& settings)
      : run_(run),
        measured_(run),
        step_(settings.step_mm),
        windows_(windowsOf(measured_, run, settings.window_mm)) {
    result_.is_closed = run.is_closed;
    result_.role = run.role;
    result_.deposit = run.deposit;
  }

  FillPath smooth() && {
    if (windows_.empty()) return run_;
    if (!run_.is_closed) putPoints(-2.0 * kShortestSide, startOf(windows_.front()));
    for (std::size_t i = 0; i < windows_.size(); ++i) {
      put(measured_.pointAt(startOf(windows_[i])), startOf(windows_[i]));
      putCurve(windows_[i]);
      putPoints(endOf(windows_[i]), endOfStraightAfter(i));
    }
    return std::move(result_);
  }

 private:
  static double startOf(const Window& window) { return window.middle_mm - window.reach_mm; }
  static double endOf(const Window& window) { return window.middle_mm + window.reach_mm; }
  double endOfStraightAfter(std::size_t window) const {
    if (window + 1 < windows_.size()) return startOf(windows_[window + 1]);
    return measured_.length() + (run_.is_closed ? startOf(windows_.front()) : 2.0 * kShortestSide);
  }

  /// The points of the run between two positions, the later of which may lie beyond the end of a closed run.
  void putPoints(double from, double to) {
    const std::size_t count = run_.points.size();
    for (; next_ < (run_.is_closed ? 2 : 1) * count; ++next_) {
      const double round = next_ < count ? 0.0 : measured_.length();
      const double position = measured_.positionOf(next_ % count) + round;
      if (position >= to - kShortestSide) return;
      if (position > from + kShortestSide) put(run_.points[next_ % count], position);
    }
  }

  /// A point at that position of the run: the width on the way to it is the run's there.
  void put(const Point2& point, double position) {
    if (!result_.points.empty() && (result_.points.back() - point).norm() < kShortestSide) return;
    result_.points.push_back(point);
    if (!run_.width_mm.empty()) result_.width_mm.push_back(measured_.widthAt(position - kShortestSide));
  }

  void putCurve(const Window& window) {
    const Cubic curve = curveOf(measured_, window);
    const int count = std::max(2, static_cast<int>(std::ceil((curve.to - curve.from).norm() / step_)));
    for (int k = 1; k <= count; ++k) {
      const double t = static_cast<double>(k) / count;
      const double middle = t - 0.5 / count;
      const double position = window.middle_mm + (2.0 * middle - 1.0) * window.reach_mm;
      put(curve.at(t), position);
    }
  }

  const FillPath& run_;
  MeasuredRun measured_;
  double step_;
  std::vector<Window> windows_;
  std::size_t next_ = 0;  ///< point of the run, the first round and the second
  FillPath result_;
};

/// A run without the points that are out of the way by less than the tolerance; it keeps its widths.
class Simplification {
 public:
  Simplification(const FillPath& run, double tolerance) : run_(run), tolerance_(tolerance) {}

  FillPath simplify() const {
    FillPath path = run_;
    path.points.clear();
    path.width_mm.clear();
    for (const std::size_t i : kept()) {
      path.points.push_back(run_.points[i]);
      if (!run_.width_mm.empty()) path.width_mm.push_back(run_.width_mm[i]);
    }
    return path;
  }

 private:
  /// Of a closed run three points stay in any case, so that the chains between them have a direction.
  std::vector<std::size_t> kept() const {
    const auto split = [this](std::size_t from, std::size_t to) { return splitBetween(from, to); };
    const std::size_t count = run_.points.size();
    if (!run_.is_closed) return keptOfChain(0, count - 1, split);
    const std::size_t stops[] = {0, count / 3, 2 * count / 3, count};
    std::vector<std::size_t> all;
    for (int i = 0; i < 3; ++i) {
      const std::vector<std::size_t> third = keptOfChain(stops[i], stops[i + 1], split);
      all.insert(all.end(), third.begin(), third.end() - 1);
    }
    return all;
  }

  std::size_t wrapped(std::size_t i) const { return i < run_.points.size() ? i : 0; }

  std::size_t splitBetween(std::size_t from, std::size_t to) const {
    const std::size_t farthest =
        farthestBetween(from, to, tolerance_, [this](std::size_t i) { return run_.points[wrapped(i)]; });
    return farthest != from ? farthest : changeOfWidth(from, to);
  }

  /// Where the width changes by more than a hundredth, if it does.
  std::size_t changeOfWidth(std::size_t from, std::size_t to) const {
    if (run_.width_mm.empty()) return from;
    const double width = run_.width_mm[wrapped(to)];
    for (std::size_t i = to; --i > from;)
      if (std::abs(run_.width_mm[i] - width) > 0.01 * width) return i;
    return from;
  }

  const FillPath& run_;
  double tolerance_;
};

}  // namespace

FillPath smoothed(FillPath run, const SmoothingSettings& settings) {
  if (settings.window_mm == 0.0 || run.deposit == Deposit::Drops || run.points.size() < 3) return run;
  return Smoothing(run, settings).smooth();
}

FillPath simplified(FillPath run, double tolerance_mm) {
  if (tolerance_mm == 0.0 || run.deposit == Deposit::Drops || run.points.size() < (run.is_closed ? 4 : 3))
    return run;
  return Simplification(run, tolerance_mm).simplify();
}

}  // namespace lamina
