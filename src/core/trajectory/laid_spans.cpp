// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/laid_spans.hpp"

#include <algorithm>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kSameLength = 1e-6;  // mm: what sums of lengths may differ by

}  // namespace

LaidSpans::LaidSpans(const JointCurve& curve) : curve_(&curve) {
  LaidAmount sum;
  laid_.reserve(curve.spanCount() + 1);
  laid_.push_back(sum);
  for (std::size_t span = 0; span < curve.spanCount(); ++span) {
    const double length_mm = lengthOf(span);
    sum.length_mm += length_mm;
    sum.volume_mm3 += length_mm * curve.spanEnd(span).area_mm2;
    laid_.push_back(sum);
  }
}

double LaidSpans::lengthOf(std::size_t span) const {
  const JointStation& end = curve_->spanEnd(span);
  return end.area_mm2 > 0.0 ? end.length_mm : 0.0;
}

LaidAmount LaidSpans::at(const MotionPlace& place) const {
  LaidAmount laid = laid_[place.span];
  const double length_mm = lengthOf(place.span);
  if (!(length_mm > 0.0)) return laid;
  const double gone_mm = std::min(1.0, place.along / curve_->length(place.span)) * length_mm;
  laid.length_mm += gone_mm;
  laid.volume_mm3 += gone_mm * curve_->spanEnd(place.span).area_mm2;
  return laid;
}

MotionPlace LaidSpans::placeOf(double length_mm) const {
  const auto later =
      std::upper_bound(laid_.begin(), laid_.end(), length_mm + kSameLength,
                       [](double length, const LaidAmount& laid) { return length < laid.length_mm; });
  if (later == laid_.end() || later == laid_.begin())
    throw InvalidInput("it is to begin after " + numberText(length_mm) +
                       " mm of its beads; expected less than " + numberText(laid_.back().length_mm) +
                       " mm, which is all of them");
  const auto span = static_cast<std::size_t>(later - laid_.begin() - 1);
  const double share = std::max(0.0, length_mm - laid_[span].length_mm) / lengthOf(span);
  MotionPlace place;
  place.curve = curve_;
  place.span = static_cast<std::uint32_t>(span);
  place.along = share * curve_->length(span);
  return place;
}

}  // namespace lamina
