// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A number of consecutive motions with one bead.
struct BeadRun {
  Bead bead;
  std::size_t motions = 0;
};

/// What the notes of a robot's program state about a path, or about the rest of one.
struct PathNote {
  std::size_t line = 0;
  std::optional<ToolpathLayer> layer;  ///< the layer that begins with the path, without paths
  bool is_resumed = false;             ///< whether it continues the last path of the file or procedure before
  PathRole role = PathRole::Travel;
  bool is_closed = false;
  bool is_retracted = false;
  bool is_turned = false;
  std::size_t moves = 0;  ///< number of its moves in this file or procedure
  std::vector<BeadRun> beads;
  std::vector<std::string> values;  ///< names of the process values that the path has
};

/// Reads a note word by word.
class NoteWords {
 public:
  /// @param file  for errors; must outlive the object
  NoteWords(std::string_view text, std::size_t line, const std::string& file)
      : rest_(text), line_(line), file_(file) {}

  std::size_t line() const { return line_; }

  /// The next word; empty at the end.
  std::string_view next();

  /// Reads past a word if it comes next; returns whether it does.
  bool take(std::string_view word);

  template <class Number>
  Number number(const char* expected) {
    const std::string_view word = next();
    Number value{};
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_number = result.ec == std::errc{} && result.ptr == word.data() + word.size();
    if (!is_number) refuse(word, expected);
    return value;
  }

  /// Reads a length from 0 to 1 km [mm].
  double length(const char* expected);

  void expectEnd();

  /// @throws InvalidProgram naming file and line
  [[noreturn]] void refuse(std::string_view found, const std::string& expected) const;

 private:
  std::string_view rest_;
  std::size_t line_;
  const std::string& file_;
};

/// Collects the notes of paths.
class PathNotes {
 public:
  /// Reads one note of a path.
  /// @throws InvalidProgram naming file and line
  void read(NoteWords words);

  const std::vector<PathNote>& paths() const { return paths_; }
  /// Returns the notes collected so far, and removes them.
  std::vector<PathNote> take();

 private:
  std::vector<PathNote> paths_;
  std::optional<ToolpathLayer> layer_;
};

}  // namespace lamina
