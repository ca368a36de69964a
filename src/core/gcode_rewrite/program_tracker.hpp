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

/// Whether E is absolute. G90 and G91 set this in Marlin, but not in RepRapFirmware and Klipper; a mode that
/// firmwares read differently is disputed.
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
  /// What was said on the command line holds whatever G90 and G91 mean.
  void declare() { is_declared_ = is_known_; }

  bool isDisputed() const { return stated_ != marlin_; }
  bool isKnown() const { return is_known_; }  ///< said by M82, M83 or the user
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
  Homing,    ///< G28 that is to be annulled
  Filament,  ///< G0 or G1 without coordinates
  Motion,    ///< of the part, straight or along an arc
  Deferred,  ///< of the part, before all coordinates are known
};

/// A motion of the part [mm, as the slicer wrote it].
struct TrackedMotion {
  Point3 start = Point3::Zero();
  bool is_start_known = false;
  std::vector<Point3> ends;    ///< one, or the chords of an arc
  double extrusion_mm = 0.0;   ///< filament pushed forth
  double filament_from = 0.0;  ///< value of E before, where it is absolute

  const Point3& end() const { return ends.back(); }
  bool deposits() const;
};

/// Follows the modal state of a program line by line, and refuses what cannot be transformed.
class ProgramTracker {
 public:
  /// Reads the begin code first, for its modes hold in what follows.
  explicit ProgramTracker(const RewriteSettings& settings);

  /// @throws InvalidProgram naming the line: G91, G20, an origin moved by G92, a command that moves and is
  ///   none of G0 to G3, coordinates without a command, a deposition from an unknown place, E that firmwares
  ///   read differently
  LineRole read(std::string_view line, std::size_t number);
  /// What follows is the end code.
  void leavePart() { section_ = ProgramSection::End; }

  ProgramSection section() const { return section_; }
  SectionMark mark() const { return mark_; }  ///< of the line read last
  const SectionMarks& marks() const { return marks_; }
  const GcodeBlock& command() const { return command_; }
  const TrackedMotion& motion() const { return motion_; }  ///< after LineRole::Motion
  bool isExtrusionRelative() const { return extrusion_.mode() == ExtrusionMode::Relative; }
  bool isExtrusionStated() const { return extrusion_.isKnown(); }
  bool isPositionRelative() const { return is_relative_; }
  bool isInInches() const { return unit_mm_ != 1.0; }
  double filament() const { return filament_; }  ///< value of E, where it is absolute
  double feed() const { return feed_; }          ///< [mm/min], 0 until stated

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
