// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/urscript/urscript_printer.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimals.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/program/robot/robot_angles.hpp"
#include "program/robot/notes/robot_notes.hpp"

namespace lamina {
namespace {

constexpr std::size_t kLongestUrName = 64;
constexpr std::size_t kUrNoteWidth = 200;
constexpr int kUrDecimals = 6;             // m, rad, m/s
constexpr double kUrMetre = 1e-3;          // in a millimetre
constexpr double kUrFastestJoint = M_PI;   // rad/s: the slowest of the joints' greatest speeds
constexpr double kBlendShare = 0.45;       // of the shorter way: two blends never meet
constexpr double kLeastBlendRoom = 0.05;   // mm: a blend between nearer points fails as it runs
constexpr double kRoundingOfBlend = 1e-6;  // um: of a product of two decimals
constexpr int kLastUrOutput = 7;           // of standard digital outputs

/// Keywords, and functions that a program of their name would hide.
const std::vector<std::string_view> kUrWords = {"abs",
                                                "acos",
                                                "and",
                                                "asin",
                                                "atan",
                                                "atan2",
                                                "break",
                                                "ceil",
                                                "continue",
                                                "cos",
                                                "def",
                                                "elif",
                                                "else",
                                                "end",
                                                "false",
                                                "floor",
                                                "for",
                                                "force",
                                                "freedrive_mode",
                                                "get_inverse_kin",
                                                "global",
                                                "halt",
                                                "if",
                                                "in",
                                                "join",
                                                "kill",
                                                "lamina_dry",
                                                "length",
                                                "local",
                                                "log",
                                                "movec",
                                                "movej",
                                                "movel",
                                                "movep",
                                                "norm",
                                                "not",
                                                "or",
                                                "pass",
                                                "popup",
                                                "pose_add",
                                                "pose_trans",
                                                "pow",
                                                "random",
                                                "return",
                                                "run",
                                                "sec",
                                                "servoj",
                                                "set_payload",
                                                "sin",
                                                "sleep",
                                                "socket_open",
                                                "speedj",
                                                "speedl",
                                                "sqrt",
                                                "stopj",
                                                "stopl",
                                                "sync",
                                                "tan",
                                                "textmsg",
                                                "then",
                                                "thread",
                                                "true",
                                                "while",
                                                "xor"};
constexpr int kLastUrLevel = 1;  // of standard analogue outputs

void requireUrOutput(int output, int last, const char* kind) {
  if (output > last)
    throw InvalidInput(std::string("URScript has standard ") + kind + " outputs 0 to " +
                       std::to_string(last) + "; found " + std::to_string(output));
}

class UrScriptPrinter : public RobotPrinter {
 public:
  explicit UrScriptPrinter(const RobotSite& site) : site_(site) {
    if (!site.external.empty())
      throw InvalidInput("the arm has " + std::to_string(site.external.size()) +
                         " external axes; expected none: URScript moves none");
    if (site.settings.arc.process == RobotProcess::Schedules)
      throw InvalidConfig(
          "robot_program.process is 'schedules'; expected 'outputs': URScript has no statements of welders");
    if (site.cell) base_from_bed_ = site.cell->carrier_from_bed;
  }

  void print(const RobotStatement& statement) override {
    // An output would be set as a blend begins, before its point: the tip comes to the point for it.
    if (std::holds_alternative<LevelChange>(statement) && pending_) pending_->rests = true;
    if (!std::holds_alternative<NoteLine>(statement)) flush();
    std::visit([this](const auto& each) { add(each); }, statement);
  }

  RobotFileSize size() const override { return {lines_, points_}; }

  std::vector<RobotFile> files(const RobotFileHead& head) const override {
    UrScriptPrinter whole(*this);
    whole.flush();
    std::string text =
        "def " + head.name + "():\n  # generated by Lamina\n  # part: " + plainText(head.part_name) + "\n";
    for (const std::string& note : head.notes)
      for (const std::string& comment : noteComments(note, "  #", kUrNoteWidth)) text += comment + "\n";
    if (site_.settings.dry_flag > 0) text += "  global lamina_dry = False\n";
    text += drySpeed();
    if (site_.cell) text += "  set_tcp(" + urPose(site_.cell->flange_from_nozzle) + ")\n";
    text += payload();
    return {{head.name + ".script", text + whole.body_ + "end\n"}};
  }

 private:
  std::string drySpeed() const {
    if (!site_.hasDrySpeed()) return "";
    const std::string variable(kDrySpeedVariable);
    return "  global " + variable + " = 1.0\n  if lamina_dry:\n    " + variable + " = " +
           trimmedDecimals(0.01 * site_.settings.dry_speed_percent, kUrDecimals) + "\n  end\n";
  }

  /// Nothing where the controller's is kept.
  std::string payload() const {
    const RobotProgramSettings& settings = site_.settings;
    if (settings.tool_mass_kg == 0.0) return "";
    std::string text = "  set_payload(" + trimmedDecimals(settings.tool_mass_kg, 3) + ", [";
    for (std::size_t axis = 0; axis < 3; ++axis)
      text += (axis > 0 ? ", " : "") +
              decimalText(kUrMetre * settings.tool_centre_of_gravity_mm[axis], kUrDecimals);
    return text + "])\n";
  }

  static std::string urPose(const Eigen::Isometry3d& pose) {
    const Eigen::Vector3d turn = rotationVector(Eigen::Quaterniond(pose.linear()));
    std::string text = "p[";
    for (int axis = 0; axis < 3; ++axis)
      text += (axis > 0 ? ", " : "") + decimalText(kUrMetre * pose.translation()[axis], kUrDecimals);
    for (int axis = 0; axis < 3; ++axis) text += ", " + decimalText(turn[axis], kUrDecimals);
    return text + "]";
  }

  void addLine(const std::string& line) {
    body_.append("  ").append(line).append("\n");
    ++lines_;
  }

  void flush() {
    if (!pending_) return;
    const TipMove move = *pending_;
    pending_.reset();
    Eigen::Isometry3d pose(move.orientation);
    pose.translation() = move.point;
    for (const double coordinate : Point3(base_from_bed_ * move.point))
      requireInFormat(coordinate, "mm", RobotLanguage::UrScript);
    const bool is_process = move.lays && site_.settings.urscript.bead_move == UrBeadMove::MoveP;
    std::string text = (is_process ? "movep(" : "movel(") + urPose(base_from_bed_ * pose) +
                       ", a=" + trimmedDecimals(site_.settings.urscript.acceleration_m_s2, 3) +
                       ", v=" + trimmedDecimals(kUrMetre * move.feed_mm_s, kUrDecimals) +
                       (site_.hasDrySpeed() ? "*" + std::string(kDrySpeedVariable) : "");
    const double blend_mm = move.rests || move.room_mm < kLeastBlendRoom
                                ? 0.0
                                : std::min(site_.settings.corner_mm, kBlendShare * move.room_mm);
    // Down, so that rounding makes no two blends meet.
    const double blend_um = std::floor(1e3 * blend_mm + kRoundingOfBlend);
    text += ", r=" + trimmedDecimals(1e-6 * blend_um, kUrDecimals) + ")";
    addLine(text);
    for (const std::string& note : notes_) addLine(note);
    notes_.clear();
  }

  void add(const NoteLine& note) {
    for (const std::string& comment : noteComments(note.text, "#", kUrNoteWidth)) {
      if (pending_)
        notes_.push_back(comment);
      else
        addLine(comment);
    }
  }

  void add(const JointMove& move) {
    std::string text = "movej([";
    for (std::size_t j = 0; j < 6; ++j)
      text += (j > 0 ? ", " : "") + decimalText(toRadians(move.joints.arm_deg[j]), kUrDecimals);
    addLine(text + "], a=" + trimmedDecimals(site_.settings.urscript.joint_acceleration_rad_s2, 3) +
            ", v=" + trimmedDecimals(0.01 * site_.settings.joint_speed_percent * kUrFastestJoint, 3) + ")");
    ++points_;
  }

  void add(const TipMove& move) {
    pending_ = move;
    ++points_;
  }

  void add(const OutputSwitch& output) {
    requireUrOutput(output.output, kLastUrOutput, "digital");
    addProcess("set_standard_digital_out(" + std::to_string(output.output) + ", " +
                   (output.is_on ? "True" : "False") + ")",
               output.is_on);
  }

  /// A dry run passes over what starts the process or sets its level.
  void addProcess(const std::string& line, bool starts) {
    if (!starts || site_.settings.dry_flag == 0) return addLine(line);
    addLine("if not lamina_dry:");
    addLine("  " + line);
    addLine("end");
  }

  void add(const ArcSwitch&) {}  // refused before

  void add(const LevelChange& level) {
    requireUrOutput(level.output, kLastUrLevel, "analogue");
    if (!(level.value >= 0.0 && level.value <= 1.0))
      throw InvalidInput("analogue output " + std::to_string(level.output) + " is to be set to " +
                         numberText(level.value) + "; URScript takes 0 to 1 (robot_program.levels)");
    addProcess("set_standard_analog_out(" + std::to_string(level.output) + ", " +
                   trimmedDecimals(level.value, kUrDecimals) + ")",
               level.value != 0.0);
  }

  void add(const ProgramWait& wait) { addLine("sleep(" + trimmedDecimals(wait.duration_s, 3) + ")"); }

  void add(const ToolStatement&) {}  // stands in the head

  void add(const FileCall& call) {
    throw InvalidInput("a script cannot run the file '" + call.name +
                       "'; expected files that are run one by one");
  }

  const RobotSite& site_;
  Eigen::Isometry3d base_from_bed_ = Eigen::Isometry3d::Identity();
  std::string body_;
  std::optional<TipMove> pending_;  ///< until it is known whether the tip rests at its end
  std::vector<std::string> notes_;  ///< behind it
  std::size_t lines_ = 0;
  std::size_t points_ = 0;
};

std::unique_ptr<RobotPrinter> openUrScript(const RobotSite& site) {
  return std::make_unique<UrScriptPrinter>(site);
}

std::string urScriptName(const std::string& asked, const RobotProgramSettings&) {
  requireProgramName(asked, kLongestUrName, RobotLanguage::UrScript);
  requireFreeName(asked, kUrWords, RobotLanguage::UrScript);
  return asked;
}

}  // namespace

RobotDialect urScriptDialect(const RobotProgramSettings& settings) {
  RobotDialect dialect;
  dialect.language = RobotLanguage::UrScript;
  dialect.limits.points = static_cast<std::size_t>(settings.urscript.max_points);
  dialect.limit_key = "urscript.max_points";
  dialect.has_calls = false;
  dialect.open = openUrScript;
  dialect.name = urScriptName;
  return dialect;
}

}  // namespace lamina
