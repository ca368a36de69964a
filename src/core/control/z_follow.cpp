// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/z_follow.hpp"

#include <algorithm>

#include "lamina/control/path_low_pass.hpp"

namespace lamina {
namespace {

constexpr double kShiftRate = 0.2;  // layers per layer

}  // namespace

std::vector<double> nozzleShift(const LayerCells& cells, const LayerKnowledge& known, double before_mm,
                                const NozzleRoom& room, const LoopSettings& settings) {
  std::vector<double> shift(cells.size(), 0.0);
  if (settings.z == NozzleHeight::Plan) return shift;
  if (settings.z == NozzleHeight::Surface && settings.process == LoopProcess::Free) {
    shift = lowPassed(known.error_mm, cells, settings.low_pass_mm);
    for (double& dz : shift) dz = -dz;
  } else {
    const double mean = meanOverCells(cells, known.error_mm);
    const bool is_pressed = settings.process == LoopProcess::Pressed;
    const double wanted = is_pressed ? before_mm + settings.gain * mean : -mean;
    const double step = kShiftRate * room.layer_mm;
    std::fill(shift.begin(), shift.end(), std::clamp(wanted, before_mm - step, before_mm + step));
  }
  // The nozzle's plan is a layer above where the layer below should be.
  const double lowest = room.highest_mm - room.layer_mm - room.clearance_mm;
  for (double& dz : shift) dz = std::clamp(std::max(dz, lowest), -room.layer_mm, room.layer_mm);
  return shift;
}

}  // namespace lamina
