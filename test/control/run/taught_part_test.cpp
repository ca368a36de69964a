// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Part after part of one program, each laid by what those before have taught.
#include "lamina/control/run/taught_part.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "support/scratch_folder.hpp"
#include "support/sensed_wall.hpp"

namespace lamina {
namespace {

using test::SensedWall;
using test::sensedWall;
using test::SensedWallCase;

SensedWallCase taughtWall(const std::string& learned) {
  SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  SettingsSchema schema;
  describe(schema, wall.settings);
  schema.set("process.material", "wire");
  wall.machine = "gantry 45";
  schema.set("loop.learned", learned);
  wall.layers = 12;
  wall.grows = [](std::size_t, double along_mm) {
    const double end = std::max(0.0, 1.0 - std::min(along_mm, 60.0 - along_mm) / 10.0);
    return (1.0 - 0.15 * end) * (1.0 + 0.05 * std::sin(2.0 * M_PI * along_mm / 40.0));
  };
  return wall;
}

/// Of the true heights of all layers.
double rmseOf(const SensedWall& printed) {
  double squares = 0.0;
  double count = 0.0;
  for (std::size_t k = 0; k < printed.heights_mm.size(); ++k)
    for (const double height : printed.heights_mm[k]) {
      const double error = 1.5 * static_cast<double>(k + 1) - height;
      squares += error * error;
      count += 1.0;
    }
  return std::sqrt(squares / count);
}

TEST(TaughtPart, MakesEachPartBetterThanTheOneBefore) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("learnt.csv");
  std::vector<double> rmse;
  for (std::uint64_t part = 1; part <= 5; ++part) {
    SensedWallCase wall = taughtWall(part == 1 ? "" : file);
    wall.seed = part;
    const SensedWall printed = sensedWall(wall);
    rmse.push_back(rmseOf(printed));
    ASSERT_TRUE(printed.learnt);
    EXPECT_EQ(printed.learnt->parts, part);
    writeFile(file, partMapCsv(*printed.learnt));
    RecordProperty("part_" + std::to_string(part) + "_mm", std::to_string(rmse.back()));
    EXPECT_TRUE(part == 1 || rmse[part - 1] < rmse[part - 2]) << "part " << part << ": " << rmse.back();
  }
  EXPECT_LE(rmse.back(), 0.5 * rmse.front());
}

TEST(TaughtPart, IsRefusedOnAnotherMachineOrOfAnotherMaterialOrProgram) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("learnt.csv");
  writeFile(file, partMapCsv(*sensedWall(taughtWall("")).learnt));
  const auto refusalOf = [&](const SensedWallCase& wall) {
    try {
      sensedWall(wall);
      return std::string();
    } catch (const InvalidInput& error) {
      return std::string(error.what());
    }
  };
  SensedWallCase wall = taughtWall(file);
  EXPECT_EQ(refusalOf(wall), "");
  wall.machine = "irb_4600";
  EXPECT_NE(refusalOf(wall).find("machine 'irb_4600' instead of 'gantry 45'"), std::string::npos);
  wall = taughtWall(file);
  wall.settings.material = "paste";
  EXPECT_NE(refusalOf(wall).find("material"), std::string::npos);
  wall = taughtWall(file);
  wall.layers = 11;
  EXPECT_NE(refusalOf(wall).find("program"), std::string::npos);
  wall = taughtWall(file);
  wall.settings.cell_mm = 1.0;
  EXPECT_NE(refusalOf(wall).find("monitor.cell_mm"), std::string::npos);
  wall = taughtWall(folder.file("none.csv"));
  EXPECT_THROW(sensedWall(wall), FileError);
}

TEST(TaughtPart, TeachesNothingWithoutANameOrAWholePart) {
  SensedWallCase wall = taughtWall("");
  wall.settings.material.clear();
  EXPECT_FALSE(sensedWall(wall).learnt) << "of no material";
  const SensedWall printed = sensedWall(taughtWall(""));
  LoopRun run(printed.part, taughtWall("").settings);
  EXPECT_FALSE(run.learnt(PartEnd::Complete)) << "not a layer is laid";
}

/// The nozzle makes the heights of a pressed process: by them no amount is learnt, or laid.
TEST(TaughtPart, TakesNoAmountsFromTheHeightsOfAPressedProcess) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("learnt.csv");
  SensedWallCase wall = taughtWall("");
  writeFile(file, partMapCsv(*sensedWall(wall).learnt));
  wall.settings.loop.process = LoopProcess::Pressed;
  wall.settings.loop.z = NozzleHeight::Layer;
  EXPECT_FALSE(sensedWall(wall).learnt);
  wall.settings.learned = file;
  EXPECT_THROW(sensedWall(wall), InvalidInput);
}

TEST(TaughtPart, LearnsNothingFromAnAbortedPart) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("learnt.csv");
  const PartMap map = *sensedWall(taughtWall("")).learnt;
  writeFile(file, partMapCsv(map));
  const SensedWall printed = sensedWall(taughtWall(file));
  LoopRun run(printed.part, taughtWall(file).settings);
  std::size_t cloud = 0;
  for (const StampedTip& pose : printed.tips) {
    for (; cloud < printed.clouds.size() && printed.clouds[cloud].stamp_ns <= pose.stamp_ns; ++cloud)
      run.see(printed.clouds[cloud]);
    run.observe(pose);
  }
  run.finish();
  EXPECT_EQ(run.learnt(PartEnd::Aborted)->amount, map.amount);
  EXPECT_NE(run.learnt(PartEnd::Complete)->amount, map.amount);
}

TEST(PartMapCsv, ReadsBackToTheSameBits) {
  const PartMap map{{"4f2a", "gantry 45", "wire"}, 3, {{0.1, -0.2}, {}, {1.0 / 3.0}}};
  const PartMap back = readPartMap(partMapCsv(map), "map");
  EXPECT_EQ(back.amount, map.amount);
  EXPECT_EQ(back.parts, 3U);
  EXPECT_EQ(differenceOf(map.identity, back.identity), "");
}

TEST(PartMapCsv, IsRefusedOnceItWasChanged) {
  const std::string text = partMapCsv({{"4f2a", "gantry", "wire"}, 1, {{0.1, -0.2}}});
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    other.replace(other.find(from), from.size(), to);
    return other;
  };
  EXPECT_NO_THROW(readPartMap(text, "map"));
  const std::pair<const char*, const char*> changes[] = {
      {"gantry", "robot"}, {"0,0.1", "0,0.3"},      {"# parts 1\n", ""},        {"0,0.1", "0,nan"},
      {"0,0.1", "2,0.1"},  {"layer,amount", "a,b"}, {"# parts 1", "# parts x"}, {"0,-0.2", "0,-2"}};
  for (const auto& [from, to] : changes)
    EXPECT_THROW(readPartMap(changed(from, to), "map"), InvalidInput) << to;
}

}  // namespace
}  // namespace lamina
