// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gcode_block.hpp"
#include "lamina/gcode_rewrite/rewrite_settings.hpp"
#include "section_marks.hpp"

namespace lamina {

/// Whether E is absolute. In Marlin G90 and G91 change this, in RepRapFirmware and Klipper they do not; a
/// mode that would depend on the firmware is disputed.
class ExtrusionModeState {
 public:
  explicit ExtrusionModeState(std::optional<ExtrusionMode> initial)
      : stated_(initial.value_or(ExtrusionMode::Absolute)),
        marlin_(stated_),
        is_known_(initial.has_value()) {}

  void state(ExtrusionMode mode) {
    stated_ = marlin_ = mode;
    is_known_ = true;
    is_declared_ = false;
  }
  void positionMode(ExtrusionMode mode) {
    if (!is_declared_) marlin_ = mode;
  }
  /// States that the mode given on the command line holds whatever G90 and G91 mean.
  void declare() { is_declared_ = is_known_; }

  bool isDisputed() const { return stated_ != marlin_; }
  bool isKnown() const { return is_known_; }  ///< whether M82, M83 or the user has stated it
  ExtrusionMode mode() const { return stated_; }

 private:
  ExtrusionMode stated_;
  ExtrusionMode marlin_;
  bool is_known_;
  bool is_declared_ = false;
};

enum class ProgramSection { Start, Part, End };

/// How the rewriter must treat a line.
enum class LineRole {
  Copied,
  Blank,
  Homing,    ///< a G28 that is to be removed
  Filament,  ///< G0 or G1 without coordinates
  Motion,    ///< of the part, straight or along an arc
  Deferred,  ///< a motion of the part before all coordinates are known
};

/// A motion of the part [mm, as the slicer wrote it].
struct TrackedMotion {
  Point3 start = Point3::Zero();
  bool is_start_known = false;
  std::vector<Point3> ends;    ///< one end, or those of the chords of an arc
  double extrusion_mm = 0.0;   ///< filament extruded
  double filament_from = 0.0;  ///< value of E before the motion, if E is absolute

  const Point3& end() const { return ends.back(); }
  bool deposits() const;
};

/// Follows the modal state of a program line by line, and refuses lines that cannot be transformed.
class ProgramTracker {
 public:
  /// Reads the begin code first, as its modes hold for the lines that follow.
  explicit ProgramTracker(const RewriteSettings& settings);

  /// @throws InvalidProgram naming the line: for G91, G20, an origin moved by G92, a moving command other
  ///   than G0 to G3, coordinates without a command, a deposition from an unknown position, or an E that
  ///   firmwares read differently
  LineRole read(std::string_view line, std::size_t number);
  /// States that the end code follows.
  void leavePart() { section_ = ProgramSection::End; }

  ProgramSection section() const { return section_; }
  SectionMark mark() const { return mark_; }  ///< mark of the line read last
  const SectionMarks& marks() const { return marks_; }
  const GcodeBlock& command() const { return command_; }
  const TrackedMotion& motion() const { return motion_; }  ///< valid after LineRole::Motion
  bool isExtrusionRelative() const { return extrusion_.mode() == ExtrusionMode::Relative; }
  bool isExtrusionStated() const { return extrusion_.isKnown(); }
  bool isPositionRelative() const { return is_relative_; }
  bool isInInches() const { return unit_mm_ != 1.0; }
  double filament() const { return filament_; }  ///< value of E, if E is absolute
  double feed() const { return feed_; }          ///< [mm/min]; 0 until one is stated

 private:
  void readBeginCode(std::string_view code);
  LineRole readCommand(LineStart start);
  void readMark();
  LineRole readG();
  void readM();
  LineRole home() const;
  void setPosition();
  LineRole move();
  double takeExtrusion();
  void moveTo(const std::array<bool, 3>& known_before);
  void addArc();
  void requireKnownWords() const;
  void requireSupported() const;
  void requireFixedOrigin() const;
  [[noreturn]] void refuse(const std::string& what) const;

  bool annuls_homing_;
  double chord_tolerance_mm_;
  ExtrusionModeState extrusion_;
  SectionMarks marks_;
  GcodeBlock command_;
  ProgramSection section_ = ProgramSection::Start;
  SectionMark mark_ = SectionMark::None;
  bool is_custom_ = false;
  bool is_relative_ = false;
  double unit_mm_ = 1.0;
  int arc_axis_ = 2;
  Point3 position_ = Point3::Zero();
  std::array<bool, 3> known_{};
  double filament_ = 0.0;
  bool is_filament_known_ = true;
  double feed_ = 0.0;
  TrackedMotion motion_;
};

}  // namespace lamina
