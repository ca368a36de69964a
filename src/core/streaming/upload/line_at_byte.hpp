// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace lamina {

/// Ends of a program's commands in its text, and their layers. They are held in memory, with one byte for
/// most commands: during a print the machine's reports are evaluated without the program's disk.
class CommandEnds {
 public:
  /// Adds the next command.
  /// @param end  number of bytes of the text up to the command's end; not less than the end of the command
  ///   before
  void add(std::uint64_t end, std::int32_t layer);

 private:
  friend class LineAtByte;
  struct LayerBegin {
    std::uint64_t line = 0;  ///< number of commands before the layer
    std::int32_t layer = -1;
  };
  std::string
      distances_;  ///< between ends, seven bits a byte, low bits first; the last byte without its top bit
  std::uint64_t lines_ = 0;
  std::uint64_t last_end_ = 0;
  std::vector<LayerBegin> layers_;
};

/// Finds the last command of a program before a position in its file.
class LineAtByte {
 public:
  explicit LineAtByte(std::shared_ptr<const CommandEnds> ends) : ends_(std::move(ends)) {}

  /// Number of commands that end at or before a byte of the file.
  std::uint64_t linesBefore(std::uint64_t byte);
  /// Layer of the last of these commands; -1 before the first.
  std::int32_t layer() const { return layer_; }

 private:
  void rewind();
  std::uint64_t nextDistance(std::size_t& at) const;

  std::shared_ptr<const CommandEnds> ends_;
  std::size_t at_ = 0;          ///< byte of the distances
  std::size_t next_layer_ = 0;  ///< of the layers that begin
  std::uint64_t lines_ = 0;
  std::uint64_t end_ = 0;  ///< of the last of these commands
  std::int32_t layer_ = -1;
};

}  // namespace lamina
