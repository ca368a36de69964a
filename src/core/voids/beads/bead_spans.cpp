// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voids/beads/bead_spans.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/polygon/plane_vectors.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

/// Everything within a radius of a straight line.
class Capsule {
 public:
  Capsule(const Point2& from, const Point2& to, double radius)
      : from_(from), to_(to), radius_(radius), length_((to - from).norm()) {
    if (length_ > 0.0) along_ = (to - from) / length_;
  }

  double low() const { return std::min(from_.y(), to_.y()) - radius_; }
  double high() const { return std::max(from_.y(), to_.y()) + radius_; }

  /// Its part of the line at height y, which must meet it.
  Span at(double y) const {
    Span span{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Point2& end : {from_, to_}) {
      const double aside = y - end.y();
      if (std::abs(aside) > radius_) continue;
      const double half = std::sqrt(radius_ * radius_ - aside * aside);
      include(span, end.x() - half);
      include(span, end.x() + half);
    }
    if (along_.y() == 0.0) return span;
    for (const double side : {-radius_, radius_}) {
      const Point2 start = from_ + side * leftOf(along_);
      const double t = (y - start.y()) / along_.y();
      if (t >= 0.0 && t <= length_) include(span, start.x() + t * along_.x());
    }
    return span;
  }

  double arcAt(const Point2& point) const { return std::clamp(along_.dot(point - from_), 0.0, length_); }

 private:
  static void include(Span& span, double x) {
    span.low = std::min(span.low, x);
    span.high = std::max(span.high, x);
  }

  Point2 from_;
  Point2 to_;
  double radius_;
  double length_;
  Point2 along_ = Point2::Zero();
};

/// Puts beads on rows; those that follow each other closely become one span.
class SpanWriter {
 public:
  SpanWriter(const ScanRows& rows, BeadMeasure measure)
      : rows_(rows), measure_(measure), spans_(rows.count) {}

  void add(const Path& path, std::uint32_t run) {
    const bool is_drops = path.deposit == Deposit::Drops;
    double arc = 0.0;
    forEachDepositedSegment(path, [&](const DepositedSegment& segment) {
      const Point2 from = segment.start.head<2>();
      const Point2 to = segment.end.head<2>();
      const double width =
          is_drops || measure_ == BeadMeasure::Reach ? segment.bead.width_mm : planWidth(segment.bead);
      if (is_drops || segment.bead.width_mm > 0.0)
        add(Capsule(from, to, 0.5 * width), run, arc, is_drops ? 0.0 : 0.5 * width);
      arc += is_drops ? kDropArc : (to - from).norm();
    });
  }

  std::vector<std::vector<BeadSpan>> spans() && { return std::move(spans_); }

 private:
  /// @param closeness  [mm] along the run within which spans that overlap are joined
  void add(const Capsule& capsule, std::uint32_t run, double arc, double closeness) {
    const std::size_t end = rows_.firstAbove(capsule.high());
    for (std::size_t row = rows_.firstAbove(capsule.low()); row < end; ++row) {
      const double y = rows_.at(row);
      const Span span = capsule.at(y);
      if (!(span.high > span.low)) continue;
      BeadSpan added;
      added.low = span.low;
      added.high = span.high;
      added.run = run;
      added.arc_low = arc + capsule.arcAt({span.low, y});
      added.arc_high = arc + capsule.arcAt({span.high, y});
      put(spans_[row], added, closeness);
    }
  }

  static void put(std::vector<BeadSpan>& row, const BeadSpan& added, double closeness) {
    if (!row.empty() && row.back().run == added.run) {
      BeadSpan& last = row.back();
      const auto [arc_low, arc_high] =
          std::minmax({last.arc_low, last.arc_high, added.arc_low, added.arc_high});
      const bool overlaps = added.low <= last.high && last.low <= added.high;
      if (overlaps && arc_high - arc_low <= closeness) {
        const bool rises = added.low + added.high >= last.low + last.high;
        last.low = std::min(last.low, added.low);
        last.high = std::max(last.high, added.high);
        last.arc_low = rises ? arc_low : arc_high;
        last.arc_high = rises ? arc_high : arc_low;
        return;
      }
    }
    row.push_back(added);
  }

  const ScanRows& rows_;
  BeadMeasure measure_;
  std::vector<std::vector<BeadSpan>> spans_;
};

}  // namespace

std::vector<std::vector<BeadSpan>> beadSpans(const ToolpathLayer& layer, const ScanRows& rows,
                                             BeadMeasure measure) {
  SpanWriter writer(rows, measure);
  for (std::size_t i = 0; i < layer.paths.size(); ++i)
    if (isPartOfPart(layer.paths[i])) writer.add(layer.paths[i], static_cast<std::uint32_t>(i));
  return std::move(writer).spans();
}

}  // namespace lamina
