// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/drops/drop_program.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/program/gcode/gcode_line.hpp"
#include "lamina/program/gcode/gcode_reader.hpp"
#include "lamina/program/program_frame.hpp"
#include "program/stated_height.hpp"

namespace lamina {
namespace {

bool takePrefix(std::string_view& text, const std::string& prefix) {
  if (prefix.empty() || text.substr(0, prefix.size()) != prefix) return false;
  text.remove_prefix(prefix.size());
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  return true;
}

/// How coordinates are written where the program is being read.
class CoordinateState {
 public:
  void read(const GcodeLine& line, const std::optional<Point3>& reached) {
    std::optional<double> x;
    std::optional<double> y;
    bool may_shift = false;
    bool names_axes = false;
    for (const GcodeWord& word : line.words) {
      if (word.letter == 'X') x = word.value;
      if (word.letter == 'Y') y = word.value;
      if (word.letter == 'G' && word.value) may_shift |= takeCommand(*word.value);
      names_axes |= word.letter == 'X' || word.letter == 'Y' || word.letter == 'Z' || word.letter == 'E';
    }
    if (may_shift) return forget(x || !names_axes, y || !names_axes);
    if (!reached || !end.is_absolute) return;
    if (x) end.shift.x() = reached->x() - *x * end.unit_mm;
    if (y) end.shift.y() = reached->y() - *y * end.unit_mm;
    knows_x_ |= x.has_value();
    knows_y_ |= y.has_value();
    end.is_shift_known = knows_x_ && knows_y_;
  }

  InsertionPoint end;

 private:
  /// @return true if it shifts coordinates
  bool takeCommand(double code) {
    if (code == 90.0 || code == 91.0) end.is_absolute = code == 90.0;
    if (code == 20.0 || code == 21.0) end.unit_mm = code == 20.0 ? 25.4 : 1.0;
    if (code == 0.0 || code == 1.0) end.motion = code == 0.0 ? "G0" : "G1";
    if (code == 2.0 || code == 3.0) end.motion.clear();
    return code == 92.0 || code == 28.0;
  }

  void forget(bool x, bool y) {
    knows_x_ &= !x;
    knows_y_ &= !y;
    end.is_shift_known = knows_x_ && knows_y_;
  }

  bool knows_x_ = false;
  bool knows_y_ = false;
};

class DropParser {
 public:
  DropParser(std::string text, const DropDialect& dialect) : dialect_(dialect), reader_({}, handlers()) {
    program_.text = std::move(text);
    has_layer_marks_ = program_.text.find(";" + dialect.layer_mark) != std::string::npos;
    is_in_part_ = !has_layer_marks_;
  }

  DropProgram parse() && {
    const std::string_view text = program_.text;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
      readLine(text.substr(begin, end - begin), end);
      begin = end;
    }
    return std::move(program_);
  }

 private:
  GcodeHandlers handlers() {
    GcodeHandlers handlers;
    handlers.motion = [this](const GcodeMotion& motion) {
      reached_ = motion.end;
      feed_mm_s_ = motion.feed_mm_s;
      height_mm_ = motion.height_mm;
    };
    handlers.other = [this](std::size_t, std::string_view command) {
      if (isDischarge(command, dialect_)) command_ = command;
      if (command == "G28") reached_.reset();
    };
    return handlers;
  }

  void readLine(std::string_view line, std::size_t end) {
    ++number_;
    command_.clear();
    reader_.read(line);
    if (line.back() != '\n') reader_.finish();
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.remove_suffix(1);
    const GcodeLine& parts = parser_.parse(line, number_);
    for (const std::string_view comment : parts.comments) readComment(comment);
    state_.read(parts, reached_);
    if (!command_.empty()) addDrop(end);
  }

  void readComment(std::string_view comment) {
    const std::string_view whole = comment;
    if (takePrefix(comment, dialect_.layer_mark)) {
      is_in_part_ = true;
      is_new_layer_ = true;
    } else if (takePrefix(comment, dialect_.role_mark)) {
      role_ = roleOf(comment, dialect_);
      state_.end.role_comment = ";" + std::string(whole);
      ++section_;
    } else if (whole == "end of the part") {
      is_in_part_ = false;
    } else if (program_.layers.empty()) {
      readHeader(comment);
    }
  }

  void readHeader(std::string_view comment) {
    if (StatedFrame frame; readFrameComment(comment, frame))
      refuse("drops on inclined layers; programs of drops are understood on level ones");
    if (takePrefix(comment, dialect_.diameter_key + "=")) program_.diameter_mm = positive(comment);
    if (takePrefix(comment, dialect_.height_key + "=")) program_.layer_height_mm = positive(comment);
    if (takePrefix(comment, dialect_.strategy_key + "=")) program_.strategy = comment;
    if (takePrefix(comment, dialect_.units_key + "=") && comment != "mm")
      refuse("the unit of the header is '" + std::string(comment) + "'; must be mm");
  }

  void addDrop(std::size_t end) {
    if (!is_in_part_) return;
    if (!reached_) refuse("a drop before any motion; where it falls is not known");
    const bool rises = !program_.layers.empty() && std::abs(program_.layers.back().drops.back().position.z() -
                                                            reached_->z()) > kSameStatedHeight;
    if (program_.layers.empty() || is_new_layer_ || (!has_layer_marks_ && rises))
      program_.layers.emplace_back();
    is_new_layer_ = false;
    DropProgramLayer& layer = program_.layers.back();
    layer.drops.push_back({*reached_, feed_mm_s_, role_, section_, command_});
    layer.height_mm = height_mm_;
    layer.end = state_.end;
    layer.end.offset = end;
    layer.end.line = number_;
  }

  double positive(std::string_view text) const {
    double value = 0.0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc{} || !(value > 0.0 && value < 1e3))
      refuse("the header has '" + std::string(text) + "'; must be a positive length in mm");
    return value;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw InvalidProgram("line " + std::to_string(number_) + ": " + what);
  }

  DropDialect dialect_;
  DropProgram program_;
  GcodeReader reader_;
  GcodeLineParser parser_;
  CoordinateState state_;
  std::size_t number_ = 0;
  std::string command_;  ///< of the drop in the line being read
  std::optional<Point3> reached_;
  double feed_mm_s_ = 0.0;
  std::optional<double> height_mm_;
  std::optional<PathRole> role_;
  std::size_t section_ = 0;
  bool has_layer_marks_ = false;
  bool is_in_part_ = false;
  bool is_new_layer_ = false;
};

}  // namespace

bool isDropProgram(std::string_view text, const DropDialect& dialect) {
  if (text.find(";" + dialect.diameter_key + "=") != std::string_view::npos) return true;
  for (std::size_t at = text.find(dialect.discharge); at != std::string_view::npos;
       at = text.find(dialect.discharge, at + 1)) {
    const std::string_view line = text.substr(at, std::min(text.find('\n', at), text.size()) - at);
    const std::string_view command = line.substr(0, line.find_first_of(";\r"));
    if ((at == 0 || text[at - 1] == '\n') && isDischarge(command, dialect)) return true;
  }
  return false;
}

DropProgram parseDropProgram(std::string text, const DropDialect& dialect) {
  return DropParser(std::move(text), dialect).parse();
}

}  // namespace lamina
