// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/notes/path_notes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kLargestNote = 1e6;  // mm
constexpr const char* kCount = "a number of moves, 1 at least";

PathRole roleOf(std::string_view name, const NoteWords& words) {
  try {
    return pathRoleFromString(std::string(name));
  } catch (const InvalidInput&) {
    words.refuse(name, "the role of a path");
  }
}

PathNote pathNote(NoteWords& words) {
  PathNote note;
  note.role = roleOf(words.next(), words);
  note.is_closed = words.take("closed");
  if (!note.is_closed && !words.take("open")) words.refuse(words.next(), "open or closed");
  note.is_retracted = words.take("retracted");
  note.is_turned = words.take("turned");
  note.moves = words.number<std::size_t>(kCount);
  return note;
}

ToolpathLayer layerNote(NoteWords& words) {
  ToolpathLayer layer;
  layer.z_mm = words.number<double>("the height of a layer");
  if (!(std::abs(layer.z_mm) <= kLargestNote)) words.refuse(numberText(layer.z_mm), "the height of a layer");
  layer.height_mm = words.length("how high a layer is");
  return layer;
}

BeadRun beadNote(NoteWords& words) {
  BeadRun run;
  run.bead.width_mm = words.length("the width of a bead");
  run.bead.height_mm = words.length("the height of a bead");
  run.motions = words.number<std::size_t>("a number of motions");
  return run;
}

}  // namespace

std::string_view NoteWords::next() {
  while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
  const std::size_t end = std::min(rest_.find(' '), rest_.size());
  const std::string_view word = rest_.substr(0, end);
  rest_.remove_prefix(end);
  return word;
}

bool NoteWords::take(std::string_view word) {
  NoteWords ahead = *this;
  if (ahead.next() != word) return false;
  rest_ = ahead.rest_;
  return true;
}

double NoteWords::length(const char* expected) {
  const auto value = number<double>(expected);
  if (!(value >= 0.0 && value <= kLargestNote)) refuse(numberText(value), expected);
  return value;
}

void NoteWords::expectEnd() {
  const std::string_view word = next();
  if (!word.empty()) refuse(word, "nothing more in this note");
}

void NoteWords::refuse(std::string_view found, const std::string& expected) const {
  throw InvalidProgram("'" + file_ + "' line " + std::to_string(line_) + ": found '" + std::string(found) +
                       "'; expected " + expected);
}

void PathNotes::read(NoteWords words) {
  const std::string_view kind = words.next();
  if (kind == "layer") {
    layer_ = layerNote(words);
  } else if (kind == "path" || kind == "resumed") {
    PathNote note;
    note.is_resumed = kind == "resumed";
    if (note.is_resumed)
      note.moves = words.number<std::size_t>(kCount);
    else
      note = pathNote(words);
    if (note.moves == 0) words.refuse("0", kCount);
    note.line = words.line();
    note.layer.swap(layer_);
    paths_.push_back(std::move(note));
  } else if (kind == "bead") {
    if (paths_.empty() || paths_.back().is_resumed) words.refuse(kind, "a note of a path before its beads");
    paths_.back().beads.push_back(beadNote(words));
  } else if (kind == "value") {
    if (paths_.empty() || paths_.back().is_resumed) words.refuse(kind, "a note of a path before its values");
    const std::string name(words.next());
    std::vector<std::string>& values = paths_.back().values;
    if (name.empty() || std::find(values.begin(), values.end(), name) != values.end())
      words.refuse(name, "the name of a process value, each once");
    values.push_back(name);
  } else {
    words.refuse(kind, "layer, path, resumed, bead or value");
  }
  words.expectEnd();
}

std::vector<PathNote> PathNotes::take() { return std::exchange(paths_, {}); }

}  // namespace lamina
