#pragma once

// A panel as the window shows it: in a column that scrolls, with the application's style.

#include "tests/support/app_theme.h"
#include "tests/support/kept_picture.h"
#include "tests/support/qt_text.h"
#include "tests/support/qt_wait.h"
#include "widgets/controls/selection.h"

#include <gmock/gmock.h>
#include <QScrollArea>

namespace hexoderm::test {

/// `Panel` is made of a Selection.
template <class Panel>
class PanelOnScreen : public testing::Test {
 protected:
  explicit PanelOnScreen(const QSize& size) {
    scroll_.setWidget(panel_);
    scroll_.setWidgetResizable(true);
    scroll_.resize(size);
    scroll_.show();
    EXPECT_TRUE(waitUntilExposed(scroll_));
  }
  template <class T>
  T* find(const char* name) {
    T* found = panel_->template findChild<T*>(QLatin1String(name));
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  void keep(const QString& name) { keepPicture(panel_->grab().toImage(), name); }

  AppTheme theme_;
  Selection selection_;
  QScrollArea scroll_;
  Panel* panel_ = new Panel(&selection_);
};

}  // namespace hexoderm::test
