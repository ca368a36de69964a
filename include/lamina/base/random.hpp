// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace lamina {

/// Small seeded generator of random numbers (SplitMix64 [Steele2014]). The same seed gives the same numbers
/// on every machine, which the distributions of the standard library do not guarantee.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits();
  /// Uniform in [low, high).
  double uniform(double low, double high);
  /// Uniform in [0, count); count at least 1.
  std::uint64_t below(std::uint64_t count);
  /// Normal with the given mean and standard deviation (Box-Muller).
  double normal(double mean, double sigma);

 private:
  std::uint64_t state_;
};

}  // namespace lamina
