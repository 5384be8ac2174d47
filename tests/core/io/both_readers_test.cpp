// The quick readers of sessions and calibrations beside the thorough ones: what they take is the same to the last bit,
// and they take what we write.

#include "tests/support/both_readers.h"
#include "hexoderm/base/file.h"
#include "hexoderm/sim/simulated_session.h"
#include "hexoderm/sim/simulated_skin.h"
#include "tests/fuzz/mutations.h"
#include "tests/support/json_mutations.h"
#include "tests/support/paths.h"
#include "tests/support/random_session.h"
#include "tests/support/rich_calibration.h"
#include "tests/support/solvers.h"
#include "tests/support/testing.h"

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

TEST(BothSessionReaders, TakeWhatIsWritten) {
  EXPECT_EQ(readSessionBothWays(threeCellsText()), TakenBy::Both);
  EXPECT_EQ(readSessionBothWays(everythingText()), TakenBy::Both);
  EXPECT_EQ(readSessionBothWays(sessionToJson(Session(builtInCellModel("hex-bma150"), {}))), TakenBy::Both);
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    EXPECT_EQ(readSessionBothWays(sessionToJson(test::RandomSession(seed).draw())), TakenBy::Both);
  }
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

TEST(BothSessionReaders, TakeSessionsOfASecondProgram) {
  EXPECT_EQ(readFolder(kData / "vectors", readSessionBothWays), (std::map<TakenBy, int>{{TakenBy::Both, 5}}));
}

TEST(BothCalibrationReaders, TakeWhatIsWritten) {
  EXPECT_EQ(readCalibrationBothWays(richText()), TakenBy::Both);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const Session session = test::RandomSession(seed).draw();
    const auto result = reconstruct(*session.snapshot(), test::by(seed % 2 == 0 ? Solver::Tree : Solver::Global));
    EXPECT_EQ(readCalibrationBothWays(calibrationToJson(*result)), TakenBy::Both);
  }
}

/// A format with two readers.
struct Format {
  const char* name;
  TakenBy (*read)(const std::string& text);
  std::vector<std::string> (*texts)();
  int changed_texts;
  int refused_in_corpus;  ///< at least
};

class BothReaders : public testing::TestWithParam<Format> {};
INSTANTIATE_TEST_SUITE_P(Formats, BothReaders,
                         testing::Values(Format{"session_json", readSessionBothWays,
                                                [] {
                                                  return std::vector{threeCellsText(), everythingText()};
                                                },
                                                4000, 4},
                                         Format{"calibration_json", readCalibrationBothWays,
                                                [] { return std::vector{richText()}; }, 3000, 1}),
                         [](const auto& format) { return std::string(format.param.name); });

TEST_P(BothReaders, TakeTheSameFromDenseAndReorderedFiles) {
  const nlohmann::json sorted = nlohmann::json::parse(GetParam().texts().back());
  EXPECT_EQ(GetParam().read(sorted.dump()), TakenBy::Both);
  EXPECT_EQ(GetParam().read(sorted.dump(7, '\t')), TakenBy::Both);
}

TEST_P(BothReaders, AgreeAboutTheCorpus) {
  std::map<TakenBy, int> taken = readFolder(kData.parent_path() / "fuzz/corpus" / GetParam().name, GetParam().read);
  EXPECT_GE(taken[TakenBy::Thorough] + taken[TakenBy::Both], 1);
  EXPECT_GE(taken[TakenBy::Nobody], GetParam().refused_in_corpus);
}

TEST_P(BothReaders, AgreeAboutAnyValueInAnyPlace) {
  std::map<TakenBy, int> taken;
  for (const std::string& text : GetParam().texts()) {
    test::forEachMutation(nlohmann::json::parse(text), [&](const std::string& changed, const std::string& what) {
      SCOPED_TRACE(what);
      ++taken[GetParam().read(changed)];
    });
  }
  EXPECT_GT(taken[TakenBy::Both], 100);
  EXPECT_GT(taken[TakenBy::Thorough], 10);
  EXPECT_GT(taken[TakenBy::Nobody], 500);
}

TEST_P(BothReaders, AgreeAboutChangedTexts) {
  const std::vector<std::string> texts = GetParam().texts();
  std::mt19937_64 random(1);
  std::map<TakenBy, int> taken;
  for (int k = 0; k < GetParam().changed_texts && !HasFailure(); ++k) {
    ++taken[GetParam().read(fuzz::mutated(texts[static_cast<std::size_t>(k) % texts.size()], random))];
  }
  EXPECT_GT(taken[TakenBy::Both], 50);
  EXPECT_GT(taken[TakenBy::Nobody], 500);
}

}  // namespace
}  // namespace hexoderm
