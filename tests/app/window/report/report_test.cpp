#include "app/window/report/report.h"
#include "app/window/report/report_page.h"
#include "app/window/report/report_pdf.h"
#include "app/window/report/report_title.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/file.h"
#include "tests/app/window/window_test.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/temporary_folder.h"
#include "widgets/verify/verify_words.h"
#include "widgets/words/words.h"

#include <map>

namespace hexoderm {
namespace {

ReportContent contentOf(const Reconstruction& result) {
  ReportContent content;
  content.reconstruction = std::make_shared<const Reconstruction>(result);
  content.name = "arm <b>left</b> & hand.hexo";
  content.graph = {"Skin graph", QSize(40, 30), [](QPainter& painter) { painter.fillRect(0, 0, 40, 30, Qt::blue); }};
  content.made_at = QDateTime(QDate(2026, 3, 4), QTime(5, 6, 7));
  return content;
}

Reconstruction awkwardResult() {
  Reconstruction result = makeTestReconstruction();
  result.patches[0].lot = {{0.03, -0.0101, 0}, {0.001, 0.002, 0.001}, 1.01, 0.004};
  result.poses[0].label = Message::verbatim("<script>alert('pose')</script>");
  result.source.text = Message::verbatim("<img src=x onerror=alert(1)>");
  result.source.sha256 = std::string(64, 'a');
  result.findings = {makeFinding(FindingCode::BodyPartBoundary,
                                 Message::verbatim("The part <script> & \"hand\" ends here."), {CellId(3)}),
                     makeFinding(FindingCode::NoPoses,
                                 message("There is no pose yet: the shape shown follows from the ports alone."))};
  result.assessment.level = VerdictLevel::Usable;
  result.assessment.reason =
      message("Usable: {}, {}.",
              message("{} (95 %, worst: {})", message("±{}, ±{}", Millimetres{1.2e-3}, Degrees{0.4 * kDegree}),
                      cellsText({CellId(3)})),
              message("{} poses", 3));
  result.assessment.next_action = message("Look at the findings, then export.");
  result.assessment.position_95_m = 0.0012;
  result.assessment.orientation_95_rad = 0.007;
  return result;
}

/// A bent X of 17 cells whose uncertainty grows outwards.
Reconstruction withUncertainty() {
  Reconstruction result = demoReconstruction();
  result.assessment = awkwardResult().assessment;
  for (PatchReconstruction& patch : result.patches) {
    for (CellPlacement& cell : patch.cells) {
      const double sigma_m = 1e-4 * static_cast<double>(patch.pathTo(cell.cell).size());
      cell.cov_t_r = Matrix6d(Matrix6d::Identity() * sigma_m * sigma_m);
      cell.shape_cov_t_r = *cell.cov_t_r;
    }
  }
  return result;
}

/// The text of every element, as a browser would show it.
QString textOf(const QString& html) {
  QString text;
  QXmlStreamReader xml(html);
  while (!xml.atEnd()) {
    xml.readNext();
    if (xml.isCharacters()) text += xml.text().toString();
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString() << " in line " << xml.lineNumber();
  return text;
}

TEST(Report, IsWellFormedAndSaysAllThatMatters) {
  const Reconstruction result = awkwardResult();
  const QString html = reportHtml(contentOf(result));
  const QString text = textOf(html);
  for (const Finding& finding : result.findings) {
    EXPECT_TRUE(text.contains(QString::fromStdString(finding.message.english()))) << finding.message.english();
  }
  EXPECT_THAT(text, HasTexts({"arm <b>left</b> & hand.hexo", "Look at the findings, then export.",
                              "<script>alert('pose')</script>", "<img src=x onerror=alert(1)>", "aaaaaaaaaaaaaaaa",
                              "Hexoderm " HEXODERM_VERSION, "2026-03-04T05:06:07", "3:2 – 7:3", "hex-bma150",
                              "offset 30.0, −10.1, 0.0 ± 2.0 mg, scale 1.010 ± 0.004 (1 sigma)",
                              "With a probability of 95 %, each measured cell is at most 1.2 mm"}));
  EXPECT_EQ(text.count("Usable: ±1.2 mm"), 1) << "the verdict is said once";
  // Nothing from files becomes markup.
  EXPECT_FALSE(html.contains("<script"));
  EXPECT_FALSE(html.contains("<b>left"));
  EXPECT_FALSE(html.contains("onerror=alert(1)>"));
}

/// The pictures in a page, by their captions.
std::map<QString, QByteArray> picturesIn(const QString& html) {
  std::map<QString, QByteArray> pictures;
  const QRegularExpression figure(
      "<figure><img src=\"data:image/[a-z+]+;base64,([^\"]+)\" alt=\"[^\"]*\"/><figcaption>([^<]*)</figcaption>");
  for (auto found = figure.globalMatch(html); found.hasNext();) {
    const QRegularExpressionMatch match = found.next();
    pictures[match.captured(2)] = QByteArray::fromBase64(match.captured(1).toLatin1());
  }
  return pictures;
}

TEST(Report, ShowsThePatchFromFourSidesWithScaleBarsAndIds) {
  const QString html = reportHtml(contentOf(withUncertainty()));
  const auto pictures = picturesIn(html);
  EXPECT_TRUE(pictures.count("Skin graph"));
  EXPECT_EQ(html.count("<figcaption>"), html.count("<img "));
  std::set<QByteArray> different;
  QString ids;
  for (const char* side : {"Front", "Right side", "Back", "Left side"}) {
    ASSERT_TRUE(pictures.count(QLatin1String(side))) << side;
    const QByteArray& svg = pictures.at(QLatin1String(side));
    EXPECT_TRUE(svg.contains("<svg")) << side;
    EXPECT_TRUE(svg.contains(" mm</text>")) << side << " has no scale bar";
    ids += QString::fromUtf8(svg);
    different.insert(svg);
  }
  EXPECT_EQ(different.size(), 4U);
  for (int id = 1; id <= 17; ++id) {
    EXPECT_TRUE(ids.contains(QStringLiteral(">%1</text>").arg(id))) << "no side shows cell " << id;
  }
}

TEST(Report, PicturesHaveTheColoursOfTheUncertaintyOfTheShape) {
  Reconstruction result = withUncertainty();
  const auto before = picturesIn(reportHtml(contentOf(result)));
  *result.patches[0].cells[5].shape_cov_t_r *= 4;
  const QString html = reportHtml(contentOf(result));
  EXPECT_TRUE(
      textOf(html).contains(QStringLiteral("Thick outline: cell %1,").arg(result.patches[0].cells[5].cell.value())))
      << "the cell that is known least well";
  const auto after = picturesIn(html);
  EXPECT_NE(before.at("Front"), after.at("Front"));
  // What the shape does not depend on leaves them as they are.
  *result.patches[0].cells[5].cov_t_r *= 4;
  EXPECT_EQ(picturesIn(reportHtml(contentOf(result))).at("Front"), after.at("Front"));
}

TEST(Report, BeginsWithWhatTheOperatorSaid) {
  ReportContent content = contentOf(awkwardResult());
  content.title = {"Toro <3>", "left forearm", "A. Meier", "Mould renewed.\nWarm."};
  const QString text = textOf(reportHtml(content));
  EXPECT_THAT(text.section("Usable: ±1.2 mm", 0, 0),
              HasTexts({"Toro <3>", "left forearm", "A. Meier", "Mould renewed."}));
  content.title = {};
  EXPECT_FALSE(textOf(reportHtml(content)).contains("Operator")) << "empty fields are left out";
}

TEST(Report, SaysWhatWasVerifiedAndWhatWasNot) {
  ReportContent content = contentOf(withUncertainty());
  EXPECT_TRUE(textOf(reportHtml(content)).contains("Not made for this report: a pose that was held out"));
  content.verify.loops = std::vector<FoundLoop>();
  content.verify.surfaces = {checkSurface(content.reconstruction->patches[0], std::nullopt)};
  const QString text = textOf(reportHtml(content));
  EXPECT_TRUE(text.contains(loopsText({}, 1).text));
  EXPECT_TRUE(text.contains(surfaceText(content.verify.surfaces->front(), 0.0012).text));
  EXPECT_FALSE(text.contains("Not made for this report: a pose that was held out, closed loops"));
}

TEST(Report, SaysWhereAPatchIsOnTheRobot) {
  Reconstruction result = withUncertainty();
  EXPECT_FALSE(textOf(reportHtml(contentOf(result))).contains("Place on the robot"));
  PatchPlacement placement;
  placement.origin = result.patches[0].origin;
  placement.link = "forearm <link>";
  placement.place = PatchOnLink{placement.origin, placement.link, SE3(), std::nullopt};
  placement.place->T_l_o.t = {0.012, -0.0345, 0.1};
  result.placements = {placement};
  EXPECT_THAT(textOf(reportHtml(contentOf(result))),
              HasTexts({"Place on the robot", "forearm <link>", "12.0", "−34.5", "100.0"}));
}

/// The number of pages that a PDF says it has.
int pagesOf(const QByteArray& pdf) {
  const int count = pdf.indexOf("/Count ");
  return count < 0 ? 0 : QString::fromLatin1(pdf.mid(count + 7, 6)).section(QRegularExpression("\\D"), 0, 0).toInt();
}

/// What is drawn on each page, from the layout itself.
std::vector<QString> pagesText(const ReportContent& content) {
  std::vector<QString> pages;
  for (const auto& page : pdfTexts(ReportPage(content).document())) pages.push_back(page.join(QLatin1Char('\n')));
  return pages;
}

TEST(Report, NumbersItsPagesAndSaysOnEachWhetherItIsOfASimulation) {
  Reconstruction result = withUncertainty();
  for (int k = 0; k < 150; ++k) result.findings.push_back(awkwardResult().findings.front());
  ReportContent content = contentOf(result);
  for (const bool simulated : {true, false}) {
    content.simulated = simulated;
    const std::vector<QString> pages = pagesText(content);
    ASSERT_GE(pages.size(), 4U);
    EXPECT_EQ(static_cast<int>(pages.size()), pagesOf(reportPdf(content)));
    for (std::size_t k = 0; k < pages.size(); ++k) {
      EXPECT_EQ(pages[k].contains("SIMULATED"), simulated) << k;
      EXPECT_TRUE(pages[k].contains(QStringLiteral("Page %1 of %2").arg(k + 1).arg(pages.size()))) << k;
    }
    EXPECT_EQ(textOf(reportHtml(content)).contains("SIMULATED"), simulated);
  }
}

TEST(Report, BreaksItsTablesWell) {
  // Whatever stands above it, no row is alone at either end of a page, and every page has the head of its table.
  for (int findings = 90; findings < 130; ++findings) {
    Reconstruction result = awkwardResult();
    result.findings.clear();
    for (int k = 0; k < findings; ++k) {
      result.findings.push_back(makeFinding(FindingCode::NoPoses, message("Finding number {}.", k)));
    }
    ReportContent content = contentOf(result);
    content.graph.reset();
    int seen = 0;
    for (const QString& page : pagesText(content)) {
      const int rows = page.count("Finding number ");
      seen += rows;
      EXPECT_NE(rows, 1) << "a row is alone, with " << findings << " findings";
      EXPECT_EQ(page.count("Severity"), rows > 0 ? 1 : 0) << page.toStdString();
    }
    EXPECT_EQ(seen, findings);
  }
}

TEST(Report, OfASkinWithoutAnythingIsStillOneAndThatOfALargeOneSaysHowManyCellsAreMissing) {
  ReportContent content = contentOf(test::ResultBuilder().build());
  content.graph.reset();
  EXPECT_FALSE(textOf(reportHtml(content)).isEmpty());
  EXPECT_TRUE(reportPdf(content).startsWith("%PDF"));

  Reconstruction result = awkwardResult();
  const CellPlacement cell = result.patches[0].cells[0];
  while (result.patches[0].cells.size() < 1000) result.patches[0].cells.push_back(cell);
  EXPECT_THAT(textOf(reportHtml(contentOf(result))), HasText("901 more cells"));
}

TEST(Report, IsWrittenWholeOrNotAtAll) {
  const test::TemporaryFolder folder;
  const ReportContent content = contentOf(awkwardResult());
  const auto write = [&](const char* name) {
    writeReport(content, QString::fromStdString((folder.path() / name).string()));
  };
  write("report.html");
  EXPECT_EQ(readFile(folder.path() / "report.html"), reportHtml(content).toStdString());
  EXPECT_EQ(folder.entryCount(), 1U);
  EXPECT_THROW(write("report.txt"), InvalidArgument);
  // Also root can't write into what is no folder.
  EXPECT_THROW(write("report.html/report.pdf"), StorageError);
  std::filesystem::create_directory(folder.path() / "taken.pdf");
  EXPECT_THROW(write("taken.pdf"), StorageError);
  EXPECT_EQ(folder.entryCount(), 2U);
}

class ReportWindow : public WindowTest {};

TEST_F(ReportWindow, IsWrittenFromTheMenuAndAsksOnceForItsTitle) {
  EXPECT_FALSE(action("actionReport")->isEnabled());
  takeDemoPoses(3);
  ASSERT_TRUE(action("actionReport")->isEnabled());
  press(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
  auto* form = waitForDialog("reportTitleDialog");
  EXPECT_FALSE(form->isModal());
  // By the keyboard alone, from field to field.
  form->activateWindow();
  ASSERT_TRUE(waitUntil([&] { return QApplication::focusWidget() == form->findChild<QLineEdit*>("reportRobot"); }));
  QTest::keyClicks(QApplication::focusWidget(), "Toro 3");
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  QTest::keyClicks(QApplication::focusWidget(), "forearm");
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  typeIntoFileDialog("saveDialog", pathTo("demo.html"));
  ASSERT_TRUE(waitForMessage("demo.html"));
  // It is remembered, and can be changed.
  for (const bool again : {false, true}) {
    action("actionReportTitle")->trigger();
    form = waitForDialog("reportTitleDialog");
    EXPECT_EQ(form->findChild<QLineEdit*>("reportRobot")->text(), "Toro 3");
    if (again) {
      EXPECT_EQ(form->findChild<QLineEdit*>("reportOperator")->text(), "A. Meier");
    }
    form->findChild<QLineEdit*>("reportOperator")->setText("A. Meier");
    click(form->findChild<QPushButton*>("reportTitleButton"));
    ASSERT_TRUE(waitUntilGone("reportTitleDialog"));
  }
  const QString html = QString::fromStdString(readFile(pathTo("demo.html").toStdString()));
  EXPECT_GE(html.count("<figure>"), 6);
  EXPECT_THAT(textOf(html),
              HasTexts({"Toro 3", "forearm", "SIMULATED", words(controller().reconstruction()->assessment.reason)}));
}

TEST(ReportTitleKept, IsThatOfItsSession) {
  const ReportTitle first{"Toro", "arm", "A", "n"};
  EXPECT_FALSE(keptReportTitle("/a/first.hexo").has_value());
  keepReportTitle("/a/first.hexo", first);
  EXPECT_EQ(keptReportTitle("/a/first.hexo"), first);
  EXPECT_FALSE(keptReportTitle("/a/second.hexo").has_value());
  EXPECT_EQ(proposedReportTitle().robot, "Toro");
  EXPECT_TRUE(proposedReportTitle().notes.isEmpty()) << "notes are about one session";
  for (int k = 0; k < 250; ++k) keepReportTitle(QStringLiteral("/b/%1.hexo").arg(k), {});
  EXPECT_FALSE(keptReportTitle("/a/first.hexo").has_value()) << "settings don't grow for ever";
  EXPECT_TRUE(keptReportTitle("/b/249.hexo").has_value());
}

}  // namespace
}  // namespace hexoderm
