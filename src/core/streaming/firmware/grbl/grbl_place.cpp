// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/grbl/grbl_place.hpp"

#include <cstddef>
#include <utility>

namespace lamina {

void GrblPlace::learn(const GrblReport& report) {
  if (report.work_offset) work_offset_ = report.work_offset;
  work_ = report.work_position;
  if (work_ || !report.machine_position || !work_offset_) return;
  work_ = report.machine_position;
  for (std::size_t i = 0; i < work_->size(); ++i) (*work_)[i] -= (*work_offset_)[i];
}

bool GrblPlace::follow(const GrblReport& report) {
  learn(report);
  const auto place = report.machine_position ? report.machine_position : report.work_position;
  return std::exchange(place_, place) != place;
}

}  // namespace lamina
