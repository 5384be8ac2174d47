// A skin of which a cell has fallen off: every command says that the patches are not placed against each other, and no
// export puts them at one place.

#include "hexoderm/base/sha256.h"
#include "hexoderm/io/session_json.h"
#include "tests/app/cli/cli_program.h"

namespace hexoderm {
namespace {

class CliPatches : public Cli {
 protected:
  /// Sets the only link of a cell aside, and solves.
  void SetUp() override {
    ASSERT_EQ(run("simulate --poses 4 --seed 4 -o arm.session.json").exit_code, 0);
    Session session = readSessionJson(path("arm.session.json"));
    for (const CellReport& cell : NeighborList(session.neighbors())) {
      std::vector<NeighborReport> links = cell.neighbors;
      std::erase_if(links, [](const NeighborReport& report) { return report.cell == CellId(0); });
      if (links.size() != 1) continue;
      if (fallen_ != 0) {
        free_end_ = toString(cell.id) + (links[0].port == PortNumber(1) ? ":2" : ":1");
        break;
      }
      fallen_ = cell.id.value();
      session.setLinkMuted({cell.id, links[0].port}, {links[0].cell, links[0].cell_port.value()}, true, "it came off");
    }
    ASSERT_NE(fallen_, 0U);
    writeSessionJson(session, path("arm.session.json"));
    const Outcome solve = run("solve arm.session.json -o arm.calibration.json");
    ASSERT_THAT(solve.out, AllOf(HasSubstr("2 patches"), HasSubstr("was set aside by hand (it came off)")))
        << solve.err;
  }

  [[nodiscard]] std::string exported(const std::string& format, const std::string& options = "") const {
    return outputOf("export arm.calibration.json --to " + format + " " + options + " -o -");
  }

  std::uint32_t fallen_ = 0;
  std::string free_end_;  ///< a free port of the largest patch, as --loop has it
};

// What each format holds of which patches is for the exporters' tests.
TEST_F(CliPatches, AFileOfOneFrameHoldsTheLargestPatchAndTheRestIsNamed) {
  const std::string left_out = "Not in the file: the patch of cell " + std::to_string(fallen_) + " (1 cell)";
  const std::string command = "export arm.calibration.json --to ply";
  const Outcome plain = run(command + " -o arm.ply");
  EXPECT_EQ(plain.exit_code, 0);
  EXPECT_THAT(plain.err, AllOf(HasSubstr(left_out), HasSubstr("--patch CELL")));
  EXPECT_EQ(std::ranges::count(plain.err, '\n'), 2) << "and what the format can't hold: " << plain.err;
  EXPECT_THAT(run(command + " -o -").err, HasSubstr(left_out)) << "on standard output too";
  EXPECT_THAT(run(command + " --quiet -o arm.ply").err, IsEmpty());

  const Outcome json = run(command + " --json -o arm.ply");
  EXPECT_THAT(json.err, Not(HasSubstr("Not in the file")));
  const auto patches = nlohmann::json::parse(json.out).at("left_out");
  ASSERT_EQ(patches.size(), 1U);
  EXPECT_EQ(patches[0].at("origin"), fallen_);
  EXPECT_THAT(patches[0].at("cells").get<std::vector<std::uint32_t>>(), ElementsAre(fallen_));
}

TEST_F(CliPatches, APatchOrAllOfThemAreExportedOnRequest) {
  const std::string fallen = std::to_string(fallen_);
  EXPECT_THAT(exported("ply", "--patch " + fallen), HasSubstr("in the frame of cell " + fallen));
  EXPECT_THAT(exported("vtp", "--all-patches"), HasSubstr("NumberOfPolys=\"" + std::to_string(17 * 8) + "\""));
  EXPECT_EQ(run("export arm.calibration.json --to csv -o tables").err, "") << "all of them, unasked";
  for (const auto& [options, says] :
       {std::pair("ply --patch 999", "no patch holds a cell 999"), std::pair("urdf --all-patches", "one frame"),
        std::pair("vtp --patch 1 --all-patches", "excludes")}) {
    EXPECT_THAT(errorOf("export arm.calibration.json -o nowhere --to " + std::string(options), 2), HasSubstr(says));
  }
  EXPECT_FALSE(exists("nowhere"));
}

TEST_F(CliPatches, APlacedPatchIsInTheFrameOfItsLink) {
  const std::string place = "--place " + std::to_string(fallen_) + "@hand:1,2,3,0,0,1.5707963267948966 ";
  EXPECT_THAT(exported("tf-yaml", place), AllOf(HasSubstr("frame_id: \"hand\""), HasSubstr("{x: 1.0, y: 2.0, z: 3.0}"),
                                                Not(HasSubstr("base_link"))));
  EXPECT_THAT(exported("ply", place + "--in-link hand"), HasSubstr("in the frame of link hand"));
  const Outcome json = run("export arm.calibration.json --to ply " + place + "--in-link hand --json -o hand.ply");
  const auto told = nlohmann::json::parse(json.out);
  EXPECT_EQ(told.at("left_out").at(0).at("cells").size(), 16U);
  EXPECT_EQ(told.at("not_carried").at(0), "A PLY file holds no sensors and no uncertainties.");
  const Outcome note = run("export arm.calibration.json --to tf-ros1 " + place + "-o skin.launch");
  EXPECT_THAT(note.err, AllOf(HasSubstr("not placed on a link"), HasSubstr("--place")));
  for (const std::string wrong :
       {"hand", "hand:1,2,3", "hand:1,2,3,0,0,x", "999@hand:0,0,0,0,0,0", "a b:0,0,0,0,0,0"}) {
    complaint("export arm.calibration.json --to tf-ros1 --place '" + wrong + "' -o wrong.launch", 2);
    EXPECT_FALSE(exists("wrong.launch"));
  }
}

TEST_F(CliPatches, SeveralFormatsAreAFolderWithAManifest) {
  writeFileAtomically(path("robot.urdf"), "<robot name=\"r\">\n  <link name=\"hand\"/>\n</robot>\n");
  const Outcome bundle = run(
      "export arm.calibration.json --to robot-urdf,tf-yaml,icub --robot robot.urdf --place hand:0,0,0.1,0,0,0 -o out");
  EXPECT_EQ(bundle.exit_code, 0) << bundle.err;
  const auto manifest = nlohmann::json::parse(readFile(path("out/manifest.json")));
  EXPECT_EQ(manifest.at("files").size(), 3U);
  std::vector<std::string> roles;
  for (const auto& input : manifest.at("inputs")) roles.push_back(input.at("role"));
  EXPECT_THAT(roles, ElementsAre("calibration", "robot", "source"));
  EXPECT_EQ(manifest.at("inputs").at(0).at("sha256"), sha256Hex(readFile(path("arm.calibration.json"))));
  EXPECT_EQ(run("export arm.calibration.json --to urdf,ply -o -").exit_code, 2);
  EXPECT_EQ(run("export arm.calibration.json --to urdf,nothing -o out").exit_code, 2);
  EXPECT_THAT(errorOf("export arm.calibration.json --to robot-urdf -o r.urdf", 2),
              HasSubstr("--to robot-urdf: expected --robot FILE too"));
}

TEST_F(CliPatches, LinksAreThoseOfTheRobotWhereverItIsGiven) {
  writeFileAtomically(path("robot.urdf"), "<robot name=\"r\">\n  <link name=\"forearm\"/>\n</robot>\n");
  const std::string command = "export arm.calibration.json --robot robot.urdf -o out.file --to ";
  for (const std::string format : {"tf-yaml", "robot-urdf", "ply"}) {
    EXPECT_THAT(errorOf(command + format + " --place forarm:0,0,0,0,0,0", 2),
                HasSubstr("the place of a patch: robot.urdf: the robot has no link forarm; did you mean forearm?"));
  }
  EXPECT_THAT(run(command + "tf-yaml").err, HasSubstr("--parent: robot.urdf: the robot has no link base_link"));
  EXPECT_EQ(run(command + "ply").exit_code, 0) << "it has no link";
  EXPECT_EQ(run(command + "tf-yaml --place forearm:0,0,0,0,0,0").exit_code, 0);
  EXPECT_THAT(errorOf("export arm.calibration.json --robot none.urdf -o out.file --to tf-yaml", 3),
              HasSubstr("--robot none.urdf: cannot be read"));
}

TEST_F(CliPatches, ARobotThatHasTheSkinAlreadyIsBadInputAndAJoinWithoutAPlaceIsSaid) {
  writeFileAtomically(path("robot.urdf"), "<robot name=\"r\">\n  <link name=\"base_link\"/>\n</robot>\n");
  EXPECT_THAT(errorOf("export arm.calibration.json --to robot-urdf --robot robot.urdf -o once.urdf", 0),
              HasSubstr("it is joined to base_link without any offset. --place LINK:"));
  const std::string place = " --place base_link:0,0,0,0,0,0 ";
  EXPECT_THAT(run("export arm.calibration.json --to robot-urdf --robot robot.urdf -o placed.urdf" + place).err,
              Not(HasSubstr("without any offset")));
  EXPECT_THAT(errorOf("export arm.calibration.json --to robot-urdf --robot once.urdf -o twice.urdf" + place, 3),
              HasSubstr("--robot once.urdf: already has a link skin_patch"));
  EXPECT_FALSE(exists("twice.urdf"));
}

TEST_F(CliPatches, EvaluateGivesMetricsOfEachPatchByItselfAndNoneBetweenThem) {
  EXPECT_THAT(
      outputOf("evaluate arm.calibration.json --fit cylinder --against arm.session.json"),
      AllOf(HasSubstr("How the patches lie to each other is not known"), HasSubstr("cylinder through 16 cell centres"),
            HasSubstr("points are needed"), HasSubstr("cell " + std::to_string(fallen_) + " alone")));
  const auto json = nlohmann::json::parse(run("evaluate arm.calibration.json --fit cylinder --json").out);
  ASSERT_EQ(json.at("fits").size(), 2U);
  const auto fitted = [](const nlohmann::json& fit) { return fit.contains("radius_mm"); };
  EXPECT_EQ(std::ranges::count_if(json.at("fits"), fitted), 1);
  EXPECT_TRUE(std::ranges::any_of(json.at("fits"), [](const auto& fit) { return fit.contains("why_not"); }));
  EXPECT_THAT(errorOf("evaluate arm.calibration.json --loop " + std::to_string(fallen_) + ":1," + free_end_, 2),
              HasSubstr("lie in different patches"));
}

}  // namespace
}  // namespace hexoderm
