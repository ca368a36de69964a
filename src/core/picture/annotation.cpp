// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/annotation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <vector>

namespace lamina {
namespace {

constexpr Colour kInk{0.15, 0.16, 0.18};
constexpr Colour kFaintInk{0.42, 0.44, 0.47};
constexpr double kLongestBar = 200.0;  // px
constexpr double kWidestLabel = 70.0;  // px, of a bar

std::string formatted(const char* format, double value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// The largest of 1, 2, 5 times a power of ten that is not above the limit.
double roundLength(double limit) {
  const double decade = std::pow(10.0, std::floor(std::log10(limit)));
  for (const double factor : {5.0, 2.0})
    if (factor * decade <= limit) return factor * decade;
  return decade;
}

double barLength(const Canvas& canvas) { return roundLength(kLongestBar / canvas.pixelsPerMm()); }

}  // namespace

void drawTitle(Canvas& canvas, const std::string& title, const std::string& subtitle) {
  canvas.text({28.0, 40.0}, title, {22.0, kInk, TextAnchor::Left, TextWeight::Bold});
  std::istringstream lines(subtitle);
  double base = 63.0;
  for (std::string line; std::getline(lines, line); base += 22.0)
    canvas.text({28.0, base}, line, {15.0, kFaintInk, TextAnchor::Left, TextWeight::Normal});
}

Box2 scaleBarBox(const Canvas& canvas, const Point2& at) {
  const double length_px = barLength(canvas) * canvas.pixelsPerMm();
  constexpr double kAround = 8.0;  // px, beside the bar
  constexpr double kLabel = 28.0;  // px, of the label above it
  const double over = std::max(0.0, 0.5 * (kWidestLabel - length_px));
  Box2 box;
  box.include(at - Point2(kAround + over, kLabel));
  box.include(at + Point2(length_px + kAround + over, kAround));
  return box;
}

void drawScaleBar(Canvas& canvas, const Point2& at) {
  const double length_mm = barLength(canvas);
  const Point2 end = at + Point2(length_mm * canvas.pixelsPerMm(), 0.0);
  const Stroke stroke{kInk, 2.0};
  constexpr double kTick = 5.0;
  canvas.linePx({at, end}, stroke);
  for (const Point2& tick : {at, end})
    canvas.linePx({tick - Point2(0.0, kTick), tick + Point2(0.0, kTick)}, stroke);
  canvas.text(0.5 * (at + end) - Point2(0.0, 9.0), formatted("%g mm", length_mm),
              {14.0, kInk, TextAnchor::Centre});
}

void drawLegend(Canvas& canvas, const Point2& at, const std::vector<LegendEntry>& entries) {
  constexpr double kSquare = 14.0;
  constexpr double kPerCharacter = 8.2;  // px, at the size of the labels
  constexpr double kRow = 21.0;
  const double right = canvas.width() - 8.0;
  std::vector<Point2> places;
  Point2 next = at;
  for (const LegendEntry& entry : entries) {
    const double label_px = kPerCharacter * static_cast<double>(entry.label.size());
    if (next.x() > at.x() && next.x() + kSquare + 7.0 + label_px > right) next = {at.x(), next.y() + kRow};
    places.push_back(next);
    next.x() += kSquare + 28.0 + label_px;
  }
  // Rows are added above: the last one stands where it is asked for.
  const Point2 up(0.0, next.y() - at.y());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const LegendEntry& entry = entries[i];
    const Point2 place = places[i] - up;
    Box2 square;
    square.include(place - Point2(0.0, kSquare - 2.0));
    square.include(place + Point2(kSquare, 2.0));
    canvas.rectanglePx(square, entry.colour);
    canvas.text(place + Point2(kSquare + 7.0, 0.0), entry.label, {14.0, kInk});
  }
}

void drawColourBar(Canvas& canvas, const Box2& bar, const ColourScale& scale) {
  constexpr int kSteps = 128;
  constexpr int kLabels = 5;
  const double height = bar.size().y();
  for (int i = 0; i < kSteps; ++i) {
    Box2 step;
    step.include({bar.low.x(), bar.high.y() - height * (i + 1) / kSteps - 0.5});
    step.include({bar.high.x(), bar.high.y() - height * i / kSteps});
    canvas.rectanglePx(step, colourAt(scale.map, (i + 0.5) / kSteps));
  }
  for (int i = 0; i < kLabels; ++i) {
    const double part = static_cast<double>(i) / (kLabels - 1);
    const Point2 place(bar.high.x(), bar.high.y() - part * height);
    canvas.linePx({place, place + Point2(5.0, 0.0)}, {kInk, 1.0});
    const double value = scale.low + part * (scale.high - scale.low);
    canvas.text(place + Point2(9.0, 5.0), formatted("%.4g", value), {13.0, kInk});
  }
  canvas.text({bar.low.x(), bar.low.y() - 12.0}, scale.label, {14.0, kInk});
}

}  // namespace lamina
