// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/resume/remaining_program.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/decimals.hpp"
#include "lamina/base/error.hpp"
#include "streaming/resume/program_state.hpp"

namespace lamina {
namespace {

std::string shortNumber(double value) { return trimmedDecimals(value, 4); }

std::string word(char letter, double value) { return std::string(" ") + letter + shortNumber(value); }

Point3 axisOf(const ResumeSettings& settings) {
  const Point3 axis(settings.tool_axis.at(0), settings.tool_axis.at(1), settings.tool_axis.at(2));
  constexpr double kLeastRise = 0.1;  // of its length: flatter, the approach would come from the side
  if (!(axis.norm() > 0.0) || axis.normalized().z() < kLeastRise)
    throw InvalidConfig("resume.tool_axis does not rise from the bed; expected three numbers such as 0,0,1");
  return axis.normalized();
}

/// The height at which the nozzle passes over all that was deposited.
double safeHeight(const ProgramState& state, double clearance_mm) {
  const double top = state.has_deposited ? state.highest.z() : state.position.z();
  return std::max(top, state.position.z()) + clearance_mm;
}

void requireClear(const ProgramState& state, double nozzle_machine_mm, double safe_mm,
                  const ResumeSettings& settings) {
  if (nozzle_machine_mm < safe_mm)
    throw InvalidInput("the nozzle stands at z = " + shortNumber(nozzle_machine_mm - state.shift.z()) +
                       " mm; raise it to at least " + shortNumber(safe_mm - state.shift.z()) +
                       " mm, so that x and y can be homed above the part");
  if (!state.has_deposited) return;
  const double x = settings.purge_at_mm.at(0);
  const double y = settings.purge_at_mm.at(1);
  const double off =
      std::max({state.lowest.x() - x, x - state.highest.x(), state.lowest.y() - y, y - state.highest.y()});
  if (off < settings.clearance_mm)
    throw InvalidInput("resume.purge_at_mm is " + shortNumber(x) + "," + shortNumber(y) +
                       "; expected a place at least " + shortNumber(settings.clearance_mm) +
                       " mm beside the part, which reaches from " + shortNumber(state.lowest.x()) + "," +
                       shortNumber(state.lowest.y()) + " to " + shortNumber(state.highest.x()) + "," +
                       shortNumber(state.highest.y()));
}

/// Bed, height, x and y, nozzles: nothing touches the part yet.
std::string preparation(const ProgramState& state, double nozzle_height_mm) {
  std::string text = "G21\nG90\nM83\n";
  if (state.bed_c) text += "M140" + word('S', *state.bed_c) + "\nM190" + word('S', *state.bed_c) + "\n";
  if (state.chamber_c) text += "M141" + word('S', *state.chamber_c) + "\n";
  text += "G92" + word('Z', nozzle_height_mm) + "\nG28 X Y\n";
  for (const auto& [tool, target] : state.nozzle_c)
    if (tool != state.tool) text += "M104 T" + std::to_string(tool) + word('S', target) + "\n";
  if (state.tool != 0 || state.nozzle_c.size() > 1) text += "T" + std::to_string(state.tool) + "\n";
  const auto target = state.nozzle_c.find(state.tool);
  if (target != state.nozzle_c.end()) text += "M109" + word('S', target->second) + "\n";
  if (!state.workplace.empty()) text += state.workplace + "\n";
  for (const auto& setting : state.remembered) text += setting.second + "\n";
  if (state.plane != 17) text += "G" + std::to_string(state.plane) + "\n";
  return text;
}

std::string purgeAndApproach(const ProgramState& state, double safe_mm, const ResumeSettings& settings) {
  constexpr double kPi = 3.14159265358979323846;
  constexpr double kApproachFactor = 0.2;
  const double area = kPi / 4.0 * settings.filament_diameter_mm * settings.filament_diameter_mm;
  const Point3 axis = axisOf(settings);
  const Point3& to = state.position;
  const Point3 above = to + axis * ((safe_mm - to.z()) / axis.z());
  const std::string travel = word('F', 60.0 * settings.travel_feed_mm_s) + "\n";
  const std::string push = word('F', 60.0 * settings.purge_feed_mm_s) + "\n";
  std::string text = "G1" + word('Z', safe_mm) + travel;
  text += "G1" + word('X', settings.purge_at_mm.at(0)) + word('Y', settings.purge_at_mm.at(1)) + travel;
  if (settings.purge_mm3 > 0.0) text += "G1" + word('E', settings.purge_mm3 / area) + push;
  text += "G1" + word('E', -settings.retraction_mm) + push;
  text += "G1" + word('X', above.x()) + word('Y', above.y()) + travel;
  text += "G1" + word('X', to.x()) + word('Y', to.y()) + word('Z', to.z()) +
          word('F', 60.0 * kApproachFactor * settings.travel_feed_mm_s) + "\n";
  const double prime = settings.retraction_mm - state.retracted_mm;
  if (prime != 0.0) text += "G1" + word('E', prime) + push;
  if (state.is_firmware_retracted) text += "G10\n";
  return text;
}

/// What the program counts by, last, since all that is added counts in millimetres of the machine.
std::string modes(const ProgramState& state) {
  std::string text = "G92";
  for (int axis = 0; axis < 3; ++axis)
    if (state.shift[axis] != 0.0) text += word("XYZ"[axis], state.position[axis] - state.shift[axis]);
  text += word('E', state.filament_mm) + "\n";
  if (state.unit_mm != 1.0) text += "G20\n";
  text += state.is_relative ? "G91\n" : "G90\n";
  text += state.is_filament_relative ? "M83\n" : "M82\n";
  text += (state.is_rapid ? "G0" : "G1") + word('F', state.feed_mm_min / state.unit_mm) + "\n";
  return text;
}

RemainingProgramNotes notesOf(const ProgramState& state, double nozzle_height_mm) {
  RemainingProgramNotes notes;
  notes.to_check = {"the part still holds on the bed, and nothing stands in the way of homing x and y",
                    "the nozzle is free of the part and stands at z = " + shortNumber(nozzle_height_mm) +
                        " mm when this begins",
                    "the last bead ends where the first line begins, at x, y, z = " +
                        shortNumber(state.position.x() - state.shift.x()) + ", " +
                        shortNumber(state.position.y() - state.shift.y()) + ", " +
                        shortNumber(state.position.z() - state.shift.z()) + " mm",
                    "homing x and y comes to the same place as before, to a tenth of a millimetre"};
  if (!state.bed_c) notes.to_check.emplace_back("the bed is as hot as it was: the program does not say");
  if (state.nozzle_c.count(state.tool) == 0)
    notes.to_check.emplace_back("the nozzle is hot: the program does not say how hot");
  std::set<std::string> seen;
  for (const std::string& command : state.not_reproduced)
    if (seen.insert(command.substr(0, command.find(' '))).second)
      notes.to_check.push_back("what \"" + command + "\" did before is still so: it is not repeated");
  return notes;
}

/// Writes the lines that are left, the first ones at half speed.
void writeLines(ProgramCursor& cursor, ProgramState& state, double ramp_mm, const TextSink& sink) {
  const double start = state.deposited_length_mm;
  const double speed = state.speed_percent;
  const std::string full_speed = "M220" + word('S', speed) + "\n";
  bool is_slow = ramp_mm > 0.0;
  if (is_slow) sink("M220" + word('S', 0.5 * speed) + "\n");
  if (!is_slow && speed != 100.0) sink(full_speed);
  while (const auto line = cursor.next()) {
    sink(line->command + "\n");
    if (!is_slow) continue;
    state.run(line->command);
    const bool sets_speed = line->command.compare(0, 4, "M220") == 0;
    if (!sets_speed && state.deposited_length_mm - start < ramp_mm) continue;
    is_slow = false;
    if (!sets_speed) sink(full_speed);
  }
  if (is_slow) sink(full_speed);
}

}  // namespace

void describe(SettingsSchema& schema, ResumeSettings& settings) {
  schema.number("resume.purge_mm3", settings.purge_mm3, {0.0, 10000.0},
                "Volume of material that is purged beside the part.");
  schema.numbers("resume.purge_at_mm", settings.purge_at_mm, 2, "Where it is purged, x and y.");
  schema.number("resume.clearance_mm", settings.clearance_mm, Bounds::above(0.0, 1000.0),
                "Distance from all that was deposited, until the approach.");
  schema.numbers("resume.tool_axis", settings.tool_axis, 3,
                 "Direction from the nozzle's tip into the tool, along which it approaches.");
  schema.number("resume.ramp_mm", settings.ramp_mm, {0.0, 1000.0},
                "Length that is deposited at half speed at least, in whole lines.");
  schema.number("resume.filament_diameter_mm", settings.filament_diameter_mm, Bounds::above(0.0, 20.0),
                "Diameter of the filament, for the purge.");
  schema.number("resume.retraction_mm", settings.retraction_mm, {0.0, 50.0},
                "Filament that is pulled back between purge and part.");
  schema.number("resume.travel_feed_mm_s", settings.travel_feed_mm_s, Bounds::above(0.0, 1000.0),
                "Speed of the motions that are added.");
  schema.number("resume.purge_feed_mm_s", settings.purge_feed_mm_s, Bounds::above(0.0, 100.0),
                "Speed of the filament while it is purged.");
}

std::uint64_t firstLineOfLayer(const StreamableProgram& program, std::int32_t layer) {
  ProgramCursor cursor = program.open();
  std::uint64_t number = 0;
  while (const auto line = cursor.next()) {
    ++number;
    if (line->layer == layer) return number;
  }
  throw InvalidInput(program.name() + " has no line in layer " + std::to_string(layer) +
                     "; expected a layer that its comments report");
}

std::uint64_t firstLineAtHeight(const StreamableProgram& program, double height_mm) {
  constexpr double kRounding = 1e-6;  // mm
  ProgramCursor cursor = program.open();
  ProgramState state;
  std::uint64_t number = 0;
  double deposited = 0.0;
  while (const auto line = cursor.next()) {
    ++number;
    state.run(line->command);
    const bool has_deposited = state.deposited_length_mm > deposited;
    deposited = state.deposited_length_mm;
    if (has_deposited && state.position.z() - state.shift.z() >= height_mm - kRounding) return number;
  }
  throw InvalidInput(program.name() + " deposits nothing at z = " + shortNumber(height_mm) + " mm or above");
}

RemainingProgramNotes writeRemaining(const StreamableProgram& program, std::uint64_t from_line,
                                     double nozzle_height_mm, const ResumeSettings& settings,
                                     const TextSink& sink) {
  if (from_line < 1 || from_line > program.lines())
    throw InvalidInput("the line to go on from is " + std::to_string(from_line) + "; expected 1 to " +
                       std::to_string(program.lines()));
  ProgramCursor cursor = program.open();
  ProgramState state;
  for (std::uint64_t line = 1; line < from_line; ++line)
    if (const auto passed = cursor.next()) state.run(passed->command);
  const double safe_mm = safeHeight(state, settings.clearance_mm);
  requireClear(state, nozzle_height_mm + state.shift.z(), safe_mm, settings);
  const std::string begin = preparation(state, nozzle_height_mm + state.shift.z()) +
                            purgeAndApproach(state, safe_mm, settings) + modes(state);
  RemainingProgramNotes notes = notesOf(state, nozzle_height_mm);
  sink("; The rest of " + program.name() + ", from line " + std::to_string(from_line) + " of " +
       std::to_string(program.lines()) + ".\n; Run it only if:\n");
  for (const std::string& note : notes.to_check) sink("; - " + note + "\n");
  sink(begin);
  sink("; from here on the lines of the program, the first at half speed\n");
  writeLines(cursor, state, settings.ramp_mm, sink);
  return notes;
}

}  // namespace lamina
