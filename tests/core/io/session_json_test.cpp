#include "hexoderm/io/session_json.h"

#include "hexoderm/base/file.h"
#include "hexoderm/base/sha256.h"
#include "hexoderm/session/session_store.h"
#include "tests/core/io/json_complaints.h"
#include "tests/support/paths.h"
#include "tests/support/random_session.h"
#include "tests/support/session_matchers.h"
#include "tests/support/temporary_folder.h"

namespace hexoderm {
namespace {

using test::TemporaryFolder;

const std::filesystem::path kThreeCells = std::filesystem::path(HEXODERM_TEST_DATA) / "three_cells.session.json";

nlohmann::json threeCells() { return nlohmann::json::parse(readFile(kThreeCells)); }

TEST(SessionJson, ReadsAFileWrittenByHand) {
  const Session session = readSessionJson(kThreeCells);
  EXPECT_EQ(session.model().name, "hex-bma150");
  EXPECT_EQ(session.source().text.english(), "Three cells in a row, bent by 20 degrees at each link");
  EXPECT_EQ(session.source().file, "three_cells.session.json");
  EXPECT_EQ(session.source().sha256, sha256Hex(readFile(kThreeCells)));

  ASSERT_EQ(session.neighbors().size(), 3U);
  const std::vector<NeighborReport> neighbors = {{PortNumber(3), CellId(1), std::nullopt},
                                                 {PortNumber(2), CellId(5), PortNumber(3)}};
  EXPECT_EQ(session.neighbors()[1], (CellReport{CellId(2), "forearm", neighbors}));

  ASSERT_EQ(session.poses().size(), 3U);
  const PoseCapture& first = *session.poses()[0].capture;
  EXPECT_EQ(first.id, PoseId(1));
  EXPECT_EQ(first.label.english(), "lying on the table");
  EXPECT_FALSE(session.poses()[0].disabled);
  ASSERT_EQ(first.samples.size(), 3U);
  EXPECT_EQ(first.samples[0].mean_g, Eigen::Vector3d(0.1, 0.2, 0.9746794344808963));
  EXPECT_EQ(first.samples[0].count, 100U);
  Eigen::Matrix3d cov_g2;
  cov_g2 << 1e-6, 1e-8, 0, 1e-8, 2e-6, -1e-8, 0, -1e-8, 3e-6;
  EXPECT_EQ(first.samples[0].cov_g2, cov_g2);
  EXPECT_EQ(first.samples[1].count, 0U);
  EXPECT_TRUE(first.samples[1].cov_g2.isZero(0));
  EXPECT_TRUE(session.poses()[1].disabled);
  EXPECT_EQ(session.nextPoseId(), PoseId(6));

  ASSERT_NE(session.truth(), nullptr);
  EXPECT_EQ(session.truth()->frame, "arm");
  ASSERT_EQ(session.truth()->cells.size(), 3U);
  EXPECT_EQ(session.truth()->cells[1].T_b_u.R * Eigen::Vector3d::UnitX(), Eigen::Vector3d(Eigen::Vector3d::UnitY()));
  EXPECT_EQ(session.truth()->cells[1].T_b_u.t, Eigen::Vector3d(0.024, -0.014, 0.001));
}

TEST(SessionJson, KeepsEverythingThatAStoreKeepsAndBack) {
  const TemporaryFolder folder;
  const Session session = test::sessionWithEverything();
  const auto path = [&](const char* name) { return folder.path() / name; };
  writeSessionStore(session, path("1.hexo"));
  writeSessionJson(readSessionStore(path("1.hexo")), path("2.session.json"));
  writeSessionStore(readSessionJson(path("2.session.json")), path("3.hexo"));
  writeSessionJson(readSessionStore(path("3.hexo")), path("4.session.json"));
  test::expectSameSession(session, readSessionJson(path("2.session.json")));
  test::expectSameSession(session, readSessionStore(path("3.hexo")));
  EXPECT_EQ(readFile(path("2.session.json")), readFile(path("4.session.json")));
}

TEST(SessionJson, OfARandomSessionComesBackAsItWas) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    const Session session = test::RandomSession(seed).draw();
    test::expectSameSession(parseSessionJson(sessionToJson(session), "s.json"), session);
  }
}

TEST(SessionJson, ReadsLinksThatAreSetAside) {
  nlohmann::json json = threeCells();
  EXPECT_TRUE(parseSessionJson(json.dump(), "s.json").mutedLinks().empty());
  EXPECT_FALSE(nlohmann::json::parse(sessionToJson(parseSessionJson(json.dump(), "s.json"))).contains("muted_links"));
  json["muted_links"] = {{{"source", 2}, {"source_port", 3}, {"target", 1}, {"target_port", 2}, {"why", "a cable"}}};
  const MutedLink expected{{CellId(1), PortNumber(2)}, {CellId(2), PortNumber(3)}, "a cable"};
  EXPECT_THAT(parseSessionJson(json.dump(), "s.json").mutedLinks(), testing::ElementsAre(expected));

  json["muted_links"].push_back({{"source", 1}, {"source_port", 2}, {"target", 2}, {"target_port", 3}});
  EXPECT_THAT(messageOf<FormatError>([&] { parseSessionJson(json.dump(), "s.json"); }),
              saysAll("s.json: muted_links[1]: expected each link once"));
  json["muted_links"][1]["target_port"] = "two";
  EXPECT_THAT(messageOf<FormatError>([&] { parseSessionJson(json.dump(), "s.json"); }),
              saysAll("s.json: muted_links[1].target_port: expected a whole number"));
  json["muted_links"][1] = {{"source", 1}, {"source_port", 2}, {"target", 1}, {"target_port", 2}};
  EXPECT_THAT(messageOf<FormatError>([&] { parseSessionJson(json.dump(), "s.json"); }),
              saysAll("s.json: muted_links[1].target_port: expected another port", "two ends"));
}

TEST(SessionJson, SaysWhereTheSkinLies) {
  nlohmann::json json = threeCells();
  json["surface"] = "concave";
  const Session session = parseSessionJson(json.dump(), "s.json");
  EXPECT_EQ(session.side(), SkinSide::Concave);
  EXPECT_EQ(nlohmann::json::parse(sessionToJson(session))["surface"], "concave");
  json["surface"] = "hollow";
  EXPECT_THAT(messageOf<FormatError>([&] { parseSessionJson(json.dump(), "s.json"); }),
              saysAll("s.json: surface: expected \"convex\" or \"concave\""));
}

TEST(SessionJson, ReadsTimesReasonsAndTemperatures) {
  nlohmann::json json = threeCells();
  json["poses"][1]["why_disabled"] = "leaned on it";
  json["poses"][1]["taken_at_ms"] = -1;
  json["poses"][2]["taken_at_ms"] = 1'700'000'000'123;
  json["poses"][2]["samples"][0]["temperature_c"] = -40.5;
  const Session session = parseSessionJson(json.dump(), "s.json");
  EXPECT_FALSE(session.poses()[0].capture->taken_at_ms.has_value());
  EXPECT_EQ(session.poses()[1].why_disabled, "leaned on it");
  EXPECT_EQ(session.poses()[1].capture->taken_at_ms, -1);
  EXPECT_EQ(session.poses()[2].capture->taken_at_ms, 1'700'000'000'123);
  EXPECT_EQ(session.poses()[2].capture->samples[0].temperature_c, -40.5);
  EXPECT_FALSE(session.poses()[2].capture->samples[1].temperature_c.has_value());
  for (const nlohmann::json& none : {nlohmann::json(0.5), nlohmann::json(UINT64_MAX)}) {
    json["poses"][1]["taken_at_ms"] = none;
    EXPECT_THAT(messageOf<FormatError>([&] { parseSessionJson(json.dump(), "s.json"); }),
                saysAll("s.json: poses[1].taken_at_ms: expected a whole number"));
  }
}

TEST(SessionJson, HoldsABuiltInCellModelByItsName) {
  const Session session(builtInCellModel("hex-bma150"), {});
  EXPECT_EQ(nlohmann::json::parse(sessionToJson(session)).at("cell_model"), "hex-bma150");
}

TEST(SessionJson, TakesAnEmptySkin) {
  const Session session = parseSessionJson(
      R"({"format": "hexoderm-session", "version": 1, "cell_model": "hex-bma150", "cells": [], "poses": []})",
      "s.json");
  EXPECT_TRUE(session.neighbors().empty());
  EXPECT_TRUE(session.poses().empty());
  EXPECT_EQ(session.truth(), nullptr);
  EXPECT_EQ(session.source().text.english(), "");
}

TEST(SessionJson, LeavesContradictionsOfTheSkinToTheGraph) {
  nlohmann::json json = threeCells();
  json["cells"].push_back(json["cells"][0]);                                    // duplicate cell
  json["cells"][2]["ports"][0] = {{"port", 3}, {"cell", 5}};                    // self link
  json["cells"][2]["ports"][1] = {{"port", 42}, {"cell", 4711}};                // unknown port and cell
  json["poses"][0]["samples"].push_back({{"cell", 1}, {"mean_g", {0, 0, 1}}});  // duplicate sample
  json["poses"].push_back(json["poses"][0]);                                    // duplicate pose
  const Session session = parseSessionJson(json.dump(), "s.json");
  EXPECT_EQ(session.neighbors().size(), 4U);
  EXPECT_EQ(session.poses().size(), 4U);
}

TEST(SessionJson, NamesTheKeyPathOfWhatIsWrong) {
  test::expectComplaints(threeCells(),
                         {
                             {"/poses/0/id", 4294967295, {"s.json: poses[0].id", "0 to 4294967294"}},
                             {"/poses/0/samples/0/cov_g2/3", -1e-9, {"poses[0].samples[0].cov_g2", "at least 0"}},
                             {"/truth/cells/0/R/0", 1.01, {"s.json: truth.cells[0].R: expected a rotation matrix"}},
                             {"/truth/cells/1/id", 1, {"s.json: truth.cells[1].id: expected each cell once"}},
                             {"/poses/0/samples/0/cov_g2",
                              {1e-6, 2e-6, 0, 1e-6, 0, 1e-6},
                              {"s.json: poses[0].samples[0].cov_g2: expected a covariance (positive semidefinite)"}},
                             {"/poses/0/samples/0/cov_g2",
                              {1e-6, 1e-7, 0, 2e-7, 1e-6, 0, 0, 0, 1e-6},
                              {"poses[0].samples[0].cov_g2: expected an array of 6 numbers, found an array of 9"}},
                             {"/version", 2, {"s.json: version", "version 2", "up to version 1"}},
                             {"/format",
                              "hexoderm-calibration",
                              {"s.json: format: expected \"hexoderm-session\", found \"hexoderm-calibration\""}},
                             {"/cell_model", "oct-9", {"s.json: cell_model", "hex-bma150", "found \"oct-9\""}},
                             {"/cell_model", {{"name", "x"}}, {"s.json: cell_model.side_m: is missing"}},
                         },
                         [](const std::string& text) { parseSessionJson(text, "s.json"); });
}

TEST(SessionJson, WithAnyValueInAnyPlaceIsReadOrRefused) {
  for (const std::string& text : {readFile(kThreeCells), sessionToJson(test::sessionWithEverything())}) {
    test::expectReadAgainOrRefused(
        text, "s.json", [](const std::string& changed) { return sessionToJson(parseSessionJson(changed, "s.json")); });
  }
}

TEST(SessionJson, IsRefusedWhereverItIsCutOff) {
  const std::string text = readFile(kThreeCells);
  expectRefusedWhereverCutOff(text, text.find_last_of('}'),
                              "s.json: ", [](const std::string& cut) { parseSessionJson(cut, "s.json"); });
}

TEST(SessionJson, NamesTheWholePathOfABadFile) {
  const TemporaryFolder folder;
  const auto path = folder.put("bad.session.json", "{");
  EXPECT_THAT(messageOf<FormatError>([&] { readSessionJson(path); }), saysAll(path.string()));
}

TEST(SessionJson, IsWrittenWholeOrNotAtAll) {
  const TemporaryFolder folder;
  const Session session = readSessionJson(kThreeCells);
  const auto path = folder.path() / "out.session.json";
  writeSessionJson(session, path);
  EXPECT_EQ(readFile(path), sessionToJson(session));

  EXPECT_THAT(messageOf<InvalidArgument>([&] { writeSessionJson(test::sessionWithABadReading(), path); }),
              saysAll("out.session.json: pose 7: cell 1: the mean must be finite"));
  EXPECT_EQ(readFile(path), sessionToJson(session)) << "the earlier file is intact";
  EXPECT_THROW(writeSessionJson(session, folder.path()), StorageError);
  EXPECT_EQ(folder.entryCount(), 1U);
}

TEST(SessionJson, OfASecondProgramIsReadAndComesBackAsItWas) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kThreeCells.parent_path() / "vectors")) {
    if (entry.path().extension() != ".json") continue;
    SCOPED_TRACE(entry.path().filename().string());
    const Session session = readSessionJson(entry.path());
    EXPECT_EQ(session.model().name, "reference-hex");
    ASSERT_NE(session.truth(), nullptr);
    EXPECT_EQ(session.truth()->cells.size(), session.neighbors().size());
    EXPECT_FALSE(session.poses().empty());
    test::expectSameSession(parseSessionJson(sessionToJson(session), "back.json"), session);
    ++count;
  }
  EXPECT_GE(count, 5U);
}

}  // namespace
}  // namespace hexoderm
