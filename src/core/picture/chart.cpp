// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/chart.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/picture/annotation.hpp"
#include "lamina/picture/canvas.hpp"

namespace lamina {
namespace {

constexpr Colour kChartInk{0.15, 0.16, 0.18};
constexpr Colour kChartFaintInk{0.42, 0.44, 0.47};
constexpr Colour kChartGrid{0.90, 0.91, 0.92};
constexpr int kSmallestSpan = 200;
constexpr double kChartMargin = 0.06;  // beyond the outermost points, of their extent
constexpr double kLeft = 96.0;         // px, of the plot area's sides
constexpr double kRight = 28.0;
constexpr double kChartTop = 92.0;
constexpr double kBottom = 70.0;

bool isShown(const Point2& point) { return std::isfinite(point.x()) && std::isfinite(point.y()); }

/// What the axes show.
Box2 extentOf(const Chart& chart) {
  Box2 box;
  for (const ChartSeries& series : chart.series)
    for (const Point2& point : series.points)
      if (isShown(point)) box.include(point);
  if (box.isEmpty()) return {Point2(0.0, 0.0), Point2(1.0, 1.0)};
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const double size = box.high[axis] - box.low[axis];
    const double scale = std::max({std::abs(box.high[axis]), std::abs(box.low[axis]), 1e-12});
    const double room = size > 1e-12 * scale ? kChartMargin * size : 0.5 * scale;
    box.low[axis] -= room;
    box.high[axis] += room;
  }
  return box;
}

/// Places of an extent on the picture.
struct Frame {
  Box2 extent;
  Box2 area;  // px

  Point2 at(const Point2& point) const {
    const Point2 part = (point - extent.low).cwiseQuotient(extent.size());
    return {area.low.x() + part.x() * area.size().x(), area.high.y() - part.y() * area.size().y()};
  }
};

std::string tickLabel(double value, double step) {
  return numberText(std::abs(value) < 1e-9 * step ? 0.0 : value);
}

void drawAxes(Canvas& canvas, const Frame& frame, const Chart& chart) {
  const Box2& area = frame.area;
  const auto xs = roundTicks(frame.extent.low.x(), frame.extent.high.x(), 8);
  const auto ys = roundTicks(frame.extent.low.y(), frame.extent.high.y(), 8);
  const TextStyle label{15.0, kChartFaintInk, TextAnchor::Centre};
  for (const double x : xs) {
    const double column = frame.at({x, frame.extent.low.y()}).x();
    canvas.linePx({{column, area.low.y()}, {column, area.high.y()}}, {kChartGrid, 1.0});
    canvas.text({column, area.high.y() + 22.0}, tickLabel(x, xs[1] - xs[0]), label);
  }
  for (const double y : ys) {
    const double row = frame.at({frame.extent.low.x(), y}).y();
    canvas.linePx({{area.low.x(), row}, {area.high.x(), row}}, {kChartGrid, 1.0});
    canvas.text({area.low.x() - 10.0, row + 5.0}, tickLabel(y, ys[1] - ys[0]),
                {15.0, kChartFaintInk, TextAnchor::Right});
  }
  canvas.linePx({area.low, {area.low.x(), area.high.y()}, area.high}, {kChartFaintInk, 1.5});
  canvas.text({area.centre().x(), area.high.y() + 54.0}, chart.x_label,
              {17.0, kChartInk, TextAnchor::Centre});
  canvas.text({20.0, area.low.y() - 14.0}, chart.y_label, {17.0, kChartInk, TextAnchor::Left});
}

void drawSeries(Canvas& canvas, const Frame& frame, const ChartSeries& series) {
  std::vector<Point2> places;
  for (const Point2& point : series.points)
    if (isShown(point)) places.push_back(frame.at(point));
  if (series.line_px > 0.0 && places.size() > 1) canvas.linePx(places, {series.colour, series.line_px});
  if (series.dot_px > 0.0)
    for (const Point2& place : places) canvas.dotPx(place, series.dot_px, series.colour);
}

void drawLegendOf(Canvas& canvas, const Chart& chart) {
  std::vector<LegendEntry> entries;
  for (const ChartSeries& series : chart.series)
    if (!series.label.empty()) entries.push_back({series.label, series.colour});
  if (entries.size() > 1) drawLegend(canvas, {kLeft + 190.0, kChartTop - 14.0}, entries);
}

}  // namespace

std::vector<double> roundTicks(double low, double high, int most) {
  const double rough = (high - low) / most;
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10.0 * decade;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * decade >= rough) step = factor * decade;
  std::vector<double> ticks;
  for (double i = std::ceil(low / step); i * step <= high && ticks.size() < 100U; i += 1.0)
    ticks.push_back(i * step);
  if (ticks.size() < 2) ticks = {low, high};
  return ticks;
}

std::string chartPng(const Chart& chart, int width_px, int height_px) {
  if (std::min(width_px, height_px) < kSmallestSpan)
    throw InvalidInput("diagram of " + std::to_string(width_px) + " x " + std::to_string(height_px) +
                       " pixels; each side must be at least 200");
  Canvas canvas(width_px, height_px);
  const Frame frame{extentOf(chart),
                    {Point2(kLeft, kChartTop), Point2(width_px - kRight, height_px - kBottom)}};
  drawAxes(canvas, frame, chart);
  for (const ChartSeries& series : chart.series) drawSeries(canvas, frame, series);
  canvas.text({20.0, 36.0}, chart.title, {21.0, kChartInk, TextAnchor::Left, TextWeight::Bold});
  drawLegendOf(canvas, chart);
  return canvas.png();
}

}  // namespace lamina
