// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_rewrite/closing_code.hpp"

#include <algorithm>
#include <utility>

#include "gcode_rewrite/decimal_number.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

/// Absolute and in mm, whatever holds there.
void appendAbsolute(const ProgramTracker& tracker, const std::string& motions, std::string& out) {
  if (tracker.isInInches()) out += "G21\n";
  if (tracker.isPositionRelative()) out += "G90\n";
  out += motions;
  if (tracker.isInInches()) out += "G20\n";
  if (!tracker.isPositionRelative()) return;
  // Marlin takes G90 and G91 for E too.
  out += tracker.isExtrusionRelative() ? "G91\nM83\n" : "G91\nM82\n";
}

bool isMotion(const GcodeBlock& command) {
  return command.start() == LineStart::G && command.code() >= 0 && command.code() <= 3 &&
         command.hasAny("XYZ");
}

/// Up first, then across, then down: the part stands in between.
std::string moveTo(const Point3& position, double clear_z, double feed_mm_min, int decimals) {
  std::string text = "G0 F";
  appendFixed(text, feed_mm_min, 0);
  const auto append = [&](char letter, double value) {
    text.push_back(letter);
    appendFixed(text, value, decimals);
  };
  text += " ";
  append('Z', std::max(clear_z, position.z()));
  text += "\nG0 ";
  append('X', position.x());
  text += " ";
  append('Y', position.y());
  text += "\n";
  if (position.z() < clear_z) {
    text += "G0 ";
    append('Z', position.z());
    text += "\n";
  }
  return text;
}

}  // namespace

std::string wholeLines(std::string code) {
  if (!code.empty() && code.back() != '\n') code += '\n';
  return code;
}

ClosingCode::ClosingCode(const RewriteSettings& settings, std::optional<double> clear_z, int decimals)
    : clear_z_(clear_z), end_code_(wholeLines(settings.end_code)) {
  if (!clear_z) return;
  lift_ = "G0 Z";
  appendFixed(lift_, *clear_z, decimals);
  lift_ += '\n';
  if (settings.final_position_mm)
    move_ = moveTo(*settings.final_position_mm, *clear_z, settings.final_feed_mm_min, decimals);
}

void ClosingCode::leavePartAt(double z) {
  if (clear_z_ && z >= *clear_z_) lift_.clear();
}

void ClosingCode::requireClear(const ProgramTracker& tracker) const {
  const PlacedWord* word = tracker.command().find('Z');
  if (!clear_z_ || word == nullptr || !word->has_value || tracker.isPositionRelative()) return;
  const double z = word->value * (tracker.isInInches() ? 25.4 : 1.0);
  if (z >= *clear_z_) return;
  throw InvalidProgram("line " + std::to_string(tracker.command().number()) + ": the end code goes to z " +
                       numberText(z) + " mm, and the part reaches " + numberText(*clear_z_) +
                       " mm; expected no less, or no such line and a final position instead");
}

void ClosingCode::beforeLine(const ProgramTracker& tracker, std::string& out) {
  if (isMotion(tracker.command())) {
    requireClear(tracker);
    if (!lift_.empty()) appendAbsolute(tracker, std::exchange(lift_, {}), out);
  }
  if (tracker.command().start() != LineStart::M) return;
  const int code = tracker.command().code();
  const bool ends_program = code == 2 || code == 30 || code == 81;
  if (ends_program || code == 84 || code == 18) appendMove(tracker, out);
  if (ends_program) appendEndCode(out);
}

void ClosingCode::atEnd(const ProgramTracker& tracker, std::string& out) {
  appendMove(tracker, out);
  appendEndCode(out);
}

void ClosingCode::appendMove(const ProgramTracker& tracker, std::string& out) {
  if (move_.empty()) return;
  appendAbsolute(tracker, std::exchange(move_, {}), out);
}

void ClosingCode::appendEndCode(std::string& out) {
  out += end_code_;
  end_code_.clear();
}

}  // namespace lamina
