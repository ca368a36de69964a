// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/gcode/layer_writer.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "lamina/toolpath/wipe.hpp"
#include "program/gcode/extrusion.hpp"
#include "program/gcode/fixed_point.hpp"
#include "program/gcode/process_words.hpp"
#include "program/gcode/tool_offsets.hpp"

namespace lamina {
namespace {

constexpr double kPositionScale = 1e3;     // 3 decimals
constexpr double kFilamentScale = 1e5;     // 5 decimals
constexpr double kHeightScale = 1e5;       // 5 decimals: a bead that rises from nothing starts thin
constexpr double kFeedScale = 60.0 * 1e3;  // mm/s to mm/min with 3 decimals
constexpr std::size_t kLongestWrittenLine = 128;

/// Appends " X1.5" if the value is not the one that holds.
char* writeChanged(char* out, char letter, std::int64_t units, std::int64_t& modal) {
  if (units == modal) return out;
  modal = units;
  *out++ = ' ';
  *out++ = letter;
  return writeFixed<3>(out, units);
}

template <int decimals>
void writeComment(const char* key, std::int64_t units, std::string& text) {
  char line[kLongestWrittenLine];
  char* end = writeFixed<decimals>(line, units);
  *end++ = '\n';
  text.append(key).append(line, end);
}

}  // namespace

LayerWriter::LayerWriter(const ProgramFrame& frame, const Point3& layer_normal,
                         const ProgramSettings& settings)
    : linear_(frame.program_from_bed.linear() * frame.bed_from_part.linear()),
      translation_(frame.program_from_bed * frame.bed_from_part.translation()),
      frame_(frame),
      is_mapped_(frame.program_from_bed.linear() != Eigen::Matrix3d::Identity()),
      rise_mm_((frame.bed_from_part.linear() * layer_normal).dot(frame.bed_from_part.translation())),
      dialect_(gcodeDialects().find(settings.dialect)),
      filament_per_volume_(dialect_.has_extruder ? filamentPerVolume(settings) : 0.0),
      settings_(settings) {}

void LayerWriter::write(const ToolpathLayer& layer, const LayerStart& start, std::string& text) const {
  const bool lays_drops = std::any_of(layer.paths.begin(), layer.paths.end(),
                                      [](const Path& path) { return path.deposit == Deposit::Drops; });
  text.append(lays_drops ? ";" + settings_.drops.layer_mark : ";LAYER:")
      .append(std::to_string(start.index))
      .append("\n");
  writeComment<3>(";Z:", toUnits(layer.z_mm + rise_mm_, kPositionScale), text);
  Modal modal;
  writeHeight(layer.height_mm, modal, text);
  modal.filament_mm = start.filament_mm;
  modal.filament = toUnits(start.filament_mm, kFilamentScale);

  bool is_retracted = start.is_retracted;
  const Path* previous = nullptr;  // deposition path that ends where the next one starts
  PathRole role = PathRole::Travel;
  std::uint32_t tool = start.tool;
  modal.shift = -toolOffset(tool, settings_, frame_);
  for (std::size_t p = 0; p < layer.paths.size(); ++p) {
    const Path& path = layer.paths[p];
    const bool next_is_retracted =
        p + 1 < layer.paths.size() ? layer.paths[p + 1].process.is_retracted : start.next_is_retracted;
    const bool retracts = path.process.is_retracted && !is_retracted;
    const double wiped_mm = retracts ? wipeShare(path) * settings_.retraction_length_mm : 0.0;
    if (retracts) writeRetraction(wiped_mm - settings_.retraction_length_mm, modal, text);
    if (path.deposit == Deposit::Drops) {
      writeDrops(path, modal, text);
      continue;
    }
    if (std::exchange(tool, path.tool) != path.tool) {
      text.append("T").append(std::to_string(path.tool)).append("\n");
      modal.shift = -toolOffset(path.tool, settings_, frame_);
    }
    if (path.role != PathRole::Travel) {
      if (path.role != role || previous != nullptr)
        text.append(";TYPE:").append(toString(path.role)).append("\n");
      role = path.role;
    }
    previous = path.role == PathRole::Travel ? nullptr : &path;
    if (wiped_mm > 0.0)
      writeWipe(path, wiped_mm, modal, text);
    else
      writePath(path, modal, text);
    is_retracted = path.process.is_retracted && next_is_retracted;
    if (path.process.is_retracted && !is_retracted)
      writeRetraction(settings_.retraction_length_mm, modal, text);
  }
}

void LayerWriter::writeDrops(const Path& path, Modal& modal, std::string& text) const {
  text.append(";")
      .append(settings_.drops.role_mark)
      .append(roleName(path.role, settings_.drops))
      .append("\n");
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const double factor = i > 0 ? feedFactor(path.points[i - 1], path.points[i]) : 1.0;
    writeMotion(path.points[i], path.feed_mm_s.at(i) * factor, modal, text);
    text.append(settings_.drops.discharge).append("\n");
  }
}

std::optional<PathArcs> LayerWriter::arcsOf(const Path& path, const Modal& modal) const {
  if (settings_.arcs_tolerance_mm == 0.0 || path.role == PathRole::Travel) return std::nullopt;
  std::vector<Point3> places = {placeOf(path.firstPoint(), modal)};
  for (std::size_t m = 0; m < path.motionCount(); ++m)
    places.push_back(placeOf(path.points[path.motionEnd(m)], modal));
  // Positions are rounded when they are written.
  return PathArcs(
      path, places,
      std::max(0.5 * settings_.arcs_tolerance_mm, settings_.arcs_tolerance_mm - 1.0 / kPositionScale));
}

void LayerWriter::writePath(const Path& path, Modal& modal, std::string& text) const {
  const PathExtrusion extrusion(path, filament_per_volume_);
  const std::optional<PathArcs> arcs = arcsOf(path, modal);
  const std::size_t motions = path.motionCount();
  modal.is_depositing = path.role != PathRole::Travel;
  for (std::size_t m = 0; m < motions; ++m) {
    writeEvents(path, m, modal, text);
    const std::optional<FittedArc> arc = arcs ? arcs->from(m) : std::nullopt;
    if (arc) {
      for (std::size_t i = m; i < arc->last; ++i)
        modal.filament_mm +=
            extrusion.along((path.points[path.motionEnd(i)] - path.points[i]).norm(), path.motionEnd(i));
      writeHeight(path.bead.at(path.motionEnd(m)).height_mm, modal, text);
      writeArc(path, m, *arc, modal, text);
      m = arc->last - 1;
      continue;
    }
    const std::size_t end = path.motionEnd(m);
    const double length_mm = (path.points[end] - path.points[m]).norm();
    const double deposited_mm = extrusion.along(length_mm, end);
    modal.filament_mm += deposited_mm;
    // Too little to be written: without E it would read as a travel. The next motion takes it along.
    if (deposited_mm > 0.0 && toUnits(modal.filament_mm, kFilamentScale) == modal.filament) continue;
    if (path.role != PathRole::Travel) writeHeight(path.bead.at(end).height_mm, modal, text);
    writeMotion(path.points[end], path.feed_mm_s.at(end) * feedFactor(path.points[m], path.points[end]),
                modal, text);
  }
  writeEvents(path, motions, modal, text);
}

void LayerWriter::writeWipe(const Path& path, double retraction_mm, Modal& modal, std::string& text) const {
  const double before_mm = modal.filament_mm;
  const double whole_mm = length(path);
  modal.is_depositing = true;  // the wipe states its E, which pulls back
  double way_mm = 0.0;
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    writeEvents(path, m, modal, text);
    const std::size_t end = path.motionEnd(m);
    way_mm += (path.points[end] - path.points[m]).norm();
    modal.filament_mm = before_mm - retraction_mm * way_mm / whole_mm;
    writeMotion(path.points[end], path.feed_mm_s.at(end) * feedFactor(path.points[m], path.points[end]),
                modal, text);
  }
  writeEvents(path, path.motionCount(), modal, text);
  // What is pulled back is pushed forth again: it does not count as deposited.
  modal.filament_mm = before_mm;
  modal.filament += toUnits(retraction_mm, kFilamentScale);
}

void LayerWriter::writeEvents(const Path& path, std::size_t motion, Modal& modal, std::string& text) const {
  for (const PathEvent& placed : eventsBefore(path.events, motion)) {
    writeEvent(placed.event, settings_, text);
    const auto* const code = std::get_if<MachineCode>(&placed.event);
    if (code == nullptr || !code->moves_axes) continue;
    text += dialect_.has_extruder ? "G21\nG90\nM83\n" : "G21\nG90\n";
    modal.x = modal.y = modal.z = modal.feed = kUnknown;
    const Point3& here = motion < path.points.size() ? path.points[motion] : path.lastPoint();
    writeMotion(here, path.feed_mm_s.at(path.motionEnd(std::min(motion, path.motionCount() - 1))), modal,
                text);
  }
}

double LayerWriter::feedFactor(const Point3& start, const Point3& end) const {
  const Point3 way = end - start;
  return is_mapped_ && !way.isZero() ? (linear_ * way).norm() / way.norm() : 1.0;
}

void LayerWriter::writeHeight(double height_mm, Modal& modal, std::string& text) {
  const std::int64_t height = toUnits(height_mm, kHeightScale);
  if (height == modal.height) return;
  modal.height = height;
  writeComment<5>(";HEIGHT:", height, text);
}

void LayerWriter::writeMotion(const Point3& end, double feed_mm_s, Modal& modal, std::string& text) const {
  const Point3 target = placeOf(end, modal);
  char line[kLongestWrittenLine];
  char* out = line + 2;
  out = writeChanged(out, 'X', toUnits(target.x(), kPositionScale), modal.x);
  out = writeChanged(out, 'Y', toUnits(target.y(), kPositionScale), modal.y);
  out = writeChanged(out, 'Z', toUnits(target.z(), kPositionScale), modal.z);
  if (out == line + 2) return;  // shorter than the last decimal: its material goes to the next motion
  const std::int64_t filament = toUnits(modal.filament_mm, kFilamentScale);
  line[0] = 'G';
  line[1] = modal.is_depositing && !dialect_.has_extruder ? '1' : '0';
  // What the last motion of a bead was too short for goes to the next bead: a travel by it would read as one.
  if (filament != modal.filament && modal.is_depositing) {
    line[1] = '1';
    *out++ = ' ';
    *out++ = 'E';
    out = writeFixed<5>(out, filament - modal.filament);
    modal.filament = filament;
  }
  out = writeChanged(out, 'F', toUnits(feed_mm_s, kFeedScale), modal.feed);
  *out++ = '\n';
  text.append(line, static_cast<std::size_t>(out - line));
}

void LayerWriter::writeArc(const Path& path, std::size_t motion, const FittedArc& arc, Modal& modal,
                           std::string& text) const {
  const Point3 target = placeOf(path.points[path.motionEnd(arc.last - 1)], modal);
  // From where the nozzle is by the words before, which are rounded.
  const Point3 start = placeOf(path.points[motion], modal);
  const std::int64_t i = toUnits(arc.centre.x(), kPositionScale) - toUnits(start.x(), kPositionScale);
  const std::int64_t j = toUnits(arc.centre.y(), kPositionScale) - toUnits(start.y(), kPositionScale);
  char line[kLongestWrittenLine];
  char* out = line;
  const auto write = [&out](const char* word, std::int64_t units) {
    while (*word != '\0') *out++ = *word++;
    out = writeFixed<3>(out, units);
  };
  write(arc.direction == ArcDirection::CounterClockwise ? "G3 X" : "G2 X",
        toUnits(target.x(), kPositionScale));
  write(" Y", toUnits(target.y(), kPositionScale));
  write(" I", i);
  write(" J", j);
  modal.x = toUnits(target.x(), kPositionScale);
  modal.y = toUnits(target.y(), kPositionScale);
  const std::int64_t filament = toUnits(modal.filament_mm, kFilamentScale);
  if (filament != modal.filament) {
    *out++ = ' ';
    *out++ = 'E';
    out = writeFixed<5>(out, filament - modal.filament);
    modal.filament = filament;
  }
  out = writeChanged(out, 'F', toUnits(path.feed_mm_s.at(path.motionEnd(motion)), kFeedScale), modal.feed);
  *out++ = '\n';
  text.append(line, static_cast<std::size_t>(out - line));
}

void LayerWriter::writeRetraction(double length_mm, Modal& modal, std::string& text) const {
  const std::int64_t units = toUnits(length_mm, kFilamentScale);
  if (units == 0) return;
  char line[kLongestWrittenLine] = "G1 E";
  char* out = writeFixed<5>(line + 4, units);
  out = writeChanged(out, 'F', toUnits(settings_.retraction_feed_mm_s, kFeedScale), modal.feed);
  *out++ = '\n';
  text.append(line, static_cast<std::size_t>(out - line));
}

}  // namespace lamina
