// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/csv/csv_writer.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <set>
#include <string>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/program/program_frame.hpp"
#include "program/csv/event_field.hpp"
#include "program/gcode/layer_batches.hpp"
#include "toolpath/path_motions.hpp"

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

/// Columns beyond those that every toolpath has.
struct Columns {
  bool deposit = false;
  bool tool = false;
  bool events = false;
  std::set<std::string> values;

  std::string header() const {
    std::string text = kCsvHeader;
    if (deposit) text += ",deposit";
    if (tool) text += ",tool";
    if (events) text += ",events";
    for (const std::string& name : values) text += "," + name;
    return text + "\n";
  }
};

void requireColumnName(const std::string& name) {
  const auto isPlain = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  if (!std::all_of(name.begin(), name.end(), isPlain) || name == "deposit" || name == "tool" ||
      name == "events")
    throw InvalidInput("process value '" + name +
                       "' cannot be a column of CSV; expected letters, digits and '_'");
}

Columns columnsOf(const Toolpath& toolpath) {
  Columns columns;
  columns.events = !toolpath.events_at_end.empty();
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) {
      columns.deposit |= path.deposit == Deposit::Drops;
      columns.tool |= path.tool != 0;
      columns.events |= !path.events.empty();
      for (const ProcessValue& value : path.values) columns.values.insert(value.name);
    }
  for (const std::string& name : columns.values) requireColumnName(name);
  return columns;
}

/// The rows of one path. What is the same in all of them is formatted once.
class PathRows {
 public:
  /// @param events_behind  the path, besides its own
  PathRows(std::size_t layer, std::size_t index, const Path& path, const Columns& columns,
           const std::vector<ToolpathEvent>& events_behind)
      : path_(path), columns_(columns), events_behind_(events_behind) {
    appendNumber(begin_, layer);
    begin_ += ',';
    appendNumber(begin_, index);
    begin_ += ',';
    begin_ += toString(path.role);
    begin_ += path.is_closed ? ",1," : ",0,";
    if (isCommon()) appendEnd(end_, 0);
  }

  void append(std::string& text) const {
    for (std::size_t i = 0; i < path_.points.size(); ++i) appendRow(text, i, i);
    if (path_.is_closed) appendRow(text, 0, path_.points.size());
  }

 private:
  bool isCommon() const {
    return path_.orientation.isCommon() && path_.bead.isCommon() && path_.feed_mm_s.isCommon();
  }

  /// @param row  from 0; its motion is the one before it
  void appendRow(std::string& text, std::size_t waypoint, std::size_t row) const {
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
    if (columns_.events) appendEvents(text, row);
    for (const std::string& name : columns_.values) appendValue(text, name, waypoint);
    text += '\n';
  }

  void appendEvents(std::string& text, std::size_t row) const {
    std::string field;
    const auto append = [&field](const char* place, const ToolpathEvent& event) {
      field += (field.empty() ? "" : "|") + std::string(place) + toField(event);
    };
    const bool is_last = row == path_.motionCount();
    if (row > 0)
      for (const PathEvent& placed : eventsBefore(path_.events, row - 1)) append("", placed.event);
    if (is_last)
      for (const PathEvent& placed : eventsBefore(path_.events, row)) append("after:", placed.event);
    if (is_last)
      for (const ToolpathEvent& event : events_behind_) append("after:", event);
    text.append(",").append(field);
  }

  void appendValue(std::string& text, const std::string& name, std::size_t waypoint) const {
    text += ',';
    for (const ProcessValue& value : path_.values)
      if (value.name == name) appendNumber(text, value.value.at(waypoint));
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
    if (columns_.deposit) text.append(",").append(toString(path_.deposit));
    if (columns_.tool) text.append(",").append(std::to_string(path_.tool));
  }

  const Path& path_;
  const Columns& columns_;
  const std::vector<ToolpathEvent>& events_behind_;
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
  const Columns columns = columnsOf(toolpath);
  sink(frameComment(toolpath));
  sink(columns.header());
  const std::vector<ToolpathEvent> none;
  const Path* const last = lastPath(toolpath);
  const auto append = [&](std::size_t l, std::string& text) {
    const auto& paths = toolpath.layers[l].paths;
    for (std::size_t p = 0; p < paths.size(); ++p)
      PathRows(l, p, paths[p], columns, &paths[p] == last ? toolpath.events_at_end : none).append(text);
  };
  writeLayers(toolpath, append, sink);
}

}  // namespace lamina
