// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voids/beads/scan_rows.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {

std::size_t ScanRows::firstAbove(double y) const {
  const double row = std::ceil((y - low_mm) / spacing_mm - 0.5);
  return row <= 0.0 ? 0 : std::min(count, static_cast<std::size_t>(row));
}

std::vector<Spans> insideSpans(const std::vector<Polygon>& outlines, const ScanRows& rows) {
  std::vector<std::vector<double>> crossings(rows.count);
  for (const Polygon& outline : outlines) {
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
      const Point2& low = outline[i].y() < outline[j].y() ? outline[i] : outline[j];
      const Point2& high = outline[i].y() < outline[j].y() ? outline[j] : outline[i];
      const std::size_t end = rows.firstAbove(high.y());
      for (std::size_t row = rows.firstAbove(low.y()); row < end; ++row) {
        const double t = (rows.at(row) - low.y()) / (high.y() - low.y());
        crossings[row].push_back(low.x() + t * (high.x() - low.x()));
      }
    }
  }
  std::vector<Spans> spans(rows.count);
  for (std::size_t row = 0; row < rows.count; ++row) {
    std::vector<double>& at = crossings[row];
    std::sort(at.begin(), at.end());
    for (std::size_t k = 1; k < at.size(); k += 2)
      if (at[k] > at[k - 1]) spans[row].push_back({at[k - 1], at[k]});
  }
  return spans;
}

Spans united(Spans spans) {
  std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.low < b.low; });
  std::size_t kept = 0;
  for (const Span& span : spans) {
    if (kept > 0 && span.low <= spans[kept - 1].high)
      spans[kept - 1].high = std::max(spans[kept - 1].high, span.high);
    else
      spans[kept++] = span;
  }
  spans.resize(kept);
  return spans;
}

Spans difference(const Spans& spans, const Spans& subtracted) {
  Spans left;
  std::size_t first = 0;
  for (const Span& span : spans) {
    while (first < subtracted.size() && subtracted[first].high <= span.low) ++first;
    double low = span.low;
    for (std::size_t k = first; k < subtracted.size() && subtracted[k].low < span.high; ++k) {
      if (subtracted[k].low > low) left.push_back({low, subtracted[k].low});
      low = std::max(low, subtracted[k].high);
    }
    if (low < span.high) left.push_back({low, span.high});
  }
  return left;
}

}  // namespace lamina
