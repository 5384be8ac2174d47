#pragma once

#include "app/window/presenters/presenter.h"
#include "app/window/session/verification.h"
#include "app/window/toolkit/dialogs.h"
#include "hexoderm/solve/checks/evaluation.h"
#include "hexoderm/solve/result/reconstruction.h"
#include "widgets/patch/compare_view.h"

#include <QDialog>
#include <QScreen>
#include <QStringList>
#include <QTimer>
#include <QVBoxLayout>
#include <vector>

namespace hexoderm {

/// Before and after in a window of its own, made when it is first asked for: the result of now beside the one before
/// the last change, or beside the calibration that the step Verify compares with.
class ComparePresenter : public Presenter {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::ComparePresenter)

 public:
  ComparePresenter(const WindowParts& parts, const Verification& verification)
      : Presenter(parts), verification_(verification), now_(controller.reconstruction()) {
    connect(actions.compare, &QAction::triggered, this, &ComparePresenter::open);
    connect(&controller, &SessionController::reconstructionChanged, this, &ComparePresenter::note);
    connect(&verification_, &Verification::compared, this, &ComparePresenter::showComparison);
  }

  /// The comparison's window goes before what its views refer to.
  ~ComparePresenter() override { delete dialog_; }

 private:
  void note(const std::shared_ptr<const Reconstruction>& reconstruction) {
    // A null one stands between two sessions: what was before belongs to the other.
    before_ = reconstruction ? now_ : nullptr;
    now_ = reconstruction;
    showComparison();
  }

  void open() {
    if (dialog_ == nullptr) {
      dialog_ = named(new QDialog(&window, Qt::Window), "compareDialog");
      dialog_->setWindowTitle(tr("Before and after"));
      auto* layout = new QVBoxLayout(dialog_);
      layout->setContentsMargins(0, 0, 0, 0);
      view_ = new CompareView(&selection);
      layout->addWidget(view_);
      connect(view_, &CompareView::sourceChosen, this, [this](int index) {
        prefers_calibration_ = index > 0 || !before_;
        showComparison();
      });
      dialog_->resize(QSize(1100, 640).boundedTo(0.9 * window.screen()->availableSize()));
    }
    // Made in one turn of the event loop and shown in a later one, so that clicks and keys wait for one of them at a
    // time.
    QTimer::singleShot(1, dialog_, [this] {
      bringToFront(dialog_);
      showComparison();
    });
  }

  void showComparison() {
    if (dialog_ == nullptr || !dialog_->isVisible()) return;
    const std::shared_ptr<const Reconstruction>& calibration = verification_.reference();
    QStringList names;
    if (before_) names << tr("the result before the last change");
    if (calibration) names << tr("%1, of the step Verify").arg(verification_.referenceName());
    const bool by_calibration = calibration && (prefers_calibration_ || !before_);
    CompareView::Content content;
    content.now = now_;
    content.before = by_calibration ? calibration : before_;
    if (content.before && content.now) {
      content.comparison =
          std::make_shared<const std::vector<Comparison>>(compareToReconstruction(*content.now, *content.before));
    }
    view_->setContent(content);
    view_->setSources(
        names, by_calibration && before_ ? 1 : 0,
        tr("There is nothing to compare with yet: change something, take another pose, or choose an earlier "
           "calibration in the step Verify."));
  }

  const Verification& verification_;
  QDialog* dialog_ = nullptr;  ///< once it was asked for
  CompareView* view_ = nullptr;
  std::shared_ptr<const Reconstruction> now_;
  std::shared_ptr<const Reconstruction> before_;  ///< the last change of the same session
  bool prefers_calibration_ = false;              ///< to the last change, where there are both
};

}  // namespace hexoderm
