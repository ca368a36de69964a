// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/sensor_recording.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/exact_text.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "recording_table.hpp"

namespace lamina {
namespace {

constexpr char kPosesFile[] = "/poses.csv";
constexpr char kProfilesFile[] = "/profiles.csv";
constexpr double kUnitTolerance = 0.01;

bool isEarlierPose(const RecordedPose& a, const RecordedPose& b) { return a.time_s < b.time_s; }
bool isEarlierProfile(const RecordedProfile& a, const RecordedProfile& b) { return a.time_s < b.time_s; }

/// The columns of a turn, if the table has all of them.
std::vector<std::size_t> turnColumns(const RecordingTable& table) {
  if (findColumn(table, "qw") == table.columns.size()) return {};
  return {requireColumn(table, "qw"), requireColumn(table, "qx"), requireColumn(table, "qy"),
          requireColumn(table, "qz")};
}

Eigen::Quaterniond turnOf(const RecordingTable& table, std::size_t row,
                          const std::vector<std::size_t>& columns) {
  if (columns.empty()) return nozzleDown();
  const Eigen::Quaterniond turn(table.at(row, columns[0]), table.at(row, columns[1]),
                                table.at(row, columns[2]), table.at(row, columns[3]));
  if (!(std::abs(turn.norm() - 1.0) < kUnitTolerance))
    throw InvalidInput("'" + table.source + "' line " + std::to_string(table.lines[row]) +
                       ": the quaternion's length is " + numberText(turn.norm()) + "; expected 1");
  return turn.normalized();
}

void appendCells(std::string& text, std::initializer_list<double> cells) {
  const char* separator = "";
  for (const double cell : cells) {
    text += separator;
    appendExact(text, cell);
    separator = ",";
  }
  text += '\n';
}

}  // namespace

std::optional<Eigen::Isometry3d> poseAt(const std::vector<RecordedPose>& poses, double time_s) {
  const auto next =
      std::lower_bound(poses.begin(), poses.end(), time_s,
                       [](const RecordedPose& pose, double time) { return pose.time_s < time; });
  if (next == poses.end()) return std::nullopt;
  if (next->time_s == time_s) return next->bed_from_nozzle;
  if (next == poses.begin()) return std::nullopt;
  const RecordedPose& before = *(next - 1);
  const double part = (time_s - before.time_s) / (next->time_s - before.time_s);
  const Eigen::Quaterniond from(before.bed_from_nozzle.linear());
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = from.slerp(part, Eigen::Quaterniond(next->bed_from_nozzle.linear())).toRotationMatrix();
  pose.translation() =
      (1.0 - part) * before.bed_from_nozzle.translation() + part * next->bed_from_nozzle.translation();
  return pose;
}

std::vector<RecordedPose> posesFromCsv(std::string_view text, const std::string& source) {
  const RecordingTable table = parseRecordingTable(text, source);
  const std::size_t time = requireColumn(table, "time_s");
  const std::size_t x = requireColumn(table, "x_mm");
  const std::size_t y = requireColumn(table, "y_mm");
  const std::size_t z = requireColumn(table, "z_mm");
  const std::vector<std::size_t> turn = turnColumns(table);
  std::vector<RecordedPose> poses(table.rows());
  for (std::size_t row = 0; row < poses.size(); ++row) {
    poses[row].time_s = table.at(row, time);
    poses[row].bed_from_nozzle.linear() = turnOf(table, row, turn).toRotationMatrix();
    poses[row].bed_from_nozzle.translation() = Point3(table.at(row, x), table.at(row, y), table.at(row, z));
  }
  std::stable_sort(poses.begin(), poses.end(), isEarlierPose);
  std::vector<RecordedPose> distinct;
  for (const RecordedPose& pose : poses) {
    if (!distinct.empty() && distinct.back().time_s == pose.time_s) distinct.pop_back();
    distinct.push_back(pose);
  }
  if (distinct.size() < 2)
    throw InvalidInput("'" + source + "' holds " + std::to_string(distinct.size()) +
                       " poses of the nozzle; expected at least 2");
  return distinct;
}

std::vector<RecordedProfile> profilesFromCsv(std::string_view text, const std::string& source) {
  const RecordingTable table = parseRecordingTable(text, source);
  const std::size_t time = requireColumn(table, "time_s");
  const std::size_t x = requireColumn(table, "x_mm");
  const std::size_t z = requireColumn(table, "z_mm");
  const std::size_t y = findColumn(table, "y_mm");
  std::vector<RecordedProfile> profiles;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double stamp = table.at(row, time);
    const double off_plane = y == table.columns.size() ? 0.0 : table.at(row, y);
    const Point3 point(table.at(row, x), off_plane, table.at(row, z));
    if (point.isZero(0.0)) continue;  // sensors send zeros in place of points that they miss
    if (profiles.empty() || profiles.back().time_s != stamp) profiles.push_back({stamp, {}});
    profiles.back().points.push_back(point);
  }
  std::stable_sort(profiles.begin(), profiles.end(), isEarlierProfile);
  if (profiles.empty()) throw InvalidInput("'" + source + "' holds no point; expected profiles");
  return profiles;
}

std::string toCsv(const std::vector<RecordedPose>& poses) {
  std::string text = "time_s,x_mm,y_mm,z_mm,qw,qx,qy,qz\n";
  for (const RecordedPose& pose : poses) {
    const Point3 at = pose.bed_from_nozzle.translation();
    const Eigen::Quaterniond turn(pose.bed_from_nozzle.linear());
    appendCells(text, {pose.time_s, at.x(), at.y(), at.z(), turn.w(), turn.x(), turn.y(), turn.z()});
  }
  return text;
}

std::string toCsv(const std::vector<RecordedProfile>& profiles) {
  std::string text = "time_s,x_mm,y_mm,z_mm\n";
  for (const RecordedProfile& profile : profiles)
    for (const Point3& point : profile.points)
      appendCells(text, {profile.time_s, point.x(), point.y(), point.z()});
  return text;
}

SensorRecording readRecording(const std::string& folder) {
  if (!std::filesystem::is_directory(folder))
    throw FileError("'" + folder +
                    "' is no folder; expected one with poses.csv and profiles.csv, or a bag (.bag)");
  const std::string poses = folder + kPosesFile;
  const std::string profiles = folder + kProfilesFile;
  return {posesFromCsv(readTextFile(poses), poses), profilesFromCsv(readTextFile(profiles), profiles)};
}

void writeRecording(const std::string& folder, const SensorRecording& recording) {
  writeFile(folder + kPosesFile, toCsv(recording.poses));
  writeFile(folder + kProfilesFile, toCsv(recording.profiles));
}

}  // namespace lamina
