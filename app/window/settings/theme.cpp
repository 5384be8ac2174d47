#include "app/window/settings/theme.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <QIcon>
#include <QPointer>
#include <QProxyStyle>
#include <QRegularExpression>
#include <QStringList>
#include <QStyleFactory>
#include <QStyleOption>
#include <QTimer>
#include <QWidget>
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace hexoderm {
namespace {

/// Fusion, whose dialog buttons would carry icons of another style than ours.
class WindowStyle : public QProxyStyle {
 public:
  WindowStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* data) const override {
    if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
    return QProxyStyle::styleHint(hint, option, widget, data);
  }
  /// Kept, for Fusion reads and decodes its pictures again each time, a dozen for each file dialog.
  QIcon standardIcon(StandardPixmap kind, const QStyleOption* option, const QWidget* widget) const override {
    const bool mirrored = (option ? option->direction : QApplication::layoutDirection()) == Qt::RightToLeft;
    QIcon& icon = icons_[{kind, mirrored}];
    if (icon.isNull()) icon = QProxyStyle::standardIcon(kind, option, widget);
    return icon;
  }

 private:
  mutable std::map<std::pair<StandardPixmap, bool>, QIcon> icons_;
};

/// The rules that the panels of the main window add to the application's sheet.
QString panelSheet(const Colors& colors) {
  return QStringLiteral(
             "QFrame[cardHead=\"true\"] { background: %1; border: 1px solid %2; border-bottom: 0;"
             " border-top-left-radius: 6px; border-top-right-radius: 6px; }"
             "QFrame[cardBody=\"true\"] { background: %1; border: 1px solid %2; border-top: 0;"
             " border-bottom-left-radius: 6px; border-bottom-right-radius: 6px; }"
             "QScrollArea#stepPanel, QWidget#stepContent { background: %1; border: 0; }"
             "QScrollArea#checksArea, QWidget#verifyPanel { background: %1; border: 0; }"
             "QFrame[stepBody=\"true\"] { background: %3; border: 0; }"
             "QLabel[stepWhat=\"true\"] { font-weight: 600; }"
             "QWidget#topBar { background: %1; border-bottom: 1px solid %2; }"
             "QWidget#topBar QMenuBar { border: 0; }"
             "QLabel#appName { color: %4; font-weight: 700; padding: 0 4px 0 16px; }"
             "QLabel#sessionName { color: %5; padding: 0 16px; }"
             "QListWidget#exportFormats { border: 1px solid %2; border-radius: 5px; padding: 4px; }"
             "QListWidget#guideContents { border: 0; padding: 8px; background: %1; }"
             "QListWidget#guideContents::item { padding: 6px 9px; border-radius: 4px; }"
             "QListWidget#guideContents::item:selected { background: %6; color: %7; }"
             "QListWidget#exportFormats::item { padding: 6px 9px; border-radius: 4px; }"
             "QListWidget#exportFormats::item:selected { background: %6; color: %7; }"
             "QScrollArea#welcomePanel, QWidget#welcomeContent { background: %1; border: 0; }"
             "QStatusBar QLabel { padding: 4px 8px; }"
             "QLabel[hint=\"true\"] { color: %5; padding: 12px 14px; background: %1; }")
      .arg(colors.panel.name(), colors.border.name(), colors.panel_active.name(), colors.text.name(),
           colors.text_muted.name(), colors.accent.name(), colors.accent_text.name());
}

/// Styles all widgets again: the visible ones of the window in front at first, then those of each other window, in as
/// many turns of the event loop as that takes, and each window is painted in the turn after its last; the rest, which
/// is most, in turns that nobody notices, or when it is shown.
class Wardrobe : public QObject {
 public:
  static Wardrobe& instance() {
    static QPointer<Wardrobe> wardrobe;
    if (!wardrobe) wardrobe = new Wardrobe(qApp);
    return *wardrobe;
  }

  /// `resizes`: what they measure, too.
  void dressAll(bool resizes) {
    resizes_ = resizes_ || resizes;
    hidden_.clear();
    shown_.clear();
    for (QWidget* top : QApplication::topLevelWidgets()) {
      if (top->isVisible()) {
        letWait(top);
      } else if (!top->parentWidget()) {
        hidden_.emplace_back(top);
      }
    }
    dressSomeShown();
    qApp->installEventFilter(this);
    soon_.start();
  }

  [[nodiscard]] bool isShownFinished() const { return windows_.empty() && shown_.empty() && dressed_.empty(); }

  void finishShown() {
    while (takeTurn()) {
    }
  }

  bool eventFilter(QObject* object, QEvent* event) override {
    if (event->type() != QEvent::Show || !object->isWidgetType()) return false;
    const auto waiting = std::find(hidden_.begin(), hidden_.end(), object);
    if (waiting == hidden_.end()) return false;
    hidden_.erase(waiting);
    dressShown(qobject_cast<QWidget*>(object));
    return false;
  }

 private:
  explicit Wardrobe(QObject* parent) : QObject(parent) {
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &Wardrobe::dressSome);
  }

  /// Until its turn comes it stays as it was, instead of being drawn with half of the new colours.
  void letWait(QWidget* window) {
    window->setUpdatesEnabled(false);
    const auto waiting = std::find(windows_.begin(), windows_.end(), window);
    if (waiting != windows_.end()) windows_.erase(waiting);
    // The one in front is the next.
    windows_.insert(window == QApplication::activeWindow() ? windows_.end() : windows_.begin(), window);
  }

  /// A part of the window whose turn it is; false if there is none.
  bool dressSomeShown() {
    constexpr qint64 kTurn_ms = 25;
    if (shown_.empty()) {
      if (windows_.empty()) return false;
      window_ = windows_.back();
      windows_.pop_back();
      shown_.push_back(window_);
    }
    QElapsedTimer turn;
    turn.start();
    while (!shown_.empty() && turn.elapsed() < kTurn_ms) {
      const QPointer<QWidget> widget = shown_.back();
      shown_.pop_back();
      if (widget) dressAlone(widget, shown_);
    }
    if (shown_.empty() && window_) dressed_.push_back(window_);
    return true;
  }

  bool letDressedBePainted() {
    if (dressed_.empty()) return false;
    for (const QPointer<QWidget>& window : std::exchange(dressed_, {})) {
      if (window) window->setUpdatesEnabled(true);
    }
    return true;
  }

  /// False when every window that is shown is dressed and may be painted.
  bool takeTurn() { return letDressedBePainted() || dressSomeShown(); }

  void dress(QWidget* widget) const {
    widget->style()->polish(widget);
    if (resizes_) {
      QEvent change(QEvent::StyleChange);
      QCoreApplication::sendEvent(widget, &change);
    }
    widget->update();
  }

  static QList<QWidget*> inside(const QWidget* widget) {
    return widget->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly);
  }

  /// Not what is inside of it: that is for the next.
  void dressAlone(QWidget* widget, std::vector<QPointer<QWidget>>& next) {
    if (!widget->isVisible()) {
      hidden_.emplace_back(widget);
      return;
    }
    dress(widget);
    for (QWidget* inner : inside(widget)) {
      if (!inner->isWindow() || !inner->isVisible()) next.emplace_back(inner);
    }
  }

  void dressShown(QWidget* window) {
    std::vector<QPointer<QWidget>> shown = {window};
    while (!shown.empty()) {
      const QPointer<QWidget> widget = shown.back();
      shown.pop_back();
      if (widget) dressAlone(widget, shown);
    }
  }

  void dressSome() {
    constexpr qint64 kTurn_ms = 5;
    QElapsedTimer turn;
    turn.start();
    if (takeTurn()) {
      soon_.start();
      return;
    }
    while (!hidden_.empty() && turn.elapsed() < kTurn_ms) {
      const QPointer<QWidget> widget = hidden_.back();
      hidden_.pop_back();
      if (!widget) continue;
      dress(widget);
      for (QWidget* inner : inside(widget)) hidden_.emplace_back(inner);
    }
    if (hidden_.empty()) {
      resizes_ = false;
      qApp->removeEventFilter(this);
    } else {
      soon_.start();
    }
  }

  QTimer soon_;
  std::vector<QPointer<QWidget>> windows_;  ///< shown, and waiting for their turns
  QPointer<QWidget> window_;                ///< the one whose turn it is
  std::vector<QPointer<QWidget>> shown_;    ///< of its widgets those that wait
  std::vector<QPointer<QWidget>> dressed_;  ///< and waiting to be painted
  std::vector<QPointer<QWidget>> hidden_;
  bool resizes_ = false;
};

/// A sheet's rules about sizes: all but the colours and the pictures that have them.
QString withoutColors(QString sheet) {
  static const QRegularExpression kColor(QStringLiteral("#[0-9a-fA-F]{6}|url\\([^)]*\\)"));
  return sheet.remove(kColor);
}

/// In the order of ThemeChoice.
const QStringList kThemeChoices = {QStringLiteral("system"), QStringLiteral("light"), QStringLiteral("dark")};

Theme& knownSystemTheme() {
  static Theme theme = systemTheme();
  return theme;
}

}  // namespace

QString themeChoiceName(ThemeChoice choice) { return kThemeChoices.at(static_cast<int>(choice)); }

std::optional<ThemeChoice> themeChoiceFromName(const QString& name) {
  const auto at = kThemeChoices.indexOf(name);
  return at < 0 ? std::nullopt : std::optional(static_cast<ThemeChoice>(at));
}

Theme resolveTheme(ThemeChoice choice) {
  if (choice == ThemeChoice::System) return knownSystemTheme();  // which asks the desktop the first time
  return choice == ThemeChoice::Dark ? Theme::Dark : Theme::Light;
}

void setSystemTheme(Theme theme) { knownSystemTheme() = theme; }

void installStyle() { QApplication::setStyle(new WindowStyle); }

void applyTheme(Theme theme) {
  const QString sheet = styleSheet(theme) + panelSheet(Colors::of(theme));
  const QString before = qApp->styleSheet();
  if (before == sheet) return;
  QApplication::setPalette(qtPalette(theme));
  if (before.isEmpty()) {
    qApp->setStyleSheet(sheet);
    return;
  }
  // Left to setStyleSheet(), every widget would be dressed once for itself and once for each widget that it is in. It
  // dresses those whose rules it remembers, so it is made to forget them all.
  qApp->style()->unpolish(qApp);
  qApp->setStyleSheet(sheet);
  const bool resizes = withoutColors(before) != withoutColors(sheet);
  Wardrobe::instance().dressAll(resizes);
}

bool isThemeFinished() { return Wardrobe::instance().isShownFinished(); }

void finishTheme() { Wardrobe::instance().finishShown(); }

}  // namespace hexoderm
