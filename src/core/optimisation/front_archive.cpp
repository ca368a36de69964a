// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "front_archive.hpp"

#include <algorithm>
#include <utility>

namespace lamina {
namespace {

/// Nowhere worse, and somewhere better.
bool dominates(const double* one, const double* other, std::size_t count) {
  // Without branches: along a front one comparison says nothing of the next.
  unsigned is_worse = 0;
  unsigned is_better = 0;
  for (std::size_t i = 0; i < count; ++i) {
    is_worse |= static_cast<unsigned>(one[i] > other[i]);
    is_better |= static_cast<unsigned>(one[i] < other[i]);
  }
  return (is_better & ~is_worse) != 0;
}

}  // namespace

void FrontArchive::add(std::size_t member, const std::vector<double>& costs) {
  const std::size_t count = costs.size();
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (!dominates(&costs_[i * count], costs.data(), count)) continue;
    // One that dominates much is asked first.
    std::swap(members_[i], members_[i / 2]);
    std::swap_ranges(&costs_[i * count], &costs_[i * count] + count, &costs_[i / 2 * count]);
    return;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (dominates(costs.data(), &costs_[i * count], count)) continue;
    members_[kept] = members_[i];
    std::copy_n(&costs_[i * count], count, &costs_[kept * count]);
    ++kept;
  }
  members_.resize(kept);
  costs_.resize(kept * count);
  members_.push_back(member);
  costs_.insert(costs_.end(), costs.begin(), costs.end());
}

}  // namespace lamina
