// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/colour.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace lamina {
namespace {

using Stops = std::array<Colour, 5>;

constexpr Stops kSequential = {Colour{0.15, 0.15, 0.40}, Colour{0.16, 0.40, 0.58}, Colour{0.15, 0.62, 0.56},
                               Colour{0.52, 0.80, 0.35}, Colour{0.98, 0.90, 0.25}};
constexpr Stops kDiverging = {Colour{0.12, 0.30, 0.65}, Colour{0.50, 0.68, 0.88}, Colour{0.96, 0.96, 0.96},
                              Colour{0.94, 0.60, 0.48}, Colour{0.72, 0.10, 0.16}};

double mix(double a, double b, double part) { return a + part * (b - a); }

}  // namespace

Colour shaded(const Colour& colour, double factor) {
  if (factor <= 1.0) return {colour.red * factor, colour.green * factor, colour.blue * factor, colour.alpha};
  const double part = std::min(1.0, factor - 1.0);
  return {mix(colour.red, 1.0, part), mix(colour.green, 1.0, part), mix(colour.blue, 1.0, part),
          colour.alpha};
}

Colour colourAt(ColourMap map, double fraction) {
  if (std::isnan(fraction)) return {0.88, 0.88, 0.88};
  const Stops& stops = map == ColourMap::Sequential ? kSequential : kDiverging;
  const double place = std::clamp(fraction, 0.0, 1.0) * (stops.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  const double part = place - static_cast<double>(i);
  const Colour& a = stops[i];
  const Colour& b = stops[i + 1];
  return {mix(a.red, b.red, part), mix(a.green, b.green, part), mix(a.blue, b.blue, part)};
}

}  // namespace lamina
