// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "lamina/cell/unit_machine.hpp"
#include "lamina/journal/cell_journal.hpp"

namespace lamina {

constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

/// A job as the page shows it.
struct ShownJob {
  std::int64_t id = 0;
  std::string name;
  std::string part;
  std::string machine;
  std::string digest;
  JobState state = JobState::NotAllowedToStart;
  std::string created_by;
  std::string released_by;
};

/// The unit as it was heard of last.
struct ShownUnit {
  UnitState state = UnitState::Stopped;
  std::uint32_t sequence = 0;
  double in_state_s = 0.0;
  int mode = kProduction;
  std::string mode_name;
  std::vector<UnitCommand> accepted_now;
  int stop_reason = 0;  ///< alarm; 0 for none
  std::string stop_message;
  std::optional<ShownJob> job;
  bool resume_waits = false;
  bool is_part_on_plate = false;
  std::uint32_t lines = 0;
  std::uint32_t lines_acknowledged = 0;
  std::int32_t layer = -1;
  double fraction = 0.0;
  std::uint32_t parts = 0;
  std::uint32_t defective = 0;
  double running_s = 0.0;  ///< in Execute, in Production
};

struct ShownAlarm {
  int id = 0;
  std::string category;
  std::string title;
  std::string remedy;
  std::string message;
  bool is_gone = false;
  bool is_acknowledged = false;
  std::string acknowledged_by;
  std::uint32_t times = 1;
};

/// A step of the machine's start-up.
struct ShownStep {
  std::string name;
  std::string state;
  std::string reason;
  double value = kNotMeasured;
  std::string unit;
  std::string expected;
};

struct ShownMachine {
  std::string job;  ///< file that runs
  double nozzle_degc = kNotMeasured;
  double bed_degc = kNotMeasured;
  std::array<double, 3> position_m = {kNotMeasured, kNotMeasured, kNotMeasured};
  std::string failure;
};

/// The loop on layer heights.
struct ShownLoop {
  std::string state;
  std::string reason;
  std::uint32_t layer = 0;
  int alarm = 0;
};

/// What a layer measured.
struct ShownLayer {
  std::uint32_t layer = 0;
  double mean_error_m = 0.0;
  double rms_error_m = 0.0;
  double worst_error_m = 0.0;
  double coverage = 0.0;
};

/// The errors of the last layer seen, in rows from the back of the bed to its front.
struct ShownDeviation {
  std::uint64_t number = 0;  ///< of the pictures, from 1; 0 for none yet
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  std::vector<float> errors_m;  ///< NaN where nothing was seen
};

/// All that is known of the cell at an instant.
struct CellSnapshot {
  std::optional<double> heard_s;  ///< steady time of the unit's last word; nothing before the first
  ShownUnit unit;
  std::vector<ShownAlarm> alarms;
  std::vector<ShownJob> queue;
  std::optional<double> machine_heard_s;
  ShownMachine machine;
  std::vector<ShownStep> startup;
  std::optional<ShownLoop> loop;
  std::vector<ShownLayer> layers;
  std::uint64_t deviation_number = 0;  ///< of the last `deviation`
  bool has_camera = false;
};

/// A layer of a program, as lines to be drawn.
struct LayerPreview {
  std::int32_t layer = 0;
  std::int32_t layers = 0;
  double z_m = 0.0;
  /// Deposited lines, each x, y, x, y, … [m].
  std::vector<std::vector<float>> lines;
  bool is_cut_short = false;  ///< there are more lines than are drawn
};

/// What there is to draw.
struct ShownPreview {
  bool is_being_read = false;         ///< the program: ask again
  std::optional<LayerPreview> layer;  ///< nothing if there is none
};

/// What became of an order to the cell.
struct DeskAnswer {
  enum class Outcome : std::uint8_t {
    Done,
    Refused,   ///< by the cell, with its reason
    BadInput,  ///< a program that cannot be printed, a value out of range
    Unknown,   ///< no such job or alarm
    Silent,    ///< nobody answers, and nothing was done
    Unsure,    ///< nobody answers: it may still be done
    Overtaken  ///< dropped for what stops the unit, or another of its kind waits already
  };
  Outcome outcome = Outcome::Done;
  int code = 0;  ///< of `CommandResult` for commands, modes, alarms
  std::string message;
  std::int64_t job = 0;
};

struct DeskCommand {
  UnitCommand command = UnitCommand::Hold;
  std::string source;
  std::optional<std::uint32_t> expected_sequence;
  int cut_off = 0;  ///< with Start: 1 resumes what was cut off, 2 discards it
};

struct DeskProgram {
  std::string path;
  std::string name;
  std::string part;
  std::string source;
};

enum class QueueChange : std::uint8_t { Release = 0, Revoke = 1, MoveToFront = 2, Remove = 3 };
enum class StartupCommand : std::uint8_t { Run = 0, Confirm = 1, Abort = 2 };
enum class ShownLoopRequest : std::uint8_t { Off = 0, Identify = 1, Active = 2 };

/// The cell as the page reaches it: what is known of it, and orders to it. Several threads call at a time;
/// orders wait for their answer, each kind on its own: what stops the unit waits behind nothing else.
class CellDesk {
 public:
  virtual ~CellDesk() = default;
  virtual CellSnapshot snapshot() const = 0;
  virtual ShownDeviation deviation() const = 0;
  /// A layer of the job that runs or ran last. Waits for nothing.
  /// @throws Error if its program cannot be read
  virtual ShownPreview preview(std::int32_t layer) = 0;

  virtual DeskAnswer command(const DeskCommand& command) = 0;
  virtual DeskAnswer changeMode(int mode, const std::string& source) = 0;
  virtual DeskAnswer enqueue(const DeskProgram& program) = 0;
  virtual DeskAnswer changeQueue(QueueChange change, std::int64_t job, const std::string& source) = 0;
  virtual DeskAnswer acknowledge(int alarm, const std::string& source) = 0;
  virtual DeskAnswer confirmRemoval(const std::string& source) = 0;
  virtual DeskAnswer startup(StartupCommand command, const std::string& step) = 0;
  virtual DeskAnswer setLoop(ShownLoopRequest request) = 0;
  /// Raises an alarm of the table.
  virtual void report(int alarm, double value, const std::string& message) = 0;
};

}  // namespace lamina
