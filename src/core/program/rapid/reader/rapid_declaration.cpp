// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "program/rapid/rapid_words.hpp"
#include "program/rapid/reader/rapid_source.hpp"

namespace lamina {
namespace {

constexpr double kMostQuarters = 100.0;
constexpr double kUnitLength = 1e-4;  // of a quaternion in 7 digits, with room

/// `count` numbers in brackets.
std::vector<double> takeList(RapidCursor& cursor, std::size_t count) {
  std::vector<double> values;
  cursor.expect("[");
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) cursor.expect(",");
    values.push_back(cursor.takeNumber("a number"));
  }
  cursor.expect("]");
  return values;
}

Point3 takePoint(RapidCursor& cursor) {
  const auto values = takeList(cursor, 3);
  return {values[0], values[1], values[2]};
}

Eigen::Quaterniond takeRotation(RapidCursor& cursor) {
  const std::size_t line = cursor.line();
  const auto values = takeList(cursor, 4);
  const Eigen::Quaterniond rotation(values[0], values[1], values[2], values[3]);
  if (!(std::abs(rotation.norm() - 1.0) < kUnitLength))
    cursor.refuseAt(line, "an orientation has length " + numberText(rotation.norm()) + "; expected 1");
  return rotation.normalized();
}

/// [[x,y,z],[w,x,y,z]].
Eigen::Isometry3d takeFrame(RapidCursor& cursor) {
  cursor.expect("[");
  const Point3 origin = takePoint(cursor);
  cursor.expect(",");
  Eigen::Isometry3d frame(takeRotation(cursor));
  frame.translation() = origin;
  cursor.expect("]");
  return frame;
}

bool takeFlag(RapidCursor& cursor) {
  if (cursor.takeWord("true")) return true;
  if (!cursor.takeWord("false")) cursor.refuse("TRUE or FALSE");
  return false;
}

RapidTool takeTool(RapidCursor& cursor) {
  RapidTool tool;
  cursor.expect("[");
  const std::size_t line = cursor.line();
  if (!takeFlag(cursor)) cursor.refuseAt(line, "the tool stands still; expected TRUE, the robot holds it");
  cursor.expect(",");
  tool.flange_from_tip = takeFrame(cursor);
  cursor.expect(",[");
  cursor.takeNumber("the tool's mass");
  cursor.expect(",");
  takePoint(cursor);
  cursor.expect(",");
  takeRotation(cursor);
  for (int i = 0; i < 3; ++i) {
    cursor.expect(",");
    cursor.takeNumber("a moment of inertia");
  }
  cursor.expect("]]");
  return tool;
}

RapidWorkObject takeWorkObject(RapidCursor& cursor) {
  RapidWorkObject object;
  cursor.expect("[");
  const std::size_t line = cursor.line();
  if (takeFlag(cursor)) cursor.refuseAt(line, "the robot holds the work object; expected FALSE");
  cursor.expect(",");
  object.is_fixed = takeFlag(cursor);
  cursor.expect(",");
  object.carrier = cursor.takeString("the name of a mechanical unit in quotation marks");
  if (object.is_fixed != object.carrier.empty())
    cursor.refuseAt(line, "a work object has ufprog " + std::string(object.is_fixed ? "TRUE" : "FALSE") +
                              " and the mechanical unit '" + object.carrier +
                              "'; expected TRUE without a unit, or FALSE with one");
  cursor.expect(",");
  object.user = takeFrame(cursor);
  cursor.expect(",");
  object.object = takeFrame(cursor);
  cursor.expect("]");
  return object;
}

void skipZone(RapidCursor& cursor) {
  cursor.expect("[");
  takeFlag(cursor);
  for (int i = 0; i < 6; ++i) {
    cursor.expect(",");
    cursor.takeNumber("a number");
  }
  cursor.expect("]");
}

double takeDeclaredSpeed(RapidCursor& cursor) {
  const std::size_t line = cursor.line();
  const double feed = takeList(cursor, 4)[0];
  if (!(feed > 0.0)) cursor.refuseAt(line, "a speed is " + numberText(feed) + " mm/s; expected more than 0");
  return feed;
}

/// That of a dry run, and no other; whether it is TRUE says nothing of the toolpath.
void takeDryFlag(RapidCursor& cursor, const std::string& name, RapidSource& source) {
  if (name != kRapidDryFlag)
    cursor.refuseAt(cursor.line(), "found a bool '" + name + "'; expected lamina_dry alone");
  takeFlag(cursor);
  source.process.insert("the flag lamina_dry");
}

void takeValue(RapidCursor& cursor, const std::string& type, const std::string& name, RapidSource& source) {
  cursor.expect(":=");
  if (type == "num")
    source.numbers[name] = cursor.takeNumber("a number");
  else if (type == "speeddata")
    source.speeds[name] = takeDeclaredSpeed(cursor);
  else if (type == "bool")
    takeDryFlag(cursor, name, source);
  else if (type == "robtarget")
    source.targets[name] = readRapidTarget(cursor);
  else if (type == "tooldata")
    source.tools[name] = takeTool(cursor);
  else if (type == "wobjdata")
    source.work_objects[name] = takeWorkObject(cursor);
  else
    skipZone(cursor);
}

bool isValueType(const std::string& type) {
  return type == "bool" || type == "num" || type == "speeddata" || type == "robtarget" ||
         type == "tooldata" || type == "wobjdata" || type == "zonedata";
}

bool isPlainType(const std::string& type) {
  return type == "signaldo" || type == "signaldi" || type == "triggdata";
}

/// Quarter turns are whole numbers.
AbbConfiguration takeConfiguration(RapidCursor& cursor) {
  const std::size_t line = cursor.line();
  const auto values = takeList(cursor, 4);
  for (const double value : values)
    if (value != std::round(value) || std::abs(value) > kMostQuarters)
      cursor.refuseAt(
          line, "a configuration holds " + numberText(value) + "; expected whole numbers of quarter turns");
  return {static_cast<int>(values[0]), static_cast<int>(values[1]), static_cast<int>(values[2]),
          static_cast<int>(values[3])};
}

/// Those up to the last that is there.
std::vector<double> takeExternal(RapidCursor& cursor) {
  std::vector<double> axes;
  cursor.expect("[");
  do axes.push_back(cursor.takeNumber("the value of an external axis"));
  while (axes.size() < 6 && cursor.take(","));
  if (axes.size() < 5) cursor.refuse("five or six external axes");
  cursor.expect("]");
  while (!axes.empty() && axes.back() >= kNoRapidAxis) axes.pop_back();
  return axes;
}

}  // namespace

RapidTarget readRapidTarget(RapidCursor& cursor) {
  RapidTarget target;
  cursor.expect("[");
  target.point = takePoint(cursor);
  cursor.expect(",");
  target.orientation = takeRotation(cursor);
  cursor.expect(",");
  target.configuration = takeConfiguration(cursor);
  cursor.expect(",");
  target.external = takeExternal(cursor);
  cursor.expect("]");
  return target;
}

RapidJoints readRapidJoints(RapidCursor& cursor) {
  RapidJoints joints;
  cursor.expect("[");
  joints.arm_deg = takeList(cursor, 6);
  cursor.expect(",");
  joints.external = takeExternal(cursor);
  cursor.expect("]");
  return joints;
}

void readRapidDeclaration(RapidCursor& cursor, RapidSource& source) {
  const std::size_t line = cursor.line();
  const std::string type = cursor.takeName("a type of data");
  if (!isValueType(type) && !isPlainType(type))
    cursor.refuseAt(line, "found data of type '" + type +
                              "'; expected num, bool, speeddata, robtarget, tooldata, wobjdata, zonedata, "
                              "triggdata, signaldi or signaldo");
  const std::string name = cursor.takeName("a name");
  if (!source.names.insert(name).second)
    cursor.refuseAt(line, "'" + name + "' is declared twice; expected once");
  if (isValueType(type)) takeValue(cursor, type, name, source);
  cursor.expect(";");
}

}  // namespace lamina
