// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "target_model.hpp"
#include "geometry/space_vectors.hpp"

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>

namespace lamina {
namespace {

constexpr double kShiftStep = 1e-4;   // mm
constexpr double kTurnStep = 1e-6;    // rad
constexpr double kClearOfBead = 1.5;  // widths from a bead's line from which on there is bed

/// The bed, but for what lies near beads.
class BedModel final : public SurfaceModel {
 public:
  BedModel(std::vector<CalibrationBead> beads, double clear_mm)
      : beads_(std::move(beads)), clear_mm_(clear_mm) {}

  Eigen::Index unknowns() const override { return 0; }
  Eigen::VectorXd steps() const override { return {}; }
  int faceOf(const Point3& point, const Eigen::VectorXd&) const override {
    for (const CalibrationBead& bead : beads_)
      if (distanceFrom(bead, point.head<2>()) < clear_mm_) return -1;
    return 0;
  }
  double distance(int, const Point3& point, const Eigen::VectorXd&) const override { return point.z(); }

 private:
  static double distanceFrom(const CalibrationBead& bead, const Point2& point) {
    const Point2 along = bead.end - bead.start;
    const double part = std::min(1.0, std::max(0.0, (point - bead.start).dot(along) / along.squaredNorm()));
    return (point - bead.start - part * along).norm();
  }

  std::vector<CalibrationBead> beads_;
  double clear_mm_;
};

/// Any plane: two tilts and a shift along its normal.
class PlaneModel final : public SurfaceModel {
 public:
  explicit PlaneModel(const std::vector<Point3>& points) {
    for (const Point3& point : points) middle_ += point / static_cast<double>(points.size());
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const Point3& point : points) scatter += (point - middle_) * (point - middle_).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter);
    axes_.col(0) = axes.eigenvectors().col(2);
    axes_.col(1) = axes.eigenvectors().col(1);
    axes_.col(2) = axes_.col(0).cross(axes_.col(1));
  }

  Eigen::Index unknowns() const override { return 3; }
  Eigen::VectorXd steps() const override { return Eigen::Vector3d(kTurnStep, kTurnStep, kShiftStep); }
  int faceOf(const Point3&, const Eigen::VectorXd&) const override { return 0; }
  double distance(int, const Point3& point, const Eigen::VectorXd& unknowns) const override {
    const Eigen::Vector3d normal = axes_ * turnBy({unknowns[0], unknowns[1], 0.0}).toRotationMatrix().col(2);
    return normal.dot(point - middle_) - unknowns[2];
  }

 private:
  Point3 middle_ = Point3::Zero();
  Eigen::Matrix3d axes_;
};

/// Faces: the four sides, the top, the ground. Unknowns: three turns, and the shifts that nobody touched.
class PyramidModel final : public SurfaceModel {
 public:
  explicit PyramidModel(const PyramidTarget& target) : target_(target) {
    const double run = 0.5 * (target.base_mm - target.top_mm);
    slope_ = Eigen::Vector2d(target.height_mm, run).normalized();  // of a side's normal: outwards, upwards
    if (!target.is_place_known) shifts_ = {0, 1};
    if (!target.is_top_known) shifts_.push_back(2);
  }

  Eigen::Index unknowns() const override { return 3 + static_cast<Eigen::Index>(shifts_.size()); }
  Eigen::VectorXd steps() const override {
    Eigen::VectorXd steps = Eigen::VectorXd::Constant(unknowns(), kShiftStep);
    steps.head(3).setConstant(kTurnStep);
    return steps;
  }
  int faceOf(const Point3& point, const Eigen::VectorXd& unknowns) const override {
    const Point3 at = inPyramid(point, unknowns);
    // The body is where all sides and the top allow it, and the ground where it ends.
    int face = kTop;
    for (int side = 0; side < kTop; ++side)
      if (heightOver(side, at) > heightOver(face, at)) face = side;
    return heightOver(kGround, at) < heightOver(face, at) ? kGround : face;
  }
  double distance(int face, const Point3& point, const Eigen::VectorXd& unknowns) const override {
    const Point3 at = inPyramid(point, unknowns);
    return heightOver(face, at) * (face < kTop ? slope_.y() : 1.0);
  }

 private:
  static constexpr int kTop = 4;
  static constexpr int kGround = 5;

  Point3 inPyramid(const Point3& point, const Eigen::VectorXd& unknowns) const {
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < shifts_.size(); ++i)
      shift[shifts_[i]] = unknowns[3 + static_cast<Eigen::Index>(i)];
    const Point3 standing = target_.bed_from_pyramid.inverse() * Point3(point - shift);
    return turnBy(unknowns.head<3>()).toRotationMatrix().transpose() * standing;
  }
  /// Above a face along z.
  double heightOver(int face, const Point3& at) const {
    if (face == kTop) return at.z() - target_.height_mm;
    if (face == kGround) return at.z();
    static const std::array<Eigen::Vector2d, 4> kOutwards = {Eigen::Vector2d(1, 0), Eigen::Vector2d(-1, 0),
                                                             Eigen::Vector2d(0, 1), Eigen::Vector2d(0, -1)};
    const double out = kOutwards[static_cast<std::size_t>(face)].dot(at.head<2>()) - 0.5 * target_.base_mm;
    return at.z() + out * slope_.x() / slope_.y();
  }

  PyramidTarget target_;
  Eigen::Vector2d slope_;
  std::vector<int> shifts_;
};

}  // namespace

std::unique_ptr<SurfaceModel> surfaceModelOf(const SensorTarget& target, const std::vector<Point3>& points) {
  if (const auto* pyramid = std::get_if<PyramidTarget>(&target))
    return std::make_unique<PyramidModel>(*pyramid);
  if (const auto* cross = std::get_if<CrossTarget>(&target))
    return std::make_unique<BedModel>(cross->beads, kClearOfBead * cross->bead_width_mm);
  if (std::get<PlaneTarget>(target).is_bed)
    return std::make_unique<BedModel>(std::vector<CalibrationBead>(), 0.0);
  return std::make_unique<PlaneModel>(points);
}

}  // namespace lamina
