// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <istream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lamina/base/quotation.hpp"
#include "lamina/streaming/job/program_origin.hpp"
#include "lamina/streaming/job/stream_settings.hpp"

namespace lamina {

/// A line of a program as it is sent.
struct ProgramLine {
  std::string command;      ///< the line without comment and surrounding blanks, never empty
  std::int32_t layer = -1;  ///< layer by the comments ";LAYER:k" or ";LAYER_CHANGE"; -1 before the first
  double seconds = 0.0;     ///< duration of its motions at their feeds; 0 unless it is computed
};

/// Reads the commands of a G-code text one by one, in constant memory. It omits comments, tape marks ('%'),
/// empty lines, and line numbers with correct checksums. A comment begins with ';' outside quotes, or is
/// enclosed by parentheses, except in quotes, in braces and in commands that carry text.
class ProgramCursor {
 public:
  explicit ProgramCursor(std::unique_ptr<std::istream> text) : text_(std::move(text)) {}

  /// The next command; nothing at the end.
  std::optional<ProgramLine> next();
  /// Number in the text, from 1, of the line of the last command.
  std::uint64_t textLine() const { return text_line_; }
  /// Number of bytes of the text up to and including the line feed of the last command's line; a last line
  /// without line feed counts as if it had one.
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

/// A program that was read and checked for the firmware to which it may be sent. A program from a file is not
/// held in memory, but read again while it is sent.
class StreamableProgram {
 public:
  /// @param settings  `firmware` is the protocol for which the program is checked; `auto` checks it for all
  /// @throws FileError if the file cannot be read
  /// @throws InvalidProgram naming the line if the firmware (with `auto`: every known one) would misread it,
  ///   or if the program has no command
  static StreamableProgram fromFile(const std::string& path, const StreamSettings& settings = {});
  /// A program whose text is held in memory; parameters and errors as for `fromFile`.
  static StreamableProgram fromText(const std::string& name, std::string text,
                                    const StreamSettings& settings = {});

  /// This program with its origin added; for a corrected program.
  StreamableProgram madeFrom(ProgramOrigin origin) const;
  /// The origin of a corrected program; nothing for any other.
  const std::optional<ProgramOrigin>& origin() const { return origin_; }

  const std::string& name() const { return name_; }
  /// Number of commands.
  std::uint64_t lines() const { return lines_; }
  /// The message about the first line that firmware of this protocol would misread; empty if there is none.
  /// @param protocol  one for which the program was checked
  std::string defectFor(const std::string& protocol) const;
  /// Names of the parts that the program defines for Klipper (EXCLUDE_OBJECT_DEFINE) before the first part
  /// begins, in the program's order; at most 10000. Known from the check: nothing is read.
  const std::vector<std::string>& definedParts() const { return *defined_parts_; }
  /// The part of the text that messages may quote.
  const Quotation& quotation() const { return quotation_; }
  /// @throws FileError if the file is gone
  ProgramCursor open() const;
  /// Whether the text is held in memory rather than in a file.
  bool isHeld() const { return text_ != nullptr; }
  /// The whole text, unchanged.
  /// @throws FileError if the file is gone
  std::unique_ptr<std::istream> openText() const;
  /// Whether the file has changed since the check: it was written to, cut, replaced or removed.
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
  std::shared_ptr<const std::vector<std::string>> defined_parts_;
  Quotation quotation_;
  std::map<std::string, std::string> defects_;  ///< by protocol
};

}  // namespace lamina
