// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The node gcode_streamer under a loop that trims layers and plans those left anew.
#include <actionlib/client/simple_action_client.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>

#include "conversions.hpp"
#include "correction_messages.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/control/program/planned_correction.hpp"
#include "lamina/control/replanned_toolpath.hpp"
#include "lamina/program/gcode/gcode_writer.hpp"
#include "lamina/streaming/job/streamable_program.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "latched.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "ros/node_process.hpp"
#include "ros/ros_home.hpp"
#include "ros/wait_until.hpp"
#include "service_call.hpp"
#include "streamed_machine.hpp"
#include "support/control_layers.hpp"
#include "support/corrected_programs.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

using lamina_msgs::MachineState;
using test::kPatience;
using test::waitUntil;
using Client = actionlib::SimpleActionClient<lamina_msgs::StreamProgramAction>;

/// Three layers of two beads of 40 mm, each of them many motions.
MachineToolpath finePart() {
  MachineToolpath placed;
  placed.toolpath = test::stackedBeads(3);
  for (ToolpathLayer& layer : placed.toolpath.layers)
    for (Path& path : layer.paths) {
      if (path.role == PathRole::Travel) continue;
      const Point3 start = path.firstPoint();
      path.points.clear();
      for (int i = 0; i <= 80; ++i) path.points.push_back(start + Point3(0.5 * i, 0.0, 0.0));
    }
  placed.bed_from_part = Eigen::Translation3d(50.0, 60.0, 0.0);
  placed.id = toolpathId(placed.toolpath);
  return placed;
}

CorrectionMap evenMap(const MachineToolpath& part, std::size_t layer, double amount, std::uint64_t sequence) {
  const LayerCells cells = layerCells(part.toolpath.layers[layer], layer, 0.5);
  return correctionMap(cells, {std::vector<double>(cells.size(), amount), {}, {}}, part.id, sequence);
}

std::string textOf(const MachineToolpath& part, const ProgramSettings& settings = {}) {
  std::string text;
  writeGcode(part.toolpath, part.bed_from_part, settings, [&](std::string_view piece) { text += piece; });
  return text;
}

std::vector<std::string> commandsOf(const std::string& text) {
  std::vector<std::string> commands;
  ProgramCursor cursor = StreamableProgram::fromText("program", text).open();
  while (const auto line = cursor.next()) commands.push_back(line->command);
  return commands;
}

/// A node of a name of its own, at a machine of its own, and what the loop has to do with it.
class CorrectedCell {
 public:
  CorrectedCell(const std::string& name, double speed_up, std::vector<std::string> parameters)
      : port(test::inRosHome("corrected_stream_" + name)),
        machine(speed_up, port),
        space_("/" + name),
        toolpath(node_.advertise<lamina_msgs::Toolpath>(space_ + "/toolpath", 1, true)),
        correction(node_.advertise<lamina_msgs::CorrectionMap>(space_ + "/correction", 10, true)),
        plan(node_.advertise<lamina_msgs::Toolpath>(space_ + "/replanned_toolpath", 1, true)) {
    parameters.insert(parameters.begin(),
                      {"__ns:=" + space_, "_port:=" + port, "_corrections/use:=true", "_loop/wait_s:=30"});
    arguments_ = std::move(parameters);
    listen();
  }

  void begin(const MachineToolpath& part) {
    states.clear();  // of one that was killed
    node = std::make_unique<test::NodeProcess>(LAMINA_STREAMER_NODE, arguments_);
    publishLatched(toolpath, toMessage(part));
    EXPECT_TRUE(waitUntil([&] {
      // The cell itself listens to toolpaths as well.
      return toolpath.getNumSubscribers() > 1 && correction.getNumSubscribers() > 0 &&
             uses_.getNumPublishers() > 0 && !states.empty();
    }));
    client = std::make_unique<Client>(space_ + "/stream_program", true);
    EXPECT_TRUE(client->waitForServer(ros::Duration(kPatience)));
  }
  void send(const CorrectionMap& map) { publishLatched(correction, toMessage(map)); }
  void stream(const MachineToolpath& part) {
    lamina_msgs::StreamProgramGoal goal;
    goal.toolpath_id = part.id;
    client->sendGoal(goal);
  }
  bool isAnswered(const std::string& service) {
    std_srvs::Trigger trigger;
    return callService(space_ + "/" + service, trigger) && trigger.response.success != 0;
  }
  /// A plan is tried once the machine waits for its layer, and refused before: it is offered until then.
  bool offer(const MachineToolpath& planned, const std::function<bool()>& is_taken) {
    const lamina_msgs::Toolpath message = toMessage(planned);
    std::size_t answers = refusals.size();
    return waitUntil([&] {
      if (is_taken()) return true;
      if (refusals.size() < answers) return false;
      plan.publish(message);
      ++answers;
      return false;
    });
  }
  bool isApplied(std::size_t layers) {
    return waitUntil([&] { return applied.size() >= layers; });
  }

  std::string port;
  test::StreamedMachine machine;
  std::unique_ptr<test::NodeProcess> node;
  std::unique_ptr<Client> client;
  std::vector<lamina_msgs::AppliedCorrection> applied;
  std::vector<lamina_msgs::AppliedCorrection> refusals;  ///< of plans
  std::vector<std::string> states;
  std::vector<lamina_msgs::Toolpath> toolpaths;  ///< announced by anybody

 private:
  void listen() {
    const boost::function<void(const lamina_msgs::AppliedCorrectionConstPtr&)> on_applied =
        [this](const auto& message) { (isRefusalOfPlan(*message) ? refusals : applied).push_back(*message); };
    const boost::function<void(const lamina_msgs::MachineStateConstPtr&)> on_state =
        [this](const auto& message) {
          if (states.empty() || states.back() != message->state_name) states.push_back(message->state_name);
        };
    const boost::function<void(const lamina_msgs::ToolpathConstPtr&)> on_toolpath =
        [this](const auto& message) { toolpaths.push_back(*message); };
    uses_ = node_.subscribe<lamina_msgs::AppliedCorrection>(space_ + "/applied_correction", 100, on_applied);
    states_ = node_.subscribe<MachineState>(space_ + "/machine_state", 1000, on_state);
    toolpaths_ = node_.subscribe<lamina_msgs::Toolpath>(space_ + "/toolpath", 10, on_toolpath);
  }

  std::string space_;
  ros::NodeHandle node_;

 public:
  ros::Publisher toolpath, correction, plan;

 private:
  ros::Subscriber uses_, states_, toolpaths_;
  std::vector<std::string> arguments_;
};

/// How fast the machine runs: the layer that is trimmed lasts 4 s, for the trim to be made and to arrive.
constexpr double kSlow = 2.0;

/// Streams the program of a part, whose second layer begins by a map and is trimmed by another.
void beginTrimmed(CorrectedCell& cell, const MachineToolpath& part, const std::string& program) {
  cell.begin(part);
  writeFile(program, textOf(part));
  lamina_msgs::StreamProgramGoal goal;
  goal.program = program;
  cell.client->sendGoal(goal);
  ASSERT_TRUE(cell.isApplied(1));
  cell.send(evenMap(part, 1, 0.3, 1));
  ASSERT_TRUE(cell.isApplied(2));
  cell.send(evenMap(part, 1, -0.2, 2));
}

/// A layer that is under way is trimmed for what was not sent. What was applied says what was run.
TEST(CorrectedStream, TrimsALayerThatIsUnderWay) {
  const test::ScratchFolder folder;
  const MachineToolpath part = finePart();
  CorrectedCell cell("trimmed", kSlow, {"_corrections/folder:=" + folder.file("record")});
  const std::string program = folder.file("part.gcode");
  ASSERT_NO_FATAL_FAILURE(beginTrimmed(cell, part, program));
  cell.send(evenMap(part, 2, 0.0, 1));
  EXPECT_TRUE(waitUntil([&] { return cell.client->getState().isDone(); }));
  EXPECT_EQ(cell.client->getState().toString(), "SUCCEEDED") << cell.client->getState().getText();
  const PlannedCorrection applied = test::recordedIn(folder.file("record"));
  ASSERT_EQ(applied.maps.size(), 3U);
  EXPECT_EQ(applied.maps[1].map.layer, 1U);
  EXPECT_GT(applied.maps[1].from_line, applied.maps[0].from_line);
  const CorrectedProgram made = correctedByMaps("part.gcode", textOf(part), applied);
  EXPECT_EQ(cell.machine.commands(), commandsOf(made.text)) << "made again from the record";
  // Some of the layer's 160 motions are deposited by the first map, the others by the trim.
  EXPECT_LT(made.report.corrected_mm, 1.3 * made.report.planned_mm);
  EXPECT_GT(made.report.corrected_mm, 0.8 * made.report.planned_mm);
}

/// A node that is killed amid a trimmed layer: what was sent is made again from its record, and the rest is
/// deposited as planned, each line once.
TEST(CorrectedStream, IsGoneOnWithByItsRecordAfterAKill) {
  const test::ScratchFolder folder;
  const MachineToolpath part = finePart();
  const std::string journal = folder.file("job.progress");
  CorrectedCell cell("killed", kSlow,
                     {"_corrections/folder:=" + folder.file("record"), "_stream/journal:=" + journal});
  const std::string program = folder.file("part.gcode");
  ASSERT_NO_FATAL_FAILURE(beginTrimmed(cell, part, program));
  const std::string trimmed = folder.file("record/layer_1_2.csv");
  ASSERT_TRUE(waitUntil([&] { return std::ifstream(trimmed).good(); }));
  const std::size_t ran = cell.machine.commands().size();
  ASSERT_TRUE(waitUntil([&] { return cell.machine.commands().size() > ran + 20; }));
  EXPECT_EQ(cell.node->end(SIGKILL), -1);
  const std::string go_on = std::string(LAMINA_COMMAND) + " stream " + program + " --port " + cell.port +
                            " --set stream.journal=" + journal + " --resume";
  EXPECT_NE(std::system((go_on + " 2> /dev/null").c_str()), 0) << "without the record";
  const std::string by_record = go_on + " --corrections " + folder.file("record");
  EXPECT_NE(std::system((by_record + " --set loop.lag_s=1 2> /dev/null").c_str()), 0) << "by other settings";
  EXPECT_EQ(std::system((by_record + " > /dev/null").c_str()), 0);
  const PlannedCorrection applied = test::recordedIn(folder.file("record"));
  EXPECT_EQ(applied.maps.size(), 2U);
  EXPECT_EQ(cell.machine.commands(), commandsOf(correctedByMaps("part.gcode", textOf(part), applied).text));
}

/// The same by a node that takes the place of the one that was killed: the layers left are announced to the
/// loop.
TEST(CorrectedStream, GoesOnByItsRecordItself) {
  const test::ScratchFolder folder;
  const MachineToolpath part = finePart();
  CorrectedCell cell(
      "resumed", kSlow,
      {"_corrections/folder:=" + folder.file("record"), "_stream/journal:=" + folder.file("job.progress")});
  const std::string program = folder.file("part.gcode");
  ASSERT_NO_FATAL_FAILURE(beginTrimmed(cell, part, program));
  ASSERT_TRUE(waitUntil([&] { return std::ifstream(folder.file("record/layer_1_2.csv")).good(); }));
  const std::size_t ran = cell.machine.commands().size();
  ASSERT_TRUE(waitUntil([&] { return cell.machine.commands().size() > ran + 20; }));
  EXPECT_EQ(cell.node->end(SIGKILL), -1);
  cell.begin(part);
  lamina_msgs::StreamProgramGoal goal;
  goal.program = program;
  goal.resume = true;
  cell.client->sendGoal(goal);
  EXPECT_TRUE(waitUntil([&] { return cell.client->getState().isDone(); }));
  EXPECT_EQ(cell.client->getState().toString(), "SUCCEEDED") << cell.client->getState().getText();
  const PlannedCorrection applied = test::recordedIn(folder.file("record"));
  EXPECT_EQ(applied.maps.size(), 2U);
  EXPECT_EQ(cell.machine.commands(), commandsOf(correctedByMaps("part.gcode", textOf(part), applied).text))
      << "every line once";
  ASSERT_TRUE(cell.isApplied(3));
  EXPECT_EQ(cell.applied.back().layer, 2U);
  EXPECT_EQ(cell.applied.back().digest, "");
  EXPECT_NE(cell.applied.back().reason.find("gone on with from its record"), std::string::npos)
      << cell.applied.back().reason;
}

/// The layers left from one on planned anew, as one of 2 mm.
MachineToolpath planOf(const MachineToolpath& part, std::size_t layer) {
  MachineToolpath plan = part;
  plan.toolpath = replannedToolpath(part.toolpath, {layer, 0.0}, {{2.0}, 1.0});
  plan.id = replannedId(plan.toolpath, layer, part.id);
  return plan;
}

/// In front of the second layer the two left are planned anew.
TEST(CorrectedStream, GoesOverToLayersPlannedAnew) {
  const MachineToolpath part = finePart();
  CorrectedCell cell("planned", 0.0, {"_corrections/follow_plans:=true"});
  cell.begin(part);
  cell.stream(part);
  ASSERT_TRUE(cell.isApplied(1));
  const MachineToolpath plan = planOf(part, 1);
  const auto isFollowed = [&] { return !cell.toolpaths.empty() && cell.toolpaths.back().id == plan.id; };
  ASSERT_TRUE(cell.offer(plan, isFollowed));
  CorrectionMap map = evenMap(plan, 0, 0.25, 1);
  cell.send(map);
  EXPECT_TRUE(waitUntil([&] { return cell.client->getState().isDone(); }));
  EXPECT_EQ(cell.client->getState().toString(), "SUCCEEDED") << cell.client->getState().getText();
  std::vector<std::string> expected;
  for (const std::string& command : commandsOf(textOf(part))) {
    if (command.find("Z3") != std::string::npos) break;  // the travel to the second layer
    expected.push_back(command);
  }
  ProgramSettings going_on;
  going_on.start_code.clear();
  map.toolpath_id = toolpathId(placed(plan.toolpath, plan.bed_from_part));
  const std::string rest =
      correctedProgram(textOf(plan, going_on), placed(plan.toolpath, plan.bed_from_part), {map}, {}).text;
  for (const std::string& command : commandsOf(rest)) expected.push_back(command);
  EXPECT_EQ(cell.machine.commands(), expected);
  EXPECT_TRUE(waitUntil([&] { return cell.states.back() == "Complete"; }));
  EXPECT_EQ(cell.states, (std::vector<std::string>{"Idle", "Starting", "Execute", "Completing", "Complete"}))
      << "one job to its end";
  ASSERT_TRUE(cell.isApplied(2));
  EXPECT_EQ(cell.applied[0].toolpath_id, part.id);
  EXPECT_EQ(cell.applied[1].toolpath_id, plan.id);
  EXPECT_EQ(cell.applied[1].digest, toMessage(evenMap(plan, 0, 0.25, 1)).digest);
  cell.stream(part);
  EXPECT_TRUE(cell.isApplied(3)) << "what it published itself takes no toolpath's place: "
                                 << cell.client->getState().getText();
  EXPECT_EQ(cell.applied.back().toolpath_id, part.id);
  cell.client->cancelGoal();
  EXPECT_TRUE(waitUntil([&] { return cell.client->getState().isDone(); }));
}

/// The loop is informed of plans that are not gone on with; where one cannot be written, the job is held, and
/// once it is let go on its layer is waited for anew.
TEST(CorrectedStream, ReportsPlansThatItDoesNotGoOnWith) {
  const MachineToolpath part = finePart();
  CorrectedCell cell("refused", 0.0, {"_corrections/follow_plans:=true"});
  cell.begin(part);
  cell.stream(part);
  ASSERT_TRUE(cell.isApplied(1));
  const MachineToolpath elsewhere = planOf(part, 2);
  cell.plan.publish(toMessage(elsewhere));
  ASSERT_TRUE(waitUntil([&] { return !cell.refusals.empty(); }));
  EXPECT_EQ(cell.refusals[0].toolpath_id, elsewhere.id);
  EXPECT_NE(cell.refusals[0].reason.find("it begins with layer 2"), std::string::npos)
      << cell.refusals[0].reason;
  MachineToolpath foreign = planOf(part, 1);
  foreign.machine = "another_machine";
  const auto isHeld = [&] { return !cell.states.empty() && cell.states.back() == "Held"; };
  ASSERT_TRUE(cell.offer(foreign, isHeld));
  ASSERT_TRUE(
      waitUntil([&] { return cell.refusals.back().reason.find("another_machine") != std::string::npos; }));
  EXPECT_EQ(cell.refusals.back().toolpath_id, foreign.id);
  EXPECT_EQ(cell.toolpaths.back().id, part.id);
  EXPECT_TRUE(cell.isAnswered("resume"));
  cell.send(evenMap(part, 1, 0.2, 1));
  EXPECT_TRUE(cell.isApplied(2));
  EXPECT_EQ(cell.applied.back().digest, toMessage(evenMap(part, 1, 0.2, 1)).digest);
  cell.send(evenMap(part, 2, 0.0, 1));
  EXPECT_TRUE(waitUntil([&] { return cell.client->getState().isDone(); }));
  EXPECT_EQ(cell.client->getState().toString(), "SUCCEEDED") << cell.client->getState().getText();
}

/// While a plan of a million points is written the node takes what is asked of it, and a job that has
/// ended meanwhile is not gone on with.
TEST(CorrectedStream, AnswersWhileAPlanIsWritten) {
  const test::ScratchFolder folder;
  const MachineToolpath part = finePart();
  CorrectedCell cell("busy", 0.0,
                     {"_corrections/follow_plans:=true", "_corrections/folder:=" + folder.file("record"),
                      "_loop/wait_s:=600"});
  cell.begin(part);
  cell.stream(part);
  ASSERT_TRUE(cell.isApplied(1));
  MachineToolpath plan = planOf(part, 1);
  for (Path& path : plan.toolpath.layers[0].paths) {
    if (path.role == PathRole::Travel) continue;
    const Point3 start = path.firstPoint();
    const Point3 end = path.points.back();
    constexpr int kSteps = 500'000;
    path.points.clear();
    for (int i = 0; i <= kSteps; ++i) path.points.push_back(start + (i / double{kSteps}) * (end - start));
  }
  plan.id = replannedId(plan.toolpath, 1, part.id);
  // Its record begins while it is written.
  const std::string record = folder.file("record") + "/" + plan.id;
  ASSERT_TRUE(cell.offer(plan, [&] { return std::filesystem::exists(record); }));
  const std::size_t refused = cell.refusals.size();
  EXPECT_TRUE(cell.isAnswered("abort"));
  EXPECT_TRUE(waitUntil([&] { return cell.client->getState().isDone(); }));
  EXPECT_TRUE(waitUntil([&] { return cell.refusals.size() > refused; }));
  EXPECT_NE(cell.refusals.back().reason.find("the job has ended"), std::string::npos)
      << cell.refusals.back().reason;
  EXPECT_EQ(cell.toolpaths.back().id, part.id);
}

}  // namespace
}  // namespace lamina
