#include "widgets/words/words.h"
#include "app/window/settings/translation.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/units.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/sim/simulated_session.h"
#include "hexoderm/sim/simulated_skin.h"
#include "hexoderm/solve/reconstructor.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <stdexcept>

namespace hexoderm {
namespace {

class Words : public testing::Test {
 protected:
  void SetUp() override { useLanguage("de"); }
  void TearDown() override { useLanguage("en"); }
  static void useLanguage(const char* language) { installTranslations(*qApp, language); }
};

TEST_F(Words, SayEveryKindOfArgumentInBothLanguages) {
  const struct {
    Message said;
    const char* german;
  } cases[] = {
      {message("Cell {} was left out; it is placed through its links.", CellId(100000)),
       "Zelle 100000 wurde weggelassen; sie wird über ihre Verbindungen verortet."},
      {message("±{}, ±{}", Millimetres{0.0012}, Degrees{0.4 * kDegree}), "±1,2 mm und ±0,4°"},
      {message("Cell {} is silent: nothing came from it for {}", CellId(4), Seconds{1.5}),
       "Zelle 4 ist stumm: Seit 1,5 s kam nichts von ihr"},
      {message("Cell {} is noisy: it scatters by {} rms while the rest is still", CellId(4), MilliG{0.22}),
       "Zelle 4 rauscht: Sie streut um 220 mg (Effektivwert), während der Rest ruht"},
      {message("a number from {} to {}", Number{-1.5}, Number{2, 1}), "eine Zahl von -1,5 bis 2,0"},
      {message("in poses {}", std::vector{PoseId(1), PoseId(2), PoseId(5)}), "in den Posen 1, 2 und 5"},
      {message("The {} joins {} and {}; the patch ends there.", message("link {} port {} - {} port {}", 1, 2, 3, 4),
               "hand", "arm.x"),
       "Die Verbindung 1 Port 2 – 3 Port 4 verbindet hand und arm.x; dort endet das Hautstück."},
      {inRow({message("{} cells", 17), message("{} links", 16), message("1 patch")}, ", "),
       "17 Zellen, 16 Verbindungen, 1 Hautstück"},
      {located("a.json", message("is missing")), "a.json: fehlt"},
      {Message::verbatim("1.5 cells {}"), "1.5 cells {}"},
      {Message(), ""},
  };
  for (const auto& [said, german] : cases) {
    EXPECT_EQ(words(said), QString::fromUtf8(german));
    useLanguage("en");
    EXPECT_EQ(words(said), QString::fromStdString(said.english()));
    useLanguage("de");
  }
}

TEST_F(Words, StayEnglishWithoutATranslation) { EXPECT_EQ(words(Message("Cell {} sings.", {3})), "Cell 3 sings."); }

TEST_F(Words, OfAnErrorAreItsMessageAndOfOthersTheirText) {
  EXPECT_EQ(words(FormatError(located("a.json", message("is missing")))), "a.json: fehlt");
  EXPECT_EQ(words(std::runtime_error("is missing")), "is missing");
}

TEST_F(Words, OfACalibrationThatWasReadBackAreGerman) {
  SimulatedSkin skin(builtInCellModel("hex-bma150"), {});
  const auto result = reconstruct(*simulateSession(skin, 2).snapshot());
  const auto back = parseCalibrationJson(calibrationToJson(*result), "a.calibration.json");
  EXPECT_NE(words(back->assessment.reason), QString::fromStdString(back->assessment.reason.english()));
  EXPECT_EQ(words(back->assessment.reason), words(result->assessment.reason));
  EXPECT_EQ(words(back->assessment.next_action), words(result->assessment.next_action));
  EXPECT_EQ(words(back->source.text), words(result->source.text));
}

}  // namespace
}  // namespace hexoderm
