// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/krl/krl_printer.hpp"

#include <cmath>

#include "base/decimals.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/program/robot/robot_angles.hpp"
#include "program/robot/notes/robot_notes.hpp"

namespace lamina {
namespace {

constexpr std::size_t kLongestKrlName = 24;
constexpr std::size_t kKrlNoteWidth = 200;
constexpr std::size_t kLongestKrlTemplate = 120;
constexpr int kKrlPositionDecimals = 3;  // mm
constexpr int kKrlAngleDecimals = 4;     // deg
constexpr int kKrlSpeedDecimals = 6;     // m/s
constexpr int kKrlLevelDecimals = 6;
constexpr double kGreatestKrlLevel = 1.0;  // of $ANOUT, as a share of 10 V
constexpr double kMetreOfSpeed = 1e-3;     // m/s in mm/s

/// Keywords, and the program that each program calls first.
const std::vector<std::string_view> kKrlWords = {
    "and",      "bas",        "bool",      "brake",    "case",       "channel",      "char",    "circ",
    "circ_rel", "confirm",    "const",     "continue", "decl",       "def",          "default", "defdat",
    "deffct",   "delay",      "do",        "else",     "end",        "enddat",       "endfct",  "endfor",
    "endif",    "endloop",    "endswitch", "endwhile", "enum",       "error",        "exit",    "ext",
    "extfct",   "false",      "for",       "frame",    "global",     "goto",         "halt",    "if",
    "import",   "int",        "interrupt", "is",       "lamina_dry", "lamina_speed", "lin",     "lin_rel",
    "loop",     "maximum",    "minimum",   "not",      "or",         "path",         "pos",     "prio",
    "ptp",      "ptp_rel",    "public",    "pulse",    "real",       "repeat",       "resume",  "return",
    "sec",      "sensor_off", "sensor_on", "signal",   "spline",     "spline_lin",   "struc",   "switch",
    "then",     "to",         "trigger",   "true",     "until",      "wait",         "when",    "while",
    "with"};

void appendKrlExternal(const std::vector<double>& external, const std::vector<JointKind>& kinds,
                       std::string& text) {
  for (std::size_t k = 0; k < external.size(); ++k) {
    requireInFormat(external[k], kinds[k] == JointKind::Linear ? "mm" : "deg", RobotLanguage::Krl);
    text += ",E" + std::to_string(k + 1) + " " + decimalText(external[k], kKrlAngleDecimals);
  }
}

std::string krlLevel(int output, double value) {
  if (!(std::abs(value) <= kGreatestKrlLevel))
    throw InvalidInput("analogue output " + std::to_string(output) + " is to be set to " + numberText(value) +
                       "; KRL takes -1 to 1 (robot_program.levels)");
  return "$ANOUT[" + std::to_string(output) + "]=" + trimmedDecimals(value, kKrlLevelDecimals);
}

/// A template with numbers put in, and one blank between words.
std::string krlFilled(const std::string& text, const std::string& mark, int number) {
  std::string filled = text;
  for (std::size_t at = filled.find(mark); at != std::string::npos; at = filled.find(mark, at))
    filled.replace(at, mark.size(), std::to_string(number));
  std::string single;
  for (const char c : filled)
    if (c != ' ' || (!single.empty() && single.back() != ' ')) single += c;
  return single;
}

std::string krlArc(const ArcSwitch& arc, const KrlSettings& settings) {
  const std::string& text = arc.is_on ? settings.arc_on : settings.arc_off;
  return krlFilled(krlFilled(text, "{schedule}", arc.schedule), "{weave}", arc.weave);
}

void requireKrlTemplate(const std::string& key, const std::string& text) {
  const bool is_plain = text == plainText(text) && text.size() <= kLongestKrlTemplate && !text.empty() &&
                        ((text[0] >= 'A' && text[0] <= 'Z') || (text[0] >= 'a' && text[0] <= 'z')) &&
                        text.back() != ' ';
  if (!is_plain)
    throw InvalidConfig(key + " is '" + text +
                        "' with robot_program.process 'schedules'; must be a statement " +
                        "of the controller's arc package on one line, a letter first, of at most " +
                        std::to_string(kLongestKrlTemplate) + " characters");
}

void requireKrlArc(const RobotProgramSettings& settings) {
  requireKrlTemplate("krl.arc_on", settings.krl.arc_on);
  requireKrlTemplate("krl.arc_off", settings.krl.arc_off);
  // A template may state what it needs by itself.
  const auto takesSchedule = [](const std::string& text) {
    return text.find("{schedule}") != std::string::npos;
  };
  if (takesSchedule(settings.krl.arc_on))
    requireSchedule("robot_program.start_schedule", settings.arc.start_schedule);
  if (takesSchedule(settings.krl.arc_off))
    requireSchedule("robot_program.end_schedule", settings.arc.end_schedule);
  if (settings.krl.arc_on == settings.krl.arc_off)
    throw InvalidConfig("krl.arc_on and krl.arc_off are both '" + settings.krl.arc_on + "'; must differ");
  if (settings.arc.weave_schedule > 0 && settings.krl.arc_on.find("{weave}") == std::string::npos)
    throw InvalidConfig("krl.arc_on is '" + settings.krl.arc_on + "' with robot_program.weave_schedule " +
                        std::to_string(settings.arc.weave_schedule) + "; expected {weave} in it, or 0");
}

void requireCountedFromOne(const char* key, int number, const char* table) {
  if (number < 1)
    throw InvalidConfig(std::string(key) + " is " + std::to_string(number) +
                        "; expected 1 at least in KRL, whose " + table + " has no 0");
}

class KrlPrinter : public RobotPrinter {
 public:
  explicit KrlPrinter(const RobotSite& site) : site_(site) {
    if (site.settings.arc.process == RobotProcess::Schedules) requireKrlArc(site.settings);
    requireCountedFromOne("robot_program.tool_number", site.settings.tool_number, "TOOL_DATA");
    requireCountedFromOne("robot_program.frame_number", site.settings.frame_number, "BASE_DATA");
    has_dry_variable_ = site.settings.dry_flag > 0 && !robotLevels(site.settings.levels).empty();
  }

  void print(const RobotStatement& statement) override {
    std::visit([this](const auto& each) { add(each); }, statement);
  }

  RobotFileSize size() const override { return {lines_, points_}; }

  std::vector<RobotFile> files(const RobotFileHead& head) const override {
    std::string text = "&ACCESS RVP\n&REL 1\nDEF " + head.name + "()\n" + declaration() +
                       "; generated by Lamina\n; part: " + plainText(head.part_name) + "\n";
    for (const std::string& note : head.notes) text += noteText(note);
    text += arcNotes();
    if (points_ > 0) text += preparation();
    std::vector<RobotFile> files = {{head.name + ".src", text + body_ + "END\n"}};
    if (!data_.empty())
      files.push_back({head.name + ".dat", "DEFDAT " + head.name + "\n" + data_ + "ENDDAT\n"});
    return files;
  }

 private:
  static std::string noteText(const std::string& note) {
    std::string text;
    for (const std::string& comment : noteComments(note, ";", kKrlNoteWidth)) text += comment + "\n";
    return text;
  }

  /// In each file: its statements are known by them.
  std::string arcNotes() const {
    const ArcSettings& arc = site_.settings.arc;
    if (arc.process == RobotProcess::Outputs || points_ == 0) return "";
    const ArcSwitch on{true, arc.start_schedule, arc.weave_schedule};
    const ArcSwitch off{false, arc.end_schedule, arc.weave_schedule};
    return noteText(std::string(kArcOnNote) + " " + krlArc(on, site_.settings.krl)) +
           noteText(std::string(kArcOffNote) + " " + krlArc(off, site_.settings.krl));
  }

  void addLine(const std::string& line) {
    body_.append(line).append("\n");
    ++lines_;
  }

  void add(const NoteLine& note) {
    for (const std::string& comment : noteComments(note.text, ";", kKrlNoteWidth)) addLine(comment);
  }

  void add(const JointMove& move) {
    std::string text = "PTP {";
    for (std::size_t j = 0; j < 6; ++j)
      text += (j > 0 ? ",A" : "A") + std::to_string(j + 1) + " " +
              decimalText(move.joints.arm_deg[j], kKrlAngleDecimals);
    appendKrlExternal(move.joints.external, site_.external, text);
    addLine(text + "}");
    ++points_;
  }

  void add(const TipMove& move) {
    const std::string speed = trimmedDecimals(move.feed_mm_s * kMetreOfSpeed, kKrlSpeedDecimals);
    if (speed != speed_)
      addLine("$VEL.CP=" + speed + (site_.hasDrySpeed() ? "*" + std::string(kDrySpeedVariable) : ""));
    speed_ = speed;
    ++points_;
    std::string target = pose(move);
    if (site_.settings.krl.points == KrlPoints::Dat) {
      const std::string name = "XP" + std::to_string(points_);
      data_.append("DECL E6POS ").append(name).append("=").append(target).append("\n");
      target = name;
    }
    const bool is_rounded = !move.rests && site_.settings.corner_mm > 0.0;
    addLine("LIN " + target + (is_rounded ? " C_DIS" : ""));
  }

  std::string pose(const TipMove& move) {
    for (const double coordinate : move.point) requireInFormat(coordinate, "mm", RobotLanguage::Krl);
    const RobotAngles angles = robotAngles(move.orientation, last_x_deg_);
    last_x_deg_ = angles.x_deg;
    std::string text = "{X " + decimalText(move.point.x(), kKrlPositionDecimals) + ",Y " +
                       decimalText(move.point.y(), kKrlPositionDecimals) + ",Z " +
                       decimalText(move.point.z(), kKrlPositionDecimals) + ",A " +
                       decimalText(angles.z_deg, kKrlAngleDecimals) + ",B " +
                       decimalText(angles.y_deg, kKrlAngleDecimals) + ",C " +
                       decimalText(angles.x_deg, kKrlAngleDecimals);
    appendKrlExternal(move.external, site_.external, text);
    return text + "}";
  }

  void add(const OutputSwitch& output) {
    requireOutputNumber(output.output, RobotLanguage::Krl);
    const std::string flag = "$FLAG[" + std::to_string(site_.settings.dry_flag) + "]";
    if (output.is_on && has_dry_variable_) addLine(std::string(kDryVariable) + "=" + flag);
    addProcess("$OUT[" + std::to_string(output.output) + "]=" + (output.is_on ? "TRUE" : "FALSE"),
               output.is_on, flag);
  }

  /// Comes before all statements.
  std::string declaration() const {
    if (points_ == 0) return "";
    return (has_dry_variable_ ? "DECL BOOL " + std::string(kDryVariable) + "\n" : "") +
           (site_.hasDrySpeed() ? "DECL REAL " + std::string(kDrySpeedVariable) + "\n" : "");
  }

  /// A variable of the program itself: an override of the controller would outlast it.
  std::string drySpeed() const {
    if (!site_.hasDrySpeed()) return "";
    const std::string variable(kDrySpeedVariable);
    return variable + "=1.0\nIF $FLAG[" + std::to_string(site_.settings.dry_flag) + "] THEN\n" + variable +
           "=" + trimmedDecimals(0.01 * site_.settings.dry_speed_percent, kKrlSpeedDecimals) + "\nENDIF\n";
  }

  /// What starts the process, or sets its level, is passed over in a dry run.
  /// @param dry  what is TRUE in one
  void addProcess(const std::string& line, bool starts, const std::string& dry) {
    const bool is_conditional = starts && site_.settings.dry_flag > 0;
    if (is_conditional) addLine("IF NOT " + dry + " THEN");
    addLine(line);
    if (is_conditional) addLine("ENDIF");
  }

  void add(const ArcSwitch& arc) { addLine(krlArc(arc, site_.settings.krl)); }

  /// An assignment would stop the controller from looking ahead, and the tip with it, and so may a look at
  /// one of its own variables.
  void add(const LevelChange& level) {
    requireOutputNumber(level.output, RobotLanguage::Krl);
    addProcess((level.is_on_the_way ? "TRIGGER WHEN DISTANCE=0 DELAY=0 DO " : "") +
                   krlLevel(level.output, level.value),
               level.value != 0.0,
               level.is_on_the_way ? std::string(kDryVariable)
                                   : "$FLAG[" + std::to_string(site_.settings.dry_flag) + "]");
  }

  void add(const ProgramWait& wait) { addLine("WAIT SEC " + trimmedDecimals(wait.duration_s, 3)); }

  void add(const ToolStatement&) {}  // stands in the head

  void add(const FileCall& call) { addLine(call.name + "()"); }

  /// That of the tool on the controller, if no other is known: it goes with the tool.
  std::string load() const {
    const RobotProgramSettings& settings = site_.settings;
    if (settings.tool_mass_kg == 0.0) return "LOAD_DATA[" + std::to_string(settings.tool_number) + "]";
    std::string text = "{M " + trimmedDecimals(settings.tool_mass_kg, kKrlPositionDecimals) + ",CM {";
    for (std::size_t axis = 0; axis < 3; ++axis)
      text += std::string(1, "XYZ"[axis]) + " " +
              decimalText(settings.tool_centre_of_gravity_mm[axis], kKrlPositionDecimals) + ",";
    return text + "A 0.0,B 0.0,C 0.0},J {X 0.0,Y 0.0,Z 0.0}}";
  }

  std::string preparation() const {
    const RobotProgramSettings& settings = site_.settings;
    const std::string frame = "BASE_DATA[" + std::to_string(settings.frame_number) + "]";
    const bool is_carried = site_.cell && site_.cell->is_bed_carried;
    std::string text = "BAS(#INITMOV,0)\nBAS(#VEL_PTP," + trimmedDecimals(settings.joint_speed_percent, 1) +
                       ")\n$ADVANCE=" + std::to_string(settings.krl.advance) +
                       "\n$IPO_MODE=#BASE\n$ORI_TYPE=#VAR\n$TOOL=TOOL_DATA[" +
                       std::to_string(settings.tool_number) + "]\n$LOAD=" + load() + "\n";
    // The frame of a bed that an external axis carries goes with that axis.
    text += is_carried
                ? "$BASE=EK(MACHINE_DEF[2].ROOT,MACHINE_DEF[2].MECH_TYPE," + frame + ")\n$ACT_EX_AX=2\n"
                : "$BASE=" + frame + "\n";
    const std::string turn = trimmedDecimals(settings.krl.turn_speed_deg_s, 3);
    return text + "$VEL.ORI1=" + turn + "\n$VEL.ORI2=" + turn +
           "\n$ACC.CP=" + trimmedDecimals(settings.krl.acceleration_m_s2, 3) +
           "\n$APO.CDIS=" + trimmedDecimals(settings.corner_mm, 3) + "\n" + drySpeed();
  }

  const RobotSite& site_;
  std::string body_;
  std::string data_;
  std::string speed_;
  std::size_t lines_ = 0;
  std::size_t points_ = 0;
  double last_x_deg_ = 0.0;
  bool has_dry_variable_ = false;  ///< the program's own, for levels that change on the way
};

std::unique_ptr<RobotPrinter> openKrl(const RobotSite& site) { return std::make_unique<KrlPrinter>(site); }

std::string krlName(const std::string& asked, const RobotProgramSettings&) {
  requireProgramName(asked, kLongestKrlName, RobotLanguage::Krl);
  requireFreeName(asked, kKrlWords, RobotLanguage::Krl);
  return asked;
}

}  // namespace

RobotDialect krlDialect(const RobotProgramSettings& settings) {
  RobotDialect dialect;
  dialect.language = RobotLanguage::Krl;
  dialect.limits.lines = static_cast<std::size_t>(settings.krl.max_lines);
  dialect.limits.bytes_in_all = static_cast<std::size_t>(settings.krl.max_mb * 1e6);
  dialect.limit_key = "krl.max_lines, krl.max_mb";
  dialect.open = openKrl;
  dialect.name = krlName;
  return dialect;
}

}  // namespace lamina
