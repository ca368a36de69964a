// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/arm/arm_cell.hpp"

#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <map>
#include <string>

#include "kinematics/arm/arm_model.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

const ChainLink* linkNamed(const SerialChain& chain, const std::string& name) {
  const auto found = std::find_if(chain.links.begin(), chain.links.end(),
                                  [&](const ChainLink& link) { return link.name == name; });
  return found == chain.links.end() ? nullptr : &*found;
}

/// The link that moves with the bed and is moved by a joint itself, or the root.
const ChainLink& carrierOf(const SerialChain& chain) {
  const ChainLink* link = linkNamed(chain, "bed");
  while (link->joint == ChainLink::kNone && link->parent != ChainLink::kNone)
    link = &chain.links[static_cast<std::size_t>(link->parent)];
  return *link;
}

/// That of the link that a cell file puts on the flange.
std::optional<ToolLoad> loadOf(const std::string& urdf,
                               const std::map<std::string, Eigen::Isometry3d>& links) {
  constexpr double kMillimetres = 1e3;  // in a metre
  const auto flange = links.find("cell_flange");
  if (flange == links.end()) return std::nullopt;
  const auto description = urdf::parseURDF(urdf);
  const auto link = description ? description->getLink("cell_flange") : nullptr;
  if (!link || !link->inertial) return std::nullopt;
  const urdf::Vector3& at = link->inertial->origin.position;
  const Point3 centre = kMillimetres * Point3(at.x, at.y, at.z);
  return ToolLoad{link->inertial->mass, links.at("tool0").inverse() * flange->second * centre};
}

}  // namespace

ArmCell armCell(const KinematicModel& arm) {
  const SerialChain& chain = requireArm(arm).chain().whole;
  if (linkNamed(chain, "tool0") == nullptr)
    throw InvalidConfig("arm '" + arm.name() +
                        "' has no link tool0; expected one, the flange as its controller counts it");
  const auto links = arm.bedFromLinks(JointValues::Zero(static_cast<Eigen::Index>(arm.joints().size())));
  const ChainLink& carrier = carrierOf(chain);
  ArmCell cell;
  cell.flange_from_nozzle = links.at("tool0").inverse() * links.at("nozzle");
  cell.carrier_from_bed = links.at(carrier.name).inverse();
  cell.is_bed_carried = carrier.joint != ChainLink::kNone;
  cell.load = loadOf(arm.urdf(), links);
  return cell;
}

}  // namespace lamina
