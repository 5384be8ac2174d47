// Everything that the window writes: each export format by its dialog, where it went, and what is said when it can't be
// written.

#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/exporter.h"
#include "tests/app/window/window_test.h"
#include "tests/support/failing_disk.h"

#include <filesystem>

namespace hexoderm {
namespace {

/// Stands in for the desktop's file manager.
class FolderOpener : public QObject {
  Q_OBJECT

 public:
  FolderOpener() { QDesktopServices::setUrlHandler("file", this, "open"); }
  ~FolderOpener() override { QDesktopServices::unsetUrlHandler("file"); }
  QStringList opened;

 public slots:
  void open(const QUrl& url) { opened << url.toLocalFile(); }
};

class WindowExportTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_NO_FATAL_FAILURE(openSession("arm.hexo", simulated(4)));
  }
  /// Chooses the row of a format in the open dialog, "CALIBRATION" for Hexoderm's own.
  static void choose(QDialog* dialog, const QString& format) {
    auto* formats = dialog->findChild<QListWidget*>("exportFormats");
    const QList<QListWidgetItem*> found = formats->findItems(format, Qt::MatchFixedString);
    ASSERT_EQ(found.size(), 1) << format.toStdString();
    formats->scrollToItem(found[0]);
    QTest::mouseClick(formats->viewport(), Qt::LeftButton, Qt::NoModifier, formats->visualItemRect(found[0]).center());
    ASSERT_EQ(formats->currentItem(), found[0]);
  }
  /// Chooses, types the path and confirms. The extension is that of the format.
  void exportAs(const QString& format, const QString& path) {
    QDialog* dialog = openExportDialog();
    ASSERT_NO_FATAL_FAILURE(choose(dialog, format));
    if (auto* robot = dialog->findChild<QLineEdit*>("export-robot"); robot->isVisible()) {
      EXPECT_FALSE(dialog->findChild<QPushButton*>("exportButton")->isEnabled()) << "the robot is missing";
      const char* const urdf = "<robot name=\"arm\">\n  <link name=\"base_link\"/>\n</robot>\n";
      QTest::keyClicks(robot, writeFile("robot.urdf", urdf));
    }
    auto* edit = dialog->findChild<QLineEdit*>("exportPath");
    edit->setFocus();
    typeInto(edit, path);
    auto* button = dialog->findChild<QPushButton*>("exportButton");
    EXPECT_EQ(button->text(), QFileInfo::exists(path) ? "Replace" : "Export");
    ASSERT_TRUE(button->isEnabled()) << dialog->findChild<QLabel*>("exportNote")->text().toStdString();
    click(button);
    ASSERT_TRUE(waitUntilGone("exportDialog"));
  }
};

TEST_F(WindowExportTest, EveryFormatIsWrittenWhereTheMessageSays) {
  std::vector<std::pair<QString, QString>> files = {{"Calibration", ".calibration.json"}};
  for (const ExportFormatDescription& format : exportFormats()) {
    files.emplace_back(QString::fromStdString(std::string(format.name)).toUpper(),
                       QString::fromStdString(std::string(format.extension)));
  }
  ASSERT_GE(files.size(), 7U);
  for (const auto& [format, extension] : files) {
    const QString path = pathTo(format + "-of-the-arm" + extension);
    ASSERT_NO_FATAL_FAILURE(exportAs(format, path));
    ASSERT_TRUE(waitForMessage("Exported to " + path));
    const QFileInfo written(path);
    ASSERT_TRUE(written.exists()) << path.toStdString();
    if (extension.isEmpty()) {
      for (const char* table : {"cells.csv", "links.csv", "poses.csv", "residuals.csv", "covariances.csv"}) {
        EXPECT_TRUE(QFile::exists(path + '/' + table)) << table;
      }
      closeMessage();
      ASSERT_NO_FATAL_FAILURE(exportAs(format, path));
      ASSERT_TRUE(waitForMessage("Exported to " + path)) << "tables are replaced when asked";
    } else {
      EXPECT_GT(written.size(), 500) << path.toStdString();
    }
    // No message of the one before is taken for the next one's.
    closeMessage();
  }
  EXPECT_EQ(readCalibrationJson(pathTo("Calibration-of-the-arm.calibration.json").toStdString())->cellCount(), 17U);
}

TEST_F(WindowExportTest, AFormatsEndingIsInTheNameAndItsOptionsAreInTheFile) {
  QDialog* dialog = openExportDialog();
  const auto* path = dialog->findChild<QLineEdit*>("exportPath");
  EXPECT_EQ(path->text(), pathTo("arm.calibration.json"));
  for (const ExportFormatDescription& format : exportFormats()) {
    ASSERT_NO_FATAL_FAILURE(choose(dialog, QString::fromStdString(std::string(format.name))));
    EXPECT_EQ(path->text(), pathTo("arm" + QString::fromStdString(std::string(format.extension))));
  }
  ASSERT_NO_FATAL_FAILURE(choose(dialog, "URDF"));
  for (const auto& [name, text] : {std::pair("export-model-name", "arm7"), std::pair("export-parent", "elbow_link"),
                                   std::pair("export-prefix", "tactile_")}) {
    auto* edit = dialog->findChild<QLineEdit*>(name);
    ASSERT_TRUE(edit->isVisible()) << name;
    edit->setFocus();
    typeInto(edit, text);
  }
  QTest::keyClick(dialog->findChild<QComboBox*>("export-links"), Qt::Key_Down);
  click(dialog->findChild<QPushButton*>("exportButton"));
  ASSERT_TRUE(waitForMessage("Exported to "));
  const QString urdf = contentOf(pathTo("arm.urdf"));
  EXPECT_THAT(urdf, HasTexts({"<robot name=\"arm7\"", "elbow_link", "tactile_"}));
  EXPECT_EQ(urdf.count("<joint "), 1) << "one link for the patch";
}

TEST_F(WindowExportTest, OfSeveralPatchesOneIsChosenAndTheOthersAreNamed) {
  ASSERT_NO_FATAL_FAILURE(openFile(HEXODERM_TEST_DATA "/two_patches.tum.xml"));
  ASSERT_EQ(controller().reconstruction()->patches.size(), 2U);
  QDialog* dialog = openExportDialog();
  ASSERT_NO_FATAL_FAILURE(choose(dialog, "Calibration"));
  EXPECT_FALSE(dialog->findChild<QComboBox*>("exportPatch")->isVisible());
  const auto noteOf = [&] { return dialog->findChild<QLabel*>("exportNote")->text(); };
  const auto patchOf = [&] { return dialog->findChild<QComboBox*>("exportPatch"); };
  ASSERT_NO_FATAL_FAILURE(choose(dialog, "CSV"));
  dialog->findChild<QLineEdit*>("exportPath")->setText(pathTo("tables"));
  EXPECT_TRUE(patchOf()->isVisible());
  EXPECT_EQ(patchOf()->currentText(), "All, each in its own frame");
  EXPECT_THAT(noteOf(), Not(HasText("Not in the file")));
  ASSERT_NO_FATAL_FAILURE(choose(dialog, "PLY"));
  EXPECT_EQ(patchOf()->count(), 2) << "one frame, one patch";
  EXPECT_EQ(patchOf()->currentText(), "Patch of cell 2, 2 cells");
  dialog->findChild<QLineEdit*>("exportPath")->setText(pathTo("large.ply"));
  EXPECT_THAT(noteOf(), HasText("Not in the file: the patch of cell 7 (1 cell)"));
  click(dialog->findChild<QPushButton*>("exportButton"));
  ASSERT_TRUE(waitForMessage("Not in the file: the patch of cell 7 (1 cell)"));
  EXPECT_THAT(message(), HasText("Exported to " + pathTo("large.ply")));
  EXPECT_TRUE(contentOf(pathTo("large.ply")).contains("in the frame of cell 2,"));
  closeMessage();

  dialog = openExportDialog();
  ASSERT_NO_FATAL_FAILURE(choose(dialog, "PLY"));
  QTest::keyClick(patchOf(), Qt::Key_Down);
  EXPECT_EQ(patchOf()->currentText(), "Cell 7 alone");
  dialog->findChild<QLineEdit*>("exportPath")->setText(pathTo("lonely.ply"));
  click(dialog->findChild<QPushButton*>("exportButton"));
  ASSERT_TRUE(waitForMessage("Exported to " + pathTo("lonely.ply")));
  EXPECT_THAT(message(), HasText("the patch of cell 2 (2 cells)"));
  EXPECT_TRUE(contentOf(pathTo("lonely.ply")).contains("in the frame of cell 7,"));
}

TEST_F(WindowExportTest, PicturesOfTheWindowAndOfTheThreeDimensionalViewAreWritten) {
  press(Qt::Key_F12);
  ASSERT_TRUE(waitForMessage("Exported to "));
  const QString window_picture = message().section("Exported to ", 1);
  EXPECT_EQ(QImage(window_picture).size(), window_->size() * window_->devicePixelRatioF()) << message().toStdString();
  QFile::remove(window_picture);  // it may be among the user's own
  closeMessage();

  action("actionScenePicture")->trigger();
  ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("saveDialog", pathTo("view.png")));
  ASSERT_TRUE(waitForMessage("Exported to " + pathTo("view.png")));
  const QImage view(pathTo("view.png"));
  ASSERT_FALSE(view.isNull());
  EXPECT_GT(coloursIn(view), 50U) << "the skin is in it";
}

TEST_F(WindowExportTest, TheDialogSaysWhatIsMissing) {
  QDialog* dialog = openExportDialog();
  auto* edit = dialog->findChild<QLineEdit*>("exportPath");
  const auto* button = dialog->findChild<QPushButton*>("exportButton");
  EXPECT_TRUE(button->isEnabled());
  edit->clear();
  EXPECT_FALSE(button->isEnabled());
  QTest::keyClicks(edit, pathTo("no/such/folder/a.stl"));
  EXPECT_FALSE(button->isEnabled());
  EXPECT_THAT(dialog->findChild<QLabel*>("exportNote")->text(), HasText("There is no folder"));
  ASSERT_NO_FATAL_FAILURE(choose(dialog, "URDF"));
  edit->setText(pathTo("arm.urdf"));
  EXPECT_TRUE(button->isEnabled());
  dialog->findChild<QLineEdit*>("export-parent")->clear();
  EXPECT_FALSE(button->isEnabled()) << "a link needs a name";
  QTest::keyClick(dialog, Qt::Key_Escape);
  EXPECT_TRUE(waitUntilGone("exportDialog"));
}

TEST_F(WindowExportTest, OpenFolderOpensWhereTheFileIs) {
  FolderOpener desktop;
  ASSERT_TRUE(QDir(folder_.path()).mkdir("out"));
  ASSERT_NO_FATAL_FAILURE(exportAs("DOT", pathTo("out/arm.dot")));
  ASSERT_TRUE(waitForMessage("Exported to " + pathTo("out/arm.dot")));
  EXPECT_EQ(find<QPushButton>("messageButton")->text(), "Open folder");
  click(find<QPushButton>("messageButton"));
  EXPECT_EQ(desktop.opened, QStringList(pathTo("out")));
}

TEST_F(WindowExportTest, AFullDiskLeavesTheEarlierFileAsItWas) {
  const QString path = writeFile("arm.ply", "what was there");
  {
    const test::NoFileGrows full;
    ASSERT_NO_FATAL_FAILURE(exportAs("PLY", path));
    ASSERT_TRUE(waitForMessage("arm.ply"));
    EXPECT_THAT(message(), Not(HasText("Exported")));
  }
  EXPECT_EQ(contentOf(path), "what was there");
  EXPECT_EQ(QDir(folder_.path()).entryList({"*.ply*", ".*ply*"}, QDir::Files | QDir::Hidden), QStringList("arm.ply"))
      << "nothing half written stays";
  ASSERT_NO_FATAL_FAILURE(exportAs("PLY", path));
  EXPECT_TRUE(waitForMessage("Exported to " + path)) << "the work goes on";
}

TEST_F(WindowExportTest, NothingReplacesASession) {
  const std::string open_session = pathTo("arm.hexo").toStdString();
  std::filesystem::create_hard_link(open_session, pathTo("arm.html").toStdString());
  std::filesystem::create_symlink(open_session, pathTo("arm.zip").toStdString());
  ResultFiles& files = controller().resultFiles();
  ReportContent report;
  report.reconstruction = controller().reconstruction();
  QString package_failed;
  QObject::connect(&files, &ResultFiles::packageFailed, &files,
                   [&](const QString& message) { package_failed = message; });
  using Write = std::function<void(const QString& path)>;
  const auto exported = [&files](std::optional<ExportFormat> format) -> Write {
    return [&files, format](const QString& path) { files.exportTo({format, path, {}}); };
  };
  const std::pair<const char*, Write> ways[] = {
      {"arm.hexo", exported(std::nullopt)},
      {"arm.html", exported(ExportFormat::Stl)},
      {"arm.zip", [&](const QString& path) { files.saveImage(QImage(8, 8, QImage::Format_RGB32), path); }},
      {"arm.html", [&](const QString& path) { files.savePicture([] { return true; }, path); }},
      {"arm.zip", [&](const QString& path) { files.saveTable("a,b", path); }},
      {"arm.html", [&](const QString& path) { files.writeReport(report, path); }},
  };
  for (const auto& [name, write] : ways) {
    write(pathTo(name));
    ASSERT_TRUE(waitForMessage("never replaced")) << name;
    EXPECT_THAT(message(), HasText(pathTo(name)));
    closeMessage();
  }
  PackageRequest package;
  package.formats = {ExportFormat::Stl};
  package.path = pathTo("arm.zip");
  files.exportPackage(package, report);
  ASSERT_TRUE(waitUntil([&] { return package_failed.contains("never replaced"); })) << package_failed.toStdString();
  controller().file().saveSession(pathTo("arm.html"));
  ASSERT_TRUE(waitForMessage("arm.html: exists already as a Hexoderm session"));
  EXPECT_EQ(readSessionStore(open_session).poses().size(), 4U);
}

TEST_F(WindowExportTest, NoExportReplacesTheFileThatIsOpen) {
  ResultFiles& files = controller().resultFiles();
  const QString calibration = pathTo("arm.calibration.json");
  files.exportTo({std::nullopt, calibration, {}});
  ASSERT_TRUE(waitForMessage("Exported to " + calibration));
  files.exportTo({std::nullopt, calibration, {}});
  ASSERT_TRUE(waitUntilIdle()) << "an ordinary file is replaced";
  const QString session = pathTo("copy.session.json");
  controller().file().saveSession(session);
  ASSERT_TRUE(waitForMessage("Saved to " + session));
  for (const QString& path : {calibration, session}) {
    ASSERT_NO_FATAL_FAILURE(openFile(path));
    const QByteArray before = contentOf(path);
    for (const bool is_picture : {false, true}) {
      if (is_picture) files.saveImage(QImage(8, 8, QImage::Format_RGB32), path);
      if (!is_picture) files.exportTo({ExportFormat::Ply, path, {}});
      ASSERT_TRUE(waitForMessage("is one of the inputs"));
      closeMessage();
    }
    EXPECT_EQ(contentOf(path), before);
  }
  controller().file().saveSession(session);
  EXPECT_TRUE(waitForMessage("Saved to " + session));
}

TEST_F(WindowExportTest, ASkinWithoutCellsIsShownAndSaysWhatCanNotBeMadeOfIt) {
  const QString path = writeFile("empty.session.json",
                                 R"({"format": "hexoderm-session", "version": 1, "cell_model": "hex-bma150",
                                     "cells": [], "poses": []})");
  ASSERT_NO_FATAL_FAILURE(openFile(path));
  EXPECT_EQ(controller().reconstruction()->cellCount(), 0U);
  EXPECT_FALSE(labelText("bannerSentence").isEmpty());
  for (int step = 1; step <= 6; ++step) press(Qt::Key_0 + step, Qt::ControlModifier);
  EXPECT_FALSE(window_->picture().isNull());
  ASSERT_NO_FATAL_FAILURE(exportAs("STL", pathTo("empty.stl")));
  ASSERT_TRUE(waitForMessage("cell"));
  EXPECT_THAT(message(), Not(HasText("Exported")));
  EXPECT_FALSE(QFile::exists(pathTo("empty.stl")));
}

}  // namespace
}  // namespace hexoderm

#include "window_export_test.moc"
