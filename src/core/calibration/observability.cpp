// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <cstdio>

#include "lamina/base/text.hpp"
#include "lamina/calibration/sensor_pose.hpp"

namespace lamina {
namespace {

constexpr std::size_t kDirections = 6;
constexpr std::size_t kShifts = 3;
constexpr double kMixedShare = 0.3;

/// The worst determined of the directions in which the given one has the greatest share.
const ObservedDirection* worstWith(const SensorPoseFit& fit, std::size_t direction) {
  const ObservedDirection* worst = nullptr;
  for (const ObservedDirection& observed : fit.directions)
    if (std::abs(observed.share[direction]) > kMixedShare) worst = &observed;
  return worst;
}

/// The others that look like it.
std::vector<std::string> mixedWith(const ObservedDirection& observed, std::size_t direction) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < kDirections; ++i)
    if (i != direction && std::abs(observed.share[i]) > kMixedShare) names.emplace_back(directionName(i));
  return names;
}

}  // namespace

const char* directionName(std::size_t direction) {
  static constexpr std::array<const char*, kDirections> kNames = {
      "x", "y", "z", "turn about x", "turn about y", "turn about z"};
  return kNames.at(direction);
}

std::string directionsNotFound(const SensorPoseFit& fit) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < kDirections; ++i)
    if (fit.is_kept[i]) names.emplace_back(directionName(i));
  return listed(names);
}

std::vector<std::string> observability(const SensorPoseFit& fit, const SensorPoseSettings& settings) {
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < kDirections; ++i) {
    if (!fit.is_kept[i]) continue;
    const ObservedDirection* const worst = worstWith(fit, i);
    const double unit = i < kShifts ? settings.max_sigma_mm : settings.max_sigma_deg;
    std::string sentence =
        std::string(directionName(i)) + " of the nozzle is not observable: it keeps its former value";
    std::array<char, 96> figure{};
    if (worst != nullptr && worst->singular_value > 1e-6)
      std::snprintf(figure.data(), figure.size(), "; its standard deviation would be %.3g %s",
                    unit / worst->singular_value, i < kShifts ? "mm" : "deg");
    else
      std::snprintf(figure.data(), figure.size(), "; nothing recorded changes with it");
    sentence += figure.data();
    const std::vector<std::string> mixed =
        worst == nullptr ? std::vector<std::string>() : mixedWith(*worst, i);
    if (!mixed.empty()) sentence += ", as it looks like " + listed(mixed, " and ");
    sentences.push_back(sentence);
  }
  return sentences;
}

}  // namespace lamina
