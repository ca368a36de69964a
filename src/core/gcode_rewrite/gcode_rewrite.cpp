// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/gcode_rewrite/gcode_rewrite.hpp"

#include <filesystem>

#include "gcode_rewrite/closing_code.hpp"
#include "gcode_rewrite/frame_transform.hpp"
#include "gcode_rewrite/line_reader.hpp"
#include "gcode_rewrite/listing_rewriter.hpp"
#include "gcode_rewrite/part_placement.hpp"
#include "gcode_rewrite/program_rewriter.hpp"
#include "gcode_rewrite/survey.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

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
  std::error_code missing;  // opening the file reports better
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

void requireToolAxis(double off_normal_deg, const RewriteSettings& settings) {
  if (!settings.tool_axis || settings.tool_axis_rule == ToolAxisRule::AsMachine ||
      off_normal_deg <= kToolAxisToleranceDeg)
    return;
  throw Unreachable(
      "the machine holds its nozzle at " + std::to_string(off_normal_deg) +
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
