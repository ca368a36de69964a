// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/gcode/laid_filament.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "lamina/base/characters.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "program/gcode/slicer_comments.hpp"

namespace lamina {
namespace {

constexpr std::streamoff kNearEnds = 65536;  // bytes: slicers write their settings at either end

/// In the comments of lines that begin within so many bytes from here.
std::optional<double> diameterWithin(std::istream& text, std::streamoff bytes) {
  std::optional<double> diameter_mm;
  std::string line;
  for (std::streamoff read = 0; read < bytes && std::getline(text, line) && !diameter_mm;
       read += static_cast<std::streamoff>(line.size()) + 1)
    if (!line.empty() && line.front() == ';') diameter_mm = statedFilamentDiameter(trimmed(line.substr(1)));
  return diameter_mm;
}

}  // namespace

LaidFilament::LaidFilament(double filament_diameter_mm)
    : area_mm2_(0.25 * M_PI * filament_diameter_mm * filament_diameter_mm),
      reader_({}, {[this](const GcodeMotion& motion) { move(motion); },
                   {},
                   [this](std::size_t /*line*/, std::string_view command) { setVolumetric(command); }}) {}

void LaidFilament::take(std::string_view command) {
  if (!fault_.empty()) return;
  try {
    reader_.read(std::string(command) + '\n');
  } catch (const InvalidProgram& error) {
    // Homing of one kind or another, a mode, a travel: nothing is laid by it.
    if (command.find_first_of("Ee") == std::string_view::npos) return;
    fault_ = std::string(command) + ": " + error.what();
    length_mm_ = volume_mm3_ = feed_mm_s_ = std::numeric_limits<double>::quiet_NaN();
  }
}

void LaidFilament::move(const GcodeMotion& motion) {
  const double distance_mm = (motion.end - motion.start).norm();
  feed_mm_s_ = motion.feed_mm_s;
  const double extruded_mm3 = motion.extrusion_mm * (is_volumetric_ ? 1.0 : area_mm2_);
  if (extruded_mm3 > 0.0) length_mm_ += distance_mm;
  retracted_mm3_ -= extruded_mm3;
  if (retracted_mm3_ >= 0.0) return;
  volume_mm3_ -= retracted_mm3_;
  retracted_mm3_ = 0.0;
}

/// Marlin: M200 D1.75 counts E in mm^3 of such filament, M200 D0 and M200 S0 in mm again, M200 S1 in mm^3.
void LaidFilament::setVolumetric(std::string_view command) {
  constexpr std::string_view kName = "M200";
  if (command.substr(0, kName.size()) != kName) return;
  const std::string words(command.substr(kName.size()));
  if (!words.empty() && (isDigit(words.front()) || words.front() == '.')) return;  // another number
  const auto value = [&words](char letter) -> std::optional<double> {
    const std::size_t word = words.find(letter);
    if (word == std::string::npos) return std::nullopt;
    return std::strtod(words.c_str() + word + 1, nullptr);
  };
  const std::optional<double> diameter_mm = value('D');
  const std::optional<double> is_set = value('S');
  if (diameter_mm) is_volumetric_ = *diameter_mm > 0.0;
  if (is_set && !(diameter_mm && *diameter_mm <= 0.0)) is_volumetric_ = *is_set != 0.0;
}

std::optional<double> filamentDiameterOf(std::istream& program) {
  if (const auto diameter_mm = diameterWithin(program, kNearEnds)) return diameter_mm;
  program.clear();
  program.seekg(0, std::ios::end);
  const std::streamoff bytes = program.tellg();
  program.seekg(std::max<std::streamoff>(0, bytes - kNearEnds));
  return diameterWithin(program, kNearEnds);
}

}  // namespace lamina
