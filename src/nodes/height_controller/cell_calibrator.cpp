// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_calibrator.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include "conversions.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/utc_time.hpp"
#include "names.hpp"
#include "refusal_text.hpp"
#include "request_settings.hpp"
#include "status.hpp"

namespace lamina {
namespace {

constexpr double kBytesOfTransform = 200.0;  // a pose and its place among the others

enum class Step : std::uint8_t { Begin = 0, Finish = 1, Drop = 2 };

template <class Request>
constexpr bool hasSteps() {
  return Request::BEGIN == static_cast<std::uint8_t>(Step::Begin) &&
         Request::FINISH == static_cast<std::uint8_t>(Step::Finish) &&
         Request::DROP == static_cast<std::uint8_t>(Step::Drop);
}
static_assert(hasSteps<lamina_msgs::CalibrateTime::Request>());
static_assert(hasSteps<lamina_msgs::CalibrateSensor::Request>());
static_assert(hasSteps<lamina_msgs::CalibrateFeeder::Request>());

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

void CellCalibrator::add(const sensor_msgs::PointCloud2ConstPtr& cloud) {
  const double points = static_cast<double>(cloud->width) * cloud->height;
  hear(cloud, std::max(points * sizeof(Point3), static_cast<double>(cloud->data.size())));
}

void CellCalibrator::add(const geometry_msgs::TransformStamped& transform) {
  hear(transform, kBytesOfTransform);
}

void CellCalibrator::addFixed(const geometry_msgs::TransformStamped& transform) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    fixed_[transform.child_frame_id] = transform;
  }
  hear(FixedTransform{transform}, kBytesOfTransform);
}

void CellCalibrator::hear(Heard heard, double bytes) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!recording_ || recording_->is_given_up) return;
  recording_->bytes += bytes;
  if (recording_->bytes <= most_bytes_) {
    recording_->heard.push_back(std::move(heard));
    return;
  }
  recording_->is_given_up = true;
  recording_->heard = {};
  ROS_WARN("%s: the recording takes more than queue_mb = %g MB, and is given up", recording_->service.c_str(),
           most_bytes_ / 1e6);
}

void CellCalibrator::setMachine(const std::string& machine) {
  const std::lock_guard<std::mutex> lock(mutex_);
  machine_ = machine;
}

void CellCalibrator::begin(const std::string& service) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (recording_)
    throw Rejected(recording_->service + " has begun a recording; expected it to be finished or dropped");
  recording_ = std::make_unique<Recording>(Recording{service, {}, 0.0, false});
  gathered_ = std::make_unique<RecordingGatherer>(names::kBedFrame, names::kNozzleFrame);
  for (const auto& [frame, transform] : fixed_) gathered_->addFixed(transform);
}

/// @throws Rejected
void CellCalibrator::requireBegun(const std::string& service) const {
  if (recording_ && recording_->service == service) return;
  throw Rejected(service + " has not begun a recording" +
                 (recording_ ? "; " + recording_->service + " has" : "; expected BEGIN before"));
}

void CellCalibrator::end(const std::string& service) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    requireBegun(service);
    recording_.reset();
  }
  gathered_.reset();
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

/// What came since the last call; of a recording that was given up nothing is left.
std::vector<CellCalibrator::Heard> CellCalibrator::takeHeard(const std::string& service) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    requireBegun(service);
    if (!recording_->is_given_up) return std::exchange(recording_->heard, {});
    recording_.reset();
  }
  gathered_.reset();
  throw InvalidInput("the recording took more than queue_mb = " + numberText(most_bytes_ / 1e6) +
                     " MB, and was given up; expected a shorter one, or a greater queue_mb");
}

void CellCalibrator::gather(const std::string& service) {
  for (Heard& heard : takeHeard(service)) {
    if (const auto* const cloud = std::get_if<sensor_msgs::PointCloud2ConstPtr>(&heard))
      gathered_->add(**cloud);
    else if (const auto* const moving = std::get_if<geometry_msgs::TransformStamped>(&heard))
      gathered_->add(*moving);
    else if (const auto* const fixed = std::get_if<FixedTransform>(&heard))
      gathered_->addFixed(fixed->transform);
    heard = sensor_msgs::PointCloud2ConstPtr();  // a cloud is not kept twice
  }
}

CellCalibrator::Evidence CellCalibrator::evidence(const std::string& service, const Calibration& cell,
                                                  const CalibrationSettings& settings) {
  gather(service);
  Evidence found;
  found.cell = cell;
  found.settings = settings;
  found.recording = gathered_->recording();
  found.nozzle_from_sensor = gathered_->nozzleFromSensor();
  if (found.recording.poses.size() < 2 || found.recording.profiles.empty())
    throw InvalidInput("the recording has " + std::to_string(found.recording.poses.size()) +
                       " poses of the nozzle and " + std::to_string(found.recording.profiles.size()) +
                       " clouds; expected two and one");
  found.date = utcText(ros::WallTime::now().sec);
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

/// What would be refused at the end is refused before the machine moves.
template <class Request, class Response>
bool CellCalibrator::answer(const std::string& service, const Request& request, Response& response,
                            const Work& work) {
  const auto checkedSettings = [&] {
    CalibrationSettings settings;
    SettingsSchema schema;
    describe(schema, settings);
    applyRequest(schema, request.settings);
    work.check(settings);
    return settings;
  };
  try {
    switch (static_cast<Step>(request.step)) {
      case Step::Begin:
        checkedSettings();
        cellOf(request.machine);
        begin(service);
        break;
      case Step::Drop:
        end(service);
        break;
      case Step::Finish: {
        const CalibrationSettings settings = checkedSettings();
        Evidence found = evidence(service, cellOf(request.machine), settings);
        work.evaluate(found);
        end(service);
        break;
      }
      default:
        throw InvalidInput("the step is " + std::to_string(request.step) +
                           "; expected BEGIN (0), FINISH (1) or DROP (2)");
    }
  } catch (...) {
    response = Response();
    const Failure failure = currentFailure();
    response.status = toMessage(failure);
    ROS_WARN_STREAM(refusalText({"answer " + service + " for machine", request.machine, ""}, failure));
  }
  for (const std::string& sentence : response.report) ROS_INFO("%s", sentence.c_str());
  return true;
}

bool CellCalibrator::onTime(lamina_msgs::CalibrateTime::Request& request,
                            lamina_msgs::CalibrateTime::Response& response) {
  const auto check = [&](const CalibrationSettings&) { timeMethod(request.method); };
  const auto evaluate = [&](Evidence& by) {
    // Bobbing does without the place of the sensor.
    const Eigen::Isometry3d about = timeMethod(request.method) == "bobbing"
                                        ? Eigen::Isometry3d::Identity()
                                        : knownPlace(by.cell, by.nozzle_from_sensor);
    const FoundTime found = findTime(by.recording, request.method, about, by.settings, by.date);
    by.cell.time = found.time;
    response.time_offset = found.fit.offset_s;
    response.spread = found.fit.spread_s;
    response.scatter = found.fit.scatter_s;
    response.drift = found.fit.drift_s_per_min;
    response.agreement = found.fit.agreement;
    response.profiles = static_cast<std::uint32_t>(found.fit.profiles);
    response.report = keep(by.cell, inWords(found));
  };
  return answer(names::kCalibrateTime, request, response, {check, evaluate});
}

bool CellCalibrator::onSensor(lamina_msgs::CalibrateSensor::Request& request,
                              lamina_msgs::CalibrateSensor::Response& response) {
  const auto target = [&](const CalibrationSettings& settings) {
    const KnownPyramid pyramid{inMillimetres(request.pyramid), inMillimetres(request.touched),
                               inMillimetres(request.top)};
    return sensorTarget(request.method, pyramid, settings);
  };
  const auto evaluate = [&](Evidence& by) {
    const std::string method = request.method.empty() ? "cross" : request.method;
    FoundPose found =
        findPose({{target(by.settings), by.recording}}, knownPlace(by.cell, by.nozzle_from_sensor),
                 timeOffsetOf(by.cell), by.settings, {method, by.date});
    found.pose = withFormer(found, by.cell.pose);
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
  };
  return answer(names::kCalibrateSensor, request, response, {target, evaluate});
}

bool CellCalibrator::onFeeder(lamina_msgs::CalibrateFeeder::Request& request,
                              lamina_msgs::CalibrateFeeder::Response& response) {
  const auto check = [](const CalibrationSettings&) {};
  const auto evaluate = [&](Evidence& by) {
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
  };
  return answer(names::kCalibrateFeeder, request, response, {check, evaluate});
}

}  // namespace lamina
