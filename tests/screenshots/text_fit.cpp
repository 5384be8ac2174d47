#include "tests/screenshots/text_fit.h"

#include "widgets/controls/action_button.h"
#include "widgets/controls/elided_label.h"
#include "widgets/controls/notice_stack.h"
#include "widgets/controls/view_mark.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QStringList>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QWidget>
#include <algorithm>
#include <vector>

namespace hexoderm {
namespace {

constexpr int kSlack_px = 1;  // styles round

class Finder {
 public:
  QStringList found;

  void look(const QWidget& widget) {
    if (!widget.isVisible() || widget.size().isEmpty()) return;
    // Of a panel behind another one's tab Qt sees nothing either, and a bar of tabs that it keeps in store lies
    // beneath.
    if (widget.inherits("QDockWidget") && widget.visibleRegion().isEmpty()) return;
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) lookAt(*label);
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) lookAt(*button);
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget)) lookAt(*tabs);
    if (const auto* header = qobject_cast<const QHeaderView*>(&widget)) lookAt(*header);
    if (const auto* menu = qobject_cast<const QMenuBar*>(&widget)) lookAt(*menu);
    if (const auto* combo = qobject_cast<const QComboBox*>(&widget)) lookAt(*combo);
    if (const auto* group = qobject_cast<const QGroupBox*>(&widget)) {
      need(widget, group->title(), widget.fontMetrics().horizontalAdvance(group->title()), widget.width());
    }
    if (widget.property("textIsCut").toBool()) {
      add(widget, widget.accessibleName(), QStringLiteral("says so itself"));
    }
    for (const QObject* child : widget.children()) {
      const auto* part = qobject_cast<const QWidget*>(child);
      if (part != nullptr && !part->isWindow()) look(*part);
    }
  }

 private:
  static QString placeOf(const QWidget& widget) {
    QStringList names{QLatin1String(widget.metaObject()->className())};
    for (const QWidget* at = &widget; at != nullptr; at = at->parentWidget()) {
      if (!at->objectName().isEmpty()) names.prepend(at->objectName());
      if (at->isWindow()) break;
    }
    return names.join(QLatin1Char('/'));
  }

  void add(const QWidget& widget, const QString& text, const QString& how) {
    found << QStringLiteral("\"%1\" %2 (%3)").arg(text, how, placeOf(widget));
  }
  void need(const QWidget& widget, const QString& text, int needed_px, int there_px, const char* side = "width") {
    if (needed_px <= there_px + kSlack_px) return;
    add(widget, text,
        QStringLiteral("needs %1 px, has %2 px in %3").arg(needed_px).arg(there_px).arg(QLatin1String(side)));
  }

  void needSize(const QWidget& widget, const QString& text, const QSize& size) {
    need(widget, text, size.width(), widget.width());
    need(widget, text, size.height(), widget.height(), "height");
    lookForTheEdge(widget, text);
  }

  /// A part that lies beyond its parent is not seen, unless it can be scrolled to.
  void lookForTheEdge(const QWidget& widget, const QString& text) {
    QRect rect = widget.rect();
    const QWidget* at = &widget;
    while (!at->isWindow() && at->parentWidget() != nullptr) {
      rect.translate(at->pos());
      at = at->parentWidget();
      const auto* area = qobject_cast<const QAbstractScrollArea*>(at->parentWidget());
      if (area != nullptr && area->viewport() == at) return;
      if (rect.right() > at->width() - 1 + kSlack_px || rect.bottom() > at->height() - 1 + kSlack_px ||
          rect.left() < -kSlack_px || rect.top() < -kSlack_px) {
        add(widget, text, QStringLiteral("hangs over the edge of ") + placeOf(*at));
        return;
      }
    }
  }

  void lookAt(const QLabel& label) {
    if (label.text().isEmpty()) return;
    if (label.property(ElidedLabel::kElides).toBool()) {
      lookForTheEdge(label, label.text());
      return;
    }
    const bool wraps = label.wordWrap();
    needSize(label, label.text(),
             {(wraps ? label.minimumSizeHint() : label.sizeHint()).width(),
              wraps ? label.heightForWidth(label.width()) : label.sizeHint().height()});
  }

  void lookAt(const QAbstractButton& button) {
    if (button.text().isEmpty()) return;
    if (const auto* action = qobject_cast<const ActionButton*>(&button)) {
      return needSize(button, button.text(), action->sizeHint());  // it breaks its text into lines
    }
    // The hint has room to spare at the sides; what counts is the text and the style's own margins.
    const int text_px = button.fontMetrics().size(Qt::TextShowMnemonic, button.text()).width();
    const int icon_px = button.icon().isNull() ? 0 : button.iconSize().width();
    needSize(button, button.text(),
             {std::min(button.sizeHint().width(), text_px + icon_px + 8), button.fontMetrics().height()});
  }

  void lookAt(const QTabBar& tabs) {
    if (tabs.visibleRegion().isEmpty()) return;
    for (int k = 0; k < tabs.count(); ++k) {
      if (!tabs.isTabVisible(k)) continue;
      const QString text = tabs.tabText(k);
      need(tabs, text, tabs.fontMetrics().size(Qt::TextShowMnemonic, text).width(), tabs.tabRect(k).width());
      // Tabs beyond the edge are reached by the arrows beside them.
      if (!tabs.usesScrollButtons()) need(tabs, text, tabs.tabRect(k).right() + 1, tabs.width());
    }
  }

  void lookAt(const QHeaderView& header) {
    if (header.model() == nullptr || header.orientation() != Qt::Horizontal) return;
    for (int k = 0; k < header.count(); ++k) {
      const int left = header.sectionViewportPosition(k);
      if (header.isSectionHidden(k) || left < 0 || left + header.sectionSize(k) > header.viewport()->width()) continue;
      const QString text = header.model()->headerData(k, Qt::Horizontal).toString();
      need(header, text, header.sectionSizeHint(k), header.sectionSize(k));
    }
  }

  void lookAt(const QMenuBar& menu) {
    for (const QAction* action : menu.actions()) {
      if (!action->isVisible()) continue;
      const QRect place = menu.actionGeometry(const_cast<QAction*>(action));
      if (place.isEmpty() || place.right() >= menu.width()) {
        add(menu, action->text(), QStringLiteral("has no room in the menu bar"));
      }
    }
  }

  void lookAt(const QComboBox& combo) {
    if (combo.window()->inherits("QFileDialog")) return;  // Qt's own
    QStyleOptionComboBox option;
    option.initFrom(&combo);
    option.editable = combo.isEditable();
    const QRect field =
        combo.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &combo);
    if (!combo.isEditable()) {
      need(combo, combo.currentText(), combo.fontMetrics().horizontalAdvance(combo.currentText()), field.width());
    }
  }
};

struct ShownText {
  const QWidget* widget;
  QString text;
  QRect place;  ///< in the root, as far as it is seen
};

QString textOf(const QWidget& widget) {
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) return label->text();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return button->text();
  if (const auto* combo = qobject_cast<const QComboBox*>(&widget)) return combo->currentText();
  if (const auto* spin = qobject_cast<const QAbstractSpinBox*>(&widget)) return spin->text();
  if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) return line->text();
  return {};
}

/// `seen`: what the widgets around it leave of it, in the root.
void collectTexts(const QWidget& widget, const QPoint& at, const QRect& seen, std::vector<ShownText>& texts) {
  if (!widget.isVisible() || qobject_cast<const NoticeStack*>(&widget) || qobject_cast<const ViewMark*>(&widget))
    return;
  const QRect place = QRect(at, widget.size()) & seen;
  if (place.isEmpty()) return;
  const QString text = textOf(widget);
  if (!text.isEmpty()) {
    texts.push_back({&widget, text, place});
    return;
  }
  for (const QObject* child : widget.children()) {
    const auto* part = qobject_cast<const QWidget*>(child);
    if (part != nullptr && !part->isWindow()) collectTexts(*part, at + part->pos(), place, texts);
  }
}

}  // namespace

QStringList findOverlaps(const QWidget& root) {
  std::vector<ShownText> texts;
  collectTexts(root, QPoint(0, 0), root.rect(), texts);
  constexpr int kSlackEach_px = 2;  // frames may touch
  QStringList found;
  for (std::size_t a = 0; a < texts.size(); ++a) {
    for (std::size_t b = a + 1; b < texts.size(); ++b) {
      const QRect both = texts[a].place & texts[b].place;
      if (both.width() > kSlackEach_px && both.height() > kSlackEach_px) {
        found << QStringLiteral("\"%1\" lies over \"%2\"").arg(texts[b].text, texts[a].text);
      }
    }
  }
  return found;
}

QStringList findSidewaysScrolling(const QWidget& root) {
  QStringList found;
  for (const auto* area : root.findChildren<QScrollArea*>()) {
    if (area->isVisible() && area->horizontalScrollBar()->isVisible()) found << area->objectName();
  }
  return found;
}

QStringList findCutTexts(const QWidget& root) {
  Finder finder;
  finder.look(root);
  return finder.found;
}

}  // namespace hexoderm
