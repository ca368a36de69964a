// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/gcode/gcode_interpreter.hpp"

#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "program/gcode/arc.hpp"

namespace lamina {
namespace {

constexpr std::array<char, 3> kAxes = {'X', 'Y', 'Z'};
constexpr double kLargestCoordinate = 1e7;  // mm: 10 km
constexpr double kOffCircle = 0.05;         // mm, and
constexpr double kOffCirclePart = 0.001;    // of the radius: what rounding and arc fitting leave

}  // namespace

WordTable::WordTable(const GcodeLine& line) : line_(line.number) {
  for (const GcodeWord& word : line.words) {
    const unsigned bit = 1U << (word.letter - 'A');
    if (word.letter != 'G' && word.letter != 'M' && (present_ & bit) != 0)
      throw InvalidProgram("line " + std::to_string(line_) + ": " + word.letter + " stands twice");
    present_ |= bit;
    if (!word.value) continue;
    valued_ |= bit;
    values_[static_cast<std::size_t>(word.letter - 'A')] = *word.value;
  }
}

bool WordTable::hasAny(std::string_view letters) const {
  for (const char letter : letters)
    if (has(letter)) return true;
  return false;
}

double WordTable::value(char letter) const {
  if ((valued_ >> (letter - 'A') & 1U) == 0)
    throw InvalidProgram("line " + std::to_string(line_) + ": " + letter + " has no value");
  return values_[static_cast<std::size_t>(letter - 'A')];
}

GcodeInterpreter::GcodeInterpreter(GcodeReaderSettings settings, GcodeHandlers handlers)
    : settings_(settings), handlers_(std::move(handlers)), feed_mm_s_(settings.initial_feed_mm_s) {}

void GcodeInterpreter::refuse(const std::string& what) const {
  throw InvalidProgram("line " + std::to_string(line_) + ": " + what);
}

void GcodeInterpreter::readLine(std::string_view text, std::size_t number) {
  line_ = number;
  const GcodeLine& line = parser_.parse(text, number);
  for (const std::string_view comment : line.comments) {
    readComment(comment, context_);
    // FullControl counts filament motion by motion.
    if (comment == kStartCodeEnds && !is_filament_mode_stated_) filament_mode_ = Mode::Relative;
    if (handlers_.comment) handlers_.comment(comment);
  }
  if (line.is_other && handlers_.other) handlers_.other(number, line.command);
  if (line.words.empty()) return;
  const WordTable words(line);
  if (words.hasAny("ABCUVW")) refuse("rotary and secondary axes (A B C U V W) are not supported");
  int command = -1;
  for (const GcodeWord& word : line.words) {
    if (word.letter != 'G' && word.letter != 'M') continue;
    if (!word.value) refuse(std::string(1, word.letter) + " has no number");
    if (setMode(word)) continue;
    if (word.letter == 'M') refuse("M" + numberText(*word.value) + " cannot share a line with motions");
    if (command != -1) refuse("two commands that use the same words");
    command = static_cast<int>(*word.value);
    if (command != *word.value) refuse("G" + numberText(*word.value) + " is not supported");
  }
  if (words.has('F')) {
    const double feed_mm_s = words.value('F') * unit_mm_ / 60.0;
    if (!(feed_mm_s > 0.0)) refuse("feed is " + numberText(words.value('F')) + "; must be positive");
    feed_mm_s_ = feed_mm_s;
  }
  if (command == -1 && words.hasAny("XYZEIJKR")) {
    if (motion_ == -1) refuse("coordinates before any motion command");
    command = motion_;
  }
  if (command != -1) run(command, words);
}

bool GcodeInterpreter::setMode(const GcodeWord& word) {
  const double code = *word.value;
  if (word.letter == 'M') {
    if (code != 82.0 && code != 83.0) return false;
    filament_mode_ = code == 82.0 ? Mode::Absolute : Mode::Relative;
    is_filament_mode_stated_ = true;
    return true;
  }
  if (code >= 17.0 && code <= 19.0 && code == std::floor(code)) {
    arc_axis_ = 19 - static_cast<int>(code);  // G17 about z, G18 about y, G19 about x
  } else if (code == 20.0 || code == 21.0) {
    unit_mm_ = code == 20.0 ? 25.4 : 1.0;
  } else if (code == 90.0 || code == 91.0) {
    position_mode_ = code == 90.0 ? Mode::Absolute : Mode::Relative;
    filament_mode_ = position_mode_;
  } else {
    return false;
  }
  return true;
}

void GcodeInterpreter::run(int command, const WordTable& words) {
  switch (command) {
    case 0:
    case 1:
    case 2:
    case 3:
      return move(command, words);
    case 4:
      return dwell(words);
    case 28:
      return home(words);
    case 92:
      return setPosition(words);
    default:
      refuse("G" + std::to_string(command) + " is not supported");
  }
}

void GcodeInterpreter::move(int command, const WordTable& words) {
  motion_ = command;
  const Point3 target = targetOf(words);
  const double extrusion_mm = extrusionOf(words);
  if (!(target.cwiseAbs().maxCoeff() <= kLargestCoordinate && std::abs(extrusion_mm) <= kLargestCoordinate))
    refuse("the motion goes further than 10 km");
  if (command < 2)
    moveStraight(target, extrusion_mm);
  else
    moveAlongArc(command, target, extrusion_mm, words);
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis)
    is_stated_[axis] |= position_mode_ == Mode::Absolute && words.has(kAxes[axis]);
}

void GcodeInterpreter::moveStraight(const Point3& target, double extrusion_mm) {
  if (target != position_ || extrusion_mm != 0.0) emit(target, extrusion_mm);
}

void GcodeInterpreter::moveAlongArc(int command, const Point3& target, double extrusion_mm,
                                    const WordTable& words) {
  if (words.has('P')) refuse("arcs of several turns (P) are not supported");
  Arc arc{position_, target, centreOf(command, target, words), arc_axis_,
          command == 3 ? ArcDirection::CounterClockwise : ArcDirection::Clockwise};
  Point3 from = arc.start - arc.centre;
  Point3 to = arc.end - arc.centre;
  from[arc.axis] = to[arc.axis] = 0.0;
  if (from.norm() < 1e-6) refuse("arc without centre: the centre is where it starts");
  const double off_mm = std::abs(from.norm() - to.norm());
  if (off_mm > kOffCircle && off_mm > kOffCirclePart * from.norm())
    refuse("the arc ends " + numberText(off_mm) + " mm off its circle");
  const std::vector<Point3> ends = flatten(arc, settings_.chord_tolerance_mm);
  for (const Point3& end : ends) emit(end, extrusion_mm / static_cast<double>(ends.size()));
}

Point3 GcodeInterpreter::centreOf(int command, const Point3& target, const WordTable& words) const {
  constexpr std::array<std::string_view, 3> kOffsets = {"JK", "IK", "IJ"};
  const std::string_view offsets = kOffsets[static_cast<std::size_t>(arc_axis_)];
  if (words.has('R')) {
    if (words.hasAny("IJK")) refuse("an arc has either R or I J K");
    const Arc arc{position_,
                  target,
                  {},
                  arc_axis_,
                  command == 3 ? ArcDirection::CounterClockwise : ArcDirection::Clockwise};
    try {
      return centreOfRadius(arc, words.value('R') * unit_mm_);
    } catch (const InvalidInput& error) {
      refuse(error.what());
    }
  }
  if (!words.hasAny(offsets)) refuse("arc without centre: neither R nor " + std::string(offsets));
  return position_ +
         unit_mm_ * Point3(words.valueOr('I', 0.0), words.valueOr('J', 0.0), words.valueOr('K', 0.0));
}

Point3 GcodeInterpreter::targetOf(const WordTable& words) const {
  Point3 target = position_;
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = kAxes[static_cast<std::size_t>(axis)];
    if (!words.has(letter)) continue;
    const double origin = position_mode_ == Mode::Absolute ? machine_from_program_[axis] : position_[axis];
    target[axis] = origin + words.value(letter) * unit_mm_;
  }
  return target;
}

double GcodeInterpreter::extrusionOf(const WordTable& words) {
  if (!words.has('E')) return 0.0;
  const double stated_mm = words.value('E') * unit_mm_;
  const double extrusion_mm = filament_mode_ == Mode::Absolute ? stated_mm - filament_mm_ : stated_mm;
  filament_mm_ += extrusion_mm;
  return extrusion_mm;
}

void GcodeInterpreter::setPosition(const WordTable& words) {
  const bool sets_all = !words.hasAny("XYZE");
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = kAxes[static_cast<std::size_t>(axis)];
    if (!sets_all && !words.has(letter)) continue;
    machine_from_program_[axis] = position_[axis] - words.valueOr(letter, 0.0) * unit_mm_;
    is_stated_[static_cast<std::size_t>(axis)] = true;
  }
  if (sets_all || words.has('E')) filament_mm_ = words.valueOr('E', 0.0) * unit_mm_;
}

void GcodeInterpreter::home(const WordTable& words) {
  const bool homes_all = !words.hasAny("XYZ");
  for (int axis = 0; axis < 3; ++axis) {
    if (!homes_all && !words.has(kAxes[static_cast<std::size_t>(axis)])) continue;
    position_[axis] = 0.0;
    machine_from_program_[axis] = 0.0;
    is_stated_[static_cast<std::size_t>(axis)] = true;
  }
  if (handlers_.other) handlers_.other(line_, "G28");
}

void GcodeInterpreter::dwell(const WordTable& words) const {
  const double seconds = words.has('S') ? words.value('S') : words.valueOr('P', 0.0) / 1000.0;
  if (seconds < 0.0) refuse("dwell of " + numberText(seconds) + " s");
  if (handlers_.dwell) handlers_.dwell(line_, seconds);
}

void GcodeInterpreter::emit(const Point3& end, double extrusion_mm) {
  if (handlers_.motion) {
    GcodeMotion motion = motionIn(context_);
    motion.start = position_;
    motion.end = end;
    motion.extrusion_mm = extrusion_mm;
    motion.feed_mm_s = feed_mm_s_;
    motion.line = line_;
    for (int axis = 0; axis < 3; ++axis)
      motion.is_start_stated &= is_stated_[static_cast<std::size_t>(axis)] || end[axis] == position_[axis];
    handlers_.motion(motion);
  }
  position_ = end;
}

}  // namespace lamina
