#include "app/window/presenters/log_presenter.h"

#include "app/window/guide/actions.h"
#include "app/window/log/bug_report.h"
#include "app/window/log/event_log.h"
#include "app/window/log/log_view.h"
#include "widgets/controls/message_bar.h"

#include <QClipboard>
#include <QDesktopServices>
#include <QDir>
#include <QGuiApplication>
#include <QUrl>

namespace hexoderm {

LogPresenter::LogPresenter(const Views& views, const SessionController& controller, const WindowActions& actions,
                           const EventLog& log)
    : views_(views), controller_(controller), log_(log) {
  connect(&views_.log, &LogView::reportWanted, this, &LogPresenter::copyReport);
  connect(&views_.log, &LogView::folderWanted, this, &LogPresenter::openFolder);
  connect(actions.copy_report, &QAction::triggered, this, &LogPresenter::copyReport);
  connect(actions.open_log_folder, &QAction::triggered, this, &LogPresenter::openFolder);
  connect(&log_, &EventLog::fileFailed, this, [this](const QString& why) {
    views_.messages.showMessage(Tone::Caution, tr("The log is kept in memory only. %1").arg(why));
  });
}

void LogPresenter::copyReport() {
  QGuiApplication::clipboard()->setText(composeBugReport(log_, controller_, views_.window));
  views_.messages.showMessage(
      Tone::Good, tr("Copied: versions, graphics, what is open and the last lines of the log, with your home "
                     "folder as ~. Paste it into the report."));
}

void LogPresenter::openFolder() {
  if (!QDesktopServices::openUrl(QUrl::fromLocalFile(log_.folder()))) {
    views_.messages.showMessage(
        Tone::Caution,
        tr("No program to show folders was found. The log is %1.").arg(QDir::toNativeSeparators(log_.filePath())));
  }
}

}  // namespace hexoderm
