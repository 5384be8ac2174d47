#include "widgets/controls/finding_card.h"

#include "widgets/words/words.h"

#include <gtest/gtest.h>
#include <QtTest>
#include <QtWidgets>

namespace hexoderm {
namespace {

Finding looseLink() {
  return makeFinding(FindingCode::LinkNotRigid, message("The link {} moved by {}.", "3:1 - 4:2", Degrees{0.1}),
                     {CellId(3), CellId(4)}, {PortNumber(1), PortNumber(2)});
}

QString textOf(const QWidget& card, const char* name) { return card.findChild<QLabel*>(QLatin1String(name))->text(); }

TEST(FindingCard, SaysWhatWhereWhyAndWhatToDo) {
  FindingCard card;
  const Finding finding = looseLink();
  card.setFinding(finding, {{FindingRemedy::MuteLink, "Set link aside"}});
  card.setUnfolded(true);
  EXPECT_EQ(textOf(card, "findingSeverity"), "Warning");
  EXPECT_TRUE(textOf(card, "findingWhat").contains("3:1 - 4:2 moved by 5.7°"));
  EXPECT_EQ(textOf(card, "findingWhere"), "cells 3, 4");
  EXPECT_TRUE(textOf(card, "findingWhy").contains(words(descriptionOf(finding.code).why)));
  EXPECT_TRUE(textOf(card, "findingToDo").contains(words(descriptionOf(finding.code).what_to_do)));
  for (const char* name : {"findingWhy", "findingToDo"}) {
    EXPECT_TRUE(card.findChild<QLabel*>(QLatin1String(name))->isVisibleTo(&card));
  }
  card.setUnfolded(false);
  EXPECT_FALSE(card.findChild<QLabel*>("findingWhy")->isVisibleTo(&card));
  EXPECT_TRUE(card.findChild<QLabel*>("findingWhat")->isVisibleTo(&card));
  card.findChild<QToolButton*>("findingFold")->click();
  EXPECT_TRUE(card.isUnfolded());
}

TEST(FindingCard, OneThatIsNowhereCanNotBeShown) {
  FindingCard card;
  card.setFinding(makeFinding(FindingCode::SensorsUnlikeModel, message("They err more.")), {});
  EXPECT_FALSE(card.findChild<QPushButton*>("findingShow")->isVisibleTo(&card));
  card.setFinding(looseLink(), {});
  EXPECT_TRUE(card.findChild<QPushButton*>("findingShow")->isVisibleTo(&card));
}

TEST(FindingCards, TheWorstIsUnfoldedAndTheOthersAreCounted) {
  FindingCards cards("cards");
  EXPECT_TRUE(cards.isHidden());
  std::vector<FindingCards::Item> items;
  for (std::uint32_t k = 1; k <= 6; ++k) {
    items.push_back({makeFinding(FindingCode::DeadSensor, message("Cell {} is dead.", k), {CellId(k)}), {}});
  }
  cards.setItems(items);
  ASSERT_EQ(cards.cards().size(), 4U);
  EXPECT_TRUE(cards.cards()[0]->isUnfolded());
  EXPECT_FALSE(cards.cards()[1]->isUnfolded());
  QSignalSpy all(&cards, &FindingCards::allWanted);
  bool is_said = false;
  for (QPushButton* button : cards.findChildren<QPushButton*>()) {
    if (button->text() != "2 more under Findings") continue;
    is_said = button->isVisibleTo(&cards);
    button->click();
  }
  EXPECT_TRUE(is_said);
  EXPECT_EQ(all.count(), 1);
  // What somebody has unfolded stays so while the findings are the same.
  cards.cards()[1]->setUnfolded(true);
  items[1].offers = {{FindingRemedy::LightCell, "Light cell 2"}};
  cards.setItems(items);
  EXPECT_TRUE(cards.cards()[1]->isUnfolded());
  items.resize(1);
  cards.setItems(items);
  EXPECT_FALSE(cards.cards()[1]->isVisibleTo(&cards));
  cards.setItems({});
  EXPECT_TRUE(cards.isHidden());
}

}  // namespace
}  // namespace hexoderm
