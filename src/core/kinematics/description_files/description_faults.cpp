// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description_files/description_faults.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr double kUnitAxis = 1e-6;  // as of `directionOf`
constexpr std::array<const char*, 4> kJointTypes = {"revolute", "continuous", "prismatic", "fixed"};

double numberOf(const TiXmlElement& element, const char* name) {
  const char* text = element.Attribute(name);
  return text != nullptr ? std::strtod(text, nullptr) : 0.0;
}

/// Looks through a description once.
class FaultCollector {
 public:
  explicit FaultCollector(const PackagePath& packages) : packages_(packages) {}

  std::vector<std::string> of(const TiXmlElement& robot) {
    for (const TiXmlElement* link = robot.FirstChildElement("link"); link != nullptr;
         link = link->NextSiblingElement("link"))
      addLink(*link);
    for (const TiXmlElement* joint = robot.FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint"))
      if (!joints_.emplace(attributeOf(*joint, "name"), joint).second)
        add("joint", *joint, "has the name of another");
    for (const TiXmlElement* joint = robot.FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint"))
      addJoint(*joint);
    requireTree();
    return faults_;
  }

 private:
  void add(const std::string& kind, const TiXmlElement& element, const std::string& what) {
    faults_.push_back(kind + " '" + attributeOf(element, "name") + "' (line " +
                      std::to_string(element.Row()) + ") " + what);
  }

  void addLink(const TiXmlElement& link) {
    if (!links_.insert(attributeOf(link, "name")).second) add("link", link, "has the name of another");
    for (const TiXmlElement* body = link.FirstChildElement("collision"); body != nullptr;
         body = body->NextSiblingElement("collision")) {
      const TiXmlElement* geometry = body->FirstChildElement("geometry");
      const TiXmlElement* mesh = geometry != nullptr ? geometry->FirstChildElement("mesh") : nullptr;
      if (geometry == nullptr) add("link", link, "has a collision without geometry");
      if (mesh != nullptr) addMesh(link, attributeOf(*mesh, "filename"));
    }
  }

  void addMesh(const TiXmlElement& link, const std::string& name) {
    const std::string suffix = smallSuffix(name);
    if (suffix == ".dae") {
      add("link", link,
          "has the collision mesh '" + name +
              "', which is COLLADA; expected STL or OBJ, as `assimp export` or Blender make of it");
      return;
    }
    if (!isMeshOfBodies(name)) {
      add("link", link, "has the collision mesh '" + name + "'; expected STL, OBJ or PLY");
      return;
    }
    const auto path = packages_.resolved(name);
    if (!path)
      add("link", link,
          "has the collision mesh '" + name + "', whose package is in none of the folders " +
              listed(packages_.folders()));
    else if (!std::filesystem::exists(*path))
      add("link", link, "has the collision mesh '" + name + "', but there is no file " + *path);
  }

  void addJoint(const TiXmlElement& joint) {
    const std::string type = attributeOf(joint, "type");
    const bool is_known =
        std::any_of(kJointTypes.begin(), kJointTypes.end(), [&](const char* known) { return type == known; });
    if (!is_known) add("joint", joint, "is of type '" + type + "'; expected one of " + types());
    const std::string parent = linkOf(joint, "parent");
    const std::string child = linkOf(joint, "child");
    if (!child.empty() && !parent_of_.emplace(child, parent).second)
      add("joint", joint, "has the child '" + child + "', which hangs on another joint, too");
    if (is_known && type != "fixed") addMotion(joint, type);
  }

  /// Name of the link at one end; empty, and a fault, if there is none.
  std::string linkOf(const TiXmlElement& joint, const char* end) {
    const TiXmlElement* element = joint.FirstChildElement(end);
    std::string name = element != nullptr ? attributeOf(*element, "link") : "";
    if (links_.count(name) != 0) return name;
    add("joint", joint, std::string("has the ") + end + " '" + name + "', which is no link");
    return "";
  }

  void addMotion(const TiXmlElement& joint, const std::string& type) {
    if (const TiXmlElement* axis = joint.FirstChildElement("axis")) addAxis(joint, *axis);
    if (const TiXmlElement* mimic = joint.FirstChildElement("mimic")) {
      const auto driver = joints_.find(attributeOf(*mimic, "joint"));
      if (driver == joints_.end())
        add("joint", joint, "mimics '" + attributeOf(*mimic, "joint") + "', which is no joint");
      else if (driver->second->FirstChildElement("mimic") != nullptr)
        add("joint", joint, "mimics '" + driver->first + "', which mimics another; expected a driven one");
      return;  // limits are those of what it mimics
    }
    const TiXmlElement* limit = joint.FirstChildElement("limit");
    if (limit == nullptr) {
      add("joint", joint, "has no limits");
      return;
    }
    const double velocity = numberOf(*limit, "velocity");
    if (!(velocity > 0.0 && std::isfinite(velocity)))
      add("joint", joint,
          limit->Attribute("velocity") == nullptr
              ? "has no velocity; expected one in its limit, or in cell.arm.limits"
              : "has a velocity of " + attributeOf(*limit, "velocity") + "; must be positive");
    if (type != "continuous" && !(numberOf(*limit, "lower") < numberOf(*limit, "upper")))
      add("joint", joint,
          "has limits '" + attributeOf(*limit, "lower") + "' to '" + attributeOf(*limit, "upper") +
              "'; the lower must be the lesser");
  }

  void addAxis(const TiXmlElement& joint, const TiXmlElement& axis) {
    std::istringstream text(attributeOf(axis, "xyz"));
    std::array<double, 3> xyz{};
    for (double& each : xyz) text >> each;
    const double length = std::hypot(xyz[0], xyz[1], xyz[2]);
    if (text.fail() || !(std::abs(length - 1.0) < kUnitAxis))
      add("joint", joint,
          "has the axis '" + attributeOf(axis, "xyz") + "'; expected three numbers of unit length");
  }

  void requireTree() {
    std::vector<std::string> roots;
    for (const std::string& link : links_)
      if (parent_of_.count(link) == 0) roots.push_back("'" + link + "'");
    const std::vector<std::string> loop = linksOfLoop();
    if (links_.empty())
      faults_.emplace_back("there is no link");
    else if (roots.size() > 1)
      faults_.push_back("links " + listed(roots) + " hang on none; expected one such link, the root");
    if (!loop.empty())
      faults_.push_back("links " + listed(loop) +
                        " hang on each other in a loop; expected a tree: a rod that closes one is left out, "
                        "and its joint mimics another");
  }

  /// The links of the first loop that there is; empty for a tree.
  std::vector<std::string> linksOfLoop() const {
    for (const auto& [link, parent] : parent_of_) {
      std::vector<std::string> loop = {"'" + link + "'"};
      std::string up = parent;
      for (; up != link && parent_of_.count(up) != 0 && loop.size() <= links_.size(); up = parent_of_.at(up))
        loop.push_back("'" + up + "'");
      if (up == link) return loop;
    }
    return {};
  }

  static std::string types() { return listed({kJointTypes.begin(), kJointTypes.end()}); }

  const PackagePath& packages_;
  std::vector<std::string> faults_;
  std::set<std::string> links_;
  std::map<std::string, const TiXmlElement*> joints_;
  std::map<std::string, std::string> parent_of_;
};

}  // namespace

std::vector<std::string> descriptionFaults(const TiXmlElement& robot, const PackagePath& packages) {
  return FaultCollector(packages).of(robot);
}

bool isMeshOfBodies(const std::string& name) {
  const std::string suffix = smallSuffix(name);
  return suffix == ".stl" || suffix == ".obj" || suffix == ".ply";
}

std::string attributeOf(const TiXmlElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value != nullptr ? value : "";
}

}  // namespace lamina
