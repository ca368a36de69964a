// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace lamina {

/// A printer that prints files of its own, without a machine: it runs lines at a steady pace in the given
/// time. Print servers decide what they report about it.
class EmulatedPrinter {
 public:
  enum class State : std::uint8_t { Idle, Printing, Paused };
  enum class Outcome : std::uint8_t { None, Complete, Stopped, Failed };

  std::map<std::string, std::string> files = {};  ///< text of each file, by name below the folder of programs
  double lines_per_s = 100.0;
  double queue_s = 0.0;  ///< time for which motions continue after the last line was run
  double nozzle_target_c = 0.0;
  double bed_target_c = 0.0;
  bool is_halted = false;
  bool has_bed = true;
  bool excludes_parts = true;  ///< it can leave out parts
  std::uint64_t stalls = 0;
  std::vector<std::string> unknown = {};  ///< commands that it did not know
  std::vector<std::string> changes = {};  ///< commands that changed how it prints, in order

  /// Starts a print.
  /// @return false if it is printing, or has no such file
  bool print(const std::string& file);
  void pause();
  void resume();
  void cancel();
  /// Ends the print with an error.
  void breakDown();
  /// Forgets everything but the files.
  void restart();
  /// Runs a command from outside the print, and keeps it in `changes` or `unknown`.
  void change(const std::string& command);
  /// Moves for a reason other than the print.
  void moveFor(double duration_s) { moving_until_ = now_ + duration_s; }
  /// Shuts itself down.
  void halt();
  void elapse(double now);

  State state() const { return state_; }
  Outcome outcome() const { return outcome_; }
  /// Whether it reports motion. As with Klipper's idle timer, motion is reported for ever after a shutdown
  /// during a motion.
  bool isMoving() const { return state_ == State::Printing || now_ < moving_until_; }
  const std::string& file() const { return file_; }     ///< printed now or last
  std::uint64_t position() const { return position_; }  ///< bytes of the file that were run
  double printTime() const { return print_time_s_; }    ///< time of that print [s]
  /// All commands that were run, in any print, without comments.
  const std::vector<std::string>& executed() const { return executed_; }
  void forgetExecuted() { executed_.clear(); }

 private:
  void runLine(const std::string& text);
  void end(Outcome outcome);

  State state_ = State::Idle;
  Outcome outcome_ = Outcome::None;
  std::string file_;
  std::uint64_t position_ = 0;
  double now_ = 0.0;
  double print_time_s_ = 0.0;
  double line_debt_ = 0.0;  ///< number of lines to be run by now
  double moving_until_ = 0.0;
  std::vector<std::string> executed_;
};

}  // namespace lamina
