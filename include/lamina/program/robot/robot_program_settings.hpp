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

/// Name of the language: "KRL", "URScript", "Fanuc TP", "INFORM".
const char* toString(RobotLanguage language);

/// Suffix of the language's files: ".src".
const char* suffixOf(RobotLanguage language);

/// The language of a file by its suffix; nothing if no language has it.
std::optional<RobotLanguage> robotLanguageOf(const std::string& path);

/// Where the points of a program in KRL are written.
enum class KrlPoints : std::uint8_t {
  Inline,  ///< in its moves
  Dat,     ///< in the data file beside the program; moves name them
};

/// How a program starts and stops the process.
enum class RobotProcess : std::uint8_t {
  Outputs,    ///< digital and analogue outputs
  Schedules,  ///< statements of the controller's arc package, which name schedules kept there
};

/// Statements of an arc package.
struct ArcSettings {
  RobotProcess process = RobotProcess::Outputs;
  int start_schedule = 0;  ///< number, on the controller, of the schedule by which an arc starts; 0 for none
  int end_schedule = 0;    ///< number of the schedule by which an arc ends; 0 for none
  int weave_schedule = 0;  ///< number of the schedule by which an arc weaves; 0 for none
};

/// Settings of programs in KRL.
struct KrlSettings {
  KrlPoints points = KrlPoints::Inline;
  int advance = 5;                  ///< $ADVANCE: number of moves by which the controller looks ahead
  double turn_speed_deg_s = 200.0;  ///< speed at which the tool rotates: $VEL.ORI1, $VEL.ORI2
  double acceleration_m_s2 = 2.3;   ///< $ACC.CP
  std::string arc_on;    ///< statement that starts the arc; {schedule} and {weave} are replaced by numbers
  std::string arc_off;   ///< statement that ends the arc; with the same placeholders
  int max_lines = 5000;  ///< greatest number of lines in a file
  double max_mb = 4.0;   ///< greatest size of all files of a program together [10^6 bytes]
};

/// The statement by which a script deposits beads.
enum class UrBeadMove : std::uint8_t {
  MoveP,  ///< the tip keeps its speed round corners
  MoveL,
};

/// Settings of programs in URScript.
struct UrScriptSettings {
  UrBeadMove bead_move = UrBeadMove::MoveP;
  double acceleration_m_s2 = 1.2;
  double joint_acceleration_rad_s2 = 1.4;
  int max_points = 900;  ///< greatest number of points in a file
};

/// Sign of an angle.
enum class JointSign : std::uint8_t { Positive, Negative };

/// How a listing states the speed of its welds.
enum class FanucWeldSpeed : std::uint8_t {
  Stated,    ///< in each move
  Schedule,  ///< WELD_SPEED: the speed of the schedule on the controller
};

/// Settings of Fanuc's listings.
struct FanucSettings {
  int cnt = 100;                              ///< value of CNT, for points that may be rounded
  double joint_3_from_2 = -1.0;               ///< share of joint 2 that the controller adds to joint 3
  JointSign flip = JointSign::Positive;       ///< sign of joint 5 if the wrist is flipped, F
  std::vector<double> turn_axes = {1, 4, 6};  ///< joints whose whole turns a configuration counts
  int name_length = 36;                       ///< greatest number of characters of a program's name
  int max_lines = 9000;                       ///< greatest number of lines in a file
  int arc_equipment = 1;  ///< number that /APPL names if schedules start arcs; 0 for no /APPL
  FanucWeldSpeed weld_speed = FanucWeldSpeed::Stated;
  bool is_coordinated = true;  ///< whether motions over a bed that a positioner turns are written as COORD
  int positioner_frame = 1;    ///< number of the frame of group 2, the positioner
  int positioner_tool = 1;     ///< number of the tool of group 2
  int payload = 0;             ///< number of the payload on the controller that is chosen; 0 for none
};

enum class InformSpeedUnit : std::uint8_t { MillimetresPerSecond, CentimetresPerMinute };

/// Order of the first three numbers of RCONF.
enum class InformRconfOrder : std::uint8_t { FlipElbowFront, FrontElbowFlip };

/// How many slashes stand before FRAME.
enum class InformFrameMark : std::uint8_t { Three, Four };

/// Settings of jobs in INFORM.
struct InformSettings {
  /// Unit of V, as a parameter of the controller sets it.
  InformSpeedUnit speed_unit = InformSpeedUnit::MillimetresPerSecond;
  int corner_level = 1;  ///< value of PL, for points that may be rounded
  /// Pulses per degree of each joint; empty if joint moves state poses.
  std::vector<double> pulses_per_deg;
  /// Pulses of each external axis per mm or deg, in the order of the controller; needed if the arm has any.
  std::vector<double> external_pulses;
  bool is_coordinated = true;  ///< whether motions over a bed that a station turns are written as SMOVL
  JointSign flip = JointSign::Positive;  ///< sign of joint 5 if RCONF states flip
  InformRconfOrder rconf_order = InformRconfOrder::FlipElbowFront;
  int rconf_length = 8;  ///< number of values in RCONF: 6, 8 or 24
  InformFrameMark frame_mark = InformFrameMark::Four;
  int name_length = 32;   ///< greatest number of characters of a job's name
  int max_points = 2000;  ///< greatest number of points in a job
};

/// How a toolpath is written as a program for a robot whose language is not RAPID: settings for all
/// languages, and those of each.
struct RobotProgramSettings {
  std::string name;           ///< name of the program; empty for that of the file
  int tool_number = 1;        ///< number of the tool on the controller
  double tool_mass_kg = 0.0;  ///< mass that the flange carries; 0 if the controller's is kept
  /// Centre of gravity of what the flange carries, in the flange's frame; empty if the controller's is kept.
  std::vector<double> tool_centre_of_gravity_mm;
  int frame_number = 1;  ///< number of the frame on the controller that is the bed
  /// Distance from the part, back along the tool axis, at which a program starts and ends.
  double approach_mm = 50.0;
  /// Distance by which the controller may round points where the process neither starts nor ends.
  double corner_mm = 0.5;
  /// Speed of the joint move that begins a file, in percent of the greatest.
  double joint_speed_percent = 10.0;
  /// Number of the variable on the controller with which a program runs without its process; 0 for none.
  int dry_flag = 0;
  /// Speed of a dry run by that variable, in percent of the program's speeds.
  double dry_speed_percent = 100.0;
  int process_output = 1;       ///< number of the digital output that is on while material is deposited
  double process_lead_s = 0.0;  ///< wait between process on and the move
  double process_end_s = 0.0;   ///< wait between process off and the next move
  ArcSettings arc;
  std::string levels;  ///< analogue outputs of process values: "name=output*per, ..."
  /// For each joint 1, or -1 if the controller counts it in the opposite direction to the description; empty
  /// for 1 at all joints.
  std::vector<double> joint_signs;
  /// Value that the controller shows for each joint at the description's zero; empty for 0 at all joints.
  std::vector<double> joint_zeros_deg;
  /// Order, sense and zero of external axes: "external_1=e2, external_2=-e1+90"; empty for those of the
  /// joints.
  std::string external_axes;
  /// Whether a run that is too long for a file is cut, with the process stopped at the cut; otherwise it is
  /// refused.
  bool may_cut = false;
  /// Date that files state. It is a setting, as files must be the same every time.
  std::string date = "2000-01-01";
  KrlSettings krl;
  UrScriptSettings urscript;
  FanucSettings fanuc;
  InformSettings inform;
};

/// Adds the keys robot_program.*, krl.*, urscript.*, fanuc.*, inform.*.
void describe(SettingsSchema& schema, RobotProgramSettings& settings);

/// An analogue output whose value follows a process value.
struct RobotLevel {
  std::string name;  ///< name of the process value: "laser_power_w"
  int output = 0;
  double per = 1.0;  ///< value of the output for each unit of the process value
};

/// The outputs in a list "name=output*per, ...", in its order.
/// @throws InvalidConfig if an entry is not of that form, or a name or output occurs twice
std::vector<RobotLevel> robotLevels(const std::string& text);

/// Checks the settings.
/// @throws InvalidConfig naming key and value: for signs other than 1 and -1; joints other than 1 to 6;
///   numbers of pulses that are 0; schedules although outputs switch the process; a malformed date or list of
///   outputs
void requireConsistent(const RobotProgramSettings& settings);

}  // namespace lamina
