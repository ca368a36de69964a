// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include "lamina/program/gcode/gcode_reader.hpp"

namespace lamina {

/// What a program of filament has laid so far, command by command, in constant memory. Flow that is changed
/// at the machine (M221, its panel) is not known here.
class LaidFilament {
 public:
  /// @param filament_diameter_mm  positive; without effect while the program states E in mm^3 (M200)
  explicit LaidFilament(double filament_diameter_mm);
  LaidFilament(const LaidFilament&) = delete;
  LaidFilament& operator=(const LaidFilament&) = delete;

  /// Takes the next command. One that cannot be read is passed over if it has no E, as G28 W, and its way, if
  /// it has one, with it; from any other on, nothing is known any more: `fault`.
  void take(std::string_view command);

  /// Length of beads: of motions that extrude [mm]. This, volume and feed are NaN after a fault.
  double length() const { return length_mm_; }
  /// Volume of the filament that has left the nozzle [mm^3], priming and purging included. What is retracted
  /// and pushed forward again counts once.
  double volume() const { return volume_mm3_; }
  /// Feed of the last motion [mm/s]; 0 before the first.
  double feed() const { return feed_mm_s_; }
  /// The command with E that cannot be read, and why; empty if there is none.
  const std::string& fault() const { return fault_; }

 private:
  void move(const GcodeMotion& motion);
  void setVolumetric(std::string_view command);

  double area_mm2_;
  bool is_volumetric_ = false;
  double length_mm_ = 0.0;
  double volume_mm3_ = 0.0;
  double retracted_mm3_ = 0.0;
  double feed_mm_s_ = 0.0;
  std::string fault_;
  GcodeReader reader_;
};

/// The diameter [mm] of the filament for which a program was made, as a comment within 64 KiB of its
/// beginning or its end states it; nothing if none does.
std::optional<double> filamentDiameterOf(std::istream& program);

}  // namespace lamina
