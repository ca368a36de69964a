// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/reader/path_assembly.hpp"

#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "program/motion_values.hpp"

namespace lamina {
namespace {

constexpr double kSamePlace = 1e-3;  // mm: a few units of the last decimal

bool areSame(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) { return a.coeffs() == b.coeffs(); }

/// One orientation if it is that of all poses.
AlongPath<Eigen::Quaterniond> orientations(const std::vector<AssembledMove>& poses, std::size_t count) {
  std::vector<Eigen::Quaterniond> each;
  each.reserve(count);
  bool is_common = true;
  for (std::size_t i = 0; i < count; ++i) {
    each.push_back(poses[i].orientation);
    is_common &= areSame(each[i], each[0]);
  }
  if (is_common) return each.front();
  return AlongPath<Eigen::Quaterniond>(std::move(each));
}

}  // namespace

void PathAssembly::refuse(std::size_t line, const std::string& what) const {
  throw InvalidProgram("'" + file_ + "' line " + std::to_string(line) + ": " + what);
}

void PathAssembly::refuseOpen(const std::string& what) const {
  throw InvalidProgram("'" + open_file_ + "' line " + std::to_string(open_->line) + ": " + what);
}

void PathAssembly::begin(std::vector<PathNote> notes, const std::string& file) {
  notes_ = std::move(notes);
  file_ = file;
  note_ = moves_ = 0;
}

void PathAssembly::addNote(const PathNote& note, const std::string& file) {
  file_ = file;
  const bool is_whole = note_ == notes_.size();
  const std::size_t left = is_whole ? 0 : notes_[note_].moves - moves_;
  if (note.is_resumed) {
    if (note.moves != left)
      refuse(note.line, "a path is resumed for " + std::to_string(note.moves) + " moves; expected " +
                            std::to_string(left));
    return;
  }
  if (!is_whole)
    refuse(note.line, "a path begins while " + std::to_string(left) + " moves of that of line " +
                          std::to_string(notes_[note_].line) + " are to come; expected these");
  notes_.push_back(note);
}

void PathAssembly::add(const AssembledMove& move, ProcessState process, std::size_t line) {
  if (note_ == notes_.size())
    refuse(line,
           "a move of no path; expected a note '" + style_.mark + "path' with it before " + style_.place);
  if (moves_ == 0 && !notes_[note_].is_resumed) openPath(line);
  if (!open_) refuse(line, "a path is resumed; expected one before it");
  if (poses_.empty())
    addStart(move, process, line);
  else
    addMotion(move, process, line);
  last_ = poses_.back();
  if (++moves_ == notes_[note_].moves) ++note_, moves_ = 0;
}

void PathAssembly::openPath(std::size_t line) {
  closePath();
  open_ = notes_[note_];
  open_file_ = file_;
  poses_.clear();
  if (open_->is_turned) return;
  if (!last_) refuse(line, "the first move leads to the first path; expected a note with 'turned'");
  poses_.push_back(*last_);
}

void PathAssembly::addStart(const AssembledMove& move, ProcessState process, std::size_t line) {
  if (process == ProcessState::On) refuse(line, "the process is on while the tool takes its first pose");
  poses_.push_back(move);
  if (!last_) return;
  const double off_mm = (move.point - last_->point).norm();
  if (!(off_mm <= kSamePlace))
    refuse(line, "the tool moves by " + numberText(off_mm) + " mm where a path starts; expected a turn");
  poses_.back().point = last_->point;
}

void PathAssembly::addMotion(const AssembledMove& move, ProcessState process, std::size_t line) {
  const bool deposits = open_->role != PathRole::Travel;
  if (deposits != (process == ProcessState::On))
    refuse(line, std::string("the process is ") + (deposits ? "off" : "on") + " in a path that is " +
                     toString(open_->role) + "; expected it " + (deposits ? "on" : "off"));
  for (const std::string& name : open_->values)
    if (move.values.count(name) == 0)
      refuse(line, "no output gives '" + name + "' a value; expected one before the move");
  poses_.push_back(move);
}

void PathAssembly::addDwell(double duration_s, std::size_t line) {
  if (!open_ || poses_.empty()) refuse(line, "the tool waits before the first path; expected a move before");
  const std::size_t motion = poses_.size() - 1;
  if (!events_.empty() && events_.back().motion == motion)
    std::get<Dwell>(events_.back().event).duration_s += duration_s;
  else
    events_.push_back({motion, Dwell{duration_s}});
}

void PathAssembly::end(std::size_t line) {
  if (note_ != notes_.size())
    refuse(line, style_.whole + " ends amid the path of line " + std::to_string(notes_[note_].line) +
                     "; expected " + std::to_string(notes_[note_].moves) + " moves, found " +
                     std::to_string(moves_));
}

std::vector<Bead> PathAssembly::beads() const {
  const std::size_t motions = poses_.size() - 1;
  if (open_->role == PathRole::Travel && open_->beads.empty()) return std::vector<Bead>(motions);
  std::vector<Bead> each;
  for (const BeadRun& run : open_->beads) {
    if (run.motions > motions - each.size()) break;
    each.insert(each.end(), run.motions, run.bead);
  }
  if (each.size() != motions)
    refuseOpen("the notes of beads do not fit the path's " + std::to_string(motions) +
               " motions; expected one bead for each");
  return each;
}

std::vector<ProcessValue> PathAssembly::values(const Path& path) const {
  std::vector<ProcessValue> all;
  for (const std::string& name : open_->values) {
    std::vector<double> each;
    for (std::size_t i = 1; i < poses_.size(); ++i) each.push_back(poses_[i].values.at(name));
    all.push_back({name, perWaypoint(each, path.is_closed ? PathClosure::Closed : PathClosure::Open)});
  }
  return all;
}

void PathAssembly::closePath() {
  if (!open_) return;
  if (poses_.size() < 2) refuseOpen("a path has no motion; expected one at least");
  if (open_->layer) {
    program_.toolpath.layers.push_back(*open_->layer);
  } else if (program_.toolpath.layers.empty()) {
    refuseOpen("a path before the first layer; expected a note '" + style_.mark + "layer'");
  }
  Path path;
  path.role = open_->role;
  path.is_closed = open_->is_closed;
  path.process.is_retracted = open_->is_retracted;
  const PathClosure ends = path.is_closed ? PathClosure::Closed : PathClosure::Open;
  const bool returns = (poses_.back().point - poses_.front().point).norm() <= kSamePlace;
  if (path.is_closed && (poses_.size() < 3 || !returns))
    refuseOpen("a closed path does not return; expected it to end where it starts");
  path.bead = perWaypoint(beads(), ends);
  path.values = values(path);
  std::vector<double> feeds;
  for (std::size_t i = 1; i < poses_.size(); ++i) feeds.push_back(poses_[i].feed_mm_s);
  path.feed_mm_s = perWaypoint(feeds, ends);
  const std::size_t count = poses_.size() - (path.is_closed ? 1 : 0);
  for (std::size_t i = 0; i < count; ++i) path.points.push_back(poses_[i].point);
  path.orientation = orientations(poses_, count);
  // What follows starts where the path does, not at its return, which may differ in the last decimal.
  if (path.is_closed) last_->point = poses_.front().point;
  path.events = std::exchange(events_, {});
  addStations(count);
  program_.toolpath.layers.back().paths.push_back(std::move(path));
  open_.reset();
}

void PathAssembly::addStations(std::size_t waypoints) {
  const std::size_t layer = program_.toolpath.layers.size() - 1;
  const std::size_t path = program_.toolpath.layers.back().paths.size();
  for (std::size_t i = 0; i < poses_.size(); ++i)
    program_.stations.push_back({{layer, path, i % waypoints}, poses_[i]});
}

AssembledProgram PathAssembly::finish() {
  closePath();
  return std::move(program_);
}

}  // namespace lamina
