// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/seams/seam.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "lamina/base/angle.hpp"
#include "planning/modifiers/run_clipping.hpp"

namespace lamina {
namespace {

using Candidates = std::vector<std::size_t>;  ///< vertices, ascending

Polygon startingAt(Polygon loop, std::size_t vertex) {
  std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(vertex), loop.end());
  return loop;
}

template <class Before>
Polygon startingAtFirst(Polygon loop, const Candidates& among, Before before) {
  if (among.empty()) return loop;
  const std::size_t first = *std::min_element(
      among.begin(), among.end(), [&](std::size_t a, std::size_t b) { return before(loop[a], loop[b]); });
  return startingAt(std::move(loop), first);
}

Polygon startingNearest(Polygon loop, const Candidates& among, const Point2& point) {
  return startingAtFirst(std::move(loop), among, [&point](const Point2& a, const Point2& b) {
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

/// Over which a corner turns, on either side of it.
constexpr double kArm = 0.5;  // mm
const double kCorner = toRadians(30.0);
constexpr double kSameTurn = 1e-9;  // rad
constexpr double kTilt = 0.1;       // of +x in the direction of "back"

/// The point this far along the loop from a vertex, at most half of the loop.
/// @param step  1 onwards, size - 1 backwards
Point2 pointBeside(const Polygon& loop, std::size_t vertex, std::size_t step) {
  double left_mm = kArm;
  Point2 at = loop[vertex];
  for (std::size_t i = 0; i < loop.size() / 2; ++i) {
    vertex = (vertex + step) % loop.size();
    const Point2 way = loop[vertex] - at;
    const double length_mm = way.norm();
    if (length_mm >= left_mm) return at + left_mm / length_mm * way;
    left_mm -= length_mm;
    at = loop[vertex];
  }
  return at;
}

/// By how much the loop turns to the left at a vertex [rad].
double turnAt(const Polygon& loop, std::size_t vertex) {
  const Point2 before = loop[vertex] - pointBeside(loop, vertex, loop.size() - 1);
  const Point2 behind = pointBeside(loop, vertex, 1) - loop[vertex];
  return std::atan2(before.x() * behind.y() - before.y() * behind.x(), before.dot(behind));
}

/// How well a seam is seen at a vertex: less is better.
struct SeamView {
  int kind = 2;       ///< 0 at an inward corner, 1 at an outward one
  double back = 0.0;  ///< [mm]
};

SeamView viewAt(const Polygon& loop, std::size_t vertex) {
  const double turn = turnAt(loop, vertex);
  const int kind = turn <= -kCorner ? 0 : turn >= kCorner ? 1 : 2;
  return {kind, loop[vertex].y() + kTilt * loop[vertex].x()};
}

/// Beside a corner vertices turn as well, but less.
std::size_t sharpestBeside(const Polygon& loop, std::size_t vertex) {
  std::size_t sharpest = vertex;
  double turn = std::abs(turnAt(loop, vertex));
  for (const std::size_t step : {std::size_t{1}, loop.size() - 1}) {
    std::size_t i = vertex;
    for (double way_mm = 0.0; way_mm < kArm;) {
      const std::size_t next = (i + step) % loop.size();
      way_mm += (loop[next] - loop[i]).norm();
      i = next;
      if (i == vertex) break;
      const double other = std::abs(turnAt(loop, i));
      if (way_mm < kArm && other > turn + kSameTurn) {
        turn = other;
        sharpest = i;
      }
    }
  }
  return sharpest;
}

Polygon startingAtCorner(Polygon loop, const Candidates& among) {
  if (loop.size() < 3 || among.empty()) return loop;
  std::size_t best = among.front();
  SeamView best_view = viewAt(loop, best);
  for (const std::size_t i : among) {
    const SeamView view = viewAt(loop, i);
    const bool is_better =
        view.kind != best_view.kind ? view.kind < best_view.kind : view.back > best_view.back;
    if (!is_better) continue;
    best = i;
    best_view = view;
  }
  if (best_view.kind < 2) {
    const std::size_t sharpest = sharpestBeside(loop, best);
    if (std::binary_search(among.begin(), among.end(), sharpest)) best = sharpest;
  }
  return startingAt(std::move(loop), best);
}

/// The loop with a vertex in the middle of its longest stretch within these areas, at which it starts; as it
/// is if it does not pass through them.
Polygon startingWithin(Polygon loop, const std::vector<Polygon>& areas) {
  double longest_mm = 0.0;
  std::size_t edge = 0;
  Point2 middle;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2& from = loop[i];
    const Point2 way = loop[i + 1 < loop.size() ? i + 1 : 0] - from;
    std::vector<double> shares = crossings(from, from + way, areas);
    shares.insert(shares.begin(), 0.0);
    shares.push_back(1.0);
    for (std::size_t s = 1; s < shares.size(); ++s) {
      const double length_mm = (shares[s] - shares[s - 1]) * way.norm();
      const Point2 at = from + 0.5 * (shares[s - 1] + shares[s]) * way;
      if (length_mm <= longest_mm || !contains(areas, at)) continue;
      longest_mm = length_mm;
      edge = i;
      middle = at;
    }
  }
  if (longest_mm == 0.0) return loop;
  loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(edge) + 1, middle);
  return startingAt(std::move(loop), edge + 1);
}

Candidates all(const Polygon& loop) {
  Candidates vertices(loop.size());
  std::iota(vertices.begin(), vertices.end(), std::size_t{0});
  return vertices;
}

}  // namespace

Seam::Seam(const SeamSettings& settings, const Point2& anchor, std::uint64_t layer, const Regions* here)
    : placement_(settings.placement),
      anchor_(anchor),
      random_(Random(static_cast<std::uint64_t>(settings.seed)).bits() + layer) {
  if (here != nullptr) here_ = outlines(*here);
}

Polygon Seam::withVertexHere(Polygon loop) const {
  if (here_.empty()) return loop;
  const bool has_one =
      std::any_of(loop.begin(), loop.end(), [this](const Point2& vertex) { return contains(here_, vertex); });
  return has_one ? loop : startingWithin(std::move(loop), here_);
}

/// Vertices where it may start: all if it does not pass through the areas for seams.
std::vector<std::size_t> Seam::candidates(const Polygon& loop) const {
  Candidates within;
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (!here_.empty() && contains(here_, loop[i])) within.push_back(i);
  return within.empty() ? all(loop) : within;
}

Polygon Seam::placed(Polygon loop) {
  if (placement_ == SeamPlacement::Nearest) return loop;
  loop = withVertexHere(std::move(loop));
  const Candidates among = candidates(loop);
  switch (placement_) {
    case SeamPlacement::Aligned:
      return startingNearest(std::move(loop), among, anchor_);
    case SeamPlacement::Rear:
      return startingAtFirst(std::move(loop), among, isFartherBack);
    case SeamPlacement::Corner:
      return startingAtCorner(std::move(loop), among);
    case SeamPlacement::Random: {
      if (among.size() < loop.size()) {
        const auto chosen = static_cast<std::size_t>(random_.uniform(0.0, static_cast<double>(among.size())));
        return startingAt(std::move(loop), among[std::min(chosen, among.size() - 1)]);
      }
      const double distance = random_.uniform(0.0, perimeter(loop));
      return startingAlong(std::move(loop), distance);
    }
    case SeamPlacement::Nearest:
      break;
  }
  return loop;
}

Polygon Seam::approached(Polygon loop, const Point2& nozzle) const {
  if (placement_ != SeamPlacement::Nearest) return loop;
  loop = withVertexHere(std::move(loop));
  const Candidates among = candidates(loop);
  return startingNearest(std::move(loop), among, nozzle);
}

}  // namespace lamina
