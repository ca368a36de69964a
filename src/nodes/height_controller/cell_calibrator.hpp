// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lamina/calibration/cell_findings.hpp"
#include "loop/recording_gatherer.hpp"
#include "messages.hpp"

namespace lamina {

/// Calibrates the cell by messages received while the machine moves: records poses and clouds between BEGIN
/// and FINISH, evaluates them, and writes the results into the calibration file. A recording that does not
/// determine the results continues.
///
/// Services  calibrate_time (lamina/CalibrateTime), calibrate_sensor (lamina/CalibrateSensor),
///           calibrate_feeder (lamina/CalibrateFeeder), answered in a thread of their own: a print continues
class CellCalibrator {
 public:
  /// @param file     calibration file; empty: results are only reported
  /// @param most_mb  memory of the recording [1e6 bytes]; a larger recording is given up
  CellCalibrator(const ros::NodeHandle& node, std::string file, double most_mb);
  ~CellCalibrator();
  CellCalibrator(const CellCalibrator&) = delete;
  CellCalibrator& operator=(const CellCalibrator&) = delete;

  void add(const sensor_msgs::PointCloud2ConstPtr& cloud);
  void add(const geometry_msgs::TransformStamped& transform);
  void addFixed(const geometry_msgs::TransformStamped& transform);
  /// Sets the machine of the toolpath published last.
  void setMachine(const std::string& machine);

  /// Whether the file was written since the last call.
  bool takeWritten() { return is_written_.exchange(false); }

 private:
  struct FixedTransform {
    geometry_msgs::TransformStamped transform;
  };
  using Heard =
      std::variant<sensor_msgs::PointCloud2ConstPtr, geometry_msgs::TransformStamped, FixedTransform>;
  /// One recording under way.
  struct Recording {
    std::string service;       ///< service that began the recording
    std::vector<Heard> heard;  ///< messages not gathered yet
    double bytes = 0.0;
    bool is_given_up = false;  ///< because it takes too much memory
  };
  /// Input of an evaluation.
  struct Evidence {
    SensorRecording recording;
    std::optional<Eigen::Isometry3d> nozzle_from_sensor;  ///< by tf
    Calibration cell;                                     ///< so far
    CalibrationSettings settings;
    std::string date;
  };

  bool onTime(lamina_msgs::CalibrateTime::Request& request, lamina_msgs::CalibrateTime::Response& response);
  bool onSensor(lamina_msgs::CalibrateSensor::Request& request,
                lamina_msgs::CalibrateSensor::Response& response);
  bool onFeeder(lamina_msgs::CalibrateFeeder::Request& request,
                lamina_msgs::CalibrateFeeder::Response& response);
  /// The functions of one of the services.
  struct Work {
    std::function<void(const CalibrationSettings&)> check;  ///< throws if the request is to be refused
    std::function<void(Evidence&)> evaluate;
  };
  template <class Request, class Response>
  bool answer(const std::string& service, const Request& request, Response& response, const Work& work);
  void begin(const std::string& service);
  void hear(Heard heard, double bytes);
  void requireBegun(const std::string& service) const;
  void end(const std::string& service);
  Calibration cellOf(const std::string& machine) const;
  std::vector<Heard> takeHeard(const std::string& service);
  void gather(const std::string& service);
  Evidence evidence(const std::string& service, const Calibration& cell, const CalibrationSettings& settings);
  std::vector<std::string> keep(const Calibration& cell, std::vector<std::string> report);

  const std::string file_;
  const double most_bytes_;
  mutable std::mutex mutex_;                                      ///< guards what follows
  std::map<std::string, geometry_msgs::TransformStamped> fixed_;  ///< by child frame
  std::unique_ptr<Recording> recording_;
  std::string machine_;
  std::atomic<bool> is_written_{false};
  /// Data of the recording under way, used by the services' thread only: clouds and poses are many, and a
  /// print must not wait for copies.
  std::unique_ptr<RecordingGatherer> gathered_;
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_;
  std::vector<ros::ServiceServer> services_;
};

}  // namespace lamina
