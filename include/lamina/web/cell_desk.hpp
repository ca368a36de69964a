// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/cell/manual_control.hpp"
#include "lamina/cell/resume_steps.hpp"
#include "lamina/cell/unit_machine.hpp"
#include "lamina/journal/cell_journal.hpp"

namespace lamina {

/// Value of figures that were not measured.
constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

/// A job as shown on the page.
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

/// Whether commands of the PLC are taken.
enum class PlcAccess : std::uint8_t { Locked, Allowed };

/// The unit according to its last report.
struct ShownUnit {
  UnitState state = UnitState::Stopped;
  std::uint32_t sequence = 0;  ///< number of the last change of state
  double in_state_s = 0.0;     ///< time in the present state
  int mode = kProduction;
  std::string mode_name;
  std::vector<UnitCommand> accepted_now;  ///< commands that the unit would accept now
  int stop_reason = 0;                    ///< alarm that stopped the unit; 0 for none
  std::string stop_message;
  std::optional<ShownJob> job;
  bool resume_waits = false;   ///< whether a job that was cut off waits for Start to resume or discard it
  std::string resume_refusal;  ///< why that job cannot be resumed; empty if it can
  std::vector<ResumeStep> resume_steps;  ///< what is to be re-established before it is resumed
  bool is_part_on_plate = false;
  PlcAccess plc_access = PlcAccess::Locked;
  std::uint32_t lines = 0;
  std::uint32_t lines_acknowledged = 0;
  std::int32_t layer = -1;
  double fraction = 0.0;
  double laid_m = 0.0;       ///< length of the job's beads that are laid
  double material_m3 = 0.0;  ///< that it has used
  double elapsed_s = 0.0;    ///< time since the job began
  std::uint32_t parts = 0;
  std::uint32_t defective = 0;
  double running_s = 0.0;  ///< time in the state Execute, in the mode Production
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
  std::string job;  ///< name of the file that is running
  double nozzle_degc = kNotMeasured;
  double bed_degc = kNotMeasured;
  double nozzle_target_degc = kNotMeasured;  ///< 0 while it is off
  double bed_target_degc = kNotMeasured;     ///< 0 while it is off
  std::array<double, 3> position_m = {kNotMeasured, kNotMeasured, kNotMeasured};
  std::string failure;
};

/// The closed loop on layer heights.
struct ShownLoop {
  std::string state;
  std::string reason;
  std::uint32_t layer = 0;
  int alarm = 0;
};

/// A joint that can be moved by hand.
struct ShownJoint {
  std::string name;
  bool is_linear = false;
};

/// Who moves the machine by hand in the mode Manual.
struct ShownManual {
  std::string holder;   ///< of the lease; empty if nobody has it
  double left_s = 0.0;  ///< of the lease, unless it is used again
  bool is_moving = false;
  double scale = 1.0;  ///< speed within the limits, as a share of the requested speed
  std::string reason;  ///< why `scale` is less than 1, why nothing moves, or why the lease was lost
  std::vector<ShownJoint> joints;  ///< none if no node that jogs is heard
};

/// Errors of a layer's height: measured minus expected.
struct ShownLayer {
  std::uint32_t layer = 0;
  double mean_error_m = 0.0;
  double rms_error_m = 0.0;
  double worst_error_m = 0.0;
  double coverage = 0.0;
};

/// Errors of height over the layer that was measured last, in rows from the back of the bed to its front.
struct ShownDeviation {
  std::uint64_t number = 0;  ///< number of this picture, from 1; 0 if there is none yet
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  std::vector<float> errors_m;  ///< measured minus expected, row by row; NaN where nothing was measured
};

/// All that is known of the cell at one instant.
struct CellSnapshot {
  /// Time of the unit's last report, by the monotonic clock; nothing before the first.
  std::optional<double> heard_s;
  ShownUnit unit;
  std::vector<ShownAlarm> alarms;
  std::vector<ShownJob> queue;
  std::optional<double> machine_heard_s;  ///< as `heard_s`, for the machine
  ShownMachine machine;
  std::vector<ShownStep> startup;
  std::optional<ShownLoop> loop;
  std::optional<ShownManual> manual;
  std::vector<ShownLayer> layers;
  std::uint64_t deviation_number = 0;  ///< `number` of the latest `deviation`
  bool has_camera = false;
};

/// A layer of a program as lines to be drawn.
struct LayerPreview {
  std::int32_t layer = 0;
  std::int32_t layers = 0;  ///< number of layers of the program
  double z_m = 0.0;
  /// Lines along which material is deposited, each as x, y, x, y, … [m].
  std::vector<std::vector<float>> lines;
  bool is_cut_short = false;  ///< whether there are more lines than are given here
};

/// The preview of a layer, if it is available.
struct ShownPreview {
  bool is_being_read = false;         ///< whether the program is still being read; ask again later
  std::optional<LayerPreview> layer;  ///< nothing if there is no such layer, or the program is being read
};

/// Answer to an order to the cell.
struct DeskAnswer {
  enum class Outcome : std::uint8_t {
    Done,
    Refused,   ///< by the cell, with its reason
    BadInput,  ///< a program that cannot be printed, a value out of range
    Unknown,   ///< no such job or alarm
    Silent,    ///< no answer, and the order was not carried out
    Unsure,    ///< no answer; the order may still be carried out
    Overtaken  ///< dropped, since the unit is being stopped or another order of its kind waits already
  };
  Outcome outcome = Outcome::Done;
  int code = 0;  ///< a `CommandResult`, for commands, modes and alarms
  std::string message;
  std::int64_t job = 0;     ///< number of the job that was added; 0 otherwise
  std::uint64_t lease = 0;  ///< number of the lease of the mode Manual; 0 if there is none
};

struct DeskCommand {
  UnitCommand command = UnitCommand::Hold;
  std::string source;
  /// The command is refused if the unit's `sequence` differs.
  std::optional<std::uint32_t> expected_sequence;
  int cut_off = 0;                    ///< for Start: 1 resumes the job that was cut off, 2 discards it
  ResumeConfirmation confirmed = {};  ///< of the resume, by a person
};

struct DeskProgram {
  std::string path;
  std::string name;
  std::string part;
  std::string source;
  std::string mesh = {};       ///< path of the mesh from which the program was sliced; empty for none
  std::string mesh_name = {};  ///< name of the mesh file
};

/// A mesh that is sliced on the cell, and its program added to the queue.
struct DeskMesh {
  std::string path;
  std::string name;  ///< of the uploaded file; its suffix states the format
  std::string part;
  std::string source;
  std::string material;  ///< name of a profile; empty for none
  std::string process;   ///< name of a profile; empty for none
  std::vector<SettingText> settings = {};
};

enum class QueueChange : std::uint8_t { Release = 0, Revoke = 1, MoveToFront = 2, Remove = 3 };
enum class StartupCommand : std::uint8_t { Run = 0, Confirm = 1, Abort = 2 };
enum class ShownLoopRequest : std::uint8_t { Off = 0, Identify = 1, Active = 2 };

/// A step by hand that comes later than this after it was asked for is not wanted any more [s].
constexpr double kLatestStep = 0.5;

/// An order to move the machine by hand.
struct DeskManual {
  enum class Kind : std::uint8_t { Take = 0, Step = 1, Release = 2 };
  Kind kind = Kind::Take;
  ManualCaller who;
  ManualStep step = {};  ///< for Step
};

/// The verdict of the last part of a job.
struct DeskVerdict {
  std::int64_t job = 0;
  std::string verdict;
  std::string source;
  std::string reason;
};

/// Interface through which the page sees the cell and gives it orders. It is called from several threads.
/// Orders wait for their answer, each kind by itself: those that stop the unit do not wait behind others.
class CellDesk {
 public:
  virtual ~CellDesk() = default;
  virtual CellSnapshot snapshot() const = 0;
  virtual ShownDeviation deviation() const = 0;
  /// A layer of the job that is running, or ran last. Returns at once.
  /// @throws Error if its program cannot be read
  virtual ShownPreview preview(std::int32_t layer) = 0;

  virtual DeskAnswer command(const DeskCommand& command) = 0;
  virtual DeskAnswer changeMode(int mode, const std::string& source) = 0;
  virtual DeskAnswer setPlcAccess(PlcAccess access, const std::string& source) = 0;
  virtual DeskAnswer moveByHand(const DeskManual& order) = 0;
  virtual DeskAnswer enqueue(const DeskProgram& program) = 0;
  /// Waits until the mesh is sliced.
  virtual DeskAnswer enqueueMesh(const DeskMesh& mesh) = 0;
  virtual DeskAnswer changeQueue(QueueChange change, std::int64_t job, const std::string& source) = 0;
  /// Moves a job to a place in the queue, from 1.
  virtual DeskAnswer moveJob(std::int64_t job, std::int64_t place, const std::string& source) = 0;
  virtual DeskAnswer acknowledge(int alarm, const std::string& source) = 0;
  virtual DeskAnswer confirmRemoval(const std::string& source) = 0;
  virtual DeskAnswer judge(const DeskVerdict& verdict) = 0;
  virtual DeskAnswer startup(StartupCommand command, const std::string& step) = 0;
  virtual DeskAnswer setLoop(ShownLoopRequest request) = 0;
  /// Raises an alarm by its number in the table of alarms.
  virtual void report(int alarm, double value, const std::string& message) = 0;
};

}  // namespace lamina
