#include "app/window/presenters/presenters.h"

#include "app/window/log/bug_report.h"

#include <QClipboard>
#include <QDesktopServices>
#include <QDir>
#include <QGuiApplication>
#include <QUrl>

namespace hexoderm {
namespace {

/// Serves the log to people who report a bug: as a text to be pasted, as a folder to be opened.
class LogPresenter : public Presenter {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::LogPresenter)

 public:
  explicit LogPresenter(const WindowParts& parts) : Presenter(parts) {
    connect(views_.log, &LogView::reportWanted, this, &LogPresenter::copyReport);
    connect(views_.log, &LogView::folderWanted, this, &LogPresenter::openFolder);
    connect(actions_.copy_report, &QAction::triggered, this, &LogPresenter::copyReport);
    connect(actions_.open_log_folder, &QAction::triggered, this, &LogPresenter::openFolder);
    connect(&log_, &EventLog::fileFailed, this, [this](const QString& why) {
      views_.messages->showMessage(Tone::Caution, tr("The log is kept in memory only. %1").arg(why));
    });
  }

 private:
  void copyReport() {
    QGuiApplication::clipboard()->setText(composeBugReport(log_, controller_, window_));
    views_.messages->showMessage(
        Tone::Good, tr("Copied: versions, graphics, what is open and the last lines of the log, with your home "
                       "folder as ~. Paste it into the report."));
  }

  void openFolder() {
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(log_.folder()))) {
      views_.messages->showMessage(
          Tone::Caution,
          tr("No program to show folders was found. The log is %1.").arg(QDir::toNativeSeparators(log_.filePath())));
    }
  }
};

}  // namespace

std::unique_ptr<Presenter> makeLogPresenter(const WindowParts& parts) { return std::make_unique<LogPresenter>(parts); }

}  // namespace hexoderm
