// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "lamina/base/error.hpp"
#include "program/rapid/reader/rapid_source.hpp"

namespace lamina {
namespace {

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
    cursor.refuseAt(line, "an orientation has length " + std::to_string(rotation.norm()) + "; expected 1");
  return rotation.normalized();
}

/// [[x,y,z],[w,x,y,z]].
void skipFrame(RapidCursor& cursor) {
  cursor.expect("[");
  takePoint(cursor);
  cursor.expect(",");
  takeRotation(cursor);
  cursor.expect("]");
}

void skipFlag(RapidCursor& cursor) {
  if (!cursor.takeWord("true") && !cursor.takeWord("false")) cursor.refuse("TRUE or FALSE");
}

void skipTool(RapidCursor& cursor) {
  cursor.expect("[");
  skipFlag(cursor);
  cursor.expect(",");
  skipFrame(cursor);
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
}

void skipWorkObject(RapidCursor& cursor) {
  cursor.expect("[");
  skipFlag(cursor);
  cursor.expect(",");
  skipFlag(cursor);
  cursor.expect(",");
  cursor.takeString("the name of a mechanical unit in quotation marks");
  cursor.expect(",");
  skipFrame(cursor);
  cursor.expect(",");
  skipFrame(cursor);
  cursor.expect("]");
}

void skipZone(RapidCursor& cursor) {
  cursor.expect("[");
  skipFlag(cursor);
  for (int i = 0; i < 6; ++i) {
    cursor.expect(",");
    cursor.takeNumber("a number");
  }
  cursor.expect("]");
}

double takeDeclaredSpeed(RapidCursor& cursor) {
  const std::size_t line = cursor.line();
  const double feed = takeList(cursor, 4)[0];
  if (!(feed > 0.0))
    cursor.refuseAt(line, "a speed is " + std::to_string(feed) + " mm/s; expected more than 0");
  return feed;
}

void takeValue(RapidCursor& cursor, const std::string& type, const std::string& name, RapidSource& source) {
  cursor.expect(":=");
  if (type == "num")
    source.numbers[name] = cursor.takeNumber("a number");
  else if (type == "speeddata")
    source.speeds[name] = takeDeclaredSpeed(cursor);
  else if (type == "robtarget")
    source.targets[name] = readRapidTarget(cursor);
  else if (type == "tooldata")
    skipTool(cursor);
  else if (type == "wobjdata")
    skipWorkObject(cursor);
  else
    skipZone(cursor);
}

bool isValueType(const std::string& type) {
  return type == "num" || type == "speeddata" || type == "robtarget" || type == "tooldata" ||
         type == "wobjdata" || type == "zonedata";
}

bool isPlainType(const std::string& type) {
  return type == "signaldo" || type == "signaldi" || type == "triggdata";
}

}  // namespace

RapidTarget readRapidTarget(RapidCursor& cursor) {
  RapidTarget target;
  cursor.expect("[");
  target.point = takePoint(cursor);
  cursor.expect(",");
  target.orientation = takeRotation(cursor);
  cursor.expect(",");
  takeList(cursor, 4);
  cursor.expect(",[");
  std::size_t axes = 0;
  do {
    cursor.takeNumber("the value of an external axis");
    ++axes;
  } while (axes < 6 && cursor.take(","));
  if (axes < 5) cursor.refuse("five or six external axes");
  cursor.expect("]]");
  return target;
}

void readRapidDeclaration(RapidCursor& cursor, RapidSource& source) {
  const std::size_t line = cursor.line();
  const std::string type = cursor.takeName("a type of data");
  if (!isValueType(type) && !isPlainType(type))
    cursor.refuseAt(line, "found data of type '" + type +
                              "'; expected num, speeddata, robtarget, tooldata, wobjdata, zonedata, "
                              "triggdata, signaldi or signaldo");
  const std::string name = cursor.takeName("a name");
  if (!source.names.insert(name).second)
    cursor.refuseAt(line, "'" + name + "' is declared twice; expected once");
  if (isValueType(type)) takeValue(cursor, type, name, source);
  cursor.expect(";");
}

}  // namespace lamina
