// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <istream>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "lamina/base/quotation.hpp"
#include "lamina/streaming/job/program_origin.hpp"
#include "lamina/streaming/job/stream_settings.hpp"

namespace lamina {

/// A line of a program as it is sent: without comment and surrounding blanks, never empty.
struct ProgramLine {
  std::string command;
  std::int32_t layer = -1;  ///< its layer by ";LAYER:k" or ";LAYER_CHANGE"; -1 before the first
  double seconds = 0.0;     ///< time of its motions at their feeds, if it was asked for
};

/// Reads the commands of a G-code text one by one, in constant memory. It leaves out comments, tape marks
/// ('%'), empty lines, and line numbers with correct checksums. Comments begin with ';' outside quotes;
/// parentheses enclose one too, except in quotes, in braces and in commands that carry text.
class ProgramCursor {
 public:
  explicit ProgramCursor(std::unique_ptr<std::istream> text) : text_(std::move(text)) {}

  /// The next command; nothing at the end.
  std::optional<ProgramLine> next();
  /// Number of the last command's line in the text, from 1.
  std::uint64_t textLine() const { return text_line_; }
  /// Bytes of the text up to and including the end of that line, which is counted even if the last line lacks
  /// it.
  std::uint64_t bytesRead() const { return bytes_read_; }
  /// The layer to which a command read next would belong.
  std::int32_t layer() const { return layer_; }

 private:
  void readComment(std::string_view comment);

  std::unique_ptr<std::istream> text_;
  std::string raw_;
  std::uint64_t text_line_ = 0;
  std::uint64_t bytes_read_ = 0;
  std::int32_t layer_ = -1;
};

/// A program that was read whole and checked for the firmware to which it may be sent. It is read again, line
/// by line, while it is sent.
class StreamableProgram {
 public:
  /// @param settings  `firmware` is the protocol for which the program is checked; auto checks it for all
  /// @throws FileError if the file cannot be read
  /// @throws InvalidProgram naming the line if the firmware, or with auto every one, would misread it; or if
  /// there
  ///   is no command at all
  static StreamableProgram fromFile(const std::string& path, const StreamSettings& settings = {});
  static StreamableProgram fromText(const std::string& name, std::string text,
                                    const StreamSettings& settings = {});

  /// The same program with its origin, that of a corrected program.
  StreamableProgram madeFrom(ProgramOrigin origin) const;
  /// The origin of a corrected program; none of any other.
  const std::optional<ProgramOrigin>& origin() const { return origin_; }

  const std::string& name() const { return name_; }
  /// Number of commands.
  std::uint64_t lines() const { return lines_; }
  /// The first line that firmware of this protocol would misread, in words; empty if there is none.
  /// @param protocol  one for which the program was checked
  std::string defectFor(const std::string& protocol) const;
  /// The part of the text that messages may quote.
  const Quotation& quotation() const { return quotation_; }
  /// @throws FileError if the file is gone
  ProgramCursor open() const;
  /// Whether its text is in memory; else it is a file.
  bool isHeld() const { return text_ != nullptr; }
  /// The whole text, unchanged.
  /// @throws FileError if the file is gone
  std::unique_ptr<std::istream> openText() const;
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
  void check(const StreamSettings& settings);

  std::string name_;
  std::string path_;  ///< empty if the text is held
  std::optional<FileState> checked_;
  std::shared_ptr<const std::string> text_;
  std::uint64_t lines_ = 0;
  std::optional<ProgramOrigin> origin_;
  Quotation quotation_;
  std::map<std::string, std::string> defects_;  ///< by protocol
};

}  // namespace lamina
