// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/rapid/reader/rapid_path_notes.hpp"

#include <charconv>
#include <cmath>

#include "lamina/base/error.hpp"
#include "program/rapid/rapid_words.hpp"
#include "program/rapid/writer/rapid_notes.hpp"

namespace lamina {
namespace {

constexpr double kLargestNote = 1e6;  // mm

/// The words of one note.
class NoteWords {
 public:
  NoteWords(std::string_view text, std::size_t line, const std::string& file)
      : rest_(text), line_(line), file_(file) {}

  std::string_view next() {
    while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
    const std::size_t end = std::min(rest_.find(' '), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return word;
  }

  bool take(std::string_view word) {
    NoteWords ahead = *this;
    if (ahead.next() != word) return false;
    rest_ = ahead.rest_;
    return true;
  }

  template <class Number>
  Number number(const char* expected) {
    const std::string_view word = next();
    Number value{};
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_number = result.ec == std::errc{} && result.ptr == word.data() + word.size();
    if (!is_number) refuse(word, expected);
    return value;
  }

  double length(const char* expected) {
    const double value = number<double>(expected);
    if (!(value >= 0.0 && value <= kLargestNote)) refuse(std::to_string(value), expected);
    return value;
  }

  void expectEnd() {
    const std::string_view word = next();
    if (!word.empty()) refuse(word, "nothing more in this note");
  }

  [[noreturn]] void refuse(std::string_view found, const std::string& expected) const {
    throw InvalidProgram("'" + file_ + "' line " + std::to_string(line_) + ": found '" + std::string(found) +
                         "'; expected " + expected);
  }

 private:
  std::string_view rest_;
  std::size_t line_;
  const std::string& file_;
};

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
  if (!(std::abs(layer.z_mm) <= kLargestNote))
    words.refuse(std::to_string(layer.z_mm), "the height of a layer");
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

/// The text after the note's mark; nothing if it is no note.
std::optional<std::string_view> noteText(const RapidComment& comment) {
  const std::string_view mark = kRapidNote.substr(1);  // the comment is without its exclamation mark
  if (comment.text.substr(0, mark.size()) != mark) return std::nullopt;
  return comment.text.substr(mark.size());
}

/// Takes in one note of a path.
void readNote(NoteWords& words, std::size_t line, std::optional<ToolpathLayer>& layer,
              std::vector<PathNote>& notes) {
  const std::string_view kind = words.next();
  if (kind == "layer") {
    layer = layerNote(words);
  } else if (kind == "path" || kind == "resumed") {
    PathNote note;
    note.is_resumed = kind == "resumed";
    if (note.is_resumed)
      note.moves = words.number<std::size_t>(kCount);
    else
      note = pathNote(words);
    if (note.moves == 0) words.refuse("0", kCount);
    note.line = line;
    note.layer.swap(layer);
    notes.push_back(std::move(note));
  } else if (kind == "bead") {
    if (notes.empty() || notes.back().is_resumed) words.refuse(kind, "a note of a path before its beads");
    notes.back().beads.push_back(beadNote(words));
  } else {
    words.refuse(kind, "layer, path, resumed or bead");
  }
  words.expectEnd();
}

}  // namespace

std::vector<PathNote> readPathNotes(const std::vector<RapidComment>& comments, const std::string& file) {
  std::vector<PathNote> notes;
  std::optional<ToolpathLayer> layer;
  for (const RapidComment& comment : comments) {
    const auto text = noteText(comment);
    if (!text) continue;
    NoteWords words(*text, comment.line, file);
    readNote(words, comment.line, layer, notes);
  }
  return notes;
}

std::vector<std::string> readModuleNotes(const std::vector<RapidComment>& comments, const std::string& file) {
  std::vector<std::string> names;
  for (const RapidComment& comment : comments) {
    const auto text = noteText(comment);
    if (!text) continue;
    NoteWords words(*text, comment.line, file);
    if (!words.take("module")) continue;
    names.emplace_back(words.next());
    try {
      requireRapidName("a module", names.back());
    } catch (const InvalidConfig&) {
      words.refuse(names.back(), "the name of a module");
    }
  }
  return names;
}

}  // namespace lamina
