// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/variable_width_pass.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

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
  PassTracer(double centre_y, double strip, double narrowest)
      : centre_y_(centre_y), strip_(strip), narrowest_(narrowest) {}

  FillPath trace(const std::vector<VariableWidthSlice>& slices) {
    add(middle(slices.front()), clamped(slices.front().width));
    for (std::size_t i = 1; i < slices.size(); ++i) addMotion(slices[i - 1], slices[i]);
    return std::move(path_);
  }

 private:
  Point2 middle(const VariableWidthSlice& slice) const { return {slice.x, centre_y_ + slice.middle}; }
  double clamped(double width) const { return std::clamp(width, narrowest_, kWidest * strip_); }

  void addMotion(const VariableWidthSlice& from, const VariableWidthSlice& to) {
    const double change = std::abs(clamped(to.width) - clamped(from.width));
    const int parts = 1 + static_cast<int>(change / (kWidthStep * strip_) - 1e-9);
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
  double strip_;
  double narrowest_;
  FillPath path_;
};

}  // namespace

FillPath passThrough(const VariableWidthLines& strips, std::uint32_t left, const PassEndShape& left_end,
                     const PassEndShape& right_end) {
  const RasterWalk& walk = strips.walk;
  const double left_x = walk.pointAt(left).x();
  const double right_x = walk.pointAt(walk.otherEnd(left)).x();
  std::vector<VariableWidthSlice> slices = slicesOf(strips, left, left_end, right_end);
  const VariableWidthSlice& thickest = *std::max_element(
      slices.begin(), slices.end(),
      [](const VariableWidthSlice& a, const VariableWidthSlice& b) { return a.width < b.width; });
  const VariableWidthSlice fallback = thickest;
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

}  // namespace lamina
