// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Roles, events, tools and process values of a toolpath.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <set>

#include "lamina/base/error.hpp"
#include "lamina/toolpath/process_support.hpp"
#include "lamina/toolpath/timing.hpp"
#include "support/toolpaths.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

/// What `check` says of two sound layers whose wall was changed; empty if it accepts them.
std::string saidOf(const std::function<void(Path& wall)>& change,
                   const std::function<void(const Toolpath&)>& check) {
  Toolpath toolpath = test::twoLayers();
  change(toolpath.layers[0].paths[0]);
  try {
    check(toolpath);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return {};
}

std::string refusalOfEvent(std::size_t motion, const ToolpathEvent& event) {
  return saidOf([&](Path& wall) { wall.events = {{motion, event}}; }, validate);
}

bool holds(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

TEST(PathRole, HasANameOfItsOwnThatReadsBack) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < kPathRoles; ++i) {
    const auto role = static_cast<PathRole>(i);
    names.insert(toString(role));
    EXPECT_EQ(pathRoleFromString(toString(role)), role);
  }
  EXPECT_EQ(names.size(), kPathRoles);
  EXPECT_THROW(pathRoleFromString("roof"), InvalidInput);
}

TEST(PathRole, SaysWhatBecomesOfTheMaterial) {
  Path path = test::straightPath({0, 0, 0}, {1, 0, 0});
  const auto isOfPart = [&path](PathRole role) {
    path.role = role;
    return isPartOfPart(path);
  };
  for (const PathRole role :
       {PathRole::OuterWall, PathRole::InnerWall, PathRole::Infill, PathRole::GapFill, PathRole::TopSkin,
        PathRole::Skin, PathRole::BottomSkin, PathRole::Bridge, PathRole::Ironing})
    EXPECT_TRUE(isOfPart(role)) << toString(role);
  for (const PathRole role : {PathRole::Travel, PathRole::Skirt, PathRole::Brim, PathRole::Raft,
                              PathRole::Prime, PathRole::Support, PathRole::SupportInterface})
    EXPECT_FALSE(isOfPart(role)) << toString(role);
}

TEST(ToolpathEvent, IsRefusedWhereItCannotBe) {
  EXPECT_EQ(refusalOfEvent(4, Dwell{0.0}), "") << "behind all four motions";
  EXPECT_TRUE(holds(refusalOfEvent(5, Dwell{1.0}), "dwell stands before motion 5; must be 0 to 4"));
  EXPECT_TRUE(holds(refusalOfEvent(0, Dwell{-1.0}), "dwell is -1 s"));
  EXPECT_TRUE(holds(refusalOfEvent(0, Dwell{std::numeric_limits<double>::infinity()}), "dwell is inf"));
  EXPECT_TRUE(holds(refusalOfEvent(0, FanShare{1.1}), "fan share is 1.1"));
  EXPECT_TRUE(holds(refusalOfEvent(0, OperatorPause{"a\nb"}), "control character"));
  EXPECT_TRUE(holds(refusalOfEvent(0, PartMark{"a\nb"}), "name of a part"));
  EXPECT_TRUE(holds(refusalOfEvent(0, MachineCode{}), "code is empty"));
  EXPECT_EQ(refusalOfEvent(0, MachineCode{"M300\nM117 hot\n"}), "");
  EXPECT_TRUE(holds(saidOf(
                        [](Path& wall) {
                          wall.events = {{2, Dwell{1}}, {1, Dwell{1}}};
                        },
                        validate),
                    "must be 2 to 4"));
}

TEST(ProcessValue, IsRefusedWhereItFitsNoWaypoint) {
  const auto refusal = [](std::vector<ProcessValue> values) {
    return saidOf([&](Path& wall) { wall.values = std::move(values); }, validate);
  };
  EXPECT_EQ(refusal({{"power_w", 3.0}, {"wire_mm_s", AlongPath<double>({1, 2, 3, 4})}}), "");
  EXPECT_TRUE(holds(refusal({{"power_w", AlongPath<double>({1, 2})}}), "needs one value or 4"));
  EXPECT_TRUE(holds(refusal({{"power_w", 1.0}, {"power_w", 2.0}}), "'power_w' stands twice"));
  EXPECT_TRUE(holds(refusal({{"", 1.0}}), "has no name"));
}

TEST(ProcessSupport, NamesWhatCannotBeCarried) {
  const auto refusal = [](const std::function<void(Path&)>& change) {
    return saidOf(change, [](const Toolpath& toolpath) {
      requireSupported(toolpath, {ProcessElement::Dwell}, "tablets");
    });
  };
  EXPECT_EQ(refusal([](Path& wall) { wall.events = {{0, Dwell{1}}}; }), "");
  EXPECT_EQ(refusal([](Path& wall) {
              wall.events = {{0, FanShare{1}}};
            }),
            "toolpath layer 0, path 0: fan cannot be carried by tablets");
  EXPECT_TRUE(holds(refusal([](Path& wall) { wall.tool = 2; }), "tool 2 cannot"));
  EXPECT_TRUE(holds(refusal([](Path& wall) { wall.values = {{"power_w", 1.0}}; }), "'power_w' cannot"));
  EXPECT_TRUE(holds(refusal([](Path& wall) {
                      wall.events = {{0, MachineCode{"G28", true}}};
                    }),
                    "code that moves axes cannot"));
}

TEST(ToolpathId, DependsOnTheProcessToo) {
  std::set<std::string> ids{toolpathId(test::twoLayers())};
  const std::vector<std::function<void(Toolpath&)>> changes = {
      [](Toolpath& t) { t.layers[0].paths[0].tool = 1; },
      [](Toolpath& t) {
        t.layers[0].paths[0].events = {{0, Dwell{1}}};
      },
      [](Toolpath& t) {
        t.layers[0].paths[0].events = {{1, Dwell{1}}};
      },
      [](Toolpath& t) {
        t.layers[0].paths[0].events = {{0, FanShare{1}}};
      },
      [](Toolpath& t) {
        t.layers[0].paths[0].events = {{0, MachineCode{"M5"}}};
      },
      [](Toolpath& t) {
        t.layers[0].paths[0].events = {{0, MachineCode{"M5", true}}};
      },
      [](Toolpath& t) {
        t.layers[0].paths[0].events = {{0, OperatorPause{"M5"}}};
      },
      [](Toolpath& t) {
        t.layers[0].paths[0].values = {{"a", 1.0}};
      },
      [](Toolpath& t) { t.events_at_end = {Dwell{1}}; }};
  for (const auto& change : changes) {
    Toolpath toolpath = test::twoLayers();
    change(toolpath);
    EXPECT_TRUE(ids.insert(toolpathId(toolpath)).second);
  }
}

/// 100 mm in two motions, with a wait between them; 100 mm/s, 1000 mm/s2.
Toolpath interrupted(double wait_s) {
  Path path = test::straightPath({0, 0, 0}, {50, 0, 0});
  path.points.emplace_back(100, 0, 0);
  path.feed_mm_s = 100.0;
  if (wait_s > 0.0) path.events = {{1, FanShare{0.5}}, {1, Dwell{wait_s}}};
  Toolpath toolpath;
  toolpath.layers = {{0.2, 0.2, {path}}};
  return toolpath;
}

MotionLimits thousand() {
  MotionLimits limits;
  limits.acceleration_mm_s2 = limits.travel_acceleration_mm_s2 = 1000.0;
  return limits;
}

// From rest to rest over a length: length / v + v / a.
TEST(Dwell, TakesItsTimeAtRest) {
  EXPECT_NEAR(estimateTime(interrupted(0.0), thousand()).total_s, 1.1, 1e-9);
  EXPECT_NEAR(estimateTime(interrupted(2.0), thousand()).total_s, 0.6 + 2.0 + 0.6, 1e-9);
  Toolpath toolpath = interrupted(0.0);
  toolpath.events_at_end = {Dwell{3.0}};
  toolpath.layers[0].paths[0].events = {{0, Dwell{5.0}}, {2, Dwell{7.0}}};
  const ToolpathTime time = estimateTime(toolpath, thousand());
  EXPECT_NEAR(time.total_s, 5.0 + 1.1 + 7.0 + 3.0, 1e-9);
  EXPECT_NEAR(time.layer_start_s.at(0), 5.0, 1e-9);
}

TEST(Dwell, LeavesThePlayedNozzleWhereItStands) {
  const Toolpath toolpath = interrupted(2.0);
  ToolpathPlayer player(toolpath, thousand());
  for (const double time_s : {0.6, 1.0, 2.6}) {
    EXPECT_TRUE(player.at(time_s).position.isApprox(Point3(50, 0, 0), 1e-9)) << time_s;
    EXPECT_NEAR(player.at(time_s).speed_mm_s, 0.0, 1e-9) << time_s;
  }
  EXPECT_TRUE(player.at(2.9).position.isApprox(Point3(75, 0, 0), 1e-9));
  EXPECT_TRUE(player.at(0.3).position.isApprox(Point3(25, 0, 0), 1e-9)) << "back in time";
  EXPECT_TRUE(player.at(3.2).position.isApprox(Point3(100, 0, 0), 1e-9));
  EXPECT_TRUE(player.isFinished());
}

}  // namespace
}  // namespace lamina
