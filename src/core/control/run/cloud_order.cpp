// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/run/cloud_order.hpp"

#include <cstdint>
#include <cstring>

namespace lamina {
namespace {

/// By their bits: values that are no numbers have an order too.
int comparedBits(const double* a, const double* b, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    std::uint64_t of_a = 0;
    std::uint64_t of_b = 0;
    std::memcpy(&of_a, a + i, sizeof of_a);
    std::memcpy(&of_b, b + i, sizeof of_b);
    if (of_a != of_b) return of_a < of_b ? -1 : 1;
  }
  return 0;
}

}  // namespace

int compared(const SensedCloud& a, const SensedCloud& b) {
  if (a.profiles.size() != b.profiles.size()) return a.profiles.size() < b.profiles.size() ? -1 : 1;
  for (std::size_t i = 0; i < a.profiles.size(); ++i) {
    const auto& of_a = a.profiles[i];
    const auto& of_b = b.profiles[i];
    if (of_a.size() != of_b.size()) return of_a.size() < of_b.size() ? -1 : 1;
    for (std::size_t k = 0; k < of_a.size(); ++k)
      if (const int order = comparedBits(of_a[k].data(), of_b[k].data(), 3); order != 0) return order;
  }
  if (const int order = comparedBits(a.bed_from_sensor.data(), b.bed_from_sensor.data(), 16); order != 0)
    return order;
  return a.sensor.compare(b.sensor);
}

}  // namespace lamina
