// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/description_files/robot_description.hpp"

#include <tinyxml.h>

#include "kinematics/description_files/description_faults.hpp"
#include "kinematics/description_files/package_path.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"

namespace lamina {
namespace {

bool isXacro(const TiXmlElement& element) {
  if (std::string(element.Value()).rfind("xacro:", 0) == 0) return true;
  for (const TiXmlElement* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement())
    if (isXacro(*child)) return true;
  return false;
}

const TiXmlElement& requireRobot(const TiXmlDocument& document, const std::string& path) {
  const TiXmlElement* root = document.RootElement();
  if (document.Error() || root == nullptr)
    throw InvalidConfig(path + ", line " + std::to_string(document.ErrorRow()) +
                        ", is no URDF: " + document.ErrorDesc());
  if (std::string(root->Value()) != "robot")
    throw InvalidConfig(path + " is no URDF: its root is not <robot>");
  if (isXacro(*root))
    throw InvalidConfig(path + " is xacro; expected URDF, as `lamina expand " + path +
                        " -o robot.urdf` makes of it");
  return *root;
}

void requireFaultless(const std::vector<std::string>& faults, const std::string& path) {
  if (faults.empty()) return;
  std::string text =
      path + " has " + std::to_string(faults.size()) + (faults.size() == 1 ? " fault: " : " faults: ");
  for (std::size_t i = 0; i < faults.size(); ++i) text += (i == 0 ? "" : "; ") + faults[i];
  throw InvalidConfig(text);
}

void placeMeshes(TiXmlElement& robot, const PackagePath& packages) {
  for (TiXmlElement* link = robot.FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link"))
    for (TiXmlElement* body = link->FirstChildElement(); body != nullptr; body = body->NextSiblingElement()) {
      TiXmlElement* mesh = TiXmlHandle(body).FirstChild("geometry").FirstChild("mesh").ToElement();
      if (mesh == nullptr) continue;
      if (const auto path = packages.resolved(attributeOf(*mesh, "filename")))
        mesh->SetAttribute("filename", "file://" + *path);
    }
}

/// The parser of URDF asks limits of joints that have no say in them.
void limitMimics(TiXmlElement& robot) {
  for (TiXmlElement* joint = robot.FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    if (joint->FirstChildElement("mimic") == nullptr) continue;
    if (TiXmlElement* stated = joint->FirstChildElement("limit")) joint->RemoveChild(stated);
    TiXmlElement limit("limit");
    for (const char* name : {"lower", "upper", "effort", "velocity"}) limit.SetAttribute(name, "0");
    joint->InsertEndChild(limit);
  }
}

/// What the parser of URDF would refuse, and Lamina does not read.
void dropUnread(TiXmlElement& robot) {
  for (const char* name : {"transmission", "gazebo"})
    while (TiXmlElement* unread = robot.FirstChildElement(name)) robot.RemoveChild(unread);
  for (TiXmlElement* joint = robot.FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    for (const char* name : {"safety_controller", "calibration"})
      while (TiXmlElement* unread = joint->FirstChildElement(name)) joint->RemoveChild(unread);
    TiXmlElement* limit = joint->FirstChildElement("limit");
    if (limit != nullptr && limit->Attribute("effort") == nullptr) limit->SetAttribute("effort", "0");
  }
}

std::string printed(const TiXmlDocument& document) {
  TiXmlPrinter printer;
  document.Accept(&printer);
  return printer.Str();
}

}  // namespace

std::string robotDescription(const std::string& text, const std::string& path,
                             const std::vector<std::string>& packages) {
  TiXmlDocument document;
  document.Parse(text.c_str());
  requireRobot(document, path);
  TiXmlElement& robot = *document.RootElement();
  const PackagePath searched(packages, path);
  requireFaultless(descriptionFaults(robot, searched), path);
  const std::string as_written = printed(document);
  placeMeshes(robot, searched);
  limitMimics(robot);
  dropUnread(robot);
  const std::string read = printed(document);
  return read == as_written ? text : read;
}

std::string readRobotDescription(const std::string& path, const std::vector<std::string>& packages) {
  return robotDescription(readFile(path, kMostSettingsBytes), path, packages);
}

}  // namespace lamina
