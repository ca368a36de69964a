// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/program/drops/drop_program.hpp"
#include "program/gcode/fixed_point.hpp"

namespace lamina {
namespace {

void requireWritable(const InsertionPoint& end) {
  const std::string where = "line " + std::to_string(end.line) + ": ";
  if (!end.is_absolute)
    throw InvalidProgram(where +
                         "coordinates are relative (G91) where drops would be added; must be absolute");
  if (!end.is_shift_known)
    throw InvalidProgram(where + "coordinates were shifted (G92, G28) and not stated since");
  if (end.motion.empty())
    throw InvalidProgram(where + "arcs (G2, G3) hold where drops would be added; must be straight motions");
}

class LayerInsertion {
 public:
  LayerInsertion(const DropProgramLayer& layer, const DropDialect& dialect, std::string line_end)
      : layer_(layer), line_end_(std::move(line_end)), command_(layer.drops.back().command) {
    requireWritable(layer.end);
    for (const ProgramDrop& drop : layer.drops)
      if (drop.role == PathRole::Infill) command_ = drop.command;
    addLine(";" + dialect.role_mark + dialect.void_fill);
  }

  std::string lines(const std::vector<Point2>& drops) && {
    for (const Point2& drop : drops) {
      addMotion(drop);
      addLine(command_);
    }
    addMotion(layer_.drops.back().position.head<2>());
    if (!layer_.end.role_comment.empty()) addLine(layer_.end.role_comment);
    return std::move(text_);
  }

 private:
  void addLine(const std::string& line) { text_.append(line).append(line_end_); }

  void addMotion(const Point2& target) {
    const Point2 written = (target - layer_.end.shift) / layer_.end.unit_mm;
    addLine(layer_.end.motion + " X" + decimal(written.x()) + " Y" + decimal(written.y()));
  }

  static std::string decimal(double value) {
    char digits[32];
    return {digits, writeFixed<5>(digits, toUnits(value, 1e5))};
  }

  const DropProgramLayer& layer_;
  std::string line_end_;
  std::string command_;
  std::string text_;
};

}  // namespace

std::string withDrops(const DropProgram& program, const std::vector<std::vector<Point2>>& added,
                      const DropDialect& dialect) {
  if (added.size() > program.layers.size())
    throw InvalidInput("drops are given for " + std::to_string(added.size()) +
                       " layers; expected at most the " + std::to_string(program.layers.size()) +
                       " of the program");
  const std::string_view text = program.text;
  std::string result;
  std::size_t copied = 0;
  for (std::size_t l = 0; l < added.size(); ++l) {
    if (added[l].empty()) continue;
    const DropProgramLayer& layer = program.layers[l];
    const std::string_view before = text.substr(0, layer.end.offset);
    const bool is_crlf = before.size() > 1 && before.substr(before.size() - 2) == "\r\n";
    result.append(text.substr(copied, layer.end.offset - copied));
    if (before.back() != '\n') result += '\n';
    result += LayerInsertion(layer, dialect, is_crlf ? "\r\n" : "\n").lines(added[l]);
    copied = layer.end.offset;
  }
  return result.append(text.substr(copied));
}

}  // namespace lamina
