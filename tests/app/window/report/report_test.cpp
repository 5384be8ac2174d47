#include "app/window/report/report.h"
#include "app/window/report/report_pictures.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/units.h"
#include "tests/app/window/window_test.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/temporary_folder.h"
#include "widgets/words/words.h"

#include <QPainter>
#include <QRegularExpression>
#include <QTextDocument>
#include <QXmlStreamReader>
#include <filesystem>
#include <fstream>

namespace hexoderm {
namespace {

ReportContent contentOf(const Reconstruction& result) {
  ReportContent content;
  content.reconstruction = std::make_shared<const Reconstruction>(result);
  content.name = QStringLiteral("arm <b>left</b> & hand.hexo");
  QImage image(40, 30, QImage::Format_RGB32);
  image.fill(Qt::blue);
  content.pictures = {{QStringLiteral("Patch, front"), image}, {QStringLiteral("nothing"), QImage()}};
  content.made_at = QDateTime(QDate(2026, 3, 4), QTime(5, 6, 7));
  return content;
}

Reconstruction awkwardResult() {
  Reconstruction result = makeTestReconstruction();
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
                      cellsInWords({CellId(3)})),
              message("{} poses", 3));
  result.assessment.next_action = message("Look at the findings, then export.");
  result.assessment.position_95_m = 0.0012;
  result.assessment.orientation_95_rad = 0.007;
  return result;
}

std::string readAll(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
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
  const QString text = textOf(reportHtml(contentOf(result)));
  for (const Finding& finding : result.findings) {
    EXPECT_TRUE(text.contains(QString::fromStdString(finding.message.english()))) << finding.message.english();
  }
  for (const char* part : {"arm <b>left</b> & hand.hexo", "Usable: ±1.2 mm", "Look at the findings, then export.",
                           "<script>alert('pose')</script>", "<img src=x onerror=alert(1)>", "aaaaaaaaaaaaaaaa",
                           "Hexoderm " HEXODERM_VERSION, "2026-03-04T05:06:07", "3:2 – 7:3", "hex-bma150"}) {
    EXPECT_TRUE(text.contains(QString::fromUtf8(part))) << part;
  }
}

TEST(Report, LetsNothingFromFilesBecomeMarkup) {
  const QString html = reportHtml(contentOf(awkwardResult()));
  EXPECT_FALSE(html.contains(QStringLiteral("<script")));
  EXPECT_FALSE(html.contains(QStringLiteral("<b>left")));
  EXPECT_FALSE(html.contains(QStringLiteral("onerror=alert(1)>")));
}

TEST(Report, CarriesItsPicturesAndLeavesOutThoseThatAreNone) {
  const QString html = reportHtml(contentOf(awkwardResult()));
  EXPECT_EQ(html.count(QStringLiteral("<img ")), 1);
  const QRegularExpressionMatch match =
      QRegularExpression(QStringLiteral("src=\"data:image/png;base64,([^\"]+)\"")).match(html);
  ASSERT_TRUE(match.hasMatch());
  const QImage image = QImage::fromData(QByteArray::fromBase64(match.captured(1).toLatin1()));
  EXPECT_EQ(image.size(), QSize(40, 30));
  EXPECT_EQ(image.pixelColor(5, 5), QColor(Qt::blue));
}

TEST(Report, IsAPdfOfSeveralPages) {
  Reconstruction result = awkwardResult();
  for (int k = 0; k < 60; ++k) result.findings.push_back(result.findings.front());
  const QByteArray pdf = reportPdf(contentOf(result));
  EXPECT_TRUE(pdf.startsWith("%PDF"));
  const int count = pdf.indexOf("/Count ");
  ASSERT_GE(count, 0);
  EXPECT_GE(QString::fromLatin1(pdf.mid(count + 7, 4)).trimmed().section(QLatin1Char('\n'), 0, 0).toInt(), 2);
}

TEST(Report, OfASkinWithoutAnythingIsStillAReport) {
  ReportContent content = contentOf(test::ResultBuilder().build());
  content.pictures.clear();
  EXPECT_FALSE(textOf(reportHtml(content)).isEmpty());
  EXPECT_TRUE(reportPdf(content).startsWith("%PDF"));
}

TEST(Report, OfALargeSkinListsTheFirstCellsAndSaysHowManyAreMissing) {
  Reconstruction result = awkwardResult();
  const CellPlacement cell = result.patches[0].cells[0];
  while (result.patches[0].cells.size() < 1000) result.patches[0].cells.push_back(cell);
  const QString text = textOf(reportHtml(contentOf(result)));
  EXPECT_TRUE(text.contains(QStringLiteral("601 more cells"))) << result.cellCount();
}

TEST(Report, IsWrittenWholeOrNotAtAll) {
  const test::TemporaryFolder folder;
  const ReportContent content = contentOf(awkwardResult());
  const auto path = folder.path() / "report.html";
  writeReport(content, QString::fromStdString(path.string()));
  EXPECT_EQ(readAll(path), reportHtml(content).toStdString());
  EXPECT_EQ(folder.entryCount(), 1U);

  EXPECT_THROW(writeReport(content, QString::fromStdString((folder.path() / "report.txt").string())), InvalidArgument);
  // Also root can't write into what is no folder.
  EXPECT_THROW(writeReport(content, QString::fromStdString((path / "report.pdf").string())), StorageError);
  std::filesystem::create_directory(folder.path() / "taken.pdf");
  EXPECT_THROW(writeReport(content, QString::fromStdString((folder.path() / "taken.pdf").string())), StorageError);
  EXPECT_EQ(folder.entryCount(), 2U);
}

class ReportWindow : public WindowTest {};

TEST_F(ReportWindow, WritesAReportWithPicturesFromTheMenu) {
  EXPECT_FALSE(action("actionReport")->isEnabled());
  takeDemoPoses(3);
  ASSERT_TRUE(action("actionReport")->isEnabled());
  for (const char* name : {"demo.html", "demo.pdf"}) {
    press(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    typeIntoFileDialog("saveDialog", pathTo(QString::fromLatin1(name)));
    ASSERT_TRUE(waitForMessage(QString::fromLatin1(name))) << message().toStdString();
    EXPECT_GT(QFileInfo(pathTo(QString::fromLatin1(name))).size(), 20000);
  }
  const QString html = QString::fromStdString(readAll(pathTo(QStringLiteral("demo.html")).toStdString()));
  EXPECT_GE(html.count(QStringLiteral("data:image/png")), 5);
  for (const ReportPicture& taken : takeReportPictures(controller().reconstruction())) {
    EXPECT_GE(taken.image.width(), 500) << taken.title.toStdString();
    EXPECT_GE(taken.image.height(), 200) << taken.title.toStdString();
  }
  QTextDocument page;
  page.setHtml(html);
  page.setTextWidth(660);
  QImage picture((page.size() + QSizeF(60, 60)).toSize(), QImage::Format_RGB32);
  picture.fill(Qt::white);
  QPainter painter(&picture);
  painter.translate(30, 30);
  page.drawContents(&painter);
  painter.end();
  keepPicture(picture, QStringLiteral("report"));
  EXPECT_TRUE(textOf(html).contains(words(controller().reconstruction()->assessment.reason)));
}

TEST_F(ReportWindow, SaysWhyAReportCanNotBeWritten) {
  takeDemoPoses(1);
  const QString file = writeFile(QStringLiteral("file"), "x");
  controller().resultFiles().writeReport({}, file + QStringLiteral("/report.pdf"));
  ASSERT_TRUE(waitForMessage(QStringLiteral("report.pdf")));
  EXPECT_TRUE(message().contains(QStringLiteral("cannot be written"))) << message().toStdString();
}

}  // namespace
}  // namespace hexoderm
