// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Languages of robots besides RAPID.
enum class RobotLanguage : std::uint8_t {
  Krl,       ///< KUKA, .src
  UrScript,  ///< Universal Robots, .script
  Fanuc,     ///< listings of the teach pendant language, .ls
  Inform,    ///< Yaskawa, .jbi
};

constexpr std::array<RobotLanguage, 4> kRobotLanguages = {RobotLanguage::Krl, RobotLanguage::UrScript,
                                                          RobotLanguage::Fanuc, RobotLanguage::Inform};

/// "KRL", ...
const char* toString(RobotLanguage language);

/// ".src", ...
const char* suffixOf(RobotLanguage language);

/// The language of a file by its suffix; nothing if it is that of none of these.
std::optional<RobotLanguage> robotLanguageOf(const std::string& path);

/// Where the points of a program in KRL stand.
enum class KrlPoints : std::uint8_t {
  Inline,  ///< in its moves
  Dat,     ///< in the data file beside it, by name
};

/// By what a program starts and stops the process.
enum class RobotProcess : std::uint8_t {
  Outputs,    ///< digital and analogue ones
  Schedules,  ///< statements of the controller's arc package, which name schedules kept there
};

/// Statements of an arc package.
struct ArcSettings {
  RobotProcess process = RobotProcess::Outputs;
  int start_schedule = 1;
  int end_schedule = 1;
  int weave_schedule = 0;  ///< 0 for none
};

/// How KRL is written.
struct KrlSettings {
  KrlPoints points = KrlPoints::Inline;
  int advance = 5;                  ///< $ADVANCE: moves that the controller looks ahead
  double turn_speed_deg_s = 200.0;  ///< $VEL.ORI1, $VEL.ORI2
  double acceleration_m_s2 = 2.3;   ///< $ACC.CP
  std::string arc_on;               ///< statement that starts the arc; {schedule}, {weave} are put in
  std::string arc_off;              ///< statement that ends it
  int max_lines = 5000;             ///< in a file
  double max_mb = 4.0;              ///< of all files together
};

/// By which statement a script lays beads.
enum class UrBeadMove : std::uint8_t {
  MoveP,  ///< the tip keeps its speed round corners
  MoveL,
};

/// How URScript is written.
struct UrScriptSettings {
  UrBeadMove bead_move = UrBeadMove::MoveP;
  double acceleration_m_s2 = 1.2;
  double joint_acceleration_rad_s2 = 1.4;
  int max_points = 900;  ///< in a file
};

/// Sign of an angle.
enum class JointSign : std::uint8_t { Positive, Negative };

/// By what a listing states the speed of its welds.
enum class FanucWeldSpeed : std::uint8_t {
  Stated,    ///< in each move
  Schedule,  ///< WELD_SPEED: that of the schedule on the controller
};

/// How Fanuc's listings are written.
struct FanucSettings {
  int cnt = 100;                              ///< of points that may be rounded
  double joint_3_from_2 = -1.0;               ///< share of joint 2 in what joint 3 counts
  JointSign flip = JointSign::Positive;       ///< sign of joint 5 with the wrist flipped, F
  std::vector<double> turn_axes = {1, 4, 6};  ///< joints whose turns a configuration counts
  int name_length = 36;                       ///< of a program, at most
  int max_lines = 9000;                       ///< in a file
  int arc_equipment = 1;  ///< that /APPL names where arcs are started by schedules; 0 for no /APPL
  FanucWeldSpeed weld_speed = FanucWeldSpeed::Stated;
};

enum class InformSpeedUnit : std::uint8_t { MillimetresPerSecond, CentimetresPerMinute };

/// In which order RCONF begins.
enum class InformRconfOrder : std::uint8_t { FlipElbowFront, FrontElbowFlip };

/// How many slashes stand before FRAME.
enum class InformFrameMark : std::uint8_t { Three, Four };

/// How jobs in INFORM are written.
struct InformSettings {
  InformSpeedUnit speed_unit =
      InformSpeedUnit::MillimetresPerSecond;  ///< of V, a parameter of the controller
  int corner_level = 1;                       ///< PL of points that may be rounded
  std::vector<double> pulses_per_deg;         ///< of each joint; empty: joints are stated in degrees
  JointSign flip = JointSign::Positive;       ///< sign of joint 5 that RCONF calls flip
  InformRconfOrder rconf_order = InformRconfOrder::FlipElbowFront;
  int rconf_length = 8;
  InformFrameMark frame_mark = InformFrameMark::Four;
  int name_length = 32;   ///< of a job, at most
  int max_points = 2000;  ///< in a job
};

/// How a toolpath is written as a program of a robot whose language is not RAPID; what all languages share,
/// and each one's own.
struct RobotProgramSettings {
  std::string name;                   ///< empty for that of the file
  int tool_number = 1;                ///< of the tool on the controller
  int frame_number = 1;               ///< of the bed on the controller
  double approach_mm = 50.0;          ///< back along the tool axis, where a program starts and ends
  double corner_mm = 0.5;             ///< by which a point between may be rounded
  double joint_speed_percent = 10.0;  ///< of the move by joints that begins a file
  int process_output = 1;             ///< digital, on while material is deposited
  double process_lead_s = 0.0;        ///< from the process on to the move
  double process_end_s = 0.0;         ///< from the process off to the next move
  ArcSettings arc;
  std::string levels;                   ///< "name=output*per, ...": analogue outputs of process values
  std::vector<double> joint_signs;      ///< of the controller's joints over the description's; empty for 1
  std::vector<double> joint_zeros_deg;  ///< added to them; empty for 0
  bool may_cut = false;                 ///< runs that no file holds: the process stops at the cut
  std::string date = "2000-01-01";      ///< that files state; no clock, so that they are the same every time
  KrlSettings krl;
  UrScriptSettings urscript;
  FanucSettings fanuc;
  InformSettings inform;
};

/// Adds the keys robot_program.*, krl.*, urscript.*, fanuc.*, inform.*.
void describe(SettingsSchema& schema, RobotProgramSettings& settings);

/// An analogue output that a process value is sent to.
struct RobotLevel {
  std::string name;  ///< of the process value: "laser_power_w"
  int output = 0;
  double per = 1.0;  ///< what the output is set to for each unit of the value
};

/// In the order in which they stand.
/// @throws InvalidConfig if it is no list of name=output*per, or a name or output stands twice
std::vector<RobotLevel> robotLevels(const std::string& text);

/// @throws InvalidConfig naming key and value: signs that are not 1 or -1, joints that there are not, a date
///   that is none, lists that are none
void requireConsistent(const RobotProgramSettings& settings);

}  // namespace lamina
