// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/csv/csv_writer.hpp"

#include <algorithm>
#include <charconv>
#include <string>

#include "lamina/program/program_frame.hpp"
#include "program/gcode/layer_batches.hpp"

namespace lamina {
namespace {

constexpr std::size_t kNumberRoom = 32;

void appendNumber(std::string& text, double value) {
  char digits[kNumberRoom];
  text.append(digits, std::to_chars(digits, digits + kNumberRoom, value).ptr);
}

void appendNumber(std::string& text, std::size_t value) {
  char digits[kNumberRoom];
  text.append(digits, std::to_chars(digits, digits + kNumberRoom, value).ptr);
}

void appendOrientation(std::string& text, const Eigen::Quaterniond& q) {
  for (const double part : {q.w(), q.x(), q.y(), q.z()}) {
    text += ',';
    appendNumber(text, part);
  }
}

enum class DepositColumn { No, Yes };

bool laysDrops(const Toolpath& toolpath) {
  return std::any_of(toolpath.layers.begin(), toolpath.layers.end(), [](const ToolpathLayer& layer) {
    return std::any_of(layer.paths.begin(), layer.paths.end(),
                       [](const Path& path) { return path.deposit == Deposit::Drops; });
  });
}

/// The rows of one path. What is the same in all of them is formatted once.
class PathRows {
 public:
  PathRows(std::size_t layer, std::size_t index, const Path& path, DepositColumn column)
      : path_(path), column_(column) {
    appendNumber(begin_, layer);
    begin_ += ',';
    appendNumber(begin_, index);
    begin_ += ',';
    begin_ += toString(path.role);
    begin_ += path.is_closed ? ",1," : ",0,";
    if (isCommon()) appendEnd(end_, 0);
  }

  void append(std::string& text) const {
    for (std::size_t i = 0; i < path_.points.size(); ++i) appendRow(text, i);
    if (path_.is_closed) appendRow(text, 0);
  }

 private:
  bool isCommon() const {
    return path_.orientation.isCommon() && path_.bead.isCommon() && path_.feed_mm_s.isCommon();
  }

  void appendRow(std::string& text, std::size_t waypoint) const {
    const Point3& point = path_.points[waypoint];
    text += begin_;
    appendNumber(text, point.x());
    text += ',';
    appendNumber(text, point.y());
    text += ',';
    appendNumber(text, point.z());
    if (isCommon())
      text += end_;
    else
      appendEnd(text, waypoint);
  }

  void appendEnd(std::string& text, std::size_t waypoint) const {
    const Bead& bead = path_.bead.at(waypoint);
    appendOrientation(text, path_.orientation.at(waypoint));
    text += ',';
    appendNumber(text, path_.role == PathRole::Travel ? 0.0 : bead.width_mm);
    text += ',';
    appendNumber(text, bead.height_mm);
    text += ',';
    appendNumber(text, path_.feed_mm_s.at(waypoint));
    if (column_ == DepositColumn::Yes) text.append(",").append(toString(path_.deposit));
    text += '\n';
  }

  const Path& path_;
  DepositColumn column_;
  std::string begin_;
  std::string end_;
};

/// Empty for level layers.
std::string frameComment(const Toolpath& toolpath) {
  StatedFrame frame;
  frame.bed_from_layers = toolpath.part_from_layers;
  std::string comment = frameComments(frame);
  if (!comment.empty()) comment.front() = '#';
  return comment;
}

}  // namespace

void writeCsv(const Toolpath& toolpath, const TextSink& sink) {
  validate(toolpath);
  const DepositColumn column = laysDrops(toolpath) ? DepositColumn::Yes : DepositColumn::No;
  sink(frameComment(toolpath));
  sink(std::string(column == DepositColumn::Yes ? kDropCsvHeader : kCsvHeader) + "\n");
  const auto append = [&toolpath, column](std::size_t l, std::string& text) {
    const auto& paths = toolpath.layers[l].paths;
    for (std::size_t p = 0; p < paths.size(); ++p) PathRows(l, p, paths[p], column).append(text);
  };
  writeLayers(toolpath, append, sink);
}

}  // namespace lamina
