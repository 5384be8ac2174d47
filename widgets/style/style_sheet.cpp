#include "widgets/style/palette.h"

#include <QApplication>
#include <QFont>
#include <QFontInfo>
#include <array>
#include <utility>

/// A static library's resources have to be asked for, and from outside of any namespace.
static void initStyleResources() { Q_INIT_RESOURCE(widgets_style); }

namespace hexoderm {
namespace {

/// Names between @ are replaced. Widgets choose a part by a property: card, banner, primary, flat, caption, muted,
/// tone.
constexpr const char* kStyleSheet = R"(
@font@
QMainWindow, QDialog { background: @window@; }
QMainWindow::separator { background: @window@; width: 8px; height: 8px; }
QFrame[card="true"] { background: @panel@; border: 1px solid @border@; border-radius: 6px; }
QFrame[notice="true"] { background: @panel@; border: 1px solid @text_muted@; border-radius: 6px; }
QFrame[banner="true"] { background: @panel@; border: 0; border-bottom: 1px solid @border@; }
QDockWidget { color: @text_muted@; }
QDockWidget::title { background: @window@; padding: 4px 8px; text-align: left; }

QLabel { background: transparent; }
QLabel[muted="true"] { color: @text_muted@; }
QLabel[caption="true"] { color: @text_muted@; font-size: @small@pt; letter-spacing: 1px; }
QLabel[headline="true"] { font-size: @large@pt; font-weight: 600; }
QLabel[tone="neutral"] { color: @text_muted@; }
QLabel[tone="good"] { color: @good@; }
QLabel[tone="caution"] { color: @caution@; }
QLabel[tone="bad"] { color: @bad@; }
QLabel[dot="true"] { background: @text_muted@; border-radius: 7px; }
QLabel[dot="true"][tone="good"] { background: @good@; }
QLabel[dot="true"][tone="caution"] { background: @caution@; }
QLabel[dot="true"][tone="bad"] { background: @bad@; }

QMenuBar { background: @panel@; border-bottom: 1px solid @border@; padding: 3px 5px; }
QMenuBar::item { background: transparent; color: @text_muted@; padding: 4px 9px; border-radius: 4px; }
QMenuBar::item:selected, QMenuBar::item:pressed { background: @panel_active@; color: @text@; }
QMenu { background: @panel@; border: 1px solid @border@; padding: 4px; }
QMenu::item { padding: 5px 26px 5px 22px; border-radius: 4px; }
QMenu::item:selected { background: @hover@; }
QMenu::item:disabled { color: @disabled@; }
QMenu::separator { height: 1px; background: @border@; margin: 4px 6px; }
QStatusBar { background: @panel@; border-top: 1px solid @border@; color: @text_muted@; }
QStatusBar::item { border: 0; }
QStatusBar QLabel { color: @text_muted@; }
QToolTip { background: @panel@; color: @text@; border: 1px solid @border@; padding: 5px 7px; }

QPushButton, QToolButton { background: @panel@; color: @text@; border: 1px solid @border@; border-radius: 4px;
                           padding: 5px 11px; }
QPushButton:hover, QToolButton:hover { background: @hover@; }
QPushButton:pressed, QToolButton:pressed, QToolButton:checked { background: @pressed@; }
QPushButton:focus, QToolButton:focus { border: 2px solid @accent@; padding: 4px 10px; }
QPushButton:disabled, QToolButton:disabled { color: @disabled@; }
QToolButton[flat="true"], QPushButton[flat="true"] { background: transparent; border-color: transparent; }
QToolButton[flat="true"]:hover, QPushButton[flat="true"]:hover { background: @hover@; }
QToolButton[flat="true"]:focus, QPushButton[flat="true"]:focus { border-color: @accent@; }
QToolButton::menu-indicator { image: none; }
/* Qt's own, of a size that fits their pictures. */
QFileDialog QToolButton { padding: 2px; }
QFileDialog QToolButton:focus { padding: 1px; }
QPushButton[primary="true"] { background: @accent@; color: @accent_text@; border: 1px solid @accent@;
                              border-radius: 5px; padding: 8px 15px; font-weight: 600; }
QPushButton[primary="true"]:hover { background: @accent_hover@; border-color: @accent_hover@; }
QPushButton[primary="true"]:pressed { background: @accent_pressed@; border-color: @accent_pressed@; }
QPushButton[primary="true"]:focus { border: 2px solid @text@; padding: 7px 14px; }
QPushButton[primary="true"]:disabled { background: @pressed@; color: @disabled@; border-color: @border@; }

QComboBox { background: @panel@; color: @text@; border: 1px solid @border@; border-radius: 4px; padding: 4px 9px; }
QComboBox:hover { background: @hover@; }
QComboBox:focus { border-color: @accent@; }
QComboBox:disabled { color: @disabled@; }
QComboBox::drop-down { border: 0; width: 20px; }
QComboBox::down-arrow { image: url(:/hexoderm/style/chevron-down.svg); width: 10px; height: 10px; }
QAbstractSpinBox { background: @panel@; color: @text@; border: 1px solid @border@; border-radius: 4px;
                   padding: 4px 6px; selection-background-color: @accent@; selection-color: @accent_text@; }
QAbstractSpinBox:hover { background: @hover@; }
QAbstractSpinBox:focus { border-color: @accent@; }
QAbstractSpinBox:disabled { color: @disabled@; }
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button { subcontrol-origin: border; width: 20px; border: 0;
                                                             background: transparent; }
QAbstractSpinBox::up-button { subcontrol-position: top right; }
QAbstractSpinBox::down-button { subcontrol-position: bottom right; }
QAbstractSpinBox::up-arrow { image: url(:/hexoderm/style/chevron-up.svg); width: 9px; height: 9px; }
QAbstractSpinBox::down-arrow { image: url(:/hexoderm/style/chevron-down.svg); width: 9px; height: 9px; }
QCheckBox { spacing: 7px; }
QCheckBox::indicator { width: 14px; height: 14px; border: 1px solid @text_muted@; border-radius: 3px;
                       background: @panel@; }
QCheckBox::indicator:checked { background: @accent@; border-color: @accent@; image: url(@check@); }
QCheckBox::indicator:focus { border: 2px solid @text@; }
QCheckBox:disabled { color: @disabled@; }

QLineEdit, QPlainTextEdit, QTextEdit { background: @panel@; border: 1px solid @border@;
    border-radius: 4px; padding: 4px 7px; selection-background-color: @accent@; selection-color: @accent_text@; }
QLineEdit:focus, QPlainTextEdit:focus, QTextEdit:focus { border-color: @accent@; }

QAbstractItemView { background: @panel@; border: 0; outline: 0; }
QTableView { gridline-color: transparent; selection-background-color: @panel_active@; selection-color: @text@;
             border: 1px solid transparent; }
QTableView:focus { border-color: @accent@; }
QTableView::item { border: 0; border-bottom: 1px solid @border@; padding: 4px 3px; }
QTableView::item:hover { background: @hover@; color: @text@; }
QTableView::item:focus { background: @hover@; color: @text@; }
QTableView::item:selected { background: @panel_active@; color: @text@; border-top: 1px solid @selection@;
                            border-bottom: 1px solid @selection@; }
QHeaderView { background: @panel@; border: 0; }
QHeaderView::section { background: @panel@; color: @text_muted@; border: 0; border-bottom: 1px solid @border@;
                       padding: 4px 6px; font-weight: 400; }
QTableView#poseView::item { padding: 3px 1px; }
QTableView#poseView QHeaderView::section { padding: 4px 4px; }
QTableView#poseView QHeaderView::section:vertical { padding: 1px; }
QTableCornerButton::section { background: @panel@; border: 0; }

QTabWidget::pane { border: 0; }
QTabBar { background: transparent; font-weight: 600; }
QTabBar::tab { background: transparent; color: @text_muted@; font-weight: 400; border: 0;
               border-bottom: 2px solid transparent; padding: 4px 4px; margin: 2px 5px; }
QTabBar::tab:hover { color: @text@; }
QTabBar::tab:selected { color: @text@; font-weight: 600; border-bottom-color: @accent@; }
QTabBar::tab:focus { color: @accent@; }
QTabBar::scroller { width: 24px; }
QTabBar QToolButton { background: @panel@; border-color: transparent; padding: 0; }
QTabBar QToolButton::left-arrow { image: url(:/hexoderm/style/chevron-left.svg); width: 10px; height: 10px; }
QTabBar QToolButton::right-arrow { image: url(:/hexoderm/style/chevron-right.svg); width: 10px; height: 10px; }

QAbstractScrollArea::corner { background: transparent; border: 0; }
QScrollBar { background: transparent; border: 0; }
QScrollBar:vertical { width: 10px; }
QScrollBar:horizontal { height: 10px; }
QScrollBar::handle { background: @handle@; border-radius: 3px; margin: 2px; }
QScrollBar::handle:vertical { min-height: 28px; }
QScrollBar::handle:horizontal { min-width: 28px; }
QScrollBar::handle:hover { background: @text_muted@; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QSplitter::handle { background: transparent; }
QwtScaleWidget { color: @text_muted@; }
QProgressBar { background: @border@; border: 0; border-radius: 3px; max-height: 6px; }
QProgressBar::chunk { background: @accent@; border-radius: 3px; }
)";

QColor mixed(const QColor& a, const QColor& b, double part) {
  const auto mix = [part](int from, int to) { return static_cast<int>(from + part * (to - from) + 0.5); };
  return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

}  // namespace

QString styleSheet(Theme theme) {
  initStyleResources();
  const Colors& colors = Colors::of(theme);
  QString sheet = QString::fromUtf8(kStyleSheet);
  const std::array<std::pair<const char*, QColor>, 18> named = {{
      {"window", colors.window},
      {"panel", colors.panel},
      {"panel_active", colors.panel_active},
      {"border", colors.border},
      {"text", colors.text},
      {"text_muted", colors.text_muted},
      {"accent", colors.accent},
      {"accent_text", colors.accent_text},
      {"good", colors.good},
      {"caution", colors.caution},
      {"bad", colors.bad},
      {"selection", colors.selection},
      {"hover", mixed(colors.panel, colors.text, 0.05)},
      {"pressed", mixed(colors.panel, colors.text, 0.12)},
      {"disabled", mixed(colors.text_muted, colors.panel, 0.4)},
      {"handle", mixed(colors.border, colors.text_muted, 0.3)},
      {"accent_hover", mixed(colors.accent, colors.text, 0.15)},
      {"accent_pressed", mixed(colors.accent, colors.text, 0.3)},
  }};
  for (const auto& [name, color] : named) sheet.replace(QStringLiteral("@%1@").arg(QLatin1String(name)), color.name());

  sheet.replace(QStringLiteral("@check@"),
                QStringLiteral(":/hexoderm/style/check-on-%1.svg")
                    .arg(theme == Theme::Dark ? QLatin1String("dark") : QLatin1String("light")));

  // Sizes follow the system's; the family is Inter where it is installed.
  double points = 10;
  QString font_rule;
  if (qApp != nullptr) {
    const QFont font = QApplication::font();
    if (font.pointSizeF() > 0) points = font.pointSizeF();
    if (QFontInfo(QFont(QStringLiteral("Inter"))).family() == QLatin1String("Inter")) {
      font_rule = QStringLiteral("QWidget, QToolTip { font-family: \"Inter\"; }");
    }
  }
  sheet.replace(QStringLiteral("@font@"), font_rule);
  sheet.replace(QStringLiteral("@small@"), QString::number(0.88 * points, 'f', 1));
  sheet.replace(QStringLiteral("@large@"), QString::number(1.2 * points, 'f', 1));
  return sheet;
}

}  // namespace hexoderm
