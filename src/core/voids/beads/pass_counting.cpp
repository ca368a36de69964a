// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voids/beads/pass_counting.hpp"

#include <algorithm>
#include <limits>

namespace lamina {
namespace {

double arcAt(const BeadSpan& span, double x) {
  const double t = (x - span.low) / (span.high - span.low);
  return span.arc_low + t * (span.arc_high - span.arc_low);
}

}  // namespace

PassCounter::PassCounter(const ToolpathLayer& layer, double reach_mm) : reach_mm_(reach_mm) {
  for (const Path& path : layer.paths) closed_length_.push_back(path.is_closed ? length(path) : 0.0);
}

int PassCounter::passesAt(std::vector<Place>& places) const {
  std::sort(places.begin(), places.end(),
            [](const Place& a, const Place& b) { return a.run != b.run ? a.run < b.run : a.arc < b.arc; });
  int passes = 0;
  for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
    int of_run = 1;
    for (end = begin + 1; end < places.size() && places[end].run == places[begin].run; ++end)
      if (places[end].arc - places[end - 1].arc > reach_mm_) ++of_run;
    const double length = closed_length_[places[begin].run];
    const bool closes = length > 0.0 && places[begin].arc + length - places[end - 1].arc <= reach_mm_;
    passes += closes && of_run > 1 ? of_run - 1 : of_run;
  }
  return passes;
}

void PassCounter::addPieces(const std::vector<BeadSpan>& active, Span range,
                            std::vector<Piece>& pieces) const {
  const auto add = [&](double low, double high, int passes) {
    if (!pieces.empty() && pieces.back().passes == passes && pieces.back().high == low) {
      pieces.back().high = high;
    } else {
      Piece piece;
      piece.low = low, piece.high = high, piece.passes = passes;
      pieces.push_back(piece);
    }
  };
  if (active.size() == 1) return add(range.low, range.high, 1);
  // Two parts of one run may come together along the row: within a quarter of the reach that makes no
  // difference.
  const int steps = 1 + static_cast<int>(4.0 * range.length() / reach_mm_);
  std::vector<Place> places;
  for (int k = 0; k < steps; ++k) {
    const double low = range.low + range.length() * k / steps;
    const double high = k + 1 == steps ? range.high : range.low + range.length() * (k + 1) / steps;
    places.clear();
    for (const BeadSpan& span : active) places.push_back({span.run, arcAt(span, 0.5 * (low + high))});
    add(low, high, passesAt(places));
  }
}

std::vector<PassCounter::Piece> PassCounter::count(std::vector<BeadSpan> spans) const {
  std::sort(spans.begin(), spans.end(), [](const BeadSpan& a, const BeadSpan& b) { return a.low < b.low; });
  std::vector<Piece> pieces;
  std::vector<BeadSpan> active;
  double x = 0.0;
  const auto advanceTo = [&](double target) {
    while (!active.empty() && x < target) {
      double next = target;
      for (const BeadSpan& span : active) next = std::min(next, span.high);
      if (next > x) addPieces(active, {x, next}, pieces);
      x = std::max(x, next);
      active.erase(
          std::remove_if(active.begin(), active.end(), [&](const BeadSpan& span) { return span.high <= x; }),
          active.end());
    }
  };
  for (const BeadSpan& span : spans) {
    advanceTo(span.low);
    x = span.low;
    active.push_back(span);
  }
  if (!spans.empty()) advanceTo(std::numeric_limits<double>::infinity());
  return pieces;
}

}  // namespace lamina
