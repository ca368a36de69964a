// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/seams/seam.hpp"

#include <algorithm>
#include <utility>

namespace lamina {
namespace {

template <class Before>
Polygon startingAtFirst(Polygon loop, Before before) {
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end(), before), loop.end());
  return loop;
}

Polygon startingNearest(Polygon loop, const Point2& point) {
  return startingAtFirst(std::move(loop), [&point](const Point2& a, const Point2& b) {
    return (a - point).squaredNorm() < (b - point).squaredNorm();
  });
}

bool isFartherBack(const Point2& a, const Point2& b) {
  return a.y() != b.y() ? a.y() > b.y() : a.x() > b.x();
}

/// @param distance  along the loop from its first point [mm]
Polygon startingAlong(Polygon loop, double distance) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2 a = loop[i];
    const Point2 b = loop[i + 1 < loop.size() ? i + 1 : 0];
    const double edge = (b - a).norm();
    if (distance < edge) {
      std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(i) + 1, loop.end());
      if (distance > 0.0) loop.insert(loop.begin(), a + distance / edge * (b - a));
      return loop;
    }
    distance -= edge;
  }
  return loop;
}

}  // namespace

Seam::Seam(const SeamSettings& settings, const Point2& anchor, std::uint64_t layer)
    : placement_(settings.placement),
      anchor_(anchor),
      random_(Random(static_cast<std::uint64_t>(settings.seed)).bits() + layer) {}

Polygon Seam::placed(Polygon loop) {
  switch (placement_) {
    case SeamPlacement::Aligned:
      return startingNearest(std::move(loop), anchor_);
    case SeamPlacement::Rear:
      return startingAtFirst(std::move(loop), isFartherBack);
    case SeamPlacement::Random: {
      const double distance = random_.uniform(0.0, perimeter(loop));
      return startingAlong(std::move(loop), distance);
    }
    case SeamPlacement::Nearest:
      break;
  }
  return loop;
}

Polygon Seam::approached(Polygon loop, const Point2& nozzle) const {
  return placement_ == SeamPlacement::Nearest ? startingNearest(std::move(loop), nozzle) : loop;
}

}  // namespace lamina
