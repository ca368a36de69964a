// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tracking.hpp"
#include "lamina/base/number_text.hpp"
#include "names.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {

void Tracking::add(const JointValues& wanted, const JointValues& actual) {
  joints_ = actual - wanted;
  const Eigen::Vector3d asked = model_.bedFromNozzle(wanted).translation();
  tip_mm_ = (model_.bedFromNozzle(actual).translation() - asked).norm();
  worst_tip_mm_ = std::max(worst_tip_mm_, tip_mm_);
  squares_mm2_ += tip_mm_ * tip_mm_;
  ++reports_;
}

double Tracking::rmsTip() const {
  return reports_ == 0 ? 0.0 : std::sqrt(squares_mm2_ / static_cast<double>(reports_));
}

std::optional<std::string> Tracking::deviation(double most_mm) const {
  if (most_mm <= 0.0 || tip_mm_ <= most_mm) return std::nullopt;
  return names::kTipOff + numberText(tip_mm_) + " mm from where it is to be; expected at most " +
         numberText(most_mm) + " mm";
}

}  // namespace lamina
