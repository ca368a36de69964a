// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/notes/robot_notes.hpp"

#include <algorithm>
#include <utility>

#include "base/decimals.hpp"
#include "lamina/geometry/vector.hpp"

namespace lamina {
namespace {

constexpr std::string_view kFirst = "# ";
constexpr std::string_view kFurther = "#+ ";
constexpr int kFrameDecimals = 6;  // mm: people type these numbers into controllers
constexpr int kTurnDecimals = 9;
constexpr std::size_t kMostNote = 100000;  // characters: no note of ours comes near

void appendBeads(const Path& path, std::vector<std::string>& notes) {
  const std::size_t motions = path.motionCount();
  for (std::size_t begin = 0; begin < motions;) {
    const Bead& bead = path.bead.at(path.motionEnd(begin));
    std::size_t end = path.bead.isCommon() ? motions : begin + 1;
    while (end < motions && path.bead.at(path.motionEnd(end)) == bead) ++end;
    notes.push_back("bead " + shortestText(bead.width_mm) + " " + shortestText(bead.height_mm) + " " +
                    std::to_string(end - begin));
    begin = end;
  }
}

}  // namespace

std::vector<std::string> noteComments(std::string_view note, std::string_view lead, std::size_t width) {
  std::vector<std::string> comments;
  std::string line(kFirst);
  bool is_empty = true;
  while (!note.empty()) {
    const std::size_t end = std::min(note.find(' '), note.size());
    const std::string_view word = note.substr(0, end);
    note.remove_prefix(std::min(end + 1, note.size()));
    if (!is_empty && line.size() + 1 + word.size() > width) {
      comments.push_back(std::string(lead) + line);
      line = kFurther;
      is_empty = true;
    }
    if (!is_empty) line += ' ';
    line += word;
    is_empty = false;
  }
  comments.push_back(std::string(lead) + line);
  return comments;
}

bool NoteGathering::continuesNote(std::string_view comment) {
  return comment.substr(0, kFurther.size()) == kFurther;
}

bool NoteGathering::add(std::string_view comment, std::size_t line) {
  const bool goes_on = continuesNote(comment);
  if (!goes_on && comment.substr(0, kFirst.size()) != kFirst) return false;
  comment.remove_prefix(goes_on ? kFurther.size() : kFirst.size());
  if (!goes_on) {
    text_ = std::string(comment);
    line_ = line;
  } else if (text_.size() < kMostNote) {
    text_.append(" ").append(comment);
  }
  return true;
}

std::string NoteGathering::take() { return std::exchange(text_, {}); }

std::vector<std::string> pathNotes(const Toolpath& toolpath, const RobotPath& path, bool begins_layer,
                                   double rise_mm) {
  std::vector<std::string> notes;
  const ToolpathLayer& layer = toolpath.layers[path.layer];
  if (begins_layer)
    notes.push_back("layer " + shortestText(layer.z_mm + rise_mm) + " " + shortestText(layer.height_mm));
  notes.push_back(std::string("path ") + toString(path.path->role) +
                  (path.path->is_closed ? " closed" : " open") +
                  (path.path->process.is_retracted ? " retracted" : "") + (path.is_turned ? " turned" : "") +
                  " " + std::to_string(path.moveCount()));
  if (!path.deposits()) return notes;
  appendBeads(*path.path, notes);
  for (const ProcessValue& value : path.path->values) notes.push_back("value " + value.name);
  return notes;
}

std::string frameNote(std::string_view name, const Eigen::Isometry3d& frame) {
  Eigen::Quaterniond q(frame.linear());
  if (q.w() < 0.0) q.coeffs() *= -1.0;
  const Point3 at = frame.translation();
  std::string text(name);
  for (const double number : {at.x(), at.y(), at.z()}) text += " " + trimmedDecimals(number, kFrameDecimals);
  for (const double number : {q.w(), q.x(), q.y(), q.z()})
    text += " " + trimmedDecimals(number, kTurnDecimals);
  return text;
}

}  // namespace lamina
