// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/rapid/reader/rapid_assembly.hpp"

#include "lamina/base/error.hpp"
#include "program/motion_values.hpp"

namespace lamina {
namespace {

constexpr double kSamePlace = 1e-3;  // mm: a few units of the last decimal

bool areSame(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) { return a.coeffs() == b.coeffs(); }

/// One orientation if it is that of all poses.
AlongPath<Eigen::Quaterniond> orientations(const std::vector<RapidMove>& poses, std::size_t count) {
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

void RapidAssembly::refuse(std::size_t line, const std::string& what) const {
  throw InvalidProgram("'" + file_ + "' line " + std::to_string(line) + ": " + what);
}

void RapidAssembly::begin(std::vector<PathNote> notes, const std::string& file) {
  notes_ = std::move(notes);
  file_ = file;
  note_ = moves_ = 0;
}

void RapidAssembly::add(const RapidMove& move, ProcessState process, std::size_t line) {
  if (note_ == notes_.size())
    refuse(line, "a move of no path; expected a note '!# path' with it before the procedure");
  if (moves_ == 0 && !notes_[note_].is_resumed) openPath(line);
  if (!open_) refuse(line, "a path is resumed; expected one before it");
  if (poses_.empty())
    addStart(move, process, line);
  else
    addMotion(move, process, line);
  last_ = poses_.back();
  if (++moves_ == notes_[note_].moves) ++note_, moves_ = 0;
}

void RapidAssembly::openPath(std::size_t line) {
  closePath();
  open_ = notes_[note_];
  open_file_ = file_;
  poses_.clear();
  if (open_->is_turned) return;
  if (!last_) refuse(line, "the first move leads to the first path; expected a note with 'turned'");
  poses_.push_back(*last_);
}

void RapidAssembly::addStart(const RapidMove& move, ProcessState process, std::size_t line) {
  if (process == ProcessState::On) refuse(line, "the process is on while the tool takes its first pose");
  poses_.push_back(move);
  if (!last_) return;
  const double off_mm = (move.point - last_->point).norm();
  if (!(off_mm <= kSamePlace))
    refuse(line, "the tool moves by " + std::to_string(off_mm) + " mm where a path starts; expected a turn");
  poses_.back().point = last_->point;
}

void RapidAssembly::addMotion(const RapidMove& move, ProcessState process, std::size_t line) {
  const bool deposits = open_->role != PathRole::Travel;
  if (deposits != (process == ProcessState::On))
    refuse(line, std::string("the process is ") + (deposits ? "off" : "on") + " in a path that is " +
                     toString(open_->role) + "; expected it " + (deposits ? "on" : "off"));
  poses_.push_back(move);
}

void RapidAssembly::end(std::size_t line) {
  if (note_ != notes_.size())
    refuse(line, "the procedure ends amid the path of line " + std::to_string(notes_[note_].line) +
                     "; expected " + std::to_string(notes_[note_].moves) + " moves, found " +
                     std::to_string(moves_));
}

std::vector<Bead> RapidAssembly::beads() const {
  const std::size_t motions = poses_.size() - 1;
  if (open_->role == PathRole::Travel && open_->beads.empty()) return std::vector<Bead>(motions);
  std::vector<Bead> each;
  for (const BeadRun& run : open_->beads) {
    if (run.motions > motions - each.size()) break;
    each.insert(each.end(), run.motions, run.bead);
  }
  if (each.size() != motions)
    throw InvalidProgram("'" + open_file_ + "' line " + std::to_string(open_->line) +
                         ": the notes of beads do not fit the path's " + std::to_string(motions) +
                         " motions; expected one bead for each");
  return each;
}

void RapidAssembly::closePath() {
  if (!open_) return;
  const auto refuseOpen = [&](const std::string& what) {
    throw InvalidProgram("'" + open_file_ + "' line " + std::to_string(open_->line) + ": " + what);
  };
  if (poses_.size() < 2) refuseOpen("a path has no motion; expected one at least");
  if (open_->layer) {
    toolpath_.layers.push_back(*open_->layer);
  } else if (toolpath_.layers.empty()) {
    refuseOpen("a path before the first layer; expected a note '!# layer'");
  }
  Path path;
  path.role = open_->role;
  path.is_closed = open_->is_closed;
  path.process.is_retracted = open_->is_retracted;
  const PathEnds ends = path.is_closed ? PathEnds::Closed : PathEnds::Open;
  const bool returns = (poses_.back().point - poses_.front().point).norm() <= kSamePlace;
  if (path.is_closed && (poses_.size() < 3 || !returns))
    refuseOpen("a closed path does not return; expected it to end where it starts");
  path.bead = perWaypoint(beads(), ends);
  std::vector<double> feeds;
  for (std::size_t i = 1; i < poses_.size(); ++i) feeds.push_back(poses_[i].feed_mm_s);
  path.feed_mm_s = perWaypoint(feeds, ends);
  const std::size_t count = poses_.size() - (path.is_closed ? 1 : 0);
  for (std::size_t i = 0; i < count; ++i) path.points.push_back(poses_[i].point);
  path.orientation = orientations(poses_, count);
  // What follows starts where the path does, not at its return, which may differ in the last decimal.
  if (path.is_closed) last_->point = poses_.front().point;
  toolpath_.layers.back().paths.push_back(std::move(path));
  open_.reset();
}

Toolpath RapidAssembly::finish() {
  closePath();
  return std::move(toolpath_);
}

}  // namespace lamina
