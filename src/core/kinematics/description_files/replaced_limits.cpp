// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description_files/replaced_limits.hpp"

#include <tinyxml.h>

#include <cmath>

#include "base/decimals.hpp"
#include "kinematics/description_files/description_faults.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kSameLimit = 1e-6;  // deg: what the digits of descriptions leave open

/// One of the numbers of a <limit>.
struct LimitNumber {
  const char* attribute;
  const char* key;
  double wider_sign;  ///< sign of a change that makes the range wider
};

constexpr LimitNumber kLowerBound{"lower", "lower_deg", -1.0};
constexpr LimitNumber kUpperBound{"upper", "upper_deg", 1.0};
constexpr LimitNumber kGreatestSpeed{"velocity", "deg_s", 1.0};

ReplacedLimit replacedLimitFrom(const std::string& joint, const StrictYaml& node) {
  ReplacedLimit limit;
  limit.joint = joint;
  for (const auto& [key, value] : node.entries({"lower_deg", "upper_deg", "deg_s", "wider"})) {
    if (key == "lower_deg") limit.lower_deg = value.number();
    if (key == "upper_deg") limit.upper_deg = value.number();
    if (key == "deg_s") limit.deg_s = value.number();
    if (key == "wider") limit.may_widen = value.flag();
    if (key == "deg_s" && !(*limit.deg_s > 0.0)) value.refuse("is no speed; expected a positive number");
  }
  return limit;
}

/// The value as the description states it [deg], if it does.
std::optional<double> statedNumber(const TiXmlElement& limit, const char* attribute) {
  double value = 0.0;
  if (limit.QueryDoubleAttribute(attribute, &value) != TIXML_SUCCESS) return std::nullopt;
  const bool is_none = attribute == std::string(kGreatestSpeed.attribute) && !(value > 0.0);
  if (is_none) return std::nullopt;
  return toDegrees(value);
}

void replaceNumber(TiXmlElement& limit, const LimitNumber& number, std::optional<double> by,
                   const ReplacedLimit& asked) {
  if (!by) return;
  const std::optional<double> stated = statedNumber(limit, number.attribute);
  if (stated && !asked.may_widen && number.wider_sign * (*by - *stated) > kSameLimit)
    throw InvalidConfig("cell.arm.limits: " + std::string(number.key) + " of joint '" + asked.joint +
                        "' is " + numberText(*by) + ", wider than the " + numberText(*stated) +
                        " of its description; expected a limit within that, or wider: true");
  limit.SetAttribute(number.attribute, shortestText(toRadians(*by)));
}

TiXmlElement& limitOf(TiXmlElement& joint) {
  if (TiXmlElement* limit = joint.FirstChildElement("limit")) return *limit;
  TiXmlElement limit("limit");
  limit.SetAttribute("effort", "0");
  return *joint.InsertEndChild(limit)->ToElement();
}

void replaceLimit(TiXmlElement& robot, const ReplacedLimit& asked) {
  TiXmlElement* joint = robot.FirstChildElement("joint");
  while (joint != nullptr && attributeOf(*joint, "name") != asked.joint)
    joint = joint->NextSiblingElement("joint");
  if (joint == nullptr)
    throw InvalidConfig("cell.arm.limits: the description has no joint '" + asked.joint + "'");
  const std::string type = attributeOf(*joint, "type");
  const bool is_rotary = type == "revolute" || type == "continuous";
  if (!is_rotary || joint->FirstChildElement("mimic") != nullptr)
    throw InvalidConfig("cell.arm.limits: joint '" + asked.joint + "' is " +
                        (is_rotary ? "one that mimics another" : "of type '" + type + "'") +
                        "; expected a rotary joint that is driven");
  TiXmlElement& limit = limitOf(*joint);
  if (type == "continuous") {
    // Its bounds, if there are any, mean nothing.
    limit.RemoveAttribute("lower");
    limit.RemoveAttribute("upper");
    if (asked.lower_deg.has_value() != asked.upper_deg.has_value())
      throw InvalidConfig("cell.arm.limits: joint '" + asked.joint +
                          "' turns without end, and one bound is stated; expected lower_deg and upper_deg");
    if (asked.lower_deg) joint->SetAttribute("type", "revolute");
  }
  replaceNumber(limit, kLowerBound, asked.lower_deg, asked);
  replaceNumber(limit, kUpperBound, asked.upper_deg, asked);
  replaceNumber(limit, kGreatestSpeed, asked.deg_s, asked);
}

}  // namespace

std::vector<ReplacedLimit> replacedLimitsFrom(const StrictYaml& node) {
  std::vector<ReplacedLimit> limits;
  for (const auto& [joint, value] : node.entries()) limits.push_back(replacedLimitFrom(joint, value));
  return limits;
}

std::string withReplacedLimits(const std::string& urdf, const std::vector<ReplacedLimit>& limits) {
  if (limits.empty()) return urdf;
  TiXmlDocument document;
  document.Parse(urdf.c_str());
  if (document.Error() || document.RootElement() == nullptr) return urdf;
  for (const ReplacedLimit& limit : limits) replaceLimit(*document.RootElement(), limit);
  TiXmlPrinter printer;
  document.Accept(&printer);
  return printer.Str();
}

}  // namespace lamina
