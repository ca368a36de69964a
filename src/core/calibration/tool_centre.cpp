// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/tool_centre.hpp"

#include <cmath>

#include "base/dense_solvers.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "outlying.hpp"
#include "recording_table.hpp"
#include "table_pose.hpp"

namespace lamina {
namespace {

constexpr std::size_t kFewestPoses = 4;
constexpr double kLeastDetermined = 0.1;  // as of four tilts by 8 deg
constexpr double kShownSteps = 1e3;       // in 1, of a direction in messages

/// Means over poses, and the equations of the tip's place.
struct TipEquations {
  Eigen::Matrix3d mean_turn = Eigen::Matrix3d::Zero();
  Eigen::Vector3d mean_place = Eigen::Vector3d::Zero();
  SingularParts parts;
  Eigen::VectorXd right;
};

TipEquations tipEquations(const std::vector<FlangePose>& poses) {
  TipEquations equations;
  const auto count = static_cast<double>(poses.size());
  for (const FlangePose& pose : poses) {
    equations.mean_turn += pose.base_from_flange.linear() / count;
    equations.mean_place += pose.base_from_flange.translation() / count;
  }
  Eigen::MatrixXd left(3 * static_cast<Eigen::Index>(poses.size()), 3);
  equations.right.resize(left.rows());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto row = 3 * static_cast<Eigen::Index>(i);
    left.middleRows(row, 3) = poses[i].base_from_flange.linear() - equations.mean_turn;
    equations.right.segment(row, 3) = equations.mean_place - poses[i].base_from_flange.translation();
  }
  equations.parts = singularParts(left);
  return equations;
}

void requireTurns(const TipEquations& equations, double least_determined) {
  if (least_determined >= kLeastDetermined) return;
  Eigen::Vector3d along = equations.parts.right.col(2);
  if (along.sum() < 0.0) along = -along;
  along = (along * kShownSteps).array().round() / kShownSteps + 0.0;  // no -0
  throw InvalidInput("the tip's place along (" + numberText(along.x()) + ", " + numberText(along.y()) + ", " +
                     numberText(along.z()) + ") of the flange is determined by " +
                     numberText(least_determined) +
                     "; expected at least 0.1: the flange must be tilted by 10 deg or more about two axes");
}

/// Place, point and how well they are determined; the rest is left.
ToolCentreFit tipFittedTo(const std::vector<FlangePose>& poses) {
  const TipEquations equations = tipEquations(poses);
  const SingularParts& parts = equations.parts;
  ToolCentreFit fit;
  fit.least_determined = parts.values[2] / std::sqrt(static_cast<double>(poses.size()));
  requireTurns(equations, fit.least_determined);
  fit.flange_from_tip = parts.right * (parts.left.transpose() * equations.right).cwiseQuotient(parts.values);
  fit.base_from_point = equations.mean_turn * fit.flange_from_tip + equations.mean_place;
  return fit;
}

std::vector<double> tipDistances(const ToolCentreFit& fit, const std::vector<FlangePose>& poses) {
  std::vector<double> distances;
  distances.reserve(poses.size());
  for (const FlangePose& pose : poses)
    distances.push_back((pose.base_from_flange * fit.flange_from_tip - fit.base_from_point).norm());
  return distances;
}

/// From the scatter of the touches, through the equations.
Point3 spreadOf(const ToolCentreFit& fit, const SingularParts& parts) {
  const Eigen::MatrixXd spread =
      coordinateDeviation(fit.distances_mm) * parts.right * parts.values.cwiseInverse().asDiagonal();
  return spread.rowwise().norm();
}

}  // namespace

ToolCentreFit fitToolCentre(const std::vector<FlangePose>& poses) {
  if (poses.size() < kFewestPoses)
    throw InvalidInput("the tip touches its point in " + std::to_string(poses.size()) +
                       " poses; expected at least 4");
  ToolCentreFit fit = tipFittedTo(poses);
  fit.distances_mm = tipDistances(fit, poses);
  fit.rms_mm = meanDistance(fit.distances_mm);
  fit.spread_mm = spreadOf(fit, tipEquations(poses).parts);
  fit.outlying = outlyingTouches(poses.size(), [&](const std::vector<std::size_t>& kept) {
    return tipDistances(tipFittedTo(pickedFrom(poses, kept)), poses);
  });
  return fit;
}

std::vector<FlangePose> flangePosesFromCsv(std::string_view text, const std::string& source) {
  const RecordingTable table = parseRecordingTable(text, source);
  const bool has_angles = findColumn(table, "rx_deg") < table.columns.size();
  std::vector<FlangePose> poses;
  poses.reserve(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row)
    poses.push_back({has_angles ? poseByAngles(table, row) : tablePose(table, row, ""), table.lines[row]});
  return poses;
}

}  // namespace lamina
