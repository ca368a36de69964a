// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_rewrite/program_tracker.hpp"

#include <algorithm>
#include <iterator>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "program/gcode/arc.hpp"

namespace lamina {
namespace {

constexpr std::string_view kAxes = "XYZ";
/// Home offsets, babystepping, probe offset.
constexpr int kMoveOrigin[] = {206, 290, 428, 851};
/// Programs and macros of the machine's own.
constexpr int kRunOthers[] = {23, 24, 32, 98};
constexpr double kNoFilament = 1e-9;  // mm: what subtracting absolute E leaves of nothing

template <std::size_t count>
bool isOneOf(const int (&codes)[count], int code) {
  return std::find(std::begin(codes), std::end(codes), code) != std::end(codes);
}

bool allOf(const std::array<bool, 3>& known) { return known[0] && known[1] && known[2]; }

}  // namespace

bool TrackedMotion::deposits() const {
  return extrusion_mm > kNoFilament && (ends.size() > 1 || end() != start);
}

ProgramTracker::ProgramTracker(const RewriteSettings& settings)
    : annuls_homing_(settings.homing == Homing::Annulled),
      chord_tolerance_mm_(settings.chord_tolerance_mm),
      extrusion_(settings.initial_extrusion) {
  extrusion_.declare();
  readBeginCode(settings.begin_code);
}

void ProgramTracker::readBeginCode(std::string_view code) {
  for (std::size_t number = 1; !code.empty(); ++number) {
    const std::size_t length = std::min(code.find('\n'), code.size());
    try {
      read(code.substr(0, length), number);
    } catch (const InvalidProgram& error) {
      throw InvalidProgram(std::string("begin code, ") + error.what());
    }
    code.remove_prefix(std::min(length + 1, code.size()));
  }
  if (section_ != ProgramSection::Start)
    throw InvalidProgram("the begin code holds a comment that opens a layer; expected none");
}

void ProgramTracker::refuse(const std::string& what) const {
  throw InvalidProgram("line " + std::to_string(command_.number()) + ": " + what);
}

LineRole ProgramTracker::read(std::string_view line, std::size_t number) {
  mark_ = SectionMark::None;
  if (section_ != ProgramSection::End) return readCommand(command_.read(line, number));
  try {
    return readCommand(command_.read(line, number));
  } catch (const InvalidProgram&) {
    return LineRole::Copied;  // end code is not transformed: whatever the firmware takes may stand there
  }
}

LineRole ProgramTracker::readCommand(LineStart start) {
  if (!command_.comment().empty()) readMark();
  switch (start) {
    case LineStart::Blank:
      return LineRole::Blank;
    case LineStart::G:
      return readG();
    case LineStart::M:
      readM();
      return LineRole::Copied;
    case LineStart::Coordinate:
      if (section_ == ProgramSection::Part)
        refuse("coordinates without a command; expected G0 or G1 before them");
      return LineRole::Copied;
    default:
      return LineRole::Copied;
  }
}

void ProgramTracker::readMark() {
  mark_ = marks_.read(command_.comment());
  if (mark_ == SectionMark::None) return;
  is_custom_ = mark_ == SectionMark::Custom;
  const bool opens = mark_ == SectionMark::Layer || mark_ == SectionMark::PartStart;
  if (section_ != ProgramSection::Start || !opens) return;
  section_ = ProgramSection::Part;
  known_ = {};
}

LineRole ProgramTracker::readG() {
  switch (command_.code()) {
    case 0:
    case 1:
    case 2:
    case 3:
      return move();
    case 17:
    case 18:
    case 19:
      arc_axis_ = 19 - command_.code();  // G17 about z, G18 about y, G19 about x
      return LineRole::Copied;
    case 20:
    case 21:
      unit_mm_ = command_.code() == 20 ? 25.4 : 1.0;
      return LineRole::Copied;
    case 28:
      return home();
    case 90:
    case 91:
      is_relative_ = command_.code() == 91;
      extrusion_.positionMode(is_relative_ ? ExtrusionMode::Relative : ExtrusionMode::Absolute);
      return LineRole::Copied;
    case 92:
      setPosition();
      return LineRole::Copied;
    default:
      requireSupported();
      return LineRole::Copied;
  }
}

void ProgramTracker::requireSupported() const {
  const int code = command_.code();
  const bool retracts = code == 11 || (code == 10 && !command_.hasAny("LPRXYZ"));
  if (section_ != ProgramSection::Part || code == 4 || retracts) return;
  refuse(command_.quoted() +
         " within the part cannot be transformed; expected G0 to G4, G10, G11, G17 to G21, G90 or G92");
}

void ProgramTracker::readM() {
  const int code = command_.code();
  if (code == 82) extrusion_.state(ExtrusionMode::Absolute);
  if (code == 83) extrusion_.state(ExtrusionMode::Relative);
  if (section_ != ProgramSection::End && isOneOf(kMoveOrigin, code))
    refuse("M" + std::to_string(code) + " moves the origin; expected none before the end code");
  if (section_ == ProgramSection::Part && isOneOf(kRunOthers, code))
    refuse("M" + std::to_string(code) +
           " runs code of another file within the part, which is not transformed; expected none");
}

LineRole ProgramTracker::home() const {
  if (annuls_homing_) return LineRole::Homing;
  if (section_ == ProgramSection::Part) refuse("G28 within the part loses the nozzle's place; expected none");
  return LineRole::Copied;
}

void ProgramTracker::requireFixedOrigin() const {
  if (section_ == ProgramSection::End) return;
  const bool sets_all = !command_.hasAny("XYZE");
  if (sets_all || command_.hasAny("XYZ"))
    refuse("G92 moves the origin of X, Y or Z; the machine's limits would mean nothing. Expected G92 E only");
}

void ProgramTracker::setPosition() {
  requireFixedOrigin();
  const PlacedWord* word = command_.find('E');
  if (word == nullptr) return;
  if (!word->has_value) refuse("E has no value");
  filament_ = word->value * unit_mm_;
  is_filament_known_ = true;
}

double ProgramTracker::takeExtrusion() {
  const PlacedWord* word = command_.find('E');
  motion_.filament_from = filament_;
  if (word == nullptr) return 0.0;
  if (extrusion_.isDisputed()) {
    if (section_ == ProgramSection::Part)
      refuse(
          "whether E is relative depends on the firmware, for G90 or G91 stands after M82 or M83; expected "
          "M82 or M83 after it");
    is_filament_known_ = false;
    return 0.0;
  }
  const double value = word->value * unit_mm_;
  if (isExtrusionRelative()) {
    filament_ += value;
    return value;
  }
  if (!is_filament_known_ && section_ == ProgramSection::Part)
    refuse("E is absolute but unknown here; expected G92 E before the part");
  const double pushed = value - filament_;
  filament_ = value;
  is_filament_known_ = true;
  return pushed;
}

void ProgramTracker::requireKnownWords() const {
  const std::string_view known = command_.code() >= 2 ? "XYZEFIJKR" : "XYZEFS";
  for (const PlacedWord& word : command_) {
    if (!word.has_value) refuse(std::string(1, word.letter) + " has no value");
    if (section_ == ProgramSection::Part && known.find(word.letter) == std::string_view::npos)
      refuse(std::string("a motion with ") + word.letter + " cannot be transformed; expected " +
             std::string(known) + " only");
  }
}

LineRole ProgramTracker::move() {
  requireKnownWords();
  motion_.extrusion_mm = takeExtrusion();
  if (const PlacedWord* feed = command_.find('F')) feed_ = feed->value * unit_mm_;
  const bool is_arc = command_.code() >= 2;
  if (section_ != ProgramSection::Part) return LineRole::Copied;
  if (isInInches()) refuse("the part is in inches (G20); expected mm (G21)");
  if (!is_arc && !command_.hasAny(kAxes)) return LineRole::Filament;
  if (is_relative_) refuse("relative motion (G91) within the part; expected absolute coordinates (G90)");
  if (is_custom_)
    refuse("custom code moves the nozzle within the part; whose coordinates these are is unknown");

  const std::array<bool, 3> known_before = known_;
  moveTo(known_before);
  const bool is_known = allOf(known_);
  if (!is_known && (is_arc || motion_.extrusion_mm > kNoFilament))
    refuse("deposits, or follows an arc, before X, Y and Z are all reported within the part");
  if (!is_known) return LineRole::Deferred;
  if (!motion_.is_start_known && (is_arc || motion_.extrusion_mm > kNoFilament))
    refuse("deposits, or follows an arc, from a place not reported within the part");
  if (motion_.deposits() && !marks_.unknownType().empty())
    refuse("';TYPE:" + marks_.unknownType() +
           "' is not known, and so whether this is of the part or supports it; expected a name of Cura, "
           "PrusaSlicer or OrcaSlicer");
  return LineRole::Motion;
}

void ProgramTracker::moveTo(const std::array<bool, 3>& known_before) {
  motion_.start = position_;
  motion_.is_start_known = allOf(known_before);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const PlacedWord* word = command_.find(kAxes[axis]);
    if (word == nullptr) continue;
    position_[static_cast<Eigen::Index>(axis)] = word->value;
    known_[axis] = true;
  }
  motion_.ends.clear();
  if (command_.code() >= 2 && motion_.is_start_known)
    addArc();
  else
    motion_.ends.push_back(position_);
}

void ProgramTracker::addArc() {
  Arc arc{motion_.start, position_, motion_.start, arc_axis_,
          command_.code() == 3 ? ArcDirection::CounterClockwise : ArcDirection::Clockwise};
  if (const PlacedWord* radius = command_.find('R')) {
    if (command_.hasAny("IJK")) refuse("an arc has either R or I J K");
    try {
      arc.centre = centreOfRadius(arc, radius->value);
    } catch (const InvalidInput& error) {
      refuse(error.what());
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (const PlacedWord* offset = command_.find("IJK"[axis]))
      arc.centre[static_cast<Eigen::Index>(axis)] += offset->value;
  Point3 from = arc.start - arc.centre;
  Point3 to = arc.end - arc.centre;
  from[arc.axis] = to[arc.axis] = 0.0;
  if (from.norm() < 1e-6) refuse("an arc without centre: its centre is where it starts");
  const double off_mm = std::abs(from.norm() - to.norm());
  if (off_mm > std::max(0.05, 0.001 * from.norm()))
    refuse("the arc ends " + numberText(off_mm) + " mm off its circle");
  motion_.ends = flatten(arc, chord_tolerance_mm_);
}

}  // namespace lamina
