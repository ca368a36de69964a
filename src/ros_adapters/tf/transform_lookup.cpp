// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tf/transform_lookup.hpp"

#include <tf2/exceptions.h>

#include "conversions.hpp"

namespace lamina {

Eigen::Isometry3d fromMessage(const geometry_msgs::Transform& transform) {
  const auto& translation = transform.translation;
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() =
      Point3(toMillimetres(translation.x), toMillimetres(translation.y), toMillimetres(translation.z));
  result.linear() = fromMessage(transform.rotation).normalized().toRotationMatrix();
  return result;
}

geometry_msgs::Transform toTransformMessage(const Eigen::Isometry3d& transform) {
  geometry_msgs::Transform message;
  message.translation.x = toMetres(transform.translation().x());
  message.translation.y = toMetres(transform.translation().y());
  message.translation.z = toMetres(transform.translation().z());
  message.rotation = toMessage(Eigen::Quaterniond(transform.linear()));
  return message;
}

std::string bareFrame(const std::string& frame) {
  return !frame.empty() && frame.front() == '/' ? frame.substr(1) : frame;
}

std::optional<Eigen::Isometry3d> lookUp(const tf2::BufferCore& buffer, const std::string& target,
                                        const std::string& source, const ros::Time& stamp) {
  try {
    return fromMessage(buffer.lookupTransform(target, bareFrame(source), stamp).transform);
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

Readiness readiness(const tf2::BufferCore& buffer, const std::string& target, const std::string& source,
                    const ros::Time& stamp) {
  const std::string bare = bareFrame(source);
  if (buffer.canTransform(target, bare, stamp)) return Readiness::Ready;
  try {
    const ros::Time latest = buffer.lookupTransform(target, bare, ros::Time(0)).header.stamp;
    return latest < stamp ? Readiness::NotYet : Readiness::Never;
  } catch (const tf2::TransformException&) {
    return Readiness::NotYet;
  }
}

}  // namespace lamina
