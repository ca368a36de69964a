// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/drivable_toolpath.hpp"

#include <gtest/gtest.h>

#include <string>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "lamina/program/csv/csv_writer.hpp"
#include "support/scratch_folder.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

/// A bead of 100 mm along x, whose underside is at `z` less its height.
Toolpath drivenBead(double z) { return {"bead", {{z, 0.2, {test::straightPath({0, 0, z}, {100, 0, z})}}}}; }

std::string csvOf(const Toolpath& toolpath) {
  std::string csv;
  writeCsv(toolpath, [&csv](std::string_view piece) { csv += piece; });
  return csv;
}

ToolpathOnBed readAs(const std::string& text, Placement placement) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("3fa1");  // files that are kept by their digest have no suffix
  writeFile(path, text);
  return readToolpathOnBed(path, placement, buildSpaceOf(MachineSettings()));
}

std::string whyNone(const std::string& text) {
  try {
    readAs(text, Placement::Centre);
  } catch (const InvalidProgram& error) {
    return error.what();
  }
  return "";
}

TEST(DrivableToolpath, StandsOverTheMiddleOfTheBedOrWhereItsFileSays) {
  const Toolpath bead = drivenBead(5.0);
  const double height_mm = bead.layers[0].paths[0].bead.at(1).height_mm;
  const ToolpathOnBed centred = readAs(csvOf(bead), Placement::Centre);
  EXPECT_EQ(centred.toolpath.layers.size(), 1U);
  // The bed is 220 mm wide and deep; the bead's middle is at x = 50.
  EXPECT_LT((centred.bed_from_part.translation() - Point3(60, 110, height_mm - 5.0)).norm(), 1e-9);
  EXPECT_EQ(readAs(csvOf(bead), Placement::AsIs).bed_from_part.translation(), Point3::Zero());
}

TEST(DrivableToolpath, NamesWhatIsNone) {
  EXPECT_NE(whyNone("G28\nG1 X1\n").find("line 1 is 'G28'; expected the header of a toolpath"),
            std::string::npos);
  EXPECT_NE(whyNone("\x01\x02 solid").find("line 1 is '?? solid'"), std::string::npos);
  const std::string csv = csvOf(drivenBead(5.0));
  EXPECT_NE(whyNone(csv.substr(0, csv.size() - 5)).find("CSV line 3"), std::string::npos) << "torn";
}

TEST(DrivableToolpath, IsCheckedWhole) {
  const auto model = kinematicModelByName("irb_4600");
  const CheckedMachine machine(*model);
  NoProgress nobody;
  std::size_t faults = 0;
  const auto found = [&faults](const MachineCheck& check) {
    faults = check.faults.size() + check.collisions.size();
  };
  const auto run = [&](const Toolpath& toolpath, const Point3& place) {
    return drivableRun({toolpath, Eigen::Isometry3d(Eigen::Translation3d(place))}, machine, {}, found,
                       nobody);
  };
  EXPECT_EQ(run(drivenBead(0.2), {0, 0, 0}).path.at.size() > 1, true);
  EXPECT_EQ(faults, 0U);
  EXPECT_THROW(run(drivenBead(0.2), {9000, 0, 0}), Unreachable) << "no arm is 9 m long";
  EXPECT_GT(faults, 0U);
  EXPECT_THROW(run(drivenBead(0.2), {0, 0, -60}), Unreachable) << "under the bed";
}

TEST(DrivableToolpath, AsksForNothingThatTrajectoriesCannotExpress) {
  Toolpath bead = drivenBead(0.2);
  EXPECT_NO_THROW(requireDrivable(bead));
  bead.layers[0].paths[0].events = {{0, OperatorPause{"insert nuts"}}};
  EXPECT_THROW(requireDrivable(bead), InvalidInput);
}

std::string refusalOfUnit(const DriveCheckSettings& unit, const std::string& sheet) {
  try {
    requireSameDriveSettings(unit, sheet);
    return "";
  } catch (const InvalidConfig& error) {
    return error.what();
  }
}

TEST(DriveSettings, OfUnitAndDriverAreAlikeOrNamed) {
  DriveCheckSettings driver;
  EXPECT_EQ(refusalOfUnit({}, driveSettingsSheet(driver)), "");
  EXPECT_NE(driveSettingsSheet(driver).find("joints.yaw: free\n"), std::string::npos);
  driver.joints.yaw = YawChoice::Held;
  driver.clearance.spacing_mm = 3.5;
  // Each reads these its own way: the driver has check_clearance.
  driver.clearance.need = ClearanceNeed::Always;
  driver.clearance.is_shown = true;
  const std::string refusal = refusalOfUnit({}, driveSettingsSheet(driver));
  EXPECT_NE(refusal.find("clearance.spacing_mm is '"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("' for the unit and '3.5' for its driver; "), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("joints.yaw is 'free' for the unit and 'held' for its driver; expected them alike"),
            std::string::npos)
      << refusal;
  EXPECT_EQ(refusal.find("clearance.need"), std::string::npos) << refusal;
  EXPECT_EQ(refusal.find("clearance.report"), std::string::npos) << refusal;
  DriveCheckSettings same = driver;
  same.clearance.need = ClearanceNeed::Turning;
  EXPECT_EQ(refusalOfUnit(same, driveSettingsSheet(driver)), "");
}

TEST(DriveSettings, OfClearanceDifferOnlyWhereBothCheckIt) {
  DriveCheckSettings unit, driver;
  driver.clearance.spacing_mm = 3.5;
  EXPECT_NE(refusalOfUnit(unit, driveSettingsSheet(driver)), "");
  driver.clearance.need = ClearanceNeed::Never;
  EXPECT_EQ(refusalOfUnit(unit, driveSettingsSheet(driver)), "");
  driver.clearance.need = ClearanceNeed::Always;
  unit.clearance.need = ClearanceNeed::Never;
  EXPECT_EQ(refusalOfUnit(unit, driveSettingsSheet(driver)), "");
}

TEST(DriveSettings, OfAnotherReleaseDiffer) {
  const std::string sheet = driveSettingsSheet({});
  const std::string line = "joints.yaw: free\n";
  std::string older = sheet;
  older.erase(older.find(line), line.size());
  EXPECT_NE(refusalOfUnit({}, older).find("joints.yaw is 'free' for the unit and not known for its driver"),
            std::string::npos);
  EXPECT_NE(refusalOfUnit({}, sheet + "joints.new: 1\n")
                .find("joints.new is not known for the unit and '1' for its driver"),
            std::string::npos);
}

}  // namespace
}  // namespace lamina
