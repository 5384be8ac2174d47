#pragma once

#include "widgets/controls/elided_label.h"
#include "widgets/controls/panel_parts.h"

#include <QDockWidget>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <QVariant>

namespace hexoderm {

/// A panel that can be moved: a card with a small heading on the left and a remark on the right.
class CardDock : public QDockWidget {
  Q_OBJECT

 public:
  /// `object_name` names the dock where the layout is remembered. Takes over `content`.
  CardDock(const QString& heading, const QString& object_name, QWidget* content, QWidget* parent = nullptr)
      : QDockWidget(heading, parent), title_(styledAs(new QLabel(heading.toUpper()), "caption")) {
    setNames(this, object_name, heading);
    content->setAccessibleName(heading);
    // The heading is inside the card, so that a dock looks like one thing; it is still what one drags.
    auto* bar = styledAs(new QFrame, "cardHead");
    remark_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    remark_->hide();
    auto* head = spaced(new QHBoxLayout(bar), {13, 9, 13, 5});
    head->addWidget(title_);
    head->addStretch(1);
    head->addWidget(remark_, 100);  // all that is there, before the stretch has any
    bar->setToolTip(tr("Drag to move this panel, double-click to take it out of the window"));
    setTitleBarWidget(bar);

    auto* body = styledAs(new QFrame, "cardBody");
    auto* layout = spaced(new QVBoxLayout(body), {1, 0, 1, 1});
    layout->addWidget(content);
    setWidget(body);
  }

  /// Sets the heading, for docks whose content changes.
  void setHeading(const QString& heading) {
    setWindowTitle(heading);
    setAccessibleName(heading);
    title_->setText(heading.toUpper());
  }

  /// Never widens the dock: it ends in dots where it finds no room.
  void setRemark(const QString& remark) { showIfAny(remark_, remark); }

  /// Shows `widget`, for example tabs, in the place of the heading.
  void setHead(QWidget* widget) {
    auto* head = qobject_cast<QHBoxLayout*>(titleBarWidget()->layout());
    head->insertWidget(0, widget);
    head->setContentsMargins(5, 5, 5, 0);
    title_->hide();
  }

 private:
  QLabel* title_;
  ElidedLabel* remark_ = styledAs(new ElidedLabel, "muted");
};

}  // namespace hexoderm
