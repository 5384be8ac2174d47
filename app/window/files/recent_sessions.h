#pragma once

#include "app/window/files/recent_files.h"
#include "app/window/files/recovery.h"
#include "widgets/controls/panel_parts.h"

#include <QLabel>
#include <QVBoxLayout>
#include <QVariant>
#include <QWidget>

namespace hexoderm {

/// The sessions of earlier times, for the step Connect: those that were not saved, and the newest of the recent files.
class RecentSessions : public QWidget {
  Q_OBJECT

 public:
  /// Both outlive the panel.
  RecentSessions(RecentFiles& recent, UnsavedSessions& unsaved, QWidget* parent = nullptr) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 8, 0, 0);
    layout->addWidget(new RecoveryList(unsaved));
    auto* title = styledAs(new QLabel(tr("Recent").toUpper()), "caption");
    layout->addWidget(title);
    constexpr std::size_t kShown = 3;
    constexpr int kTitleCharacters = 22;
    auto* list = new RecentList(recent, kShown, kTitleCharacters);
    connect(list, &RecentList::openWanted, this, &RecentSessions::openWanted);
    layout->addWidget(list);
  }

 signals:
  void openWanted(const QString& path);
};

}  // namespace hexoderm
