// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_rewrite/survey.hpp"

#include <algorithm>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kHighestLayer = 100.0;  // mm

}  // namespace

void Extremes::include(const Point3& point, std::size_t line) {
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto index = static_cast<std::size_t>(axis);
    if (point[axis] < box.low[axis]) {
      box.low[axis] = point[axis];
      low_line[index] = line;
    }
    if (point[axis] > box.high[axis]) {
      box.high[axis] = point[axis];
      high_line[index] = line;
    }
  }
}

Surveyor::Surveyor(const PointTransform& transform, const RewriteSettings& settings)
    : transform_(transform),
      build_aids_(settings.build_aids),
      chord_tolerance_mm_(settings.chord_tolerance_mm),
      tracker_(settings) {}

void Surveyor::read(std::string_view line, std::size_t number) {
  survey_.lines = number;
  LineRole role = LineRole::Copied;
  try {
    role = tracker_.read(line, number);
  } catch (const InvalidProgram& error) {
    if (survey_.end_line == 0) throw;
    if (!refusal_) refusal_ = error.what();
  }
  if (tracker_.command().start() == LineStart::Comment) readFrame(number);
  if (tracker_.section() != ProgramSection::Part) return;
  if (tracker_.mark() != SectionMark::None) readMark(number);
  if (role == LineRole::Motion) addMotion(number);
}

void Surveyor::readFrame(std::size_t number) {
  const auto refuse = [number](const std::string& what) {
    throw InvalidProgram("line " + std::to_string(number) + ": " + what);
  };
  try {
    readFrameComment(tracker_.command().comment(), survey_.frame);
  } catch (const InvalidProgram& error) {
    refuse(error.what());
  }
  if (survey_.frame.bed_from_program.matrix() != Eigen::Matrix4d::Identity())
    refuse("the program speaks values of axes that stand askew; expected coordinates of the bed");
}

void Surveyor::readMark(std::size_t number) {
  const SectionMark mark = tracker_.mark();
  const bool goes_on = mark == SectionMark::Layer || mark == SectionMark::Type;
  if (goes_on && refusal_) throw InvalidProgram(*refusal_);
  if (goes_on) survey_.end_line = 0;
  if (mark == SectionMark::Layer) ++live_.layers;
  const bool may_end = mark == SectionMark::Custom || mark == SectionMark::PartEnd;
  if (!may_end || survey_.end_line != 0) return;
  survey_.end_line = number;
  survey_.totals = live_;
}

void Surveyor::addMotion(std::size_t number) {
  const TrackedMotion& motion = tracker_.motion();
  ++live_.motions;
  if (motion.ends.size() > 1) ++live_.arcs;
  if (tracker_.command().find('E') != nullptr) ++(motion.deposits() ? live_.pushing : live_.not_pushing);
  if (transform_.keepsLines() || !motion.is_start_known)
    addPoints(motion.ends, number);
  else
    addPoints(divided(motion.start, motion.ends, transform_, chord_tolerance_mm_), number);
}

void Surveyor::addPoints(const std::vector<Point3>& ends, std::size_t number) {
  const TrackedMotion& motion = tracker_.motion();
  const bool deposits = motion.deposits();
  const bool is_aid = deposits && tracker_.marks().isBuildAid();
  Extremes& deposited = is_aid ? live_.aids : live_.part;
  if (deposits) {
    live_.last_deposition = number;
    live_.motion_after_deposition = 0;
    live_.depositions += is_aid ? 0 : 1;
    const Point3 start = transform_.map.map(motion.start);
    deposited.include(start, number);
    if (!is_aid) addToFirstLayer(start);
  } else if (live_.motion_after_deposition == 0) {
    live_.motion_after_deposition = number;
  }
  for (const Point3& end : ends) {
    const Point3 mapped = transform_.map.map(end);
    if (!(is_aid && build_aids_ == BuildAids::Dropped)) live_.nozzle.include(mapped, number);
    if (deposits) deposited.include(mapped, number);
    if (deposits && !is_aid) addToFirstLayer(mapped);
  }
}

void Surveyor::addToFirstLayer(const Point3& mapped) {
  if (live_.first_layer == 0) live_.first_layer = live_.layers;
  if (live_.layers != live_.first_layer) return;
  live_.first_layer_low_mm = std::min(live_.first_layer_low_mm, mapped.z());
}

Survey Surveyor::finish() {
  const auto refuse = [](std::size_t line, const std::string& what) {
    throw InvalidProgram("line " + std::to_string(line) + ": " + what);
  };
  if (tracker_.section() == ProgramSection::Start)
    throw InvalidProgram(
        "no comment opens a layer in " + std::to_string(survey_.lines) +
        " lines; expected those of Cura, PrusaSlicer, Simplify3D, Slic3r (verbose) or Lamina");
  if (survey_.end_line == 0) survey_.totals = live_;
  const SurveyTotals& totals = survey_.totals;
  if (totals.pushing + totals.not_pushing > 0 && !tracker_.isExtrusionStated() &&
      totals.not_pushing >= totals.pushing)
    throw InvalidProgram(
        "E does not grow along " + std::to_string(totals.not_pushing) + " of " +
        std::to_string(totals.pushing + totals.not_pushing) +
        " motions that hold it, and neither M82 nor M83 says whether it is absolute; expected "
        "one of them in the program, or the mode to be given");
  if (totals.depositions == 0)
    throw InvalidProgram("no motion of the part deposits; expected motions with E within layers");
  if (survey_.end_line == 0 && totals.motion_after_deposition != 0)
    refuse(
        totals.motion_after_deposition,
        "moves after the last deposition, and no comment reports whether this is of the part or of the end "
        "code; expected '; end of the part' where the part ends");
  survey_.slicer = tracker_.marks().slicer();
  survey_.layer_height_mm = tracker_.marks().layerHeight();
  if (survey_.layer_height_mm.value_or(0.0) > kHighestLayer)
    throw InvalidProgram("the comments report layers of " + numberText(*survey_.layer_height_mm) +
                         " mm; expected at most " + numberText(kHighestLayer) + " mm");
  return std::move(survey_);
}

}  // namespace lamina
