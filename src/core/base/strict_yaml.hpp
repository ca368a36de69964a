// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <utility>
#include <vector>

#include "lamina/base/quotation.hpp"
#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// A node of a YAML document with its position. Reading refuses anything unexpected, naming source, line and
/// key.
class StrictYaml {
 public:
  using Entries = std::vector<std::pair<std::string, StrictYaml>>;

  /// @param key  dotted key that leads to the node, for messages; empty for the whole document
  StrictYaml(const YAML::Node& node, std::string source_name, std::string key);

  /// Refuses the node.
  /// @throws InvalidConfig always
  [[noreturn]] void refuse(const std::string& what) const;

  bool isMap() const { return node_.IsMap(); }
  bool isList() const { return node_.IsSequence(); }
  bool isScalar() const { return node_.IsScalar(); }

  /// The entries of a map, in order.
  /// @throws InvalidConfig if the node is no map, or has a key twice
  Entries entries() const;
  /// The entries of a map that may have these keys only.
  /// @throws InvalidConfig as `entries()`; naming the allowed keys if it has another one
  Entries entries(const std::vector<std::string>& allowed) const;
  /// The elements of a list.
  /// @throws InvalidConfig if the node is no list
  std::vector<StrictYaml> pieces() const;

  /// The text of a scalar.
  /// @throws InvalidConfig if the node is no scalar
  std::string text() const;
  std::vector<std::string> texts() const;
  /// A finite number.
  /// @throws InvalidConfig if the node is none
  double number() const;
  std::vector<double> numbers() const;
  /// A whole number.
  /// @throws InvalidConfig if the node is none, or lies outside the bounds
  int whole(int low, int high) const;
  /// True or false.
  /// @throws InvalidConfig if the node is neither
  bool flag() const;

  /// All scalars below the node, with dotted keys.
  /// @throws InvalidConfig if keys are nested more than ten deep, as in an alias that contains itself
  std::vector<SettingText> settings() const;

 private:
  Quotation keyQuotation() const;
  Entries entriesQuotedBy(const Quotation& quotation) const;
  void addSettings(const std::string& prefix, int depth, std::vector<SettingText>& found) const;

  YAML::Node node_;
  std::string source_name_;
  std::string key_;
};

}  // namespace lamina
