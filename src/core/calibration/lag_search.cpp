// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lag_search.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {

double vertexOfParabola(double before, double middle, double after) {
  const double bend = before - 2.0 * middle + after;
  if (bend == 0.0) return 0.0;
  return std::clamp(0.5 * (before - after) / bend, -1.0, 1.0);
}

LineOfValues lineOfValues(const std::vector<double>& places, const std::vector<double>& values) {
  LineOfValues line;
  if (values.empty()) return line;
  const auto count = static_cast<double>(values.size());
  double middle = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    line.mean += values[i] / count;
    middle += places[i] / count;
  }
  double squares = 0.0;
  double along = 0.0;
  double spread = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    squares += (values[i] - line.mean) * (values[i] - line.mean);
    along += (values[i] - line.mean) * (places[i] - middle);
    spread += (places[i] - middle) * (places[i] - middle);
  }
  if (values.size() > 1) line.deviation = std::sqrt(squares / (count - 1.0));
  if (values.size() > 2 && spread > 0.0) line.slope = along / spread;
  return line;
}

}  // namespace lamina
