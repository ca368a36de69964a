// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "arriving_flow.hpp"

#include <cmath>
#include <utility>

namespace lamina {

ArrivingFlow::ArrivingFlow(PlantSettings plant) : plant_(std::move(plant)) {}

double ArrivingFlow::at(double now_s, double asked_mm3_s) {
  asked_.push_back({now_s, asked_mm3_s});
  const double heard_s = now_s - plant_.dead_time_s;
  while (asked_.size() > 1 && asked_[1].since_s <= heard_s) asked_.pop_front();
  const double heard_mm3_s = asked_.front().since_s <= heard_s ? asked_.front().flow_mm3_s : 0.0;
  const double passed_s = now_s - std::exchange(last_s_, now_s);
  if (plant_.lag_s > 0.0)
    follows_mm3_s_ += (1.0 - std::exp(-passed_s / plant_.lag_s)) * (heard_mm3_s - follows_mm3_s_);
  else
    follows_mm3_s_ = heard_mm3_s;
  return plant_.gain * follows_mm3_s_;
}

}  // namespace lamina
