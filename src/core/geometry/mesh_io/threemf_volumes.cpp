// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "threemf_volumes.hpp"

#include <zip.h>

#include <charconv>
#include <limits>
#include <memory>
#include <optional>

#include "geometry/svg/xml_scanner.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr zip_uint64_t kMostBytes = 64U << 20U;     // of a list of volumes
constexpr zip_uint64_t kMostOfModel = 4ULL << 30U;  // bytes

/// By the numbers that the model gives its objects.
using NumberedVolumes = std::map<std::uint32_t, std::vector<VolumeRange>>;

struct DiscardArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseEntry {
  void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};
using Archive = std::unique_ptr<zip_t, DiscardArchive>;

Archive opened(std::string_view bytes, const std::string& name) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  Archive archive(source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error));
  const std::string reason = zip_error_strerror(&error);
  zip_error_fini(&error);
  if (archive) return archive;
  if (source != nullptr) zip_source_free(source);
  throw InvalidMesh(name + ": no readable archive: " + reason);
}

/// The text of an entry; none if there is none of that name.
std::optional<std::string> entryOf(const Archive& archive, const char* entry, zip_uint64_t most_bytes,
                                   const std::string& name) {
  zip_stat_t stat;
  zip_stat_init(&stat);
  if (zip_stat(archive.get(), entry, 0, &stat) != 0 || (stat.valid & ZIP_STAT_SIZE) == 0) return std::nullopt;
  if (stat.size > most_bytes)
    throw InvalidMesh(name + ": " + entry + " has " + std::to_string(stat.size) +
                      " bytes; expected at most " + std::to_string(most_bytes));
  const std::unique_ptr<zip_file_t, CloseEntry> file(zip_fopen(archive.get(), entry, 0));
  std::string text(stat.size, '\0');
  if (!file || zip_fread(file.get(), text.data(), stat.size) != static_cast<zip_int64_t>(stat.size))
    throw InvalidMesh(name + ": " + entry + " cannot be read");
  return text;
}

/// Of any slicer's words; none for a volume of the part.
std::optional<VolumeKind> kindOfVolume(const std::string& word) {
  if (word == "ParameterModifier" || word == "modifier_part") return VolumeKind::Modifier;
  if (word == "NegativeVolume" || word == "negative_part") return VolumeKind::Negative;
  if (word == "SupportBlocker" || word == "support_blocker") return VolumeKind::SupportBlocker;
  if (word == "SupportEnforcer" || word == "support_enforcer") return VolumeKind::SupportEnforcer;
  return std::nullopt;
}

class VolumeScanner {
 public:
  VolumeScanner(const std::string& text, const std::string& name) : scanner_(text, name) {}

  NumberedVolumes scan() {
    XmlTag tag;
    while (scanner_.next(tag)) {
      if (tag.is_end) continue;
      if (tag.name == "object") object_ = number(tag, "id");
      if (tag.name == "volume")
        range_ = {VolumeKind::Modifier, number(tag, "firstid"), number(tag, "lastid")};
      if (tag.name == "metadata") addKind(tag);
      if (tag.name == "part") addPart(tag);
    }
    return std::move(found_);
  }

 private:
  std::uint32_t number(const XmlTag& tag, const std::string& key) const {
    const std::string text = tag.attribute(key);
    std::uint32_t value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc{} || result.ptr != text.data() + text.size())
      scanner_.refuse(tag.line, key + " of " + tag.name + " is '" + text + "'; expected a number");
    return value;
  }

  void addKind(const XmlTag& tag) {
    const bool is_of_volume = tag.attribute("type") == "volume" && tag.attribute("key") == "volume_type";
    const auto kind = is_of_volume ? kindOfVolume(tag.attribute("value")) : std::nullopt;
    if (!kind) return;
    range_.kind = *kind;
    found_[object_].push_back(range_);
  }

  void addPart(const XmlTag& tag) {
    if (const auto kind = kindOfVolume(tag.attribute("subtype")))
      found_[number(tag, "id")] = {{*kind, 0, std::numeric_limits<std::size_t>::max()}};
  }

  XmlScanner scanner_;
  std::uint32_t object_ = 0;
  VolumeRange range_;
  NumberedVolumes found_;
};

/// By the order in which the text of a model has its objects.
ObjectVolumes inOrder(NumberedVolumes numbered, std::string_view model) {
  constexpr std::string_view kObject = "<object ";
  constexpr std::string_view kId = " id=\"";
  ObjectVolumes ordered;
  std::size_t order = 0;
  for (std::size_t at = model.find(kObject); at != std::string_view::npos; at = model.find(kObject, at + 1)) {
    const std::string_view tag = model.substr(at, model.find('>', at) - at);
    const std::size_t id = tag.find(kId);
    std::uint32_t number = 0;
    if (id != std::string_view::npos)
      std::from_chars(tag.data() + id + kId.size(), tag.data() + tag.size(), number);
    if (const auto found = numbered.find(number); found != numbered.end())
      ordered[order] = std::move(found->second);
    ++order;
  }
  return ordered;
}

}  // namespace

ObjectVolumes objectVolumes(std::string_view archive_bytes, const std::string& name) {
  const Archive archive = opened(archive_bytes, name);
  for (const char* const entry : {"Metadata/Slic3r_PE_model.config", "Metadata/model_settings.config"}) {
    const auto text = entryOf(archive, entry, kMostBytes, name);
    if (!text) continue;
    NumberedVolumes numbered = VolumeScanner(*text, name + ", " + entry).scan();
    if (numbered.empty()) return {};
    return inOrder(std::move(numbered),
                   entryOf(archive, "3D/3dmodel.model", kMostOfModel, name).value_or(""));
  }
  return {};
}

}  // namespace lamina
