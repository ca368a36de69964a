// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/emulator/emulated_height_map.hpp"

#include <cmath>
#include <cstdio>

namespace lamina {
namespace {

constexpr int kMapPoints = 5;         // in each direction
constexpr double kProbingTime = 2.0;  // of a point [s]

/// A bump of Gauss' shape in the middle of a square of side 1.
double bumpAt(double x, double y) {
  constexpr double kWidth = 0.25;
  return std::exp(-((x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5)) / (kWidth * kWidth));
}

}  // namespace

std::string heightMapText(double bump_mm) {
  std::string map = "Bilinear Leveling Grid:\n     ";
  for (int column = 0; column < kMapPoints; ++column) map += "      " + std::to_string(column);
  for (int row = 0; row < kMapPoints; ++row) {
    map += "\n " + std::to_string(row);
    for (int column = 0; column < kMapPoints; ++column) {
      char text[32];
      std::snprintf(text, sizeof text, " %+.3f",
                    bump_mm * bumpAt(column / (kMapPoints - 1.0), row / (kMapPoints - 1.0)));
      map += text;
    }
  }
  return map + "\n";
}

double heightMapTime() { return kProbingTime * kMapPoints * kMapPoints; }

}  // namespace lamina
