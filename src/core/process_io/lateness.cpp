// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/process_io/lateness.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {

void Lateness::add(double late_s) {
  late_s = std::max(0.0, late_s);
  const auto step = static_cast<std::size_t>(std::min(late_s / kStep, static_cast<double>(counts_.size())));
  ++counts_[std::min(step, counts_.size() - 1)];
  ++count_;
  if (late_s > kLate) ++late_;
  if (late_s > kTooLate) ++too_late_;
  worst_s_ = std::max(worst_s_, late_s);
}

double Lateness::percentile(double share) const {
  const double wanted = share * static_cast<double>(count_);
  std::uint64_t counted = 0;
  for (std::size_t step = 0; step + 1 < counts_.size(); ++step) {
    counted += counts_[step];
    if (counted > 0 && static_cast<double>(counted) >= wanted)
      return std::min(worst_s_, kStep * static_cast<double>(step + 1));
  }
  return worst_s_;
}

}  // namespace lamina
