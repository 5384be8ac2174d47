#include "app/window/presenters/presenters.h"

#include "app/window/guide/guide_window.h"
#include "app/window/guide/keys_dialog.h"
#include "app/window/toolkit/deferred_dialog.h"

#include <QLayout>
#include <QMessageBox>

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
}

}  // namespace hexoderm
