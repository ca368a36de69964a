// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "lamina/program/gcode/gcode_line.hpp"
#include "lamina/program/gcode/gcode_reader.hpp"
#include "program/gcode/slicer_comments.hpp"

namespace lamina {

/// The words of one line, by letter.
class WordTable {
 public:
  /// @throws InvalidProgram if a letter other than G and M occurs twice
  explicit WordTable(const GcodeLine& line);

  bool has(char letter) const { return isSet(letter); }
  bool hasAny(std::string_view letters) const;
  /// @throws InvalidProgram if the word is absent or has no value
  double value(char letter) const;
  double valueOr(char letter, double otherwise) const { return has(letter) ? value(letter) : otherwise; }

 private:
  bool isSet(char letter) const { return (present_ >> (letter - 'A') & 1U) != 0; }

  std::size_t line_;
  unsigned present_ = 0;
  unsigned valued_ = 0;
  std::array<double, 26> values_{};
};

/// The modal state of a program, which each line read changes.
class GcodeInterpreter {
 public:
  GcodeInterpreter(GcodeReaderSettings settings, GcodeHandlers handlers);

  /// Interprets a line.
  /// @throws InvalidProgram
  void readLine(std::string_view text, std::size_t number);

 private:
  enum class Mode { Absolute, Relative };

  /// Interprets a command that only changes modes; returns false for any command that uses the other words of
  /// its line.
  bool setMode(const GcodeWord& word);
  void run(int command, const WordTable& words);
  void move(int command, const WordTable& words);
  void moveStraight(const Point3& target, double extrusion_mm);
  void moveAlongArc(int command, const Point3& target, double extrusion_mm, const WordTable& words);
  void setPosition(const WordTable& words);
  void home(const WordTable& words);
  void dwell(const WordTable& words) const;

  Point3 targetOf(const WordTable& words) const;
  double extrusionOf(const WordTable& words);
  Point3 centreOf(int command, const Point3& target, const WordTable& words) const;
  void emit(const Point3& end, double extrusion_mm);
  [[noreturn]] void refuse(const std::string& what) const;

  GcodeReaderSettings settings_;
  GcodeHandlers handlers_;
  GcodeLineParser parser_;
  SlicerContext context_;
  std::size_t line_ = 0;

  Point3 position_ = Point3::Zero();              ///< of the machine [mm]
  std::array<bool, 3> is_stated_{};               ///< whether the position is stated, by axis
  Point3 machine_from_program_ = Point3::Zero();  ///< shift set by G92 [mm]
  double filament_mm_ = 0.0;                      ///< E as the program counts it
  double feed_mm_s_;
  double unit_mm_ = 1.0;
  Mode position_mode_ = Mode::Absolute;
  Mode filament_mode_ = Mode::Absolute;
  bool is_filament_mode_stated_ = false;  ///< by M82 or M83
  int motion_ = -1;  ///< mode of lines that have coordinates alone; -1 before the first motion
  int arc_axis_ = 2;
};

}  // namespace lamina
