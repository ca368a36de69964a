// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_rewrite/program_rewriter.hpp"

#include <cmath>

#include "gcode_rewrite/decimal_number.hpp"
#include "gcode_rewrite/frame_transform.hpp"
#include "gcode_rewrite/motion_text.hpp"

namespace lamina {
namespace {

constexpr double kNoLength = 1e-9;  // mm

/// Length after over length before; 1 where there is none.
double ratio(double after, double before) { return before > kNoLength ? after / before : 1.0; }

constexpr double kBelowBed = -1e-6;  // mm

std::optional<double> clearHeight(const Survey& survey, const PointTransform& transform) {
  if (transform.axes != nullptr) return std::nullopt;
  return survey.totals.nozzle.box.high.z() + transform.shift.z();
}

double pathLength(const Point3& start, const std::vector<Point3>& ends) {
  double length = 0.0;
  const Point3* from = &start;
  for (const Point3& end : ends) {
    length += (end - *from).norm();
    from = &end;
  }
  return length;
}

/// A layer above the lowest deposition.
double footprintTop(const Survey& survey, const PointTransform& transform, const RewriteSettings& settings) {
  constexpr double kRounding = 1e-6;  // mm
  const auto height = settings.layer_height_mm ? settings.layer_height_mm : survey.layer_height_mm;
  return survey.totals.part.box.low.z() + transform.shift.z() + height.value_or(0.0) + kRounding;
}

}  // namespace

double FilamentWords::extrusion(const ProgramTracker& tracker, double pushed, const Point3& from,
                                const Point3& to) {
  double factor = 1.0;
  if (rule_ == ExtrusionRule::ByVolume)
    factor = transform_.map.volumeRatio(0.5 * (from + to));
  else if (rule_ == ExtrusionRule::ByLength)
    factor = ratio((transform_.overBed(to) - transform_.overBed(from)).norm(), (to - from).norm());
  return push(tracker, factor * pushed);
}

double FilamentWords::extrusionAlone(const ProgramTracker& tracker, double pushed) {
  return push(tracker, pushed);
}

double FilamentWords::push(const ProgramTracker& tracker, double pushed) {
  written_filament_ += pushed;
  return tracker.isExtrusionRelative() ? pushed : written_filament_;
}

std::optional<double> FilamentWords::feed(const ProgramTracker& tracker, const Point3& from,
                                          const Point3& to) {
  const Point3 mapped_from = transform_.coordinates(transform_.overBed(from));
  const Point3 mapped_to = transform_.coordinates(transform_.overBed(to));
  return newFeed(tracker, tracker.feed() * ratio((mapped_to - mapped_from).norm(), (to - from).norm()));
}

std::optional<double> FilamentWords::feedAlone(const ProgramTracker& tracker) {
  return newFeed(tracker, tracker.feed());
}

std::optional<double> FilamentWords::newFeed(const ProgramTracker& tracker, double feed) {
  constexpr double kSame = 5e-3;                                  // mm/min: the last decimal written
  const bool is_stated = tracker.command().find('F') != nullptr;  // the source's own F must not stay there
  if (feed == 0.0 || (std::abs(feed - written_feed_) < kSame && !is_stated)) return std::nullopt;
  written_feed_ = feed;
  return feed;
}

ProgramRewriter::ProgramRewriter(const PointTransform& transform, const Survey& survey,
                                 const RewriteSettings& settings)
    : transform_(transform),
      survey_(survey),
      settings_(settings),
      decimals_(decimalsOf(settings)),
      tracker_(settings),
      filament_(transform, settings.extrusion_rule),
      closing_(settings, clearHeight(survey, transform), decimals_),
      begin_code_(frameComments(transformedFrame(survey.frame, transform, settings.tool_axis)) +
                  wholeLines(settings.begin_code)),
      footprint_top_(footprintTop(survey, transform, settings)) {}

void ProgramRewriter::read(std::string_view line, std::size_t number, std::string& out) {
  if (number == survey_.end_line) leavePart(out);
  const LineRole role = tracker_.read(line, number);
  const LineStart start = tracker_.command().start();
  if (start == LineStart::Comment && isFrameComment(tracker_.command().comment())) return;
  const bool is_head = (start == LineStart::Blank || start == LineStart::Comment) &&
                       tracker_.section() == ProgramSection::Start;
  if (!is_head && !begin_code_.empty()) appendBeginCode(out);
  switch (role) {
    case LineRole::Blank:
      return;
    case LineRole::Copied:
      if (number > survey_.totals.last_deposition) closing_.beforeLine(tracker_, out);
      return copy(line, out);
    case LineRole::Homing:
      ++counts_.homings_annulled;
      out.append(";Anulada: ").append(line).push_back('\n');
      return;
    case LineRole::Filament:
      return writeFilament(out);
    case LineRole::Deferred:
      return defer(out);
    case LineRole::Motion:
      return writeMotion(out);
  }
}

void ProgramRewriter::finish(std::string& out) {
  appendBeginCode(out);
  closing_.atEnd(tracker_, out);
}

void ProgramRewriter::appendBeginCode(std::string& out) {
  out += begin_code_;
  begin_code_.clear();
}

void ProgramRewriter::copy(std::string_view line, std::string& out) {
  const GcodeBlock& command = tracker_.command();
  if (command.start() == LineStart::G && command.code() == 92 && command.find('E') != nullptr) {
    filament_.setFilament(tracker_.filament());
    is_filament_behind_ = false;
  }
  if (tracker_.section() == ProgramSection::Start) filament_.setFilament(tracker_.filament());
  out.append(line).push_back('\n');
}

void ProgramRewriter::writeFilament(std::string& out) {
  NewWords words;
  const bool has_extrusion = tracker_.command().find('E') != nullptr;
  if (has_extrusion) restoreFilament(out);
  if (has_extrusion && filament_.scalesExtrusion())
    words.extrusion = filament_.extrusionAlone(tracker_, tracker_.motion().extrusion_mm);
  if (filament_.scalesFeed()) words.feed = filament_.feedAlone(tracker_);
  appendRewritten(out, tracker_.command(), words, decimals_);
  out.push_back('\n');
}

void ProgramRewriter::defer(std::string& out) {
  ++counts_.deferred;
  appendWithoutCoordinates(out, tracker_.command());
  if (filament_.scalesFeed()) filament_.feedAlone(tracker_);  // as the line reports it
  out.push_back('\n');
}

void ProgramRewriter::writeMotion(std::string& out) {
  const TrackedMotion& motion = tracker_.motion();
  if (isDropped()) return drop(out);
  if (is_elsewhere_ && motion.is_start_known && motion.extrusion_mm != 0.0) restorePlace(out);
  is_elsewhere_ = false;
  if (tracker_.command().find('E') != nullptr) restoreFilament(out);
  if (!motion.is_start_known || (motion.ends.size() == 1 && transform_.keepsLines())) return writeLine(out);
  if (transform_.keepsLines()) return writeChords(motion.ends, out);
  const auto ends = divided(motion.start, motion.ends, transform_, settings_.chord_tolerance_mm);
  ends.size() == 1 ? writeLine(out) : writeChords(ends, out);
}

void ProgramRewriter::writeLine(std::string& out) {
  const TrackedMotion& motion = tracker_.motion();
  const Point3 point = place(motion.end());
  NewWords words;
  words.coordinates = &point;
  // From an unknown place there is no length to compare with.
  const Point3& from = motion.is_start_known ? motion.start : motion.end();
  if (filament_.scalesExtrusion() && tracker_.command().find('E') != nullptr)
    words.extrusion = filament_.extrusion(tracker_, motion.extrusion_mm, from, motion.end());
  if (filament_.scalesFeed()) words.feed = filament_.feed(tracker_, from, motion.end());
  appendRewritten(out, tracker_.command(), words, decimals_);
  out.push_back('\n');
}

void ProgramRewriter::writeChords(const std::vector<Point3>& ends, std::string& out) {
  const TrackedMotion& motion = tracker_.motion();
  const GcodeBlock& command = tracker_.command();
  Chord chord;
  chord.from = motion.start;
  chord.length = pathLength(motion.start, ends);
  for (const Point3& end : ends) {
    const double before = chord.pushed;
    chord.done += (end - chord.from).norm();
    chord.pushed = motion.extrusion_mm * (chord.length > 0.0 ? chord.done / chord.length : 1.0);
    out += command.code() == 0 ? "G0 " : "G1 ";
    appendCoordinates(out, place(end), decimals_);
    if (command.find('E') != nullptr) appendExtrusion(chord, chord.pushed - before, end, out);
    appendFeed(chord, end, out);
    if (const PlacedWord* power = &end == &ends.front() ? command.find('S') : nullptr)
      out.append(" ").append(command.text().substr(power->begin, power->end - power->begin));
    if (&end == &ends.back()) out += command.text().substr(command.wordsEnd());
    if (command.text().back() == '\r' && &end != &ends.back()) out.push_back('\r');
    out.push_back('\n');
    chord.from = end;
  }
}

void ProgramRewriter::appendExtrusion(Chord& chord, double pushed, const Point3& end, std::string& out) {
  double value = tracker_.isExtrusionRelative() ? chord.pushed - chord.written
                                                : tracker_.motion().filament_from + chord.pushed;
  if (filament_.scalesExtrusion()) value = filament_.extrusion(tracker_, pushed, chord.from, end);
  out += " E";
  const std::size_t digits = out.size();
  appendFixed(out, value, kExtrusionDecimals);
  // What was written is carried on, so that the sum of relative E is that of the line.
  chord.written += readDecimal(std::string_view(out).substr(digits)).value;
}

void ProgramRewriter::appendFeed(const Chord& chord, const Point3& end, std::string& out) {
  const PlacedWord* word = tracker_.command().find('F');
  if (filament_.scalesFeed()) {
    if (const auto feed = filament_.feed(tracker_, chord.from, end)) {
      out += " F";
      appendFixed(out, *feed, kFeedDecimals);
    }
  } else if (word != nullptr && chord.from == tracker_.motion().start) {
    out += " ";
    out.append(tracker_.command().text().substr(word->begin, word->end - word->begin));
  }
}

Point3 ProgramRewriter::place(const Point3& point) {
  const Point3 over_bed = transform_.overBed(point);
  nozzle_.include(over_bed, tracker_.command().number());
  last_z_ = over_bed.z();
  if (over_bed.z() <= footprint_top_ && tracker_.motion().deposits() && !tracker_.marks().isBuildAid())
    footprint_.include(over_bed);
  return transform_.coordinates(over_bed);
}

bool ProgramRewriter::isDropped() const {
  if (settings_.build_aids != BuildAids::Dropped) return false;
  const TrackedMotion& motion = tracker_.motion();
  if (motion.deposits()) return tracker_.marks().isBuildAid();
  return transform_.overBed(motion.end()).z() < kBelowBed;
}

void ProgramRewriter::drop(std::string& out) {
  const TrackedMotion& motion = tracker_.motion();
  ++counts_.aids_dropped;
  is_elsewhere_ = true;
  if (!motion.deposits() && tracker_.command().find('E') != nullptr) return writeInPlace(out);
  if (motion.deposits()) is_filament_behind_ = true;
  const PlacedWord* feed = tracker_.command().find('F');
  if (feed == nullptr || filament_.scalesFeed()) return;
  out += "G1 F";
  out.append(tracker_.command().text().substr(feed->begin + 1, feed->end - feed->begin - 1)).push_back('\n');
}

void ProgramRewriter::writeInPlace(std::string& out) {
  restoreFilament(out);
  if (filament_.scalesExtrusion()) {
    out += "G1 E";
    appendFixed(out, filament_.extrusionAlone(tracker_, tracker_.motion().extrusion_mm), kExtrusionDecimals);
  } else {
    appendWithoutCoordinates(out, tracker_.command());
    if (filament_.scalesFeed()) filament_.feedAlone(tracker_);
  }
  out.push_back('\n');
}

void ProgramRewriter::restoreFilament(std::string& out) {
  if (!is_filament_behind_ || tracker_.isExtrusionRelative()) return;
  is_filament_behind_ = false;
  if (filament_.scalesExtrusion()) return;  // E is counted anew there
  out += "G92 E";
  appendFixed(out, tracker_.motion().filament_from, kExtrusionDecimals);
  out.push_back('\n');
}

void ProgramRewriter::restorePlace(std::string& out) {
  out += "G0 ";
  appendCoordinates(out, place(tracker_.motion().start), decimals_);
  out.push_back('\n');
}

void ProgramRewriter::leavePart(std::string& out) {
  tracker_.leavePart();
  closing_.leavePartAt(last_z_);
  if (!filament_.scalesFeed()) return;
  if (const auto feed = filament_.feedAlone(tracker_)) {
    out += "G1 F";
    appendFixed(out, *feed, kFeedDecimals);
    out.push_back('\n');
  }
}

}  // namespace lamina
