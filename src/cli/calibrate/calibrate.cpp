// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "calibrate/calibrated_cell.hpp"
#include "subcommand.hpp"

namespace lamina::cli {

void addCalibrate(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand(
      "calibrate",
      "Find when and from where a profile sensor sees, how late a "
      "feeder follows, how much it extrudes, where tip, work object and external axes are");
  subcommand->require_subcommand(1);
  addCalibratePlan(*subcommand, chosen);
  addCalibrateTime(*subcommand, chosen);
  addCalibrateSensor(*subcommand, chosen);
  addCalibrateFeeder(*subcommand, chosen);
  addCalibrateFlow(*subcommand, chosen);
  addCalibrateTip(*subcommand, chosen);
  addCalibrateObject(*subcommand, chosen);
  addCalibratePositioner(*subcommand, chosen);
  addCalibrateRail(*subcommand, chosen);
}

}  // namespace lamina::cli
