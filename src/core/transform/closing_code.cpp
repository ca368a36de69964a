// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "transform/closing_code.hpp"

#include <algorithm>

#include "transform/decimal_number.hpp"

namespace lamina {
namespace {

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

ClosingCode::ClosingCode(const TransformSettings& settings, double clear_z, int decimals)
    : end_code_(wholeLines(settings.end_code)) {
  if (settings.final_position_mm)
    move_ = moveTo(*settings.final_position_mm, clear_z, settings.final_feed_mm_min, decimals);
}

void ClosingCode::beforeLine(const ProgramTracker& tracker, std::string& out) {
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
  if (tracker.isInInches()) out += "G21\n";
  if (tracker.isPositionRelative()) out += "G90\n";
  out += move_;
  move_.clear();
  if (tracker.isInInches()) out += "G20\n";
  if (!tracker.isPositionRelative()) return;
  // Marlin takes G90 and G91 for E too.
  out += tracker.isExtrusionRelative() ? "G91\nM83\n" : "G91\nM82\n";
}

void ClosingCode::appendEndCode(std::string& out) {
  out += end_code_;
  end_code_.clear();
}

}  // namespace lamina
