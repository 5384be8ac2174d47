#include "app/window/presenters/presenters.h"

#include "app/window/guide/guide_window.h"
#include "app/window/guide/keys_dialog.h"
#include "app/window/log/bug_report.h"
#include "app/window/toolkit/dialogs.h"

#include <QClipboard>
#include <QDesktopServices>
#include <QDir>
#include <QGuiApplication>
#include <QLayout>
#include <QMessageBox>
#include <QUrl>

namespace hexoderm {
namespace {

void showGuide(const WindowParts& parts) {
  const QString page = guidePageFor(parts.controller);
  auto* guide = parts.window.findChild<GuideWindow*>();
  if (guide == nullptr) {
    guide = new GuideWindow(&parts.window, page);
    guide->setAttribute(Qt::WA_DeleteOnClose);
    guide->setKeys(*parts.views.menus);
  }
  guide->showPage(page);
  bringToFront(guide);
}

void showAbout(QWidget& window) {
  auto* box =
      new QMessageBox(QMessageBox::NoIcon, WindowParts::tr("About Hexoderm"),
                      WindowParts::tr("<b>Hexoderm %1</b><p>Finds out where every cell of a robot's artificial skin "
                                      "is.</p><p>BSD 3-Clause licence.</p>")
                          .arg(QLatin1String(HEXODERM_VERSION)),
                      QMessageBox::Close, &window);
  // The text is indented for an icon; the same room on the other side.
  constexpr int kIndent = 20;
  QMargins margins = box->layout()->contentsMargins();
  margins.setRight(margins.right() + kIndent);
  box->layout()->setContentsMargins(margins);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

}  // namespace

void connectHelp(const WindowParts& parts) {
  QObject::connect(parts.actions.guide, &QAction::triggered, &parts.wires, [&parts] { showGuide(parts); });
  QObject::connect(parts.actions.keys, &QAction::triggered, &parts.wires,
                   [&parts] { showKeysDialog(&parts.window, *parts.views.menus); });
  QObject::connect(parts.actions.about, &QAction::triggered, &parts.wires, [&parts] { showAbout(parts.window); });

  EventLog& log = parts.log;
  MessageBar* const messages = parts.views.messages;
  const auto copyReport = [&parts, messages] {
    QGuiApplication::clipboard()->setText(composeBugReport(parts.log, parts.controller, parts.window));
    messages->showMessage(Tone::Good,
                          WindowParts::tr("Copied: versions, graphics, what is open and the last lines of the log, "
                                          "with your home folder as ~. Paste it into the report."));
  };
  const auto openFolder = [&log, messages] {
    if (QDesktopServices::openUrl(QUrl::fromLocalFile(log.folder()))) return;
    messages->showMessage(Tone::Caution, WindowParts::tr("No program to show folders was found. The log is %1.")
                                             .arg(QDir::toNativeSeparators(log.filePath())));
  };
  QObject::connect(parts.views.log, &LogView::reportWanted, &parts.wires, copyReport);
  QObject::connect(parts.views.log, &LogView::folderWanted, &parts.wires, openFolder);
  QObject::connect(parts.actions.copy_report, &QAction::triggered, &parts.wires, copyReport);
  QObject::connect(parts.actions.open_log_folder, &QAction::triggered, &parts.wires, openFolder);
  QObject::connect(&log, &EventLog::fileFailed, &parts.wires, [messages](const QString& why) {
    messages->showMessage(Tone::Caution, WindowParts::tr("The log is kept in memory only. %1").arg(why));
  });
}

}  // namespace hexoderm
