// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_rewrite/listing_rewriter.hpp"

#include "gcode_rewrite/motion_text.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

bool beginsWithMotion(std::string_view line) {
  return line.substr(0, 2) == "G0" || line.substr(0, 2) == "G1";
}

const PlacedWord* firstOf(const GcodeBlock& command, std::string_view letters) {
  for (const char letter : letters)
    if (const PlacedWord* word = command.find(letter)) return word;
  return nullptr;
}

}  // namespace

void ListingTracker::refuse(const std::string& what) const {
  throw InvalidProgram("line " + std::to_string(command_.number()) + ": " + what);
}

bool ListingTracker::read(std::string_view line, std::size_t number) {
  line = trimmed(line);
  mark_ = SectionMark::None;
  const LineStart start = command_.read(line, number);
  if (!command_.comment().empty()) mark_ = marks_.read(command_.comment());
  if (mark_ == SectionMark::Layer) has_part_ = true;
  const int code = command_.code();
  if (start == LineStart::G && (code == 90 || code == 91)) is_relative_ = code == 91;
  if (start == LineStart::G && (code == 20 || code == 21)) is_in_inches_ = code == 20;
  if (!has_part_) return false;
  requireTransformable();
  if (!beginsWithMotion(line)) return false;
  for (const char letter : {'X', 'Y', 'Z'})
    if (const PlacedWord* word = command_.find(letter)) point_[letter - 'X'] = word->value;
  return true;
}

void ListingTracker::requireTransformable() const {
  if (command_.start() == LineStart::Coordinate) refuse("coordinates without a command; expected G0 or G1");
  if (command_.start() != LineStart::G || command_.code() > 3) return;
  if (command_.code() < 0 || command_.code() > 1)
    refuse("only G0 and G1 are transformed; expected no arcs (G2, G3)");
  if (!beginsWithMotion(command_.text())) refuse("expected the line to begin with G0 or G1");
  const PlacedWord* previous = nullptr;
  for (const char letter : {'X', 'Y', 'Z'}) {
    const PlacedWord* word = command_.find(letter);
    if (word == nullptr) continue;
    if (!word->has_value) refuse(std::string(1, letter) + " has no value");
    const bool follows = previous == nullptr || word == previous + 1;
    if (!follows)
      refuse("X, Y and Z must come one after the other in this order, else words would be doubled");
    previous = word;
  }
  if (previous == nullptr) return;
  if (is_relative_) refuse("relative motion (G91); expected absolute coordinates (G90)");
  if (is_in_inches_) refuse("the part is in inches (G20); expected mm (G21)");
}

void ListingSurveyor::read(std::string_view line, std::size_t number) {
  survey_.lines = number;
  const bool has_point = tracker_.read(line, number);
  if (tracker_.mark() == SectionMark::Layer) ++survey_.totals.layers;
  if (!has_point) return;
  ++survey_.totals.motions;
  const Point3 mapped = transform_.map.map(tracker_.point());
  survey_.totals.part.include(mapped, number);
  survey_.totals.nozzle.include(mapped, number);
}

Survey ListingSurveyor::finish() {
  if (!tracker_.hasPart())
    throw InvalidProgram("no comment opens a layer in " + std::to_string(survey_.lines) + " lines");
  if (survey_.totals.motions == 0) throw InvalidProgram("no motion follows the first layer's comment");
  survey_.totals.depositions = 0;
  survey_.slicer = tracker_.marks().slicer();
  survey_.layer_height_mm = tracker_.marks().layerHeight();
  return std::move(survey_);
}

void ListingRewriter::read(std::string_view line, std::size_t number, std::string& out) {
  line = trimmed(line);
  if (line.empty()) return;
  const bool has_point = tracker_.read(line, number);
  if (line.substr(0, 4) == "G28 ") {
    ++homings_annulled_;
    out += ";Anulada: ";
  }
  const GcodeBlock& command = tracker_.command();
  const PlacedWord* first = has_point ? firstOf(command, "XYZ") : nullptr;
  if (first == nullptr) {
    out.append(line).push_back('\n');
    return;
  }
  const PlacedWord* last = firstOf(command, "ZYX");
  const Point3 mapped = transform_.coordinates(transform_.overBed(tracker_.point()));
  out.append(trimmed(line.substr(0, first->begin))).push_back(' ');
  appendCoordinates(out, mapped, decimals_);
  out.append(" ").append(trimmed(line.substr(last->end))).push_back('\n');
}

}  // namespace lamina
