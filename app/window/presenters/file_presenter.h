#pragma once

#include "app/window/presenters/presenter.h"
#include "app/window/toolkit/dialogs.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/tables/table_csv.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QMessageBox>
#include <QString>
#include <QUrl>
#include <functional>
#include <utility>

namespace hexoderm {

/// Asks the operator for the files that are read or written. Before a session is replaced or the window closes, it asks
/// whether unsaved changes are to be saved.
class FilePresenter : public Presenter {
  Q_OBJECT

 public:
  explicit FilePresenter(const WindowParts& parts) : Presenter(parts) {
    connect(actions.demo, &QAction::triggered, this, &FilePresenter::startDemo);
    connect(actions.robot_demo, &QAction::triggered, this, &FilePresenter::startRobotDemo);
    connect(actions.open, &QAction::triggered, this, &FilePresenter::askToOpen);
    connect(actions.save, &QAction::triggered, this, [this] { saveSession(false); });
    connect(actions.save_as, &QAction::triggered, this, [this] { saveSession(true); });
    connect(actions.save_calibration, &QAction::triggered, this, &FilePresenter::saveCalibration);
    connect(actions.quit, &QAction::triggered, &window, &QWidget::close);
    connect(
        &controller, &SessionController::changed, this,
        [this] {
          if (close_when_written_ && !controller.file().isWriting()) window.close();
        },
        Qt::QueuedConnection);
    connect(&controller, &SessionController::opened, views.messages, &QWidget::hide);
    connect(&controller.file(), &SessionFile::sessionSaved, this, [this](const QString& path) {
      showDone(tr("Saved to %1").arg(path), path);
      if (const auto proceed = std::exchange(after_saving_, nullptr)) proceed();
    });
    connect(&controller.resultFiles(), &ResultFiles::exported, this,
            [this](const QString& path, const QString& left_out) {
              if (left_out.isEmpty()) {
                showDone(tr("Exported to %1").arg(path), path);
              } else {
                showDone(tr("Exported to %1. %2").arg(path, left_out), path, Tone::Caution);
              }
            });
    connect(&controller, &SessionController::failed, this, [this](const QString& message) {
      forgetPlans();
      views.messages->showMessage(Tone::Bad, message);
    });
    connect(&controller.file(), &SessionFile::journalStuck, this, [this](const QString& why) {
      forgetPlans();
      views.messages->showMessage(Tone::Bad,
                                  tr("Not on disk yet; it waits in memory and the work can go on. %1").arg(why),
                                  tr("Try again"), [this] { controller.file().retryWriting(); });
    });
  }

  void openFile(const QString& path) {
    rememberFolder(path);
    afterAskingToSave([this, path] { controller.file().openFile(path); });
  }

  void startDemo() {
    afterAskingToSave([this] { controller.liveSession().startDemo(); });
  }

  /// A session of a simulated robot, to place its patches.
  void startRobotDemo() {
    afterAskingToSave([this] { controller.file().openRobotDemo(); });
  }

  /// Calls `proceed` at once where nothing would be lost, else after the operator has answered, unless they cancel.
  void afterAskingToSave(std::function<void()> proceed) {
    if (!controller.file().hasUnsavedChanges()) {
      proceed();
      return;
    }
    auto* box = new QMessageBox(QMessageBox::Question, tr("Unsaved poses"),
                                tr("Save the session first? Its latest changes are not on disk yet."),
                                QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &window);
    box->setObjectName(QStringLiteral("unsavedBox"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setDefaultButton(QMessageBox::Save);
    box->setEscapeButton(QMessageBox::Cancel);
    connect(box, &QMessageBox::finished, this, [this, proceed = std::move(proceed)](int answer) {
      if (answer == QMessageBox::Discard) {
        proceed();
      } else if (answer == QMessageBox::Save) {
        after_saving_ = proceed;
        saveSession(false);
      }
    });
    box->open();
  }

  /// Whether the window may close now. If it may not, the operator is asked, or a file is finished, and the window is
  /// closed after that.
  [[nodiscard]] bool mayClose() {
    if (!may_close_ && controller.file().hasUnsavedChanges()) {
      if (window.findChild<QMessageBox*>(QStringLiteral("unsavedBox"))) return false;
      afterAskingToSave([this] {
        may_close_ = true;
        window.close();
      });
      return false;
    }
    // A file that is being written is finished first; it takes moments, and nothing waits for it here.
    close_when_written_ = controller.file().isWriting();
    return !close_when_written_;
  }

  /// Asks where to save. `name`: suggested, without folder; `filter` as QFileDialog has it; `extension`: ".png".
  void askForPath(const QString& title, const QString& name, const QString& filter, const QString& extension,
                  std::function<void(QString)> chosen) {
    auto* dialog = named(new FileDialog(&window, title, lastFolder(), filter), "saveDialog");
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(extension.mid(1));
    dialog->selectFile(name + extension);
    connect(dialog, &QFileDialog::fileSelected, this, [chosen = std::move(chosen)](const QString& path) {
      rememberFolder(path);
      chosen(path);
    });
    // The name's extension follows the filter: "Sessions (*.hexo)".
    connect(dialog, &QFileDialog::filterSelected, dialog, [dialog, name](const QString& chosen_filter) {
      const QString suffix = chosen_filter.section(QStringLiteral("(*."), 1).section(QLatin1Char(')'), 0, 0);
      dialog->setDefaultSuffix(suffix);
      dialog->selectFile(name + QLatin1Char('.') + suffix);
    });
    connect(dialog, &QFileDialog::rejected, this, [this] { after_saving_ = nullptr; });
    openInTurns(dialog);
  }

  /// The name of what is open, without folder and extension.
  [[nodiscard]] QString suggestedName() const {
    if (controller.liveSession().isDemo() && controller.file().sessionPath().isEmpty()) return QStringLiteral("demo");
    QString name = controller.file().name();
    for (const QString& extension :
         {kSessionExtension, kJournalExtension, kCalibrationExtension, QStringLiteral(".xml")}) {
      if (name.endsWith(extension)) name.chop(extension.size());
    }
    return name;
  }

  /// Shows the folder of a file in the desktop's program for that; says so if there is none.
  void openFolderOf(const QString& path) {
    const QString folder = QFileInfo(path).absolutePath();
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(folder))) {
      views.messages->showMessage(Tone::Caution,
                                  tr("No program to show folders was found. The folder is %1.").arg(folder));
    }
  }

  /// Serves "Save as CSV…" of a table.
  void saveTablesOf(CsvActions* of_table) {
    connect(of_table, &CsvActions::saveRequested, this, [this](const QString& name, const QByteArray& csv) {
      askForPath(tr("Save the table"), name, tr("Tables (*.csv)"), QStringLiteral(".csv"),
                 [this, csv](const QString& path) { controller.resultFiles().saveTable(csv, path); });
    });
  }

 private:
  void askToOpen() {
    askToRead("openDialog", tr("Open a session or a calibration"),
              tr("Sessions and calibrations (*.hexo *.json *.xml)") + QStringLiteral(";;") + tr("All files (*)"),
              [this](const QString& path) { openFile(path); });
  }

  void saveSession(bool always_ask) {
    if (!controller.session()) return;
    if (!always_ask && (controller.file().isKept() || controller.file().sessionPath().endsWith(kSessionExtension))) {
      controller.file().saveSession(controller.file().sessionPath());
      return;
    }
    askForPath(tr("Save the session"), suggestedName(),
               tr("Sessions (*.session.json);;Sessions that keep every change (*.hexo)"), kSessionExtension,
               [this](const QString& path) { controller.file().saveSession(path); });
  }

  void saveCalibration() {
    askForPath(tr("Save the calibration"), suggestedName(), tr("Calibrations (*.calibration.json)"),
               kCalibrationExtension, [this](const QString& path) {
                 controller.resultFiles().exportTo({std::nullopt, path, {}});
               });
  }

  void showDone(const QString& text, const QString& path, Tone tone = Tone::Good) {
    views.messages->showMessage(tone, text, tr("Open folder"), [this, path] { openFolderOf(path); });
  }

  /// What waits for the session to be saved does not happen.
  void forgetPlans() {
    after_saving_ = nullptr;
    may_close_ = close_when_written_ = false;
  }

  std::function<void()> after_saving_;  ///< what waits for the session to be on disk
  bool may_close_ = false;
  bool close_when_written_ = false;

  static inline const QString kSessionExtension = QStringLiteral(".session.json");
  static inline const QString kJournalExtension = QStringLiteral(".hexo");
  static inline const QString kCalibrationExtension = QStringLiteral(".calibration.json");
};

}  // namespace hexoderm
