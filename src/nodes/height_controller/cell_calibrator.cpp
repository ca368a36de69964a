// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_calibrator.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "conversions.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "names.hpp"
#include "request_settings.hpp"
#include "status.hpp"

namespace lamina {
namespace {

constexpr double kBytesOfTransform = 200.0;  // a pose and its place among the others

/// The same in each of the three services.
enum class Step : std::uint8_t { Begin = 0, Finish = 1, Drop = 2 };
static_assert(lamina_msgs::CalibrateTime::Request::FINISH == static_cast<std::uint8_t>(Step::Finish));
static_assert(lamina_msgs::CalibrateSensor::Request::FINISH == static_cast<std::uint8_t>(Step::Finish));
static_assert(lamina_msgs::CalibrateFeeder::Request::FINISH == static_cast<std::uint8_t>(Step::Finish));
static_assert(lamina_msgs::CalibrateTime::Request::DROP == static_cast<std::uint8_t>(Step::Drop));
static_assert(lamina_msgs::CalibrateSensor::Request::DROP == static_cast<std::uint8_t>(Step::Drop));
static_assert(lamina_msgs::CalibrateFeeder::Request::DROP == static_cast<std::uint8_t>(Step::Drop));

std::vector<double> inMillimetres(const std::vector<double>& metres) {
  std::vector<double> all;
  all.reserve(metres.size());
  std::transform(metres.begin(), metres.end(), std::back_inserter(all), toMillimetres);
  return all;
}

/// @throws InvalidInput if neither the file nor tf says it
Eigen::Isometry3d knownPlace(const Calibration& cell, const std::optional<Eigen::Isometry3d>& by_tf) {
  if (cell.pose) return cell.pose->nozzle_from_sensor;
  if (by_tf) return *by_tf;
  throw InvalidInput(
      "tf does not connect the clouds' frame with 'nozzle', and no calibration says where the sensor sits; "
      "expected one of them");
}

}  // namespace

CellCalibrator::Recording::Recording(std::string begun_by)
    : service(std::move(begun_by)), gathered(names::kBedFrame, names::kNozzleFrame) {}

CellCalibrator::CellCalibrator(const ros::NodeHandle& node, std::string file, double most_mb)
    : file_(std::move(file)), most_bytes_(1e6 * most_mb), spinner_(1, &queue_) {
  ros::NodeHandle own(node);
  own.setCallbackQueue(&queue_);
  services_ = {own.advertiseService(names::kCalibrateTime, &CellCalibrator::onTime, this),
               own.advertiseService(names::kCalibrateSensor, &CellCalibrator::onSensor, this),
               own.advertiseService(names::kCalibrateFeeder, &CellCalibrator::onFeeder, this)};
  spinner_.start();
}

CellCalibrator::~CellCalibrator() {
  for (ros::ServiceServer& service : services_) service.shutdown();
  spinner_.stop();
}

void CellCalibrator::add(const sensor_msgs::PointCloud2& cloud) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!recording_) return;
  recording_->bytes += static_cast<double>(cloud.width) * cloud.height * sizeof(Point3);
  if (recording_->bytes <= most_bytes_) recording_->gathered.add(cloud);
}

void CellCalibrator::add(const geometry_msgs::TransformStamped& transform) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!recording_) return;
  recording_->bytes += kBytesOfTransform;
  if (recording_->bytes <= most_bytes_) recording_->gathered.add(transform);
}

void CellCalibrator::addFixed(const geometry_msgs::TransformStamped& transform) {
  const std::lock_guard<std::mutex> lock(mutex_);
  fixed_[transform.child_frame_id] = transform;
  if (recording_) recording_->gathered.addFixed(transform);
}

void CellCalibrator::setMachine(const std::string& machine) {
  const std::lock_guard<std::mutex> lock(mutex_);
  machine_ = machine;
}

void CellCalibrator::begin(const std::string& service) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (recording_)
    throw Rejected(recording_->service + " has begun a recording; expected it to be finished or dropped");
  recording_ = std::make_unique<Recording>(service);
  for (const auto& [frame, transform] : fixed_) recording_->gathered.addFixed(transform);
}

/// @throws Rejected
void CellCalibrator::requireBegun(const std::string& service) const {
  if (recording_ && recording_->service == service) return;
  throw Rejected(service + " has not begun a recording" +
                 (recording_ ? "; " + recording_->service + " has" : "; expected BEGIN before"));
}

void CellCalibrator::end(const std::string& service) {
  const std::lock_guard<std::mutex> lock(mutex_);
  requireBegun(service);
  recording_.reset();
}

/// What the file holds so far; without one, an empty calibration of the machine.
Calibration CellCalibrator::cellOf(const std::string& machine) const {
  Calibration cell;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    cell.machine = machine.empty() ? machine_ : machine;
  }
  if (file_.empty()) return cell;
  Calibration kept = readCalibration(file_);
  if (!cell.machine.empty()) requireCalibrationOf(kept, cell.machine);
  return kept;
}

template <class Request>
CellCalibrator::Evidence CellCalibrator::evidence(const std::string& service, const Request& request) {
  Evidence found;
  SettingsSchema schema;
  describe(schema, found.settings);
  applyRequest(schema, request.settings);
  found.cell = cellOf(request.machine);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    requireBegun(service);
    if (recording_->bytes > most_bytes_)
      throw InvalidInput("the recording takes " + std::to_string(recording_->bytes / 1e6) +
                         " MB; expected at most queue_mb = " + std::to_string(most_bytes_ / 1e6) + " MB");
    found.recording = recording_->gathered.recording();
    found.nozzle_from_sensor = recording_->gathered.nozzleFromSensor();
  }
  if (found.recording.poses.size() < 2 || found.recording.profiles.empty())
    throw InvalidInput("the recording has " + std::to_string(found.recording.poses.size()) +
                       " poses of the nozzle and " + std::to_string(found.recording.profiles.size()) +
                       " clouds; expected two and one");
  found.date = utcText(static_cast<long long>(ros::WallTime::now().sec));
  return found;
}

/// @return the report, and where the calibration is kept
std::vector<std::string> CellCalibrator::keep(const Calibration& cell, std::vector<std::string> report) {
  if (file_.empty()) {
    report.emplace_back("kept in no file: sensor.calibration names none");
    return report;
  }
  writeCalibration(file_, cell);
  is_written_ = true;
  report.push_back("written to  " + file_);
  return report;
}

template <class Request, class Response>
bool CellCalibrator::answer(const std::string& service, const Request& request, Response& response,
                            const std::function<void(Evidence&)>& evaluate) {
  try {
    switch (static_cast<Step>(request.step)) {
      case Step::Begin:
        cellOf(request.machine);  // what would be refused at the end is refused before the machine moves
        begin(service);
        break;
      case Step::Drop:
        end(service);
        break;
      case Step::Finish: {
        Evidence found = evidence(service, request);
        evaluate(found);
        end(service);
        break;
      }
      default:
        throw InvalidInput("the step is " + std::to_string(request.step) +
                           "; expected BEGIN (0), FINISH (1) or DROP (2)");
    }
  } catch (...) {
    response = Response();
    response.status = toMessage(currentFailure());
    ROS_WARN("%s: %s", service.c_str(), response.status.message.c_str());
  }
  for (const std::string& sentence : response.report) ROS_INFO("%s", sentence.c_str());
  return true;
}

bool CellCalibrator::onTime(lamina_msgs::CalibrateTime::Request& request,
                            lamina_msgs::CalibrateTime::Response& response) {
  return answer(names::kCalibrateTime, request, response, [&](Evidence& by) {
    // Bobbing does without the place of the sensor.
    const bool is_bobbing = request.method.empty() || request.method == "bobbing";
    const Eigen::Isometry3d about =
        is_bobbing ? Eigen::Isometry3d::Identity() : knownPlace(by.cell, by.nozzle_from_sensor);
    const FoundTime found = findTime(by.recording, request.method, about, by.settings, by.date);
    by.cell.time = found.time;
    response.time_offset = found.fit.offset_s;
    response.spread = found.fit.spread_s;
    response.scatter = found.fit.scatter_s;
    response.drift = found.fit.drift_s_per_min;
    response.agreement = found.fit.agreement;
    response.profiles = static_cast<std::uint32_t>(found.fit.profiles);
    response.report = keep(by.cell, inWords(found));
  });
}

bool CellCalibrator::onSensor(lamina_msgs::CalibrateSensor::Request& request,
                              lamina_msgs::CalibrateSensor::Response& response) {
  return answer(names::kCalibrateSensor, request, response, [&](Evidence& by) {
    const KnownPyramid pyramid{inMillimetres(request.pyramid), inMillimetres(request.touched),
                               inMillimetres(request.top)};
    const SensorTarget target = sensorTarget(request.method, pyramid, by.settings);
    const std::string method = request.method.empty() ? "cross" : request.method;
    const FoundPose found = findPose({{target, by.recording}}, knownPlace(by.cell, by.nozzle_from_sensor),
                                     timeOffsetOf(by.cell), by.settings, {method, by.date});
    by.cell.pose = found.pose;
    response.nozzle_from_sensor = toMessage(found.pose.nozzle_from_sensor);
    for (std::size_t i = 0; i < found.pose.spread.size(); ++i)
      response.spread.push_back(i < 3 ? toMetres(found.pose.spread[i]) : kDegree * found.pose.spread[i]);
    response.kept = found.pose.not_found;
    response.not_observable = found.not_observable;
    for (const ObservedDirection& direction : found.fit.directions)
      response.singular_values.push_back(direction.singular_value);
    response.rms = toMetres(found.fit.rms_mm);
    response.points = static_cast<std::uint32_t>(found.fit.points);
    response.report = keep(by.cell, inWords(found));
  });
}

bool CellCalibrator::onFeeder(lamina_msgs::CalibrateFeeder::Request& request,
                              lamina_msgs::CalibrateFeeder::Response& response) {
  return answer(names::kCalibrateFeeder, request, response, [&](Evidence& by) {
    const FoundFeeder found = findFeeder(by.recording, knownPlace(by.cell, by.nozzle_from_sensor),
                                         timeOffsetOf(by.cell), by.settings, by.date);
    by.cell.feeder = found.feeder;
    response.dead_time = found.fit.dead_time_s;
    response.dead_time_spread = found.fit.dead_time_spread_s;
    response.lag = found.fit.lag_s;
    response.lag_spread = found.fit.lag_spread_s;
    response.gain = found.fit.gain;
    response.rms = found.fit.rms;
    response.sections = static_cast<std::uint32_t>(found.fit.sections);
    response.report = keep(by.cell, inWords(found));
  });
}

}  // namespace lamina
