#include "tests/screenshots/screenshot_tour.h"

#include "app/window/guide/guide.h"
#include "app/window/main_window/main_window.h"
#include "tests/screenshots/text_fit.h"
#include "tests/support/qt_wait.h"
#include "widgets/controls/message_bar.h"
#include "widgets/patch/patch_view.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QImage>
#include <QTabBar>
#include <utility>

namespace hexoderm {
namespace {

constexpr std::size_t kMaxPoses = 8;

using test::waitUntil;

/// Layouts ask each other for room, step by step.
void settle() {
  constexpr int kRounds = 6;
  for (int k = 0; k < kRounds; ++k) {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    QCoreApplication::processEvents();
  }
}

QString withoutMnemonic(QString text) { return text.remove(QLatin1Char('&')); }

/// Dialogs of the window that are open, message boxes and windows of their own included.
QWidget* openDialog(const QWidget& window) {
  for (QWidget* widget : QApplication::topLevelWidgets()) {
    if (widget != &window && widget->isVisible() && widget->windowType() != Qt::ToolTip &&
        widget->windowType() != Qt::Popup) {
      return widget;
    }
  }
  return nullptr;
}

}  // namespace

bool ScreenshotTour::waitUntilIdle() {
  const SessionController& controller = window_.controller();
  const bool is_idle = waitUntil([&] {
    return controller.work().activity().isEmpty() && !controller.isSolving() && controller.reconstruction() != nullptr;
  });
  if (!is_idle) problems_ << QStringLiteral("the window did not come to rest");
  settle();
  return is_idle;
}

void ScreenshotTour::stop(QWidget& shown, const QString& name) {
  settle();
  const QString file = QStringLiteral("%1-%2-%3.png").arg(prefix_).arg(++stops_, 2, 10, QLatin1Char('0')).arg(name);
  QImage picture = &shown == &window_ ? window_.picture() : shown.grab().toImage();
  if (largest_width_px_ > 0 && picture.width() > largest_width_px_) {
    picture = picture.scaledToWidth(largest_width_px_, Qt::SmoothTransformation);
  }
  if (!picture.save(folder_.filePath(file), "PNG")) problems_ << QStringLiteral("%1 could not be written").arg(file);
  for (const QString& misfit : findCutTexts(shown) + findOverlaps(shown)) {
    problems_ << QStringLiteral("%1: %2").arg(file, misfit);
  }
  if (&shown != &window_) return;
  for (const QString& area : findSidewaysScrolling(shown)) {
    problems_ << QStringLiteral("%1: %2 scrolls sideways").arg(file, area);
  }
  if (window_.size() != size_) {
    problems_ << QStringLiteral("%1: the window is %2x%3 instead of %4x%5")
                     .arg(file)
                     .arg(window_.width())
                     .arg(window_.height())
                     .arg(size_.width())
                     .arg(size_.height());
  }
}

QAbstractButton* ScreenshotTour::stepHead(int number) const {
  return window_.findChild<QAbstractButton*>(QStringLiteral("stepHead%1").arg(number));
}

void ScreenshotTour::visitSteps(const QString& stage) {
  for (int number = 1;; ++number) {
    QAbstractButton* head = stepHead(number);
    if (head == nullptr) return;
    if (!head->isVisible()) continue;
    head->click();
    stop(window_, QStringLiteral("%1-step%2").arg(stage).arg(number));
  }
}

void ScreenshotTour::visitTables() {
  stepHead(static_cast<int>(GuideStep::Review) + 1)->click();
  auto* tabs = window_.findChild<QTabBar*>(QStringLiteral("detailTabs"));
  for (int page = 0; page < tabs->count(); ++page) {
    tabs->setCurrentIndex(page);
    stop(window_, QStringLiteral("table%1").arg(page + 1));
  }
  tabs->setCurrentIndex(0);
}

void ScreenshotTour::visitLiveMode() {
  LiveMode& live = window_.controller().liveMode();
  bool has_solved = false;
  const auto connection =
      QObject::connect(&live, &LiveMode::momentSolved, &window_, [&has_solved] { has_solved = true; });
  live.setOn(true);
  if (!waitUntil([&] { return has_solved; })) problems_ << QStringLiteral("live mode shows nothing");
  QObject::disconnect(connection);
  stop(window_, QStringLiteral("live"));
  live.setOn(false);
}

void ScreenshotTour::visitNotice() {
  auto* notice = window_.findChild<MessageBar*>();
  // As long as those about files are.
  notice->showMessage(Tone::Caution, window_.controller().file().name() + QStringLiteral(" · /home/operator/robots/") +
                                         QStringLiteral("a-rather-long-folder-name/").repeated(6));
  stop(window_, QStringLiteral("notice"));
  notice->hide();
}

void ScreenshotTour::visitDialogs() {
  bool has_shown_files = false;
  for (const QAction* known : window_.findChildren<QAction*>()) {
    // Actions that open a dialog are recognised by their dots. File dialogs are all alike.
    auto* action = const_cast<QAction*>(known);
    const QString name = action->objectName();
    const bool opens_dialog = action->text().endsWith(QChar(0x2026)) || name == QStringLiteral("actionKeys") ||
                              name == QStringLiteral("actionAbout") || name == QStringLiteral("actionGuide") ||
                              name == QStringLiteral("actionCompare");
    const bool opens_a_field = name == QStringLiteral("actionFindCell");  // in the graph
    if (!opens_dialog || opens_a_field || name.isEmpty() || !action->isEnabled()) continue;
    action->trigger();
    // Dialogs are shown some turns of the event loop later, on a busy computer long after.
    QWidget* dialog = nullptr;
    if (!waitUntil([&] { return (dialog = openDialog(window_)) != nullptr; })) {
      problems_ << QStringLiteral("%1 opens no dialog").arg(withoutMnemonic(action->text()));
      continue;
    }
    const bool is_for_files = dialog->inherits("QFileDialog");
    if (!is_for_files || !std::exchange(has_shown_files, true)) stop(*dialog, name);
    dialog->close();
    if (!waitUntil([&] { return openDialog(window_) == nullptr; })) {
      problems_ << QStringLiteral("%1 does not close").arg(withoutMnemonic(action->text()));
      return;
    }
  }
}

QStringList ScreenshotTour::run(QSize size) {
  if (!folder_.mkpath(QStringLiteral("."))) return {QStringLiteral("there is no folder %1").arg(folder_.path())};
  size_ = size;
  window_.showNormal();
  window_.resize(size);
  window_.findChild<QAction*>(QStringLiteral("actionResetLayout"))->trigger();
  // A picture shows the next pose as the part should be held, not on the way there.
  for (PatchView* view : window_.findChildren<PatchView*>()) view->setAnimated(false);
  settle();
  stop(window_, QStringLiteral("empty"));
  window_.startDemo();
  if (!waitUntilIdle()) return problems_;
  visitSteps(QStringLiteral("start"));
  SessionController& controller = window_.controller();
  stepHead(static_cast<int>(GuideStep::Capture) + 1)->click();
  controller.liveSession().setRobot(true);
  const auto poses = [&] { return controller.reconstruction() ? controller.reconstruction()->poses.size() : 0; };
  if (!waitUntil([&] { return poses() >= 1; })) return problems_ << QStringLiteral("no pose was taken");
  stop(window_, QStringLiteral("first-pose"));
  if (!waitUntil([&] { return poses() >= 2; })) return problems_ << QStringLiteral("no second pose was taken");
  stop(window_, QStringLiteral("second-pose"));
  const bool is_done =
      waitUntil([&] { return poses() >= kMaxPoses || (poses() > 1 && !controller.liveSession().wantsMorePoses()); });
  controller.liveSession().setRobot(false);
  controller.liveSession().setAutomatic(false);
  if (!is_done || !waitUntilIdle()) return problems_ << QStringLiteral("the robot did not take enough poses");
  visitSteps(QStringLiteral("done"));
  window_.actions().plot->trigger();
  stop(window_, QStringLiteral("plot"));
  window_.actions().plot->trigger();
  visitTables();
  visitLiveMode();
  visitNotice();
  visitDialogs();
  return problems_;
}

}  // namespace hexoderm
