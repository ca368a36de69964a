// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
#include <string>

namespace lamina {

/// A line of a program as it goes to the machine: no comment, no blanks around it, never empty.
struct ProgramLine {
  std::string command;
  std::int32_t layer =
      -1;  ///< it belongs to, as reported by ";LAYER:k" or ";LAYER_CHANGE"; -1 before the first
};

/// The commands of a G-code text one by one, in constant memory. Comments (from ';' on, and in parentheses
/// where the command is not one that carries text) and empty lines are left out.
class ProgramCursor {
 public:
  explicit ProgramCursor(std::unique_ptr<std::istream> text) : text_(std::move(text)) {}

  /// The next command; nothing at the end.
  std::optional<ProgramLine> next();
  /// Line of the text that the last command stood on, from 1.
  std::uint64_t textLine() const { return text_line_; }

 private:
  void readComment(std::string_view comment);

  std::unique_ptr<std::istream> text_;
  std::string raw_;
  std::uint64_t text_line_ = 0;
  std::int32_t layer_ = -1;
};

/// A program that was checked whole and can be streamed: every command is short enough, ASCII, without a line
/// number or checksum of its own, and leaves the numbering of lines alone. It is read again, line by line,
/// while it is sent.
class StreamableProgram {
 public:
  /// @param max_line_bytes  the longest framed line the firmware takes
  /// @throws FileError if the file cannot be read
  /// @throws InvalidProgram naming the line, or if there is no command at all
  static StreamableProgram fromFile(const std::string& path, int max_line_bytes);
  static StreamableProgram fromText(const std::string& name, std::string text, int max_line_bytes);

  const std::string& name() const { return name_; }
  /// Commands in it.
  std::uint64_t lines() const { return lines_; }
  /// @throws FileError if the file is gone
  ProgramCursor open() const;
  /// Whether the file is no longer the one that was checked: written to, cut, replaced or gone.
  bool hasChanged() const;

 private:
  /// Distinguishes one state of a file from another.
  struct FileState {
    std::uint64_t inode = 0;
    std::int64_t bytes = 0;
    std::int64_t modified_ns = 0;
    bool operator==(const FileState& other) const {
      return inode == other.inode && bytes == other.bytes && modified_ns == other.modified_ns;
    }
  };

  StreamableProgram() = default;
  static std::optional<FileState> stateOf(const std::string& path);
  void check(int max_line_bytes);

  std::string name_;
  std::string path_;  ///< empty if the text is held
  std::optional<FileState> checked_;
  std::shared_ptr<const std::string> text_;
  std::uint64_t lines_ = 0;
};

}  // namespace lamina
