#pragma once

#include "app/window/files/recent_files.h"
#include "app/window/files/recovery.h"
#include "app/window/guide/actions.h"
#include "widgets/controls/action_button.h"
#include "widgets/controls/panel_parts.h"

#include <QAction>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <vector>

namespace hexoderm {

/// The middle of the window as long as nothing is open: ways to begin, recent files, and sessions that were not saved.
class WelcomePanel : public QScrollArea {
  Q_OBJECT

 public:
  /// A button each, the first one being the one that stands out. All must outlive the panel.
  WelcomePanel(const std::vector<QAction*>& choices, RecentFiles& recent, UnsavedSessions& unsaved,
               QWidget* parent = nullptr)
      : QScrollArea(parent) {
    setNames(this, QStringLiteral("welcomePanel"), tr("Welcome"));
    scrollPlainly(this);
    auto* column = new QWidget;
    column->setMaximumWidth(kWidestInCharacters * fontMetrics().averageCharWidth());
    auto* list = spaced(new QVBoxLayout(column), {0, 0, 0, 0}, 6);
    list->addWidget(makeLabel(tr("Where is every cell of your skin?"), "headline"));
    list->addWidget(makeLabel(tr("Hold the part still in a few poses; Hexoderm finds out from gravity."), "muted"));
    list->addSpacing(14);
    list->addWidget(new RecoveryList(unsaved));
    auto* rows = new QGridLayout;
    rows->setHorizontalSpacing(14);
    rows->setVerticalSpacing(6);
    rows->setColumnStretch(0, 2);
    rows->setColumnStretch(1, 3);
    list->addLayout(rows);
    for (QAction* action : choices) {
      auto* button = new ActionButton(column);
      button->setAction(action);
      button->setFocusPolicy(Qt::StrongFocus);
      if (action == choices.front()) button->setProperty("primary", true);
      auto* purpose = makeLabel(WindowActions::purposeOf(*action), "muted");
      const int row = rows->rowCount();
      button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
      rows->addWidget(button, row, 0);
      rows->addWidget(purpose, row, 1);
    }
    list->addSpacing(18);
    list->addWidget(makeLabel(tr("Recent").toUpper(), "caption"));
    auto* recent_list = new RecentList(recent, kRecentShown, kTitleCharacters);
    connect(recent_list, &RecentList::openWanted, this, &WelcomePanel::openWanted);
    list->addWidget(recent_list);
    list->addStretch(1);

    auto* content = named(new QWidget, "welcomeContent");
    auto* sides = spaced(new QHBoxLayout(content), {28, 36, 28, 24});
    sides->addStretch(1);
    sides->addWidget(column, 100);
    sides->addStretch(1);
    // It scrolls up and down only: texts are broken where they would be wider.
    content->setMinimumWidth(1);
    setWidget(content);
  }

 signals:
  void openWanted(const QString& path);

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QScrollArea::resizeEvent(event);
    // Beside each button stands what it is for.
    for (ActionButton* button : findChildren<ActionButton*>()) button->setRoom(viewport()->width() * 45 / 100);
  }

 private:
  static constexpr int kWidestInCharacters = 74;
  static constexpr std::size_t kRecentShown = 5;
  static constexpr int kTitleCharacters = 34;
  static QLabel* makeLabel(const QString& text, const char* look) {
    auto* label = new QLabel(text);
    label->setWordWrap(true);
    label->setProperty(look, true);
    return label;
  }
};

}  // namespace hexoderm
