// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/hand_eye.hpp"

#include <cmath>

#include "base/dense_solvers.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "recording_table.hpp"
#include "table_pose.hpp"

namespace lamina {
namespace {

constexpr double kLeastTurn = toRadians(5.0);

Eigen::Vector3d rotationVector(const Eigen::Matrix3d& turn) {
  const Eigen::AngleAxisd about(turn);
  return about.angle() * about.axis();
}

/// From one sight to another: of the nozzle, and of the sensor.
struct RelativeMotion {
  Eigen::Isometry3d nozzle = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d sensor = Eigen::Isometry3d::Identity();
};

/// Of all pairs of sights.
std::vector<RelativeMotion> relativeMotions(const std::vector<BodySight>& sights) {
  std::vector<RelativeMotion> motions;
  for (std::size_t i = 0; i < sights.size(); ++i)
    for (std::size_t j = i + 1; j < sights.size(); ++j)
      motions.push_back({sights[i].bed_from_nozzle.inverse() * sights[j].bed_from_nozzle,
                         sights[i].sensor_from_body * sights[j].sensor_from_body.inverse()});
  return motions;
}

/// The turn that leads the sensor's rotation vectors to those of the nozzle, in the least squares: the same
/// as (MᵀM)^(-1/2) Mᵀ, kept a turn where noise would make it a reflection.
Eigen::Matrix3d commonTurn(const std::vector<RelativeMotion>& motions, HandEyeFit& fit) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const RelativeMotion& motion : motions)
    sum += rotationVector(motion.sensor.linear()) * rotationVector(motion.nozzle.linear()).transpose();
  const SingularParts parts = singularParts(sum);
  for (const double value : parts.values) fit.rotation_singular_values.push_back(std::sqrt(value));
  if (fit.rotation_singular_values[0] < kLeastTurn)
    throw InvalidInput(
        "the head turns by " + numberText(toDegrees(fit.rotation_singular_values[0])) +
        " deg over all poses; expected at least 5 deg: without turns, neither turn nor place of the "
        "sensor can be found from poses of a body");
  if (fit.rotation_singular_values[1] < kLeastTurn)
    throw InvalidInput(
        "the head turns about one axis, by " + numberText(toDegrees(fit.rotation_singular_values[1])) +
        " deg about any other; expected at least 5 deg about two axes: the sensor's turn about that "
        "axis and its place along it cannot be found");
  Eigen::Vector3d signs(1.0, 1.0, 1.0);
  const Eigen::Matrix3d left = parts.left;
  const Eigen::Matrix3d right = parts.right;
  if ((right * left.transpose()).determinant() < 0.0) signs.z() = -1.0;
  return right * signs.asDiagonal() * left.transpose();
}

Eigen::Vector3d commonPlace(const std::vector<RelativeMotion>& motions, const Eigen::Matrix3d& turn,
                            HandEyeFit& fit) {
  Eigen::MatrixXd left(3 * static_cast<Eigen::Index>(motions.size()), 3);
  Eigen::VectorXd right(left.rows());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const auto row = 3 * static_cast<Eigen::Index>(i);
    left.middleRows(row, 3) = motions[i].nozzle.linear() - Eigen::Matrix3d::Identity();
    right.segment(row, 3) = turn * motions[i].sensor.translation() - motions[i].nozzle.translation();
  }
  const SingularParts parts = singularParts(left);
  for (const double value : parts.values) fit.place_values.push_back(value);
  // Both axes of turns were seen above: no value is 0.
  return parts.right * (parts.left.transpose() * right).cwiseQuotient(parts.values);
}

/// How far the body seems to move on the bed though it rests.
void addDisagreement(const std::vector<BodySight>& sights, HandEyeFit& fit) {
  std::vector<Eigen::Isometry3d> bodies;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const BodySight& sight : sights) {
    bodies.push_back(sight.bed_from_nozzle * fit.nozzle_from_sensor * sight.sensor_from_body);
    middle += bodies.back().translation() / static_cast<double>(sights.size());
  }
  double squared_mm = 0.0;
  double squared_rad = 0.0;
  for (const Eigen::Isometry3d& body : bodies) {
    squared_mm += (body.translation() - middle).squaredNorm();
    squared_rad += rotationVector(bodies.front().linear().transpose() * body.linear()).squaredNorm();
  }
  fit.rms_mm = std::sqrt(squared_mm / static_cast<double>(sights.size()));
  fit.rms_deg = toDegrees(std::sqrt(squared_rad / static_cast<double>(sights.size())));
}

}  // namespace

HandEyeFit fitHandEye(const std::vector<BodySight>& sights) {
  if (sights.size() < 3)
    throw InvalidInput("the body is seen from " + std::to_string(sights.size()) +
                       " poses; expected at least 3");
  const std::vector<RelativeMotion> motions = relativeMotions(sights);
  HandEyeFit fit;
  fit.nozzle_from_sensor.linear() = commonTurn(motions, fit);
  fit.nozzle_from_sensor.translation() = commonPlace(motions, fit.nozzle_from_sensor.linear(), fit);
  addDisagreement(sights, fit);
  return fit;
}

std::vector<BodySight> sightsFromCsv(std::string_view text, const std::string& source) {
  const RecordingTable table = parseRecordingTable(text, source);
  requireColumn(table, "body_qz");
  std::vector<BodySight> sights;
  for (std::size_t row = 0; row < table.rows(); ++row)
    sights.push_back({tablePose(table, row, ""), tablePose(table, row, "body_")});
  return sights;
}

}  // namespace lamina
