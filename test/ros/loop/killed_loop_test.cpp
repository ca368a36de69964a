// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The loop is killed while a layer is deposited, and started again: what the machine does meanwhile, through
// all nodes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lamina/control/program/correction_files.hpp"
#include "ros/loop/scanned_wall.hpp"
#include "ros/loop/streamed_cell.hpp"
#include "ros/node_process.hpp"
#include "ros/ros_home.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

using test::kLayer;
using test::waitUntil;

constexpr std::size_t kLayers = 14;
constexpr std::size_t kKilledIn = 5;  // layer

/// Where the loop's maps are published: the test hands them on.
constexpr char kLoopCorrection[] = "loop_correction";

/// A cell whose loop the test starts and kills. The map of `kKilledIn` is withheld, so that the loop can be
/// stopped before any of that layer is deposited, however long that takes.
class KilledCell : public test::StreamedCell {
 public:
  explicit KilledCell(std::string memory) : StreamedCell("killed"), memory_(std::move(memory)) {
    const boost::function<void(const lamina_msgs::AppliedCorrectionConstPtr&)> on_applied =
        [this](const auto& message) { applied.push_back(*message); };
    const boost::function<void(const lamina_msgs::MachineStateConstPtr&)> on_state =
        [this](const auto& message) { machine_layer = message->layer; };
    const boost::function<void(const lamina_msgs::LoopStateConstPtr&)> on_loop = [this](const auto& message) {
      loop_states.push_back(*message);
    };
    const boost::function<void(const lamina_msgs::CorrectionMapConstPtr&)> on_map = [this](const auto& map) {
      const bool is_withheld = map->layer == kKilledIn && map->sequence > 0 && !was_handed_on_;
      if (is_withheld)
        withheld_ = *map;
      else
        handed_on_.publish(map);
    };
    handed_on_ = node_.advertise<lamina_msgs::CorrectionMap>(names::kCorrection, 0, true);
    of_loop_ = node_.subscribe<lamina_msgs::CorrectionMap>(kLoopCorrection, 0, on_map);
    applied_ = node_.subscribe<lamina_msgs::AppliedCorrection>(names::kAppliedCorrection, 0, on_applied);
    machine_ = node_.subscribe<lamina_msgs::MachineState>(names::kMachineState, 0, on_state);
    loop_ = node_.subscribe<lamina_msgs::LoopState>(names::kLoopState, 0, on_loop);
  }

  void startLoop() {
    const std::vector<std::string> arguments = {"__ns:=/killed",
                                                "/tf:=/killed/tf",
                                                "/tf_static:=/killed/tf_static",
                                                std::string(names::kCorrection) + ":=" + kLoopCorrection,
                                                "_request:=active",
                                                "_sensor/time_offset_trusted:=true",
                                                "_sensor/place_trusted:=true",
                                                "_pauses_print:=false",
                                                "_memory_file:=" + memory_};
    process_ = std::make_unique<test::NodeProcess>(LAMINA_LOOP_NODE, arguments);
  }
  /// Whether the map that is withheld is there, with all that the loop publishes and keeps before it begins
  /// that layer.
  bool isLoopDoneBelow() const {
    return withheld_ && figuresOf(kKilledIn - 1) != nullptr && !loop_states.empty() &&
           loop_states.back().layer >= kKilledIn;
  }
  /// The loop publishes nothing any more from now on. The streamer and this test hear what is handed on.
  void freezeLoop() {
    kill(process_->id(), SIGSTOP);
    EXPECT_TRUE(waitUntil([this] { return handed_on_.getNumSubscribers() >= 2; }));
    was_handed_on_ = true;
    handed_on_.publish(*withheld_);
  }
  int killLoop() { return process_->end(SIGKILL); }

  const lamina_msgs::CorrectionMap* mapOf(std::size_t layer, bool is_coasting) const {
    const auto found = std::find_if(maps.begin(), maps.end(), [&](const auto& map) {
      return map.layer == layer && (map.sequence == 0) == is_coasting;
    });
    return found == maps.end() ? nullptr : &*found;
  }
  const lamina_msgs::LoopFigures* figuresOf(std::size_t layer) const {
    const auto found =
        std::find_if(layers.begin(), layers.end(), [&](const auto& each) { return each.layer == layer; });
    return found == layers.end() ? nullptr : &*found;
  }
  const lamina_msgs::AppliedCorrection* appliedTo(std::size_t layer) const {
    const auto found = std::find_if(applied.begin(), applied.end(),
                                    [&](const auto& message) { return message.layer == layer; });
    return found == applied.end() ? nullptr : &*found;
  }

  std::vector<lamina_msgs::AppliedCorrection> applied;
  std::vector<lamina_msgs::LoopState> loop_states;
  std::int32_t machine_layer = -1;

 private:
  std::string memory_;
  ros::NodeHandle node_{"killed"};
  ros::Subscriber applied_, machine_, loop_, of_loop_;
  ros::Publisher handed_on_;
  std::optional<lamina_msgs::CorrectionMap> withheld_;
  bool was_handed_on_ = false;
  std::unique_ptr<test::NodeProcess> process_;
};

/// Amounts of the layers as they were applied, one after the other.
std::vector<double> appliedAmounts(const std::string& folder, std::size_t first, std::size_t last) {
  std::vector<double> amounts;
  for (const FiledMap& filed : readCorrectionFiles(folder)) {
    if (filed.map.layer < first || filed.map.layer > last) continue;
    for (const PathCorrection& path : filed.map.paths)
      for (const PointCorrection& place : path.stations) amounts.push_back(place.amount);
  }
  return amounts;
}

/// A relative amount of 1 over the gain less 1: the learnt gains are between the least and the greatest one,
/// and limits on slopes leave them between.
void expectByGain(const lamina_msgs::CorrectionMap& coasting, const lamina_msgs::LoopFigures& below) {
  // The wave has a length of 80 mm: the feeder gives 0.93 in the mean, and each layer teaches 0.3 of it.
  EXPECT_LT(below.gain_mean, 0.97);
  ASSERT_EQ(coasting.paths.size(), 1U);
  for (const double amount : coasting.paths[0].amount) {
    EXPECT_GE(amount, 1.0 / below.gain_greatest - 1.0 - 1e-9);
    EXPECT_LE(amount, 1.0 / below.gain_least - 1.0 + 1e-9);
  }
}

/// From the layer in which the loop is killed to the one that is deposited by its coasting map no step is
/// beyond what the feeder follows, and the coasting map is reached.
void expectNoStep(const lamina_msgs::CorrectionMap& coasting) {
  // Cells of 0.5 mm; 0.5 /s at 20 mm/s are 0.025 a millimetre.
  const std::vector<double> amounts =
      appliedAmounts(test::inRosHome("killed_loop_maps"), kKilledIn, kKilledIn + 1);
  ASSERT_EQ(amounts.size(), 2U * 48U);
  for (std::size_t i = 1; i < amounts.size(); ++i)
    EXPECT_LE(std::abs(amounts[i] - amounts[i - 1]), 0.0125 * (1.0 + 1e-9)) << i;
  EXPECT_NEAR(amounts.back(), coasting.paths.at(0).amount.back(), 1e-9);
}

void expectOwnMap(const KilledCell& cell, std::size_t layer) {
  ASSERT_NE(cell.mapOf(layer, false), nullptr) << layer;
  ASSERT_NE(cell.appliedTo(layer), nullptr) << layer;
  EXPECT_EQ(cell.appliedTo(layer)->digest, cell.mapOf(layer, false)->digest) << layer;
}

/// The layer that is under way keeps its map, the next one is laid by its coasting map, and then the loop is
/// there again.
TEST(KilledLoop, IsCoastedForAndComesBack) {
  const test::ScratchFolder folder;
  KilledCell cell(folder.file("memory.yaml"));
  cell.startLoop();
  cell.print(test::scannedWall(kLayers));
  ASSERT_TRUE(waitUntil([&] { return cell.isLoopDoneBelow(); }));
  cell.freezeLoop();
  // A stopped process is killed in any case: it would not end otherwise.
  EXPECT_TRUE(waitUntil([&] { return cell.machine_layer >= static_cast<std::int32_t>(kKilledIn); }));
  EXPECT_EQ(cell.killLoop(), -1);
  ASSERT_TRUE(waitUntil([&] { return cell.appliedTo(kKilledIn + 1) != nullptr; }));
  expectOwnMap(cell, kKilledIn);
  ASSERT_NE(cell.mapOf(kKilledIn + 1, true), nullptr) << "comes ahead of the map of the layer below";
  const lamina_msgs::CorrectionMap coasting = *cell.mapOf(kKilledIn + 1, true);
  EXPECT_EQ(cell.appliedTo(kKilledIn + 1)->digest, coasting.digest);
  expectByGain(coasting, *cell.figuresOf(kKilledIn - 1));
  cell.loop_states.clear();
  cell.startLoop();
  ASSERT_TRUE(waitUntil([&] { return cell.isOver(); })) << cell.applied.size() << " layers";
  EXPECT_EQ(cell.status().code, lamina_msgs::Status::OK + 0) << cell.status().message;
  EXPECT_TRUE(waitUntil([&] { return cell.layers.back().layer + 1 == kLayers; }));
  expectNoStep(coasting);
  EXPECT_TRUE(std::any_of(cell.loop_states.begin(), cell.loop_states.end(),
                          [](const auto& each) { return each.state == lamina_msgs::LoopState::ACTIVE; }));
  for (std::size_t layer = kLayers - 3; layer < kLayers; ++layer) expectOwnMap(cell, layer);
  EXPECT_TRUE(cell.layers.back().is_measured);
  EXPECT_LT(1e3 * cell.layers.back().rmse, 0.1 * kLayer);
}

}  // namespace
}  // namespace lamina
