// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/link_motion.hpp"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <mutex>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

/// While it lives, it keeps what the parser of URDF complains of, which would go to the terminal; the
/// parser's results give no reasons. One at a time: others wait.
class UrdfComplaints : public console_bridge::OutputHandler {
 public:
  UrdfComplaints();
  ~UrdfComplaints() override;
  UrdfComplaints(const UrdfComplaints&) = delete;
  UrdfComplaints& operator=(const UrdfComplaints&) = delete;

  /// The first error, which later ones follow from; empty if there was none.
  const std::string& first() const { return first_; }

  void log(const std::string& text, console_bridge::LogLevel level, const char* file, int line) override;

 private:
  std::unique_lock<std::mutex> alone_;
  console_bridge::OutputHandler* usual_;
  std::string first_;
};

/// The parser has one handler for all threads.
std::mutex& handlerMutex() {
  static std::mutex mutex;
  return mutex;
}

UrdfComplaints::UrdfComplaints() : alone_(handlerMutex()), usual_(console_bridge::getOutputHandler()) {
  console_bridge::useOutputHandler(this);
}

UrdfComplaints::~UrdfComplaints() { console_bridge::useOutputHandler(usual_); }

void UrdfComplaints::log(const std::string& text, console_bridge::LogLevel level, const char*, int) {
  if (level == console_bridge::CONSOLE_BRIDGE_LOG_ERROR && first_.empty()) first_ = text;
}

constexpr double kMillimetres = 1e3;  // in the metre of URDF
constexpr double kUnit = 1e-6;

int axisIndex(const urdf::ModelInterface& model, const urdf::Joint& joint) {
  for (int i = 0; i < 3; ++i)
    if (joint.type == urdf::Joint::PRISMATIC && joint.name == kAxisNames[i]) return i;
  throw InvalidConfig(
      "machine '" + model.getName() + "': joint '" + joint.name +
      "' moves; only prismatic joints x, y and z and rotary joints a, b and c are understood");
}

bool isRotary(const urdf::Joint& joint) {
  const bool turns = joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS;
  return turns &&
         std::find(std::begin(kRotaryNames), std::end(kRotaryNames), joint.name) != std::end(kRotaryNames);
}

}  // namespace

std::shared_ptr<urdf::ModelInterface> parseMachine(const std::string& text) {
  const UrdfComplaints complaints;
  std::shared_ptr<urdf::ModelInterface> model = urdf::parseURDF(text);
  if (!model)
    throw InvalidConfig("the machine's description of " + std::to_string(text.size()) +
                        " bytes is no URDF: " + complaints.first());
  return model;
}

Eigen::Isometry3d poseOf(const urdf::Pose& pose) {
  const Eigen::Quaterniond rotation(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
  return Eigen::Translation3d(kMillimetres * Point3(pose.position.x, pose.position.y, pose.position.z)) *
         rotation.normalized();
}

const urdf::Link& requireLink(const urdf::ModelInterface& model, const std::string& name) {
  const auto link = model.getLink(name);
  if (!link) throw InvalidConfig("machine '" + model.getName() + "' has no link '" + name + "'");
  return *link;
}

Point3 directionOf(const urdf::ModelInterface& model, const urdf::Joint& joint) {
  const Point3 axis(joint.axis.x, joint.axis.y, joint.axis.z);
  if (std::abs(axis.norm() - 1.0) < kUnit) return axis.normalized();
  throw InvalidConfig("machine '" + model.getName() + "': the axis of joint '" + joint.name + "' is " +
                      numberText(axis.norm()) + " long; expected 1");
}

LinkMotion motionOf(const urdf::ModelInterface& model, const std::string& name) {
  const urdf::Link* link = &requireLink(model, name);
  LinkMotion motion;
  while (link->parent_joint) {
    const urdf::Joint& joint = *link->parent_joint;
    const Eigen::Isometry3d origin = poseOf(joint.parent_to_joint_origin_transform);
    motion.root_from_link = origin * motion.root_from_link;
    motion.axes = origin.linear() * motion.axes;
    if (isRotary(joint))
      motion.rotaries.push_back(joint.name);
    else if (joint.type != urdf::Joint::FIXED)
      motion.axes.col(axisIndex(model, joint)) = origin.linear() * directionOf(model, joint);
    link = &requireLink(model, joint.parent_link_name);
  }
  return motion;
}

}  // namespace lamina
