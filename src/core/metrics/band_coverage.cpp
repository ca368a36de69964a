// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "metrics/band_coverage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamina {
namespace {

constexpr LineSpan kNothing{std::numeric_limits<double>::infinity(),
                            -std::numeric_limits<double>::infinity()};

void unite(LineSpan& span, const LineSpan& other) {
  if (other.from > other.to) return;
  span.from = std::min(span.from, other.from);
  span.to = std::max(span.to, other.to);
}

LineSpan discAt(const Point2& centre, double radius, double y) {
  const double squared = radius * radius - (y - centre.y()) * (y - centre.y());
  if (squared < 0.0) return kNothing;
  const double half = std::sqrt(squared);
  return {centre.x() - half, centre.x() + half};
}

/// Keeps where slope * x is from `low` to `high`.
void keepBetween(LineSpan& span, double slope, double low, double high) {
  if (slope == 0.0) {
    if (low > 0.0 || high < 0.0) span = kNothing;
    return;
  }
  const double one = low / slope;
  const double other = high / slope;
  span.from = std::max(span.from, std::min(one, other));
  span.to = std::min(span.to, std::max(one, other));
}

void keep(LineSpan& span, const HalfPlane& half, double y) {
  if (half.normal.isZero(0.0)) return;
  keepBetween(span, half.normal.x(), -std::numeric_limits<double>::infinity(),
              half.offset - half.normal.y() * y);
}

/// The band without its round ends.
LineSpan rectangleAt(const Band& band, double y) {
  const Point2 way = band.end - band.start;
  const double length = way.norm();
  if (length == 0.0) return kNothing;
  const double above = y - band.start.y();
  LineSpan span{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  // Along the middle line from 0 to its length, across it within the radius.
  keepBetween(span, way.x(), -above * way.y(), length * length - above * way.y());
  const double across = above * way.x();
  keepBetween(span, -way.y(), -band.radius * length - across, band.radius * length - across);
  span.from += band.start.x();
  span.to += band.start.x();
  return span;
}

LineSpan faceAt(const std::array<Point2, 3>& face, double y) {
  LineSpan span = kNothing;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2& a = face[i];
    const Point2& b = face[(i + 1) % 3];
    if ((a.y() <= y) == (b.y() <= y)) continue;
    const double x = a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    unite(span, {x, x});
  }
  return span;
}

void sortByBeginning(std::vector<LineSpan>& spans) {
  std::sort(spans.begin(), spans.end(), [](const LineSpan& a, const LineSpan& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  });
}

void clip(std::vector<LineSpan>& spans, const LineSpan& whole) {
  for (LineSpan& span : spans) {
    span.from = std::max(span.from, whole.from);
    span.to = std::min(span.to, whole.to);
  }
}

}  // namespace

double uncovered(const std::vector<LineSpan>& spans, const LineSpan& whole) {
  double sum = 0.0;
  double reached = whole.from;
  for (const LineSpan& span : spans) {
    if (span.from > reached) sum += std::min(span.from, whole.to) - reached;
    reached = std::max(reached, span.to);
    if (reached >= whole.to) return sum;
  }
  return sum + whole.to - reached;
}

double coveredTwice(const std::vector<LineSpan>& spans) {
  double sum = 0.0;
  double furthest = -std::numeric_limits<double>::infinity();  // end of all so far
  double second = furthest;                                    // up to where two of them reach
  for (const LineSpan& span : spans) {
    const double twice_to = std::min(span.to, furthest);
    const double twice_from = std::max(span.from, second);
    if (twice_to > twice_from) sum += twice_to - twice_from;
    second = std::max(second, twice_to);
    furthest = std::max(furthest, span.to);
  }
  return sum;
}

LineSpan spanAt(const Band& band, double y) {
  LineSpan span = rectangleAt(band, y);
  if (span.from > span.to) span = kNothing;
  unite(span, discAt(band.start, band.radius, y));
  unite(span, discAt(band.end, band.radius, y));
  return span;
}

void LineMeter::add(const Band& band, const FaceLines& lines, const LineRange& range,
                    const OverlapRule& rule) {
  const double low = std::min(band.start.y(), band.end.y()) - band.radius;
  const double high = std::max(band.start.y(), band.end.y()) + band.radius;
  const auto from =
      static_cast<int>(std::max<double>(range.first, std::ceil((low - lines.first_y) / lines.step_mm)));
  const auto to =
      static_cast<int>(std::min<double>(range.last - 1, std::floor((high - lines.first_y) / lines.step_mm)));
  for (int line = from; line <= to; ++line) {
    const double y = lines.y(line);
    LineSpan span = spanAt(band, y);
    if (span.from >= span.to) continue;
    Line& here = lines_[static_cast<std::size_t>(line - range.first)];
    here.whole.push_back(span);
    if (rule.cuts_joints) {
      keep(span, band.from_before, y);
      keep(span, band.to_after, y);
    }
    if (span.from < span.to) here.cut.push_back(span);
  }
}

LineSums LineMeter::measure(const std::array<Point2, 3>& face, const FaceLines& lines, const LineRange& range,
                            const std::vector<const Band*>& bands, const OverlapRule& rule) {
  const auto count = static_cast<std::size_t>(range.last - range.first);
  if (lines_.size() < count) lines_.resize(count);
  for (Line& line : lines_) {
    line.whole.clear();
    line.cut.clear();
  }
  for (const Band* band : bands) add(*band, lines, range, rule);
  LineSums sums;
  for (int line = range.first; line < range.last; ++line) {
    Line& here = lines_[static_cast<std::size_t>(line - range.first)];
    const LineSpan on_face = faceAt(face, lines.y(line));
    const bool meets_face = on_face.from < on_face.to;
    if (meets_face) {
      sortByBeginning(here.whole);
      sums.face_mm += on_face.to - on_face.from;
      sums.uncovered_mm += uncovered(here.whole, on_face);
    }
    if (rule.stays_on_face && !meets_face) continue;
    if (rule.stays_on_face) clip(here.cut, on_face);
    sortByBeginning(here.cut);
    sums.twice_mm += coveredTwice(here.cut);
  }
  return sums;
}

}  // namespace lamina
