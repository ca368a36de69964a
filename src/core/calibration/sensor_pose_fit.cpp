// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "base/dense_solvers.hpp"
#include "cross_crests.hpp"
#include "geometry/space_vectors.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/calibration/sensor_pose.hpp"
#include "robust_fit.hpp"
#include "target_model.hpp"
#include "view_points.hpp"

namespace lamina {
namespace {

constexpr Eigen::Index kPose = 6;  // x, y, z of the nozzle and turns about them
constexpr double kPoseShiftStep = 1e-4;
constexpr double kPoseTurnStep = 1e-6;
constexpr int kMostRounds = 8;
constexpr double kSettledMm = 5e-4;
constexpr double kSettledRad = 1e-5;

using Pose = Eigen::Matrix<double, kPose, 1>;
using PoseMatrix = Eigen::Matrix<double, kPose, kPose>;

/// A point on a face.
struct OnFace {
  std::size_t point = 0;
  int face = 0;
};

/// A view as it is fitted; its targets and points are given anew each round.
struct FittedView {
  const SensorTarget* target = nullptr;
  ViewPoints view;
  std::unique_ptr<SurfaceModel> surface;
  Eigen::VectorXd unknowns;  ///< of the surface
  std::vector<OnFace> points;
  std::vector<Crest> crests;
  double point_mm = 1.0;  ///< standard deviations
  double crest_mm = 1.0;

  std::size_t residuals() const { return points.size() + crests.size(); }
};

/// What is fitted, and from where it began.
struct PoseProblem {
  std::vector<FittedView> views;
  Eigen::Isometry3d about = Eigen::Isometry3d::Identity();
  std::array<bool, kPose> is_kept{};
};

Eigen::Isometry3d moved(const Eigen::Isometry3d& about, const Pose& by) {
  Eigen::Isometry3d pose = about;
  pose.translation() += by.head<3>();
  pose.linear() = turnBy(by.tail<3>()).toRotationMatrix() * about.linear();
  return pose;
}

/// The motion that leads from one pose to another.
Pose between(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(to.linear() * from.linear().transpose()));
  Pose by;
  by << to.translation() - from.translation(), turn.angle() * turn.axis();
  return by;
}

std::vector<Eigen::Index> freeDirections(const std::array<bool, kPose>& is_kept) {
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < kPose; ++i)
    if (!is_kept[static_cast<std::size_t>(i)]) free.push_back(i);
  return free;
}

/// The unknowns of the fit: free directions of the pose, then those of each surface.
Eigen::VectorXd packed(const PoseProblem& problem, const Pose& pose, bool in_steps) {
  const std::vector<Eigen::Index> free = freeDirections(problem.is_kept);
  std::vector<double> values;
  values.reserve(free.size());
  for (const Eigen::Index i : free)
    values.push_back(in_steps ? (i < 3 ? kPoseShiftStep : kPoseTurnStep) : pose[i]);
  for (const FittedView& view : problem.views) {
    const Eigen::VectorXd own = in_steps ? view.surface->steps() : view.unknowns;
    values.insert(values.end(), own.data(), own.data() + own.size());
  }
  return Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Pose poseIn(const PoseProblem& problem, const Eigen::VectorXd& values) {
  Pose pose = Pose::Zero();
  const std::vector<Eigen::Index> free = freeDirections(problem.is_kept);
  for (std::size_t i = 0; i < free.size(); ++i) pose[free[i]] = values[static_cast<Eigen::Index>(i)];
  return pose;
}

void addResiduals(const FittedView& view, const Eigen::Isometry3d& pose, const Eigen::VectorXd& unknowns,
                  double* residual) {
  for (const OnFace& on : view.points)
    *residual++ =
        view.surface->distance(on.face, view.view.onBed(view.view.points[on.point], pose), unknowns) /
        view.point_mm;
  for (const Crest& crest : view.crests) *residual++ = crestDistance(crest, view.view, pose) / view.crest_mm;
}

FitProblem fitProblem(const PoseProblem& problem, const Pose& start) {
  FitProblem fit;
  fit.start = packed(problem, start, false);
  fit.steps = packed(problem, start, true);
  fit.residuals = [&problem](const Eigen::VectorXd& values) {
    const Eigen::Isometry3d pose = moved(problem.about, poseIn(problem, values));
    auto next = static_cast<Eigen::Index>(freeDirections(problem.is_kept).size());
    std::size_t count = 0;
    for (const FittedView& view : problem.views) count += view.residuals();
    Eigen::VectorXd residuals(static_cast<Eigen::Index>(count));
    double* residual = residuals.data();
    for (const FittedView& view : problem.views) {
      addResiduals(view, pose, values.segment(next, view.surface->unknowns()), residual);
      residual += view.residuals();
      next += view.surface->unknowns();
    }
    return residuals;
  };
  return fit;
}

/// Which points lie on which face, and how far they scatter.
void assignPoints(FittedView& view, const Eigen::Isometry3d& pose, const SensorPoseSettings& settings) {
  const std::vector<Point3> placed = view.view.onBed(pose);
  if (!view.surface) {
    view.surface = surfaceModelOf(*view.target, placed);
    view.unknowns = Eigen::VectorXd::Zero(view.surface->unknowns());
  }
  std::vector<std::size_t> on_faces;
  for (std::size_t i = 0; i < placed.size(); ++i)
    if (view.surface->faceOf(placed[i], view.unknowns) >= 0) on_faces.push_back(i);
  view.points.clear();
  std::vector<double> distances;
  for (const std::size_t i : evenlyChosen(on_faces, settings.most_points)) {
    view.points.push_back({i, view.surface->faceOf(placed[i], view.unknowns)});
    distances.push_back(view.surface->distance(view.points.back().face, placed[i], view.unknowns));
  }
  view.point_mm = std::max(settings.noise_mm, robustDeviation(distances));
}

void assignCrests(FittedView& view, const Eigen::Isometry3d& pose, const SensorPoseSettings& settings) {
  const auto* cross = std::get_if<CrossTarget>(view.target);
  if (cross == nullptr) return;
  view.crests = crestsOf(*cross, view.view, pose);
  std::vector<double> distances;
  for (const Crest& crest : view.crests) distances.push_back(crestDistance(crest, view.view, pose));
  view.crest_mm = std::max(settings.noise_mm, robustDeviation(distances));
}

/// What the fit knows of the pose whatever the surfaces' unknowns are, in units of the greatest deviations
/// allowed.
PoseMatrix scaledInformation(PoseProblem& problem, const Pose& pose, const SensorPoseSettings& settings) {
  const std::array<bool, kPose> kept = problem.is_kept;
  problem.is_kept = {};
  FitProblem fit = fitProblem(problem, pose);
  const Eigen::MatrixXd all = informationAt(fit);
  problem.is_kept = kept;
  const Eigen::Index others = all.rows() - kPose;
  Eigen::MatrixXd own = all.topLeftCorner(kPose, kPose);
  if (others > 0) {
    Eigen::MatrixXd of_others = all.bottomRightCorner(others, others);
    of_others.diagonal().array() *= 1.0 + 1e-10;
    of_others.diagonal().array() += 1e-12;
    own -=
        all.topRightCorner(kPose, others) * symmetricSolution(of_others, all.bottomLeftCorner(others, kPose));
  }
  Pose units;
  units << Eigen::Vector3d::Constant(settings.max_sigma_mm),
      Eigen::Vector3d::Constant(settings.max_sigma_deg * kDegree);
  return units.asDiagonal() * own * units.asDiagonal();
}

/// The rows and columns of free directions.
Eigen::MatrixXd restricted(const PoseMatrix& information, const std::vector<Eigen::Index>& free) {
  const auto size = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd part(size, size);
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j)
      part(i, j) = information(free[static_cast<std::size_t>(i)], free[static_cast<std::size_t>(j)]);
  return part;
}

/// The free direction that is to be kept next; none if all are determined well enough. Where one looks like
/// another, tilts are kept before shifts: a sensor is mounted square more surely than in its place.
std::optional<std::size_t> nextKept(const PoseMatrix& information, const std::array<bool, kPose>& is_kept) {
  constexpr std::array<double, kPose> kReadiness = {1.0, 1.0, 1.0, 1.5, 1.5, 1.2};
  const std::vector<Eigen::Index> free = freeDirections(is_kept);
  if (free.empty()) return std::nullopt;
  const SymmetricParts parts = symmetricParts(restricted(information, free));
  if (parts.values[0] >= 1.0) return std::nullopt;
  std::size_t worst = 0;
  double greatest = -1.0;
  for (std::size_t i = 0; i < free.size(); ++i) {
    const auto direction = static_cast<std::size_t>(free[i]);
    const double share = std::abs(parts.vectors(static_cast<Eigen::Index>(i), 0)) * kReadiness[direction];
    if (share > greatest) worst = direction;
    greatest = std::max(greatest, share);
  }
  return worst;
}

void addDirections(SensorPoseFit& fit, const PoseMatrix& information) {
  const SymmetricParts parts = symmetricParts(information);
  for (Eigen::Index i = kPose; i-- > 0;) {
    ObservedDirection direction;
    direction.singular_value = std::sqrt(std::max(0.0, parts.values[i]));
    for (Eigen::Index j = 0; j < kPose; ++j)
      direction.share[static_cast<std::size_t>(j)] = parts.vectors(j, i);
    fit.directions.push_back(direction);
  }
}

SensorPoseFit describedFit(PoseProblem& problem, const Pose& pose, const SensorPoseSettings& settings) {
  const PoseMatrix information = scaledInformation(problem, pose, settings);
  SensorPoseFit fit;
  fit.nozzle_from_sensor = moved(problem.about, pose);
  fit.is_kept = problem.is_kept;
  addDirections(fit, information);
  const std::vector<Eigen::Index> free = freeDirections(problem.is_kept);
  const Eigen::MatrixXd part = restricted(information, free);
  const Eigen::MatrixXd covariance =
      symmetricSolution(part, Eigen::MatrixXd::Identity(part.rows(), part.rows()));
  for (std::size_t i = 0; i < free.size(); ++i) {
    const double unit = free[i] < 3 ? settings.max_sigma_mm : settings.max_sigma_deg;
    const auto at = static_cast<Eigen::Index>(i);
    fit.sigma[static_cast<std::size_t>(free[i])] = unit * std::sqrt(std::max(0.0, covariance(at, at)));
  }
  double squares = 0.0;
  for (const FittedView& view : problem.views) {
    squares += view.point_mm * view.point_mm * static_cast<double>(view.points.size());
    fit.points += view.points.size();
  }
  fit.rms_mm = fit.points > 0 ? std::sqrt(squares / static_cast<double>(fit.points)) : 0.0;
  return fit;
}

/// One fit with faces and crests as they are given now.
Pose fittedOnce(PoseProblem& problem, Pose pose) {
  for (std::size_t i = 0; i < problem.is_kept.size(); ++i)
    if (problem.is_kept[i]) pose[static_cast<Eigen::Index>(i)] = 0.0;
  const RobustFit fit = fitRobustly(fitProblem(problem, pose));
  auto next = static_cast<Eigen::Index>(freeDirections(problem.is_kept).size());
  for (FittedView& view : problem.views) {
    view.unknowns = fit.values.segment(next, view.surface->unknowns());
    next += view.surface->unknowns();
  }
  return poseIn(problem, fit.values);
}

bool isSettled(const Pose& before, const Pose& after) {
  const Pose by = (after - before).cwiseAbs();
  return by.head<3>().maxCoeff() < kSettledMm && by.tail<3>().maxCoeff() < kSettledRad;
}

void assign(PoseProblem& problem, const Pose& pose, const SensorPoseSettings& settings) {
  for (FittedView& view : problem.views) {
    assignPoints(view, moved(problem.about, pose), settings);
    assignCrests(view, moved(problem.about, pose), settings);
  }
}

/// The information at the start of a fit, with the scatter that it came to: where too little is determined,
/// the fit itself may have strayed far away.
PoseMatrix informationAtStart(PoseProblem& problem, const Pose& start, const SensorPoseSettings& settings) {
  std::vector<std::array<double, 2>> scatter;
  for (const FittedView& view : problem.views) scatter.push_back({view.point_mm, view.crest_mm});
  for (FittedView& view : problem.views) view.surface.reset();
  assign(problem, start, settings);
  for (std::size_t i = 0; i < problem.views.size(); ++i) {
    problem.views[i].point_mm = std::min(problem.views[i].point_mm, scatter[i][0]);
    problem.views[i].crest_mm = std::min(problem.views[i].crest_mm, scatter[i][1]);
  }
  return scaledInformation(problem, start, settings);
}

/// Points to faces, faces to points, until both stay.
Pose fittedByRounds(PoseProblem& problem, Pose pose, const SensorPoseSettings& settings) {
  for (FittedView& view : problem.views) view.surface.reset();
  assign(problem, pose, settings);
  for (int round = 0; round < kMostRounds; ++round) {
    const Pose fitted = fittedOnce(problem, pose);
    const bool is_settled = isSettled(pose, fitted);
    pose = fitted;
    assign(problem, pose, settings);
    if (is_settled) break;
  }
  return pose;
}

/// Fits from the start; keeps one direction that is not determined and fits the others again, until all are:
/// what looks badly determined beside it may be determined well without it.
Pose fittedWhereDetermined(PoseProblem& problem, const Pose& start, const SensorPoseSettings& settings) {
  for (;;) {
    Pose pose = fittedByRounds(problem, start, settings);
    const auto at_fit = nextKept(scaledInformation(problem, pose, settings), problem.is_kept);
    if (!at_fit) return pose;
    const auto at_start = nextKept(informationAtStart(problem, start, settings), problem.is_kept);
    problem.is_kept[at_start.value_or(*at_fit)] = true;
  }
}

PoseProblem problemOf(const std::vector<SensorView>& views, const Eigen::Isometry3d& about,
                      double time_offset_s) {
  PoseProblem problem;
  problem.about = about;
  for (const SensorView& view : views) {
    FittedView fitted;
    fitted.target = &view.target;
    fitted.view = viewPoints(view.recording, time_offset_s);
    problem.views.push_back(std::move(fitted));
  }
  return problem;
}

/// Where a cross is among the views, the sensor is first levelled over the bed, and then fitted to the beads:
/// its crests are distinguished only within a bead's width.
Eigen::Isometry3d placedOverCrosses(const std::vector<SensorView>& views, const Eigen::Isometry3d& about,
                                    const SensorPoseSettings& settings) {
  const auto isCross = [](const SensorView& view) {
    return std::holds_alternative<CrossTarget>(view.target);
  };
  const auto cross = std::find_if(views.begin(), views.end(), isCross);
  if (cross == views.end()) return about;
  const SensorTarget bed = PlaneTarget{true};
  PoseProblem problem;
  problem.about = about;
  FittedView level;
  level.target = &bed;
  level.view = viewPoints(cross->recording, settings.time_offset_s);
  problem.views.push_back(std::move(level));
  const Pose pose = fittedWhereDetermined(problem, Pose::Zero(), settings);
  return placedOverCross(std::get<CrossTarget>(cross->target), problem.views[0].view, moved(about, pose));
}

}  // namespace

SensorPoseFit fitSensorPose(const std::vector<SensorView>& views, const Eigen::Isometry3d& about,
                            const SensorPoseSettings& settings) {
  if (views.empty()) throw InvalidInput("there is no view; expected a recording of a target");
  PoseProblem problem = problemOf(views, about, settings.time_offset_s);
  const Pose start = between(about, placedOverCrosses(views, about, settings));
  const Pose pose = fittedWhereDetermined(problem, start, settings);
  return describedFit(problem, pose, settings);
}

}  // namespace lamina
