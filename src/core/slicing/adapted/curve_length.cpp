// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/curve_length.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {

CurveLength::CurveLength(const AdaptedCurve& curve) : curve_(curve), at_point_{0.0} {
  const std::size_t count = curve.points.size();
  for (std::size_t i = 1; i < count + (curve.is_closed ? 1 : 0); ++i)
    at_point_.push_back(at_point_.back() + (curve.points[i % count] - curve.points[i - 1]).norm());
}

double CurveLength::at(const CurvePlace& place) const {
  return (1.0 - place.fraction) * at_point_[place.segment] + place.fraction * at_point_[place.segment + 1];
}

CurvePlace CurveLength::placeAt(double length_mm) const {
  if (curve_.is_closed) length_mm -= total() * std::floor(length_mm / total());
  const auto after = std::upper_bound(at_point_.begin() + 1, at_point_.end() - 1, length_mm);
  CurvePlace place;
  place.segment = static_cast<std::size_t>(after - at_point_.begin()) - 1;
  const double motion = *after - *(after - 1);
  place.fraction = motion > 0.0 ? std::clamp((length_mm - *(after - 1)) / motion, 0.0, 1.0) : 0.0;
  const Point3& from = curve_.points[place.segment];
  const Point3& to = curve_.points[(place.segment + 1) % curve_.points.size()];
  place.point = (1.0 - place.fraction) * from + place.fraction * to;
  return place;
}

}  // namespace lamina
