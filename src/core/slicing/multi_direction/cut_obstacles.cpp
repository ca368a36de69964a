// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/multi_direction/cut_obstacles.hpp"

#include <cstdio>
#include <numeric>

namespace lamina {
namespace {

/// Adds a reason, and how many directions have it; nothing if none has.
void addReason(std::size_t directions, const std::string& reason, std::string& text) {
  if (directions == 0) return;
  text += (text.empty() ? "across " : "; across ") + std::to_string(directions) + " " + reason;
}

std::string threeDigits(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string bedReason(const CutObstacles& obstacles, double part_height_mm) {
  if (!(obstacles.least_tip_mm > 0.0 && obstacles.least_tip_mm < std::numeric_limits<double>::infinity()))
    return "the plane would be in the bed";
  return "the head would be in the bed, from which its tip has to stay " +
         threeDigits(obstacles.least_tip_mm) + " mm or more, in a part " + threeDigits(part_height_mm) +
         " mm high";
}

}  // namespace

std::size_t CutObstacles::count() const {
  return std::accumulate(directions.begin(), directions.end(), std::size_t{0});
}

std::string textOf(const CutObstacles& obstacles, double part_height_mm) {
  std::string reasons;
  addReason(obstacles.of(DirectionObstacle::Bed), bedReason(obstacles, part_height_mm), reasons);
  addReason(obstacles.of(DirectionObstacle::Base),
            "a piece would lie on less than " + threeDigits(obstacles.least_base_mm2) + " mm²", reasons);
  addReason(obstacles.of(DirectionObstacle::Rest), "a rest would not stand on the bed", reasons);
  addReason(obstacles.of(DirectionObstacle::Gain),
            "a cut would free less than " + threeDigits(obstacles.least_gain_mm2) + " mm²", reasons);
  addReason(obstacles.of(DirectionObstacle::Price), "a cut would cost more than it frees", reasons);
  return "no further cut across " + std::to_string(obstacles.count()) +
         (obstacles.count() == 1 ? " direction: " : " directions: ") + reasons;
}

}  // namespace lamina
