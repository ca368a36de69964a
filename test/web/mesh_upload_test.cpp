// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/mesh_upload.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "web/site_of_fakes.hpp"

namespace lamina {
namespace {

using test::SiteOfFakes;

WebResponse sendMesh(SiteOfFakes& site, const std::map<std::string, std::string>& fields) {
  site.upload.path = site.folder.path() + "/upload-1";
  site.upload.name = "Bracket.STL";
  site.upload.fields = fields;
  const std::string csrf = site.get("/api/v1/session")["csrf"];
  return site.ask(HttpMethod::Post, "/api/v1/jobs",
                  {{"x-csrf-token", csrf},
                   {"content-type", "multipart/form-data; boundary=b"},
                   {"content-length", "100"}});
}

TEST(MeshUpload, KnowsMeshesByTheirSuffix) {
  EXPECT_EQ(meshSuffix("Bracket.STL"), ".stl");
  EXPECT_EQ(meshSuffix("a.b.3mf"), ".3mf");
  EXPECT_EQ(meshSuffix("housing.stp"), ".stp");
  for (const char* name : {"a.gcode", "stl", "a.stl.gcode", ""}) EXPECT_EQ(meshSuffix(name), "") << name;
}

TEST(MeshUpload, IsSlicedByWhatItsFormSays) {
  SiteOfFakes site;
  const WebResponse sent =
      sendMesh(site, {{"material", " pla "},
                      {"process", "fine"},
                      {"settings", "slicing.layer_height_mm = 0.3\r\n\nwalls.count=2\n"}});
  EXPECT_EQ(sent.status, 201) << sent.body;
  EXPECT_EQ(nlohmann::json::parse(sent.body)["job"], 8);
  EXPECT_EQ(
      site.desk.orders().back(),
      "slice Bracket.STL of pla by fine, slicing.layer_height_mm 0.3, walls.count 2 for page: this host");
}

TEST(MeshUpload, IsRefusedInTheWordsOfWhoSlices) {
  SiteOfFakes site;
  site.desk.next = {DeskAnswer::Outcome::BadInput, 11, "Bracket.STL: no triangle", 0};
  const WebResponse sent = sendMesh(site, {});
  EXPECT_EQ(sent.status, 400);
  EXPECT_NE(sent.body.find("Bracket.STL: no triangle"), std::string::npos) << sent.body;
}

// Whoever may upload names no file of the host, and changes no machine.
TEST(MeshUpload, TakesNoFilesOfTheHostAndNoOtherMachine) {
  SiteOfFakes site;
  const std::vector<std::map<std::string, std::string>> forms = {
      {{"material", "/etc/passwd"}},
      {{"process", "mine.yaml"}},
      {{"settings", "machine.urdf=x.urdf"}},
      {{"settings", "volumetric.target_file=/etc/passwd"}},
      {{"settings", "slicing.layer_height_mm 0.3"}}};
  for (const auto& form : forms) {
    const WebResponse sent = sendMesh(site, form);
    EXPECT_EQ(sent.status, 400) << sent.body;
    EXPECT_NE(sent.body.find("expected"), std::string::npos) << sent.body;
  }
  EXPECT_TRUE(site.desk.orders().empty());
}

}  // namespace
}  // namespace lamina
