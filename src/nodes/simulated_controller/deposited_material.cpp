// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "deposited_material.hpp"

#include <string>
#include <utility>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

HeightMap bareBed(const ControllerSettings& settings) {
  const std::vector<double>& area = settings.deposit_area_mm;
  const bool is_area = area.size() == 4 && area[0] < area[2] && area[1] < area[3];
  if (!is_area)
    throw InvalidConfig("deposit.area_mm has " + std::to_string(area.size()) +
                        " values or goes from a larger to a smaller one; expected the least x and y, and the "
                        "greatest x and y, in mm");
  try {
    return HeightMap(heightGrid({{area[0], area[1]}, {area[2], area[3]}}, settings.deposit_cell_mm), 0.0);
  } catch (const InvalidInput& error) {
    throw InvalidConfig(std::string("deposit.area_mm, in cells of deposit.cell_mm: ") + error.what());
  }
}

}  // namespace

DepositedMaterial::DepositedMaterial(const ControllerSettings& settings)
    : deposit_(bareBed(settings), settings.plant, settings.grown), sensor_(settings.sensor) {}

void DepositedMaterial::observe(const NozzleInstant& now) {
  const std::optional<NozzleInstant> before = std::exchange(last_, now);
  if (!before) return;
  // The flow goes in proportion from report to report.
  const double volume = 0.5 * (before->asked_mm3_s + now.asked_mm3_s) * (now.time_s - before->time_s);
  if (volume > 0.0)
    deposit_.lay({before->tip, now.tip, volume, before->time_s, now.time_s});
  else
    deposit_.endBead();
}

std::vector<Point3> DepositedMaterial::seenFrom(const Eigen::Isometry3d& bed_from_sensor, double now_s) {
  return sensor_.measure(deposit_.surface(), bed_from_sensor, deposit_.highest(), now_s);
}

}  // namespace lamina
