// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/overhangs/overhanging_walls.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::size_t kEntries = 4;
constexpr double kGreatestFactor = 3.0;

std::string listOf(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%s%.6g", text.empty() ? "" : ",", value);
    text += digits;
  }
  return text;
}

void requireFactors(const std::string& key, const std::vector<double>& factors) {
  const auto fits = [](double factor) { return factor > 0.0 && factor <= kGreatestFactor; };
  if (factors.size() == kEntries && std::all_of(factors.begin(), factors.end(), fits)) return;
  throw InvalidConfig(key + " is '" + listOf(factors) + "'; expected 4 numbers in (0, 3]");
}

/// Linear between the entries.
double factorAt(double share, const std::vector<double>& shares, const std::vector<double>& factors) {
  if (shares.empty() || share < shares.front()) return 1.0;
  for (std::size_t i = 1; i < shares.size(); ++i)
    if (share <= shares[i])
      return factors[i - 1] +
             (share - shares[i - 1]) / (shares[i] - shares[i - 1]) * (factors[i] - factors[i - 1]);
  return factors.back();
}

}  // namespace

void describe(SettingsSchema& schema, OverhangingWallSettings& overhangs) {
  schema.flag("overhangs.use", overhangs.is_used,
              "Whether walls are deposited otherwise where part of their bead lies beyond the layer below.");
  schema.numbers("overhangs.shares", overhangs.shares, kEntries,
                 "Shares of the bead that nothing carries, ascending.");
  schema.numbers("overhangs.feed_factors", overhangs.feed_factors, kEntries,
                 "Factors on the feed at these shares; linear between them, 1 below the first.");
  schema.numbers("overhangs.flow_factors", overhangs.flow_factors, kEntries,
                 "Factors on the cross-section of beads at these shares, likewise.");
  schema.flag("overhangs.reverse", overhangs.reverses,
              "Whether overhanging walls of every second layer run the other way round.");
}

void requireConsistent(const OverhangingWallSettings& overhangs) {
  const std::vector<double>& shares = overhangs.shares;
  const auto falls = [](double a, double b) { return b <= a; };
  if (shares.size() != kEntries || shares.front() < 0.0 || shares.back() > 1.0 ||
      std::adjacent_find(shares.begin(), shares.end(), falls) != shares.end())
    throw InvalidConfig("overhangs.shares is '" + listOf(shares) +
                        "'; expected 4 numbers that ascend within [0, 1]");
  requireFactors("overhangs.feed_factors", overhangs.feed_factors);
  requireFactors("overhangs.flow_factors", overhangs.flow_factors);
}

double overhangShare(double beyond_mm, double width_mm) {
  return width_mm > 0.0 ? std::clamp(beyond_mm / width_mm, 0.0, 1.0) : 0.0;
}

double overhangFeedFactor(double share, const OverhangingWallSettings& settings) {
  return factorAt(share, settings.shares, settings.feed_factors);
}

double overhangFlowFactor(double share, const OverhangingWallSettings& settings) {
  return factorAt(share, settings.shares, settings.flow_factors);
}

}  // namespace lamina
