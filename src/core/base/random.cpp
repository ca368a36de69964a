// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/random.hpp"

#include <cmath>

namespace lamina {

std::uint64_t Random::bits() {
  std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ULL);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31);
}

double Random::uniform(double low, double high) {
  constexpr double kInverse53Bits = 0x1.0p-53;
  return low + (high - low) * static_cast<double>(bits() >> 11) * kInverse53Bits;
}

std::uint64_t Random::below(std::uint64_t count) { return bits() % count; }

double Random::normal(double mean, double sigma) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(0.0, 1.0)));
  return mean + sigma * radius * std::cos(2.0 * M_PI * uniform(0.0, 1.0));
}

}  // namespace lamina
