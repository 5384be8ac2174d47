// The quick readers of sessions and calibrations beside the thorough ones: what they take is the same to the last bit,
// and they take what we write.

#include "tests/support/both_readers.h"
#include "hexoderm/device/simulation/simulated_skin.h"
#include "hexoderm/session/simulated_session.h"
#include "hexoderm/util/file.h"
#include "tests/fuzz/mutations.h"
#include "tests/support/json_mutations.h"
#include "tests/support/paths.h"
#include "tests/support/random_session.h"
#include "tests/support/rich_calibration.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <random>

namespace hexoderm {
namespace {

using test::readCalibrationBothWays;
using test::readSessionBothWays;
using test::TakenBy;

const std::filesystem::path kData = HEXODERM_TEST_DATA;

std::string threeCellsText() { return readFile(kData / "three_cells.session.json"); }
std::string everythingText() { return sessionToJson(test::sessionWithEverything()); }
std::string richText() { return calibrationToJson(test::richCalibration()); }

/// Which readers took the texts of a folder.
template <class Read>
std::map<TakenBy, int> readFolder(const std::filesystem::path& folder, Read read) {
  std::map<TakenBy, int> taken;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".md") continue;
    SCOPED_TRACE(entry.path().filename().string());
    ++taken[read(readFile(entry.path()))];
  }
  return taken;
}

/// The same for changed texts.
template <class Read>
std::map<TakenBy, int> readMutations(const std::vector<std::string>& texts, int count, Read read) {
  std::mt19937_64 random(1);
  std::map<TakenBy, int> taken;
  for (int k = 0; k < count && !testing::Test::HasFailure(); ++k) {
    ++taken[read(fuzz::mutated(texts[static_cast<std::size_t>(k) % texts.size()], random))];
  }
  return taken;
}

TEST(BothSessionReaders, TakeWhatIsWritten) {
  EXPECT_EQ(readSessionBothWays(threeCellsText()), TakenBy::Both);
  EXPECT_EQ(readSessionBothWays(everythingText()), TakenBy::Both);
  EXPECT_EQ(readSessionBothWays(sessionToJson(Session(builtInCellModel("hex-bma150"), {}))), TakenBy::Both);
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    EXPECT_EQ(readSessionBothWays(sessionToJson(test::RandomSession(seed).draw())), TakenBy::Both);
  }
}

TEST(BothSessionReaders, TakeTheSameFromDenseAndReorderedFiles) {
  const nlohmann::json sorted = nlohmann::json::parse(everythingText());
  EXPECT_EQ(readSessionBothWays(sorted.dump()), TakenBy::Both);
  EXPECT_EQ(readSessionBothWays(sorted.dump(7, '\t')), TakenBy::Both);
}

TEST(BothSessionReaders, LeaveWhatIsUnusualToTheThoroughOne) {
  const auto with = [](const char* pointer, const nlohmann::json& value) {
    nlohmann::json json = nlohmann::json::parse(everythingText());
    json[nlohmann::json::json_pointer(pointer)] = value;
    return readSessionBothWays(json.dump());
  };
  EXPECT_EQ(with("/note", "a key that nobody knows"), TakenBy::Both);
  EXPECT_EQ(with("/poses/0/note", {{"a", {1, 2}}}), TakenBy::Both);
  EXPECT_EQ(with("/poses/0/samples/0/note", 1), TakenBy::Thorough);
  EXPECT_EQ(with("/cells/0/note", 1), TakenBy::Thorough);
  EXPECT_EQ(with("/truth", nullptr), TakenBy::Thorough);
  EXPECT_EQ(with("/poses/0/samples/0/count", nullptr), TakenBy::Thorough);
  EXPECT_EQ(with("/poses/0/samples/0/count", -1), TakenBy::Nobody);
  EXPECT_EQ(readSessionBothWays("\xEF\xBB\xBF" + everythingText()), TakenBy::Thorough);
}

TEST(BothSessionReaders, AgreeAboutTheCorpus) {
  std::map<TakenBy, int> taken = readFolder(kData.parent_path() / "fuzz/corpus/session_json", readSessionBothWays);
  EXPECT_GE(taken[TakenBy::Both], 2);
  EXPECT_GE(taken[TakenBy::Nobody], 4);
}

TEST(BothSessionReaders, AgreeAboutAnyValueInAnyPlace) {
  std::map<TakenBy, int> taken;
  for (const std::string& text : {threeCellsText(), everythingText()}) {
    test::forEachMutation(nlohmann::json::parse(text), [&](const std::string& changed, const std::string& what) {
      SCOPED_TRACE(what);
      ++taken[readSessionBothWays(changed)];
    });
  }
  EXPECT_GT(taken[TakenBy::Both], 100);
  EXPECT_GT(taken[TakenBy::Thorough], 10);
  EXPECT_GT(taken[TakenBy::Nobody], 500);
}

TEST(BothSessionReaders, TakeSessionsOfASecondProgram) {
  EXPECT_EQ(readFolder(kData / "vectors", readSessionBothWays), (std::map<TakenBy, int>{{TakenBy::Both, 5}}));
}

TEST(BothSessionReaders, AgreeAboutChangedTexts) {
  std::map<TakenBy, int> taken = readMutations({threeCellsText(), everythingText()}, 4000, readSessionBothWays);
  EXPECT_GT(taken[TakenBy::Both], 100);
  EXPECT_GT(taken[TakenBy::Nobody], 1000);
}

TEST(BothCalibrationReaders, TakeWhatIsWritten) {
  EXPECT_EQ(readCalibrationBothWays(richText()), TakenBy::Both);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const Session session = test::RandomSession(seed).draw();
    SolverOptions options;
    options.solver = seed % 2 == 0 ? Solver::Tree : Solver::Global;
    EXPECT_EQ(readCalibrationBothWays(calibrationToJson(*reconstruct(*session.snapshot(), options))), TakenBy::Both);
  }
}

TEST(BothCalibrationReaders, TakeTheSameFromDenseAndReorderedFiles) {
  const nlohmann::json sorted = nlohmann::json::parse(richText());
  EXPECT_EQ(readCalibrationBothWays(sorted.dump()), TakenBy::Both);
  EXPECT_EQ(readCalibrationBothWays(sorted.dump(3)), TakenBy::Both);
}

TEST(BothCalibrationReaders, AgreeAboutTheCorpus) {
  std::map<TakenBy, int> taken =
      readFolder(kData.parent_path() / "fuzz/corpus/calibration_json", readCalibrationBothWays);
  EXPECT_GE(taken[TakenBy::Thorough] + taken[TakenBy::Both], 1);
  EXPECT_GE(taken[TakenBy::Nobody], 1);
}

TEST(BothCalibrationReaders, AgreeAboutAnyValueInAnyPlace) {
  std::map<TakenBy, int> taken;
  test::forEachMutation(nlohmann::json::parse(richText()), [&](const std::string& changed, const std::string& what) {
    SCOPED_TRACE(what);
    ++taken[readCalibrationBothWays(changed)];
  });
  EXPECT_GT(taken[TakenBy::Both], 100);
  EXPECT_GT(taken[TakenBy::Thorough], 10);
  EXPECT_GT(taken[TakenBy::Nobody], 500);
}

TEST(BothCalibrationReaders, AgreeAboutChangedTexts) {
  std::map<TakenBy, int> taken = readMutations({richText()}, 3000, readCalibrationBothWays);
  EXPECT_GT(taken[TakenBy::Both], 50);
  EXPECT_GT(taken[TakenBy::Nobody], 500);
}

}  // namespace
}  // namespace hexoderm
