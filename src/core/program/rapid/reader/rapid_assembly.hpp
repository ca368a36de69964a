// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"
#include "program/rapid/reader/rapid_path_notes.hpp"
#include "program/rapid/reader/rapid_source.hpp"

namespace lamina {

enum class ProcessState : std::uint8_t { Off, On };

/// Makes a toolpath of moves, in the order in which they are run, and of the notes that report their paths.
class RapidAssembly {
 public:
  /// A procedure with moves begins.
  void begin(std::vector<PathNote> notes, const std::string& file);
  /// @param process  while it runs
  void add(const RapidMove& move, ProcessState process, std::size_t line);
  /// It ends.
  void end(std::size_t line);

  Toolpath finish();

 private:
  [[noreturn]] void refuse(std::size_t line, const std::string& what) const;
  void openPath(std::size_t line);
  void addStart(const RapidMove& move, ProcessState process, std::size_t line);
  void addMotion(const RapidMove& move, ProcessState process, std::size_t line);
  void closePath();
  std::vector<Bead> beads() const;

  std::vector<PathNote> notes_;
  std::string file_;
  std::size_t note_ = 0;   ///< the one whose moves come
  std::size_t moves_ = 0;  ///< of it, so far
  std::optional<RapidMove> last_;

  std::optional<PathNote> open_;  ///< the path that is being read
  std::string open_file_;
  std::vector<RapidMove> poses_;  ///< where it starts, and at the end of each motion
  Toolpath toolpath_;
};

}  // namespace lamina
