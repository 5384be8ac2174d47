#include "app/window/settings/theme.h"
#include "tests/support/qt_wait.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>

namespace hexoderm {
namespace {

/// Counts how often each widget is made to look like itself.
class CountingStyle : public QProxyStyle {
 public:
  CountingStyle() : QProxyStyle("Fusion") {}
  using QProxyStyle::polish;
  void polish(QWidget* widget) override {
    ++times[widget];
    QProxyStyle::polish(widget);
  }
  std::map<const QWidget*, int> times;
};

TEST(ThemeTest, AChangeDressesAWidgetOnceHoweverDeepItIsInOthers) {
  auto* style = new CountingStyle;
  QApplication::setStyle(style);
  applyTheme(Theme::Light);
  QWidget window;
  QWidget* inner = &window;
  for (int depth = 0; depth < 8; ++depth) {
    auto* outer = inner;
    inner = new QFrame(outer);
    (new QVBoxLayout(outer))->addWidget(inner);
  }
  auto* label = new QLabel("deep", inner);
  label->setProperty("muted", true);
  window.show();
  ASSERT_TRUE(test::waitUntilExposed(window));

  style->times.clear();
  applyTheme(Theme::Dark);
  EXPECT_EQ(style->times[label], 1);
  EXPECT_EQ(style->times[&window], 1);
  EXPECT_EQ(label->palette().color(QPalette::WindowText), Colors::of(Theme::Dark).text_muted);
  // The same theme again is no change.
  applyTheme(Theme::Dark);
  EXPECT_EQ(style->times[label], 1);
  installStyle();
}

/// A little of everything that the style sheet dresses.
std::unique_ptr<QWidget> makeParts() {
  auto window = std::make_unique<QWidget>();
  auto* layout = new QVBoxLayout(window.get());
  for (const char* property : {"muted", "caption", "headline", "hint"}) {
    auto* label = new QLabel(QLatin1String(property));
    label->setProperty(property, true);
    layout->addWidget(label);
  }
  auto* card = new QFrame;
  card->setProperty("card", true);
  auto* card_layout = new QVBoxLayout(card);
  auto* primary = new QPushButton("Go on");
  primary->setProperty("primary", true);
  auto* disabled = new QPushButton("Not now");
  disabled->setEnabled(false);
  auto* choice = new QComboBox;
  choice->addItem("one of many");
  auto* check = new QCheckBox("checked");
  check->setChecked(true);
  auto* table = new QTableWidget(3, 2);
  table->setHorizontalHeaderLabels({"first", "second"});
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  for (int row = 0; row < 3; ++row) table->setItem(row, 0, new QTableWidgetItem("text"));
  table->selectRow(1);
  for (QWidget* part :
       {static_cast<QWidget*>(primary), static_cast<QWidget*>(disabled), static_cast<QWidget*>(choice),
        static_cast<QWidget*>(check), static_cast<QWidget*>(new QLineEdit("typed")), static_cast<QWidget*>(table)}) {
    part->setFocusPolicy(Qt::NoFocus);
    card_layout->addWidget(part);
  }
  layout->addWidget(card);
  window->resize(360, 520);
  return window;
}

QImage pictureOf(QWidget& window) {
  window.show();
  EXPECT_TRUE(test::waitUntilExposed(window));
  QImage picture = window.grab().toImage();
  window.hide();
  return picture;
}

TEST(ThemeTest, WhatWasThereBeforeAChangeLooksLikeWhatIsMadeAfterIt) {
  installStyle();
  applyTheme(Theme::Dark);
  applyTheme(Theme::Light);
  const std::unique_ptr<QWidget> before = makeParts();
  const QImage light = pictureOf(*before);
  applyTheme(Theme::Dark);
  const std::unique_ptr<QWidget> after = makeParts();
  const QImage dark = pictureOf(*before);
  EXPECT_NE(dark, light);
  EXPECT_EQ(dark, pictureOf(*after));
  applyTheme(Theme::Light);
  EXPECT_EQ(pictureOf(*before), light);
  EXPECT_EQ(pictureOf(*after), light);
}

TEST(ThemeTest, WhatIsHiddenIsDressedAfterwardsToo) {
  applyTheme(Theme::Light);
  const std::unique_ptr<QWidget> parts = makeParts();
  const QImage shown_once = pictureOf(*parts);
  const auto* label = parts->findChild<QLabel*>();
  const auto text = [label] { return label->palette().color(QPalette::WindowText); };
  const QColor light = text();
  applyTheme(Theme::Dark);
  EXPECT_EQ(text(), light) << "nobody waits for what nobody sees";
  EXPECT_TRUE(test::waitUntil([&] { return text() != light; }));
  applyTheme(Theme::Light);
  EXPECT_TRUE(test::waitUntil([&] { return text() == light; }));
}

TEST(ThemeTest, LargerTextMakesRoomForItselfInWhatIsThere) {
  applyTheme(Theme::Light);
  const QFont usual = QApplication::font();
  const std::unique_ptr<QWidget> window = makeParts();
  window->show();
  ASSERT_TRUE(test::waitUntilExposed(*window));
  auto* button = window->findChild<QPushButton*>();
  auto* label = window->findChild<QLabel*>();
  const int button_height = button->sizeHint().height();
  const int label_height = label->sizeHint().height();
  const int height = window->sizeHint().height();
  QFont large = usual;
  large.setPointSizeF(1.5 * usual.pointSizeF());
  QApplication::setFont(large);
  applyTheme(Theme::Light);
  EXPECT_TRUE(test::waitUntil([&] { return window->sizeHint().height() > height; }));
  EXPECT_GT(button->sizeHint().height(), button_height);
  EXPECT_GT(label->sizeHint().height(), 1.3 * label_height);
  QApplication::setFont(usual);
  applyTheme(Theme::Light);
  EXPECT_TRUE(test::waitUntil([&] { return window->sizeHint().height() == height; }));
  EXPECT_EQ(button->sizeHint().height(), button_height);
}

}  // namespace
}  // namespace hexoderm
