// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/gcode/full_control_writer.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/toolpath/process_support.hpp"
#include "program/arc_refusal.hpp"
#include "program/gcode/extrusion.hpp"
#include "program/gcode/fixed_point.hpp"
#include "program/gcode/start_code.hpp"

namespace lamina {
namespace {

constexpr double kStraightDown = 1e-6;  // rad
constexpr double kMicrons = 1e3;        // of a position
constexpr double kFeedUnits = 60e3;     // of 0.001 mm/min in mm/s
constexpr double kFilamentUnits = 1e5;

[[noreturn]] void refuse(const Toolpath& toolpath, const std::string& what) {
  throw InvalidInput("the toolpath of '" + toolpath.part_name + "' " + what);
}

void requireWritableSteps(const Toolpath& toolpath, const ProgramFrame& frame) {
  validate(toolpath);
  bool deposits = false;
  const Eigen::Matrix3d program_from_part = (frame.program_from_bed * frame.bed_from_part).linear();
  if (!program_from_part.isIdentity(kStraightDown))
    refuse(toolpath, "is turned on its bed; a program of FullControl's dialect only moves it");
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) {
      if (path.deposit == Deposit::Drops) refuse(toolpath, "has drops; FullControl's dialect has only beads");
      for (const Eigen::Quaterniond& orientation : path.orientation.values())
        if ((orientation * Point3::UnitZ() + Point3::UnitZ()).norm() > kStraightDown)
          refuse(toolpath, "turns the nozzle; in FullControl's dialect it points straight down");
      deposits = deposits || path.role != PathRole::Travel;
    }
  if (!deposits) refuse(toolpath, "deposits nothing; a program needs at least one bead");
}

/// Motions as lines, with what they need to know of those before.
class MotionWriter {
 public:
  MotionWriter(const Point3& shift, double filament_per_volume)
      : shift_(shift), filament_per_volume_(filament_per_volume) {}

  void writePath(const Path& path, std::string& text) {
    const PathExtrusion extrusion(path, filament_per_volume_);
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const std::size_t end = path.motionEnd(m);
      const double filament = extrusion.along((path.points[end] - path.points[m]).norm(), end);
      write(path.points[end], path.feed_mm_s.at(end), filament, text);
    }
  }

  /// Over the point at the height where the start code ends, then down to it.
  void approach(const Point3& point, double feed_mm_s, std::string& text) {
    const std::int64_t below = toUnits(shift_.z() + point.z(), kMicrons);
    last_[2] = below;
    write(point, feed_mm_s, 0.0, text);
    last_[2] = kUnknown;
    write(point, feed_mm_s, 0.0, text);
  }

 private:
  static constexpr std::int64_t kUnknown = std::numeric_limits<std::int64_t>::min();

  void write(const Point3& end, double feed_mm_s, double filament_mm, std::string& text) {
    text += filament_mm > 0.0 ? "G1" : "G0";
    word<3>(" F", toUnits(feed_mm_s, kFeedUnits), feed_, text);
    constexpr std::array<const char*, 3> kAxes{" X", " Y", " Z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      word<3>(kAxes[axis], toUnits(shift_[a] + end[a], kMicrons), last_[axis], text);
    }
    if (filament_mm > 0.0) {
      filament_mm_ += filament_mm;
      const std::int64_t total = toUnits(filament_mm_, kFilamentUnits);
      append<5>(" E", total - filament_, text);
      filament_ = total;
    }
    text += '\n';
  }

  template <int decimals>
  static void append(const char* name, std::int64_t units, std::string& text) {
    char digits[32];
    text += name;
    text.append(digits, writeFixed<decimals>(digits, units));
  }

  template <int decimals>
  static void word(const char* name, std::int64_t units, std::int64_t& last, std::string& text) {
    if (units == last) return;
    last = units;
    append<decimals>(name, units, text);
  }

  Point3 shift_;
  double filament_per_volume_;
  std::array<std::int64_t, 3> last_{kUnknown, kUnknown, kUnknown};
  std::int64_t feed_ = kUnknown;
  double filament_mm_ = 0.0;
  std::int64_t filament_ = 0;
};

const Path& firstDeposit(const Toolpath& toolpath) {
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel) return path;
  refuse(toolpath, "deposits nothing");
}

}  // namespace

void writeFullControl(const Toolpath& toolpath, const ProgramFrame& frame, const ProgramSettings& settings,
                      const TextSink& sink) {
  requireWritableSteps(toolpath, frame);
  requireSupported(toolpath, {}, "G-code of dialect fullcontrol");
  if (settings.arcs_tolerance_mm > 0.0) refuseArcs(settings, "G-code of dialect fullcontrol");
  const std::string start_code = expandCode("program.start_code", settings.start_code, settings, frame);
  const std::string end_code = expandCode("program.end_code", settings.end_code, settings, frame);
  MotionWriter writer((frame.program_from_bed * frame.bed_from_part).translation(),
                      filamentPerVolume(settings));
  std::string text = ";FLAVOR:Marlin\n" + start_code + "G21\nG90\nM83\nG92 E0\n;END OF THE START GCODE\n";
  const Path& first = firstDeposit(toolpath);
  writer.approach(first.firstPoint(), first.feed_mm_s.at(0), text);
  sink(text);
  bool has_begun = false;
  for (const ToolpathLayer& layer : toolpath.layers) {
    text.clear();
    for (const Path& path : layer.paths) {
      has_begun = has_begun || &path == &first;
      if (has_begun) writer.writePath(path, text);
    }
    sink(text);
  }
  sink(";START OF THE END GCODE\n" + end_code);
}

}  // namespace lamina
