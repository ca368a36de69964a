// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <string>

#include "lamina/streaming/job/streamable_program.hpp"
#include "streaming/job/used_outputs.hpp"
#include "streaming/upload/line_at_byte.hpp"

namespace lamina {

/// A program as it is uploaded: the bytes of its text, with an end of line added to the last line if it has
/// none, as Klipper does not run such a line. The program is read once for size, checksums and the ends of
/// its commands; it is not held in memory.
class ProgramBody {
 public:
  /// @throws FileError if the file is gone
  /// @throws InvalidProgram if the program changed since it was checked, or has a line that print servers
  ///   misread
  explicit ProgramBody(StreamableProgram program);

  std::uint64_t bytes() const { return bytes_; }
  std::uint32_t crc32() const { return crc32_; }
  const std::string& sha256() const { return sha256_; }  ///< 64 hexadecimal digits
  /// Number of the first line that is not UTF-8, from 1; 0 if all are.
  std::uint64_t lineNotUtf8() const { return line_not_utf8_; }
  std::size_t longestCommand() const { return longest_bytes_; }       ///< [bytes]
  std::uint64_t longestCommandLine() const { return longest_line_; }  ///< from 1
  /// The outputs that the program switches on.
  const UsedOutputs& outputs() const { return outputs_; }
  const StreamableProgram& program() const { return program_; }
  /// Where each command ends in the bytes.
  const std::shared_ptr<const CommandEnds>& commandEnds() const { return command_ends_; }

  /// Reads the bytes in order.
  class Reader {
   public:
    /// Reads the next bytes into `buffer`.
    /// @return how many were read; 0 at the end
    std::size_t read(char* buffer, std::size_t size);

   private:
    friend class ProgramBody;
    explicit Reader(std::unique_ptr<std::istream> text) : text_(std::move(text)) {}

    std::unique_ptr<std::istream> text_;
    char last_ = '\n';
  };
  /// @throws FileError if the file is gone
  Reader open() const { return Reader(program_.openText()); }

 private:
  void checkLines();
  void digest();

  StreamableProgram program_;
  std::uint64_t bytes_ = 0;
  std::uint32_t crc32_ = 0;
  std::string sha256_;
  std::uint64_t line_not_utf8_ = 0;
  std::size_t longest_bytes_ = 0;
  std::uint64_t longest_line_ = 0;
  UsedOutputs outputs_;
  std::shared_ptr<const CommandEnds> command_ends_;
};

}  // namespace lamina
