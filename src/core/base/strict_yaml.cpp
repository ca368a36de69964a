// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/strict_yaml.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr int kDeepestKeys = 10;  // an alias may lead back to itself

}  // namespace

StrictYaml::StrictYaml(const YAML::Node& node, std::string source_name, std::string key)
    : node_(node), source_name_(std::move(source_name)), key_(std::move(key)) {}

void StrictYaml::refuse(const std::string& what) const {
  const std::string key = key_.empty() ? std::string() : key_ + ": ";
  throw InvalidConfig(source_name_ + ":" + std::to_string(node_.Mark().line + 1) + ": " + key + what);
}

/// Below a key there is a document whose keys were allowed.
Quotation StrictYaml::keyQuotation() const {
  Quotation quotation;
  if (!key_.empty()) quotation.recognise();
  return quotation;
}

StrictYaml::Entries StrictYaml::entries() const { return entriesQuotedBy(keyQuotation()); }

StrictYaml::Entries StrictYaml::entriesQuotedBy(const Quotation& quotation) const {
  if (!node_.IsMap()) refuse("expected a map of keys and values");
  Entries found;
  std::set<std::string> seen;
  for (const auto& entry : node_) {
    if (!entry.first.IsScalar()) refuse("expected keys that are words");
    const std::string name = entry.first.Scalar();
    if (!seen.insert(name).second) refuse(quotation.of(name) + " stands twice");
    const std::string key = key_.empty() ? name : key_ + ": " + name;
    found.emplace_back(name, StrictYaml(entry.second, source_name_, key));
  }
  return found;
}

StrictYaml::Entries StrictYaml::entries(const std::vector<std::string>& allowed) const {
  const auto isAllowed = [&](const std::string& name) {
    return std::find(allowed.begin(), allowed.end(), name) != allowed.end();
  };
  Quotation quotation = keyQuotation();
  for (const auto& entry : node_)
    if (node_.IsMap() && entry.first.IsScalar() && isAllowed(entry.first.Scalar())) quotation.recognise();
  Entries found = entriesQuotedBy(quotation);
  for (const auto& [name, value] : found)
    if (!isAllowed(name)) refuse("unknown key " + quotation.of(name) + "; there are " + listed(allowed));
  return found;
}

std::vector<StrictYaml> StrictYaml::pieces() const {
  if (!node_.IsSequence()) refuse("expected a list");
  std::vector<StrictYaml> found;
  for (const auto& piece : node_) found.emplace_back(piece, source_name_, key_);
  return found;
}

std::string StrictYaml::text() const {
  if (!node_.IsScalar()) refuse("expected a single value");
  return node_.Scalar();
}

std::vector<std::string> StrictYaml::texts() const {
  std::vector<std::string> found;
  for (const StrictYaml& piece : pieces()) found.push_back(piece.text());
  return found;
}

double StrictYaml::number() const {
  const std::string digits = text();
  double value = 0.0;
  const char* end = digits.data() + digits.size();
  const auto result = std::from_chars(digits.data(), end, value);
  if (result.ec != std::errc{} || result.ptr != end || !std::isfinite(value))
    refuse("'" + digits + "'; expected a finite number");
  return value;
}

std::vector<double> StrictYaml::numbers() const {
  std::vector<double> found;
  for (const StrictYaml& piece : pieces()) found.push_back(piece.number());
  return found;
}

int StrictYaml::whole(int low, int high) const {
  const double value = number();
  if (value != std::floor(value) || value < low || value > high)
    refuse("'" + text() + "'; expected a whole number from " + std::to_string(low) + " to " +
           std::to_string(high));
  return static_cast<int>(value);
}

bool StrictYaml::flag() const {
  const std::string word = text();
  if (word != "true" && word != "false") refuse("'" + word + "'; expected true or false");
  return word == "true";
}

std::vector<SettingText> StrictYaml::settings() const {
  std::vector<SettingText> found;
  addSettings("", 0, found);
  std::set<std::string> seen;
  for (const SettingText& setting : found)
    if (!seen.insert(setting.key).second) refuse("'" + setting.key + "' stands twice");
  return found;
}

void StrictYaml::addSettings(const std::string& prefix, int depth, std::vector<SettingText>& found) const {
  if (depth == kDeepestKeys) refuse("keys are nested too deep");
  for (const auto& [name, value] : entries()) {
    if (value.isMap())
      value.addSettings(prefix + name + ".", depth + 1, found);
    else
      found.push_back({prefix + name, value.text()});
  }
}

}  // namespace lamina
