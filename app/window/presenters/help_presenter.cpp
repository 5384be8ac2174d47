#include "app/window/presenters/presenters.h"

#include "app/window/guide/guide_window.h"
#include "app/window/guide/keys_dialog.h"

#include <QLayout>
#include <QMessageBox>

namespace hexoderm {
namespace {

/// Shows what the menu Help offers: the guide, the list of keys, the version.
class HelpPresenter : public Presenter {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::HelpPresenter)

 public:
  explicit HelpPresenter(const WindowParts& parts) : Presenter(parts) {
    connect(actions_.guide, &QAction::triggered, this, &HelpPresenter::showGuide);
    connect(actions_.keys, &QAction::triggered, this, [this] { showKeysDialog(&window_, *views_.menus); });
    connect(actions_.about, &QAction::triggered, this, &HelpPresenter::showAbout);
  }

 private:
  void showGuide() {
    const QString page = guidePageFor(controller_);
    auto* guide = window_.findChild<GuideWindow*>();
    if (guide == nullptr) {
      guide = new GuideWindow(&window_, page);
      guide->setAttribute(Qt::WA_DeleteOnClose);
      guide->setKeys(*views_.menus);
    }
    guide->showPage(page);
    guide->show();
    guide->raise();
    guide->activateWindow();
  }

  void showAbout() {
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
};

}  // namespace

std::unique_ptr<Presenter> makeHelpPresenter(const WindowParts& parts) {
  return std::make_unique<HelpPresenter>(parts);
}

}  // namespace hexoderm
