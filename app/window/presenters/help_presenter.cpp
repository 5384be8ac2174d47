#include "app/window/presenters/help_presenter.h"

#include "app/window/guide/actions.h"
#include "app/window/guide/guide_window.h"
#include "app/window/guide/keys_dialog.h"

#include <QLayout>
#include <QMessageBox>

namespace hexoderm {

HelpPresenter::HelpPresenter(QWidget& window, const QMenuBar& menus, const SessionController& controller,
                             const WindowActions& actions)
    : window_(window), menus_(menus), controller_(controller) {
  connect(actions.guide, &QAction::triggered, this, &HelpPresenter::showGuide);
  connect(actions.keys, &QAction::triggered, this, [this] { showKeysDialog(&window_, menus_); });
  connect(actions.about, &QAction::triggered, this, &HelpPresenter::showAbout);
}

void HelpPresenter::showGuide() {
  const QString page = guidePageFor(controller_);
  auto* guide = window_.findChild<GuideWindow*>();
  if (guide == nullptr) {
    guide = new GuideWindow(&window_, page);
    guide->setAttribute(Qt::WA_DeleteOnClose);
    guide->setKeys(menus_);
  }
  guide->showPage(page);
  guide->show();
  guide->raise();
  guide->activateWindow();
}

void HelpPresenter::showAbout() {
  auto* box = new QMessageBox(QMessageBox::NoIcon, tr("About Hexoderm"),
                              tr("<b>Hexoderm %1</b><p>Finds out where every cell of a robot's artificial skin "
                                 "is.</p><p>BSD 3-Clause licence.</p>")
                                  .arg(QLatin1String(HEXODERM_VERSION)),
                              QMessageBox::Close, &window_);
  // The text is indented for an icon; the same room on the other side.
  constexpr int kIndent = 20;
  QMargins margins = box->layout()->contentsMargins();
  margins.setRight(margins.right() + kIndent);
  box->layout()->setContentsMargins(margins);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

}  // namespace hexoderm
