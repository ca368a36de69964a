// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/gcode_rewrite/gcode_rewrite.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>

#include "closing_code.hpp"
#include "decimal_number.hpp"
#include "frame_transform.hpp"
#include "gcode_block.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"
#include "lamina/gcode_rewrite/rewrite_settings.hpp"
#include "line_reader.hpp"
#include "motion_text.hpp"
#include "point_transform.hpp"
#include "program_rewriter.hpp"
#include "section_marks.hpp"
#include "survey.hpp"

namespace lamina {
namespace {

constexpr double kRounding = 1e-6;  // mm: below what programs resolve

std::string shown(double value_mm) {
  std::string text;
  appendFixed(text, value_mm, 3);
  return text + " mm";
}

std::string hint(const Extremes& reached, const Box3& limits, Eigen::Index axis, double shift) {
  const double low = reached.box.low[axis] + shift;
  const double high = reached.box.high[axis] + shift;
  const double room = limits.high[axis] - limits.low[axis];
  if (high - low > room) return "the program spans " + shown(high - low) + " there and cannot fit";
  const double move = low < limits.low[axis] ? limits.low[axis] - low : limits.high[axis] - high;
  return "it would fit if it were moved by " + shown(move);
}

void requirePartWithin(const Extremes& reached, const Point3& shift, const Box3& limits) {
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto index = static_cast<std::size_t>(axis);
    const double low = reached.box.low[axis] + shift[axis];
    const double high = reached.box.high[axis] + shift[axis];
    const bool is_low = low < limits.low[axis] - kRounding;
    if (!is_low && !(high > limits.high[axis] + kRounding)) continue;
    throw Unreachable("line " + std::to_string(is_low ? reached.low_line[index] : reached.high_line[index]) +
                      ": the nozzle would be at " + "xyz"[axis] + " = " + shown(is_low ? low : high) +
                      "; must be in [" + shown(limits.low[axis]) + ", " + shown(limits.high[axis]) + "]; " +
                      hint(reached, limits, axis, shift[axis]));
  }
}

void requireAboveBed(const Extremes& deposited, double shift_mm, const std::string& what) {
  if (deposited.box.isEmpty() || deposited.box.low.z() + shift_mm >= -kRounding) return;
  throw Unreachable("line " + std::to_string(deposited.low_line[2]) + ": " + what +
                    " would be deposited at z = " + shown(deposited.box.low.z() + shift_mm) +
                    ", below the bed; must be 0 mm or more");
}

void requireFinalWithin(const Point3& position, const Box3& limits) {
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (!(position[axis] >= limits.low[axis] && position[axis] <= limits.high[axis]))
      throw Unreachable(std::string("the final position is ") + "xyz"[axis] + " = " + shown(position[axis]) +
                        "; must be in [" + shown(limits.low[axis]) + ", " + shown(limits.high[axis]) + "]");
}

/// What moves the mapped part to its place over the bed [mm].
/// @throws InvalidProgram if the lift needs a layer height that is neither set nor stated
Point3 shiftOf(const Survey& survey, const RewriteSettings& settings) {
  Point3 shift = settings.offset_mm;
  const Box3& part = survey.totals.part.box;
  if (settings.table_position_mm) shift.head<2>() = *settings.table_position_mm - part.centre().head<2>();
  if (settings.lift == Lift::None) return shift;
  const auto height = settings.layer_height_mm ? settings.layer_height_mm : survey.layer_height_mm;
  if (!height)
    throw InvalidProgram(
        "the program does not report its layer height, at which the lowest deposition is put; expected it to "
        "be "
        "given (layer_height_mm)");
  shift.z() += *height - part.low.z();
  return shift;
}

/// @throws Unreachable naming line, axis, value and limit if the nozzle would leave the limits, deposit below
///   the bed, or go to a final position out of the limits
void requireReachable(const Survey& survey, const Point3& shift, const RewriteSettings& settings) {
  const SurveyTotals& totals = survey.totals;
  requireAboveBed(totals.part, shift.z(), "the part");
  if (settings.build_aids == BuildAids::Kept)
    requireAboveBed(
        totals.aids, shift.z(),
        "skirt, brim, raft or support lies on the slicer's bed, not on the machine's; slice without, "
        "or drop it. It");
  if (!settings.limits_mm) return;
  if (settings.final_position_mm) requireFinalWithin(*settings.final_position_mm, *settings.limits_mm);
  // Where the nozzle goes if aids are dropped is known only when they are.
  const bool is_known = settings.build_aids == BuildAids::Kept;
  requirePartWithin(is_known ? totals.nozzle : totals.part, shift, *settings.limits_mm);
}

/// @param nozzle  places it goes to over the bed, with the shift
/// @throws Unreachable as above
void requireWithinLimits(const Extremes& nozzle, const RewriteSettings& settings) {
  if (settings.limits_mm) requirePartWithin(nozzle, Point3::Zero(), *settings.limits_mm);
}

/// The points of a program as the listings of [Garcia2024] take them: of every line that begins with G0 or G1
/// after the first layer is opened, to the end of the file, from (0, 0, 0) on.
class ListingTracker {
 public:
  /// @return whether the line has a point
  /// @throws InvalidProgram naming the line: what the listing would leave untransformed or write wrongly
  ///   (G2, G3, G20, G91, words out of order)
  bool read(std::string_view line, std::size_t number);

  bool hasPart() const { return has_part_; }
  const Point3& point() const { return point_; }  ///< [mm, as sliced]
  const GcodeBlock& command() const { return command_; }
  const SectionMarks& marks() const { return marks_; }
  SectionMark mark() const { return mark_; }

 private:
  void requireTransformable() const;
  [[noreturn]] void refuse(const std::string& what) const;

  GcodeBlock command_;
  SectionMarks marks_;
  SectionMark mark_ = SectionMark::None;
  bool has_part_ = false;
  bool is_relative_ = false;
  bool is_in_inches_ = false;
  Point3 point_ = Point3::Zero();
};

/// First pass of the listing: the height comes from all points.
class ListingSurveyor {
 public:
  explicit ListingSurveyor(const PointTransform& transform) : transform_(transform) {}
  void read(std::string_view line, std::size_t number);
  /// @throws InvalidProgram if no comment opens a layer, or there is no motion after it
  Survey finish();

 private:
  const PointTransform& transform_;
  ListingTracker tracker_;
  Survey survey_;
};

/// Second pass of the listing, byte for byte: lines stripped, empty ones dropped, coordinates between what
/// stands before the first and after the last of them.
class ListingRewriter {
 public:
  ListingRewriter(const PointTransform& transform, int decimals)
      : transform_(transform), decimals_(decimals) {}
  void read(std::string_view line, std::size_t number, std::string& out);
  std::size_t homingsAnnulled() const { return homings_annulled_; }

 private:
  const PointTransform& transform_;
  int decimals_;
  ListingTracker tracker_;
  std::size_t homings_annulled_ = 0;
};

bool beginsWithMotion(std::string_view line) {
  return line.substr(0, 2) == "G0" || line.substr(0, 2) == "G1";
}

const PlacedWord* firstOf(const GcodeBlock& command, std::string_view letters) {
  for (const char letter : letters)
    if (const PlacedWord* word = command.find(letter)) return word;
  return nullptr;
}

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

constexpr std::size_t kBetweenReports = 1U << 16U;  // lines
constexpr std::size_t kWritten = 1U << 18U;         // bytes gathered before they are written

/// Calls `each` with every line of the file and its number.
/// @return how many bytes there were
template <class Each>
std::size_t forEachLine(const std::string& path, const std::string& stage, Progress& progress, Each each) {
  LineReader reader(path);
  while (const auto line = reader.next()) {
    try {
      each(*line, reader.number());
    } catch (const InvalidInput& error) {
      if (error.code() != ErrorCode::InvalidInput) throw;  // names its line
      throw InvalidProgram("line " + std::to_string(reader.number()) + ": " + error.what());
    }
    if (reader.number() % kBetweenReports != 0) continue;
    throwIfCancelled(progress, stage);
    progress.report(stage, reader.size() == 0 ? 0.0
                                              : static_cast<double>(reader.bytesRead()) /
                                                    static_cast<double>(reader.size()));
  }
  throwIfCancelled(progress, stage);
  progress.report(stage, 1.0);
  return reader.bytesRead();
}

/// What the first pass found, of which file.
struct Measured {
  Survey survey;
  std::size_t bytes = 0;
  std::filesystem::file_time_type written_at;
};

std::filesystem::file_time_type lastWritten(const std::string& path) {
  std::error_code missing;  // opening the file gives a better message
  return std::filesystem::last_write_time(path, missing);
}

template <class Reader>
Measured measure(const std::string& path, Reader& surveyor, Progress& progress) {
  const auto written_at = lastWritten(path);
  const std::size_t bytes =
      forEachLine(path, "measure", progress,
                  [&](std::string_view line, std::size_t number) { surveyor.read(line, number); });
  return {surveyor.finish(), bytes, written_at};
}

void requireUnchanged(const std::string& path, const Measured& before, std::size_t bytes) {
  if (bytes == before.bytes && lastWritten(path) == before.written_at) return;
  throw FileError("'" + path + "' has been written to while it was read (" + std::to_string(before.bytes) +
                  " bytes before, " + std::to_string(bytes) + " after); expected it to stay as it is");
}

template <class Reader, class Finish>
void rewrite(const ProgramFiles& files, const Measured& before, Reader& rewriter, Progress& progress,
             Finish appendEnd) {
  AtomicFile output(files.output);
  std::string text;
  text.reserve(2 * kWritten);
  const std::size_t bytes =
      forEachLine(files.input, "write", progress, [&](std::string_view line, std::size_t number) {
        rewriter.read(line, number, text);
        if (text.size() < kWritten) return;
        output.write(text);
        text.clear();
      });
  requireUnchanged(files.input, before, bytes);
  appendEnd(text);
  output.write(text);
  output.commit();
}

RewriteReport reportOf(const Survey& survey, const Point3& shift, const RewriteSettings& settings) {
  RewriteReport report;
  report.slicer = survey.slicer;
  report.lines = survey.lines;
  report.layers = survey.totals.layers;
  report.motions = survey.totals.motions;
  report.depositions = survey.totals.depositions;
  report.arcs = survey.totals.arcs;
  report.shift = shift;
  report.layer_height_mm = settings.layer_height_mm.value_or(survey.layer_height_mm.value_or(0.0));
  for (const auto& [from, to] : {std::pair<const Box3&, Box3&>{survey.totals.part.box, report.part},
                                 {survey.totals.nozzle.box, report.nozzle}}) {
    to = from;
    to.low += shift;
    to.high += shift;
  }
  return report;
}

/// 0 where a raft or supports may lie below, and where the height of layers is not known.
double firstLayerGap(const SurveyTotals& totals, const RewriteReport& report,
                     const RewriteSettings& settings) {
  const bool has_aids = settings.build_aids == BuildAids::Kept && !totals.aids.box.isEmpty();
  if (has_aids || report.layer_height_mm <= 0.0) return 0.0;
  return std::max(0.0, totals.first_layer_low_mm + report.shift.z() - report.layer_height_mm);
}

void requireToolAxis(double off_normal_deg, const RewriteSettings& settings) {
  if (!settings.tool_axis || settings.tool_axis_rule == ToolAxisRule::AsMachine ||
      off_normal_deg <= kToolAxisToleranceDeg)
    return;
  throw Unreachable(
      "the machine holds its nozzle at " + numberText(off_normal_deg) +
      " deg from the normal of the layers; expected 0 deg, another axis or angle of the map, or "
      "the tool axis to be as the machine has it");
}

RewriteReport rewriteCorrected(const ProgramFiles& files, PointTransform transform,
                               const RewriteSettings& settings, Progress& progress) {
  Surveyor surveyor(transform, settings);
  const Measured measured = measure(files.input, surveyor, progress);
  const double off_normal_deg =
      toolAxisOffNormalDeg(transformedFrame(measured.survey.frame, transform, settings.tool_axis));
  requireToolAxis(off_normal_deg, settings);
  transform.shift = shiftOf(measured.survey, settings);
  requireReachable(measured.survey, transform.shift, settings);
  ProgramRewriter rewriter(transform, measured.survey, settings);
  rewrite(files, measured, rewriter, progress, [&](std::string& out) {
    requireWithinLimits(rewriter.nozzle(), settings);
    rewriter.finish(out);
  });
  RewriteReport report = reportOf(measured.survey, transform.shift, settings);
  report.first_layer_gap_mm = firstLayerGap(measured.survey.totals, report, settings);
  report.nozzle = rewriter.nozzle().box;
  report.footprint = rewriter.footprint();
  report.tool_axis_off_normal_deg = off_normal_deg;
  report.deferred = rewriter.counts().deferred;
  report.homings_annulled = rewriter.counts().homings_annulled;
  report.aids_dropped = rewriter.counts().aids_dropped;
  return report;
}

/// Refuses what the listing has no notion of.
void requireOfListing(const RewriteSettings& settings) {
  const RewriteSettings usual;
  const std::pair<const char*, bool> given[] = {
      {"begin code", !settings.begin_code.empty()},
      {"end code", !settings.end_code.empty()},
      {"a final position", settings.final_position_mm.has_value()},
      {"what becomes of homing", settings.homing != usual.homing},
      {"what becomes of build aids", settings.build_aids != usual.build_aids},
      {"the rule of extrusion", settings.extrusion_rule != usual.extrusion_rule},
      {"the mode of E", settings.initial_extrusion.has_value()},
      {"a chord tolerance", settings.chord_tolerance_mm != usual.chord_tolerance_mm},
  };
  for (const auto& [what, is_given] : given)
    if (is_given)
      throw InvalidConfig(std::string(what) +
                          " is given, which the listing does not know; expected the corrected mode");
}

RewriteReport rewriteAsListing(const ProgramFiles& files, PointTransform transform,
                               const RewriteSettings& settings, Progress& progress) {
  requireOfListing(settings);
  ListingSurveyor surveyor(transform);
  const Measured measured = measure(files.input, surveyor, progress);
  transform.shift = shiftOf(measured.survey, settings);
  if (settings.limits_mm) requireReachable(measured.survey, transform.shift, settings);
  ListingRewriter rewriter(transform, decimalsOf(settings));
  rewrite(files, measured, rewriter, progress, [](std::string&) {});
  RewriteReport report = reportOf(measured.survey, transform.shift, settings);
  report.homings_annulled = rewriter.homingsAnnulled();
  return report;
}

}  // namespace

RewriteReport rewriteProgram(const ProgramFiles& files, const Maps& maps, const RewriteSettings& settings,
                             Progress& progress) {
  validate(settings);
  std::error_code missing;
  if (std::filesystem::equivalent(files.input, files.output, missing))
    throw InvalidInput("output '" + files.output + "' is the file that is read; expected another one");
  const PointTransform transform{maps.map, maps.axes, Point3::Zero()};
  if (maps.axes != nullptr && settings.final_position_mm)
    throw InvalidConfig(
        "a final position is one over the bed, and this machine takes other coordinates; expected it in the "
        "end "
        "code instead");
  const bool as_listing = settings.mode == RewriteMode::Listing;
  if (as_listing && transform.axes != nullptr)
    throw InvalidConfig(
        "the listing writes coordinates of the bed; expected the corrected mode for other axes");
  if (as_listing && !transform.keepsLengths())
    throw InvalidConfig("the listing rotates only; expected the corrected mode for other maps");
  return as_listing ? rewriteAsListing(files, transform, settings, progress)
                    : rewriteCorrected(files, transform, settings, progress);
}

}  // namespace lamina
