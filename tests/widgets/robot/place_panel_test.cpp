#include "widgets/robot/place_panel.h"

#include "hexoderm/base/units.h"
#include "tests/support/panel_on_screen.h"

namespace hexoderm {
namespace {

using testing::HasSubstr;

PlaceStand standOfTwoPatches() {
  PlaceStand stand;
  stand.has_robot = stand.names_robot = true;
  stand.robot = {Tone::Good, "demo_arm, 8 links"};
  stand.joints = {Tone::Good, "4 of 4 poses have joint angles."};
  stand.poses = {{1, "Pose 1"}, {2, "Pose 2"}};
  stand.pose = 1;
  stand.patches = {{1, "Patch of cell 1, 17 cells"}, {18, "Patch of cell 18, 17 cells"}};
  stand.patch = 1;
  stand.links = {{"forearm", "forearm · fits"}, {"hand", "hand · can't be told from forearm"}};
  stand.other_links = QStringList{"base", "forearm", "hand"};
  stand.link = "forearm";
  stand.link_says = {Tone::Caution, "Move the wrist."};
  stand.has_surface = true;
  stand.known.origin = CellId(1);
  stand.known.points = {{CellId(3), {0.01, 0, -0.02}, 0.001}};
  stand.places = QStringList{"1 · misfit 0.40 mm", "2 · misfit 0.90 mm"};
  stand.place_says = {Tone::Caution, "2 places fit."};
  return stand;
}

class PlacePanelTest : public test::PanelOnScreen<PlacePanel> {
 protected:
  PlacePanelTest() : PanelOnScreen({286, 900}) {}
};

TEST_F(PlacePanelTest, WithoutARobotItAsksForOneAndSaysWhyNotWhereNothingCanBePlaced) {
  EXPECT_TRUE(find<QPushButton>("placeChooseRobot")->isEnabled());
  EXPECT_FALSE(find<QListWidget>("placeLinks")->isVisible());
  EXPECT_FALSE(find<QPushButton>("placeAddPoint")->isVisible());
  PlaceStand stand;
  stand.why_not = "There is no skin yet.";
  panel_->setStand(stand);
  EXPECT_FALSE(find<QPushButton>("placeChooseRobot")->isEnabled());
  EXPECT_EQ(find<QLabel>("placeRobotSentence")->text(), stand.why_not);
}

TEST_F(PlacePanelTest, ListsAndFieldsAskForWhatTheyShow) {
  panel_->setStand(standOfTwoPatches());
  keep("place-panel-light");
  QStringList links;
  QObject::connect(panel_, &PlacePanel::linkChosen, [&](const QString& link) { links << link; });
  auto* list = find<QListWidget>("placeLinks");
  EXPECT_TRUE(list->item(0)->text().startsWith("✓ "));
  list->setFocus();
  list->setCurrentRow(1);
  QTest::keyClick(list, Qt::Key_Return);
  ASSERT_FALSE(links.isEmpty());
  EXPECT_EQ(links.back(), "hand");

  std::optional<KnownPoint> added;
  QObject::connect(panel_, &PlacePanel::pointAdded, [&](const KnownPoint& point) { added = point; });
  find<QSpinBox>("placePointCell")->setValue(7);
  panel_->proposePoint({0.0123, -0.05, 0});
  QTest::mouseClick(find<QPushButton>("placeAddPoint"), Qt::LeftButton);
  ASSERT_TRUE(added);
  EXPECT_EQ(added->cell, CellId(7));
  EXPECT_NEAR(added->x_l.x(), 0.0123, 1e-9);
  EXPECT_NEAR(added->sigma_m, 0.001, 1e-9);

  EXPECT_FALSE(find<QPushButton>("placeRemoveKnown")->isEnabled()) << "nothing is picked";
  std::optional<bool> by_surface;
  QObject::connect(panel_, &PlacePanel::surfaceChosen, [&](bool on) { by_surface = on; });
  QTest::keyClick(find<QCheckBox>("placeBySurface"), Qt::Key_Space);
  EXPECT_EQ(by_surface, false);
}

TEST_F(PlacePanelTest, APlaceIsShownByPointingAndTakenByReturn) {
  panel_->setStand(standOfTwoPatches());
  std::vector<int> previewed;
  std::vector<int> chosen;
  QObject::connect(panel_, &PlacePanel::placePreviewed, [&](int row) { previewed.push_back(row); });
  QObject::connect(panel_, &PlacePanel::placeChosen, [&](int row) { chosen.push_back(row); });
  auto* list = find<QListWidget>("placePlaceList");
  list->setFocus();
  list->setCurrentRow(1);
  EXPECT_THAT(previewed, testing::Contains(1));
  EXPECT_TRUE(chosen.empty());
  QTest::keyClick(list, Qt::Key_Return);
  EXPECT_THAT(chosen, testing::Contains(1));
  // The same lists again leave the row where it is.
  panel_->setStand(standOfTwoPatches());
  EXPECT_EQ(list->currentRow(), 1);
  QEvent leave(QEvent::Leave);
  QApplication::sendEvent(list->viewport(), &leave);
  EXPECT_EQ(previewed.back(), -1);
}

TEST_F(PlacePanelTest, ThePickedCellIsProposedForPoints) {
  panel_->setStand(standOfTwoPatches());
  selection_.selectCell(CellId(12));
  EXPECT_EQ(find<QSpinBox>("placePointCell")->value(), 12);
  EXPECT_EQ(find<QSpinBox>("placeFromCell")->value(), 12);
}

TEST_F(PlacePanelTest, SaysWhereNothingTellsThePlace) {
  PlaceStand stand = standOfTwoPatches();
  stand.has_surface = false;
  stand.known.points.clear();
  panel_->setStand(stand);
  EXPECT_FALSE(find<QCheckBox>("placeBySurface")->isEnabled());
  EXPECT_THAT(find<QLabel>("placeKnownSentence")->text().toStdString(), HasSubstr("Nothing says where"));
  theme_.set(Theme::Dark);
  keep("place-panel-dark");
}

TEST(PlaceWords, LinksThatCannotBeToldApartStandTogether) {
  PatchLinks patch;
  LinkCandidate candidate;
  candidate.links = {PatchTurn{"forearm"}, PatchTurn{"hand"}};
  candidate.chi_squared = 11.2;
  candidate.freedom = 13;
  patch.candidates = {candidate};
  const std::vector<LinkChoice> choices = linkChoices(patch);
  ASSERT_EQ(choices.size(), 2U);
  EXPECT_EQ(choices[0].link, "forearm");
  EXPECT_THAT(choices[0].text.toStdString(), HasSubstr("misfit 11.2, usual is 13"));
  EXPECT_EQ(choices[1].link, "hand");
  EXPECT_THAT(choices[1].text.toStdString(), HasSubstr("can't be told from forearm"));
  patch.nearest = candidate;
  EXPECT_THAT(linkChoices(patch)[2].text.toStdString(), HasSubstr("does not fit"));
  EXPECT_EQ(linkText(patch).tone, Tone::Bad);
}

TEST(PlaceWords, SeveralSentencesHaveSignsAndTheGravestTone) {
  EXPECT_EQ(together({{Tone::Good, "One."}}).text, "One.");
  const VerifySentence two = together({{Tone::Good, "One."}, {Tone::Bad, "Two."}, {Tone::Caution, {}}});
  EXPECT_EQ(two.tone, Tone::Bad);
  EXPECT_EQ(two.text, "✓ One.\n✕ Two.");
}

TEST(PlaceWords, APlaceNamesItsMisfitAndWhatIsOpen) {
  PlaceCandidate candidate;
  candidate.rms_m = 0.0004;
  candidate.patches.resize(1);
  EXPECT_THAT(placeInList(candidate, 1, false).toStdString(), HasSubstr("1 · misfit 0.40"));
  candidate.patches[0].free.resize(1);
  EXPECT_THAT(placeInList(candidate, 1, false).toStdString(), HasSubstr("can be moved"));
  candidate.patches[0].free[0].held_by_rotation = true;
  EXPECT_THAT(placeInList(candidate, 1, false).toStdString(), testing::Not(HasSubstr("can be moved")));
  EXPECT_THAT(placeInList(candidate, 1, false).toStdString(), testing::Not(HasSubstr("by hand")));
  candidate.by_hand = true;
  EXPECT_THAT(placeInList(candidate, 1, false).toStdString(), HasSubstr("put by hand"));
  candidate.fits = false;
  EXPECT_THAT(placeInList(candidate, 2, true).toStdString(), HasSubstr("does not fit"));
  EXPECT_TRUE(placeInList(candidate, 2, true).startsWith("✓ 2"));
}

}  // namespace
}  // namespace hexoderm
