#pragma once

#include "hexoderm/base/units.h"
#include "hexoderm/skin/patch_on_link.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/controls/selection.h"
#include "widgets/controls/typed_values.h"
#include "widgets/robot/place_words.h"
#include "widgets/style/of_enum.h"
#include "widgets/tables/joint_table.h"
#include "widgets/tables/joint_table_view.h"
#include "widgets/verify/verify_section.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QResizeEvent>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStringList>
#include <QVBoxLayout>
#include <QWidget>
#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace hexoderm {

/// Work for the step that may take a while.
enum class PlaceWork { Robot, Joints, Links, Places };

/// Everything that the panel shows.
struct PlaceStand {
  struct Choice {
    quint32 id = 0;  ///< of a patch its origin cell, of a pose its ID
    QString text;
    friend bool operator==(const Choice&, const Choice&) = default;
  };
  QString why_not;  ///< why nothing can be placed, one sentence; empty: it can

  bool has_robot = false;
  bool names_robot = false;  ///< the session does, also where its file can't be read
  VerifySentence robot;      ///< which one, and what is doubtful about it
  VerifySentence joints;
  JointSheet sheet;  ///< of the robot's joints in the session's poses

  std::vector<Choice> poses;
  quint32 pose = 0;  ///< in which the robot is drawn
  std::vector<Choice> patches;
  quint32 patch = 0;  ///< that is spoken of

  std::vector<LinkChoice> links;
  QStringList other_links;  ///< of the robot, to be chosen against the evidence, or without any
  QString link;             ///< that the patch is taken to be on; empty: open
  VerifySentence link_says;

  bool has_surface = false;  ///< of that link
  PatchPlacement known;
  QString known_fault;  ///< what was wrong about the last point or distance

  QStringList places;
  int place = -1;  ///< the row of the chosen one; -1: none is, or it is not among them
  bool is_placed = false;
  bool is_drawn = false;  ///< the robot has the patch on it, where it is or could be
  bool can_move = false;  ///< by hand
  VerifySentence place_says;
};

/// The step "Place on the robot": which robot, on which link each patch is, where on the link. The panel asks by its
/// requests and shows what it is given; it is narrow enough for the column of steps.
class PlacePanel : public QWidget {
  Q_OBJECT

 public:
  /// `selection` must outlive the panel: its cell is proposed for known points.
  explicit PlacePanel(Selection* selection, QWidget* parent = nullptr) : QWidget(parent), selection_(selection) {
    setObjectName(QStringLiteral("placePanel"));
    buildRobot();
    buildJoints();
    buildPatch();
    buildLink();
    buildKnown();
    buildPlaces();
    auto* layout = spaced(new QVBoxLayout(this), {0, 4, 0, 4}, 16);
    for (VerifySection* part : {robot_, joints_, patch_, link_, known_, places_}) layout->addWidget(part);
    layout->addStretch();
    for (const PlaceWork work : {PlaceWork::Robot, PlaceWork::Joints, PlaceWork::Links, PlaceWork::Places}) {
      connect(section(work), &VerifySection::cancelled, this, [this, work] { emit cancelRequested(work); });
    }
    connect(selection_, &Selection::changed, this, [this] {
      if (!selection_->cell()) return;
      const int cell = static_cast<int>(selection_->cell()->value());
      point_cell_->setValue(cell);
      from_cell_->setValue(cell);
    });
    setStand({});
  }

  void setStand(const PlaceStand& stand) {
    stand_ = stand;
    const bool can = stand.why_not.isEmpty();
    robot_->setSentence(can ? stand.robot : VerifySentence{Tone::Neutral, stand.why_not});
    joints_->setSentence(stand.joints);
    link_->setSentence(stand.link_says);
    places_->setSentence(stand.place_says);
    fillChoices(pose_, stand.poses, stand.pose);
    fillChoices(patch_list_, stand.patches, stand.patch);
    QStringList links;
    for (const LinkChoice& choice : stand.links) {
      links << (choice.link == stand.link ? QStringLiteral("✓ ") + choice.text : choice.text);
    }
    fillChoices(links_, links);
    fillChoices(place_list_, stand.places);
    std::vector<PlaceStand::Choice> all{{0, tr("open")}};
    for (const QString& link : stand.other_links) all.push_back({static_cast<quint32>(all.size()), link});
    fillChoices(other_link_, all, static_cast<quint32>(stand.other_links.indexOf(stand.link) + 1));
    showSheet();
    showKnown();
    refreshControls();
  }

  [[nodiscard]] const PlaceStand& stand() const { return stand_; }

  void setRunning(PlaceWork work, bool running) {
    section(work)->setRunning(running);
    refreshControls();
  }

  [[nodiscard]] bool isRunning(PlaceWork work) const { return section(work)->isRunning(); }

  /// A point that was picked in 3D: it goes into the fields, and waits there to be added. Ends picking.
  void proposePoint(const Eigen::Vector3d& x_l) {
    for (std::size_t k = 0; k < point_mm_.size(); ++k) {
      point_mm_.at(k)->setValue(toMillimetres(x_l[static_cast<Eigen::Index>(k)]));
    }
    pick_->setChecked(false);
    add_point_->setFocus(Qt::OtherFocusReason);
  }

  /// Moving by keys has ended without this panel.
  void endMoving() {
    const QSignalBlocker blocker(move_);
    move_->setChecked(false);
  }

 signals:
  void robotWanted();
  void packageWanted();
  void robotRemoved();
  void jointsWanted();
  void anglesTyped(const std::vector<hexoderm::TypedAngle>& angles);
  /// Why joint angles that were typed are not taken, one sentence.
  void anglesRefused(const QString& why);
  void cancelRequested(hexoderm::PlaceWork work);
  void poseChosen(quint32 pose);
  void patchChosen(quint32 origin);
  void linkChosen(const QString& link);
  void surfaceChosen(bool by_surface);
  void pointAdded(const hexoderm::KnownPoint& point);
  void pointRemoved(int index);
  void distanceAdded(const hexoderm::KnownDistance& distance);
  void distanceRemoved(int index);
  /// The place that the mouse or the keyboard is at; -1: none.
  void placePreviewed(int row);
  void placeChosen(int row);
  void placeRemoved();
  /// The patch is to be moved by keys, or no more: it lies where it is to lie.
  void movingChanged(bool moving);
  void lookWanted();
  void pickingChanged(bool picking);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Leave && watched == place_list_->viewport()) emit placePreviewed(-1);
    return QWidget::eventFilter(watched, event);
  }

 private:
  void buildRobot() {
    package_->setToolTip(tr("Where a URDF says package://NAME/…: the folder called NAME"));
    robot_->addRow({choose_robot_, remove_robot_});
    robot_->addRow({package_});
    connect(choose_robot_, &QPushButton::clicked, this, &PlacePanel::robotWanted);
    connect(package_, &QPushButton::clicked, this, &PlacePanel::packageWanted);
    connect(remove_robot_, &QPushButton::clicked, this, &PlacePanel::robotRemoved);
  }

  void buildJoints() {
    joints_->addRow({choose_joints_});
    connect(choose_joints_, &QPushButton::clicked, this, &PlacePanel::jointsWanted);
    joint_view_->setToolTip(
        tr("Type angles, or paste a block of them from a spreadsheet; an empty cell is an angle that is not known"));
    joints_->addRow()->addWidget(joint_view_, 1);
    connect(joint_table_, &JointTable::typed, this, &PlacePanel::anglesTyped);
    connect(joint_table_, &JointTable::refused, this, &PlacePanel::anglesRefused);
    makeNarrow(pose_);
    QHBoxLayout* pose = joints_->addRow();
    pose->addWidget(labelFor(pose_, tr("Drawn in")));
    pose->addWidget(pose_, 1);
    connect(pose_, qOverload<int>(&QComboBox::activated), this,
            [this] { emit poseChosen(pose_->currentData().toUInt()); });
  }

  void buildPatch() {
    makeNarrow(patch_list_);
    patch_->addRow()->addWidget(patch_list_, 1);
    connect(patch_list_, qOverload<int>(&QComboBox::activated), this,
            [this] { emit patchChosen(patch_list_->currentData().toUInt()); });
  }

  void buildLink() {
    links_->setToolTip(tr("Return or a click puts the patch on a link"));
    link_->addRow()->addWidget(links_, 1);
    const auto choose = [this](QListWidgetItem* item) {
      const int row = links_->row(item);
      if (row >= 0 && static_cast<std::size_t>(row) < stand_.links.size()) {
        emit linkChosen(stand_.links[static_cast<std::size_t>(row)].link);
      }
    };
    connect(links_, &QListWidget::itemClicked, this, choose);
    connect(links_, &QListWidget::itemActivated, this, choose);
    makeNarrow(other_link_);
    QHBoxLayout* row = link_->addRow();
    row->addWidget(labelFor(other_link_, tr("On link")));
    row->addWidget(other_link_, 1);
    connect(other_link_, qOverload<int>(&QComboBox::activated), this,
            [this] { emit linkChosen(other_link_->currentIndex() > 0 ? other_link_->currentText() : QString()); });
  }

  void buildKnown() {
    known_->addRow()->addWidget(by_surface_);
    connect(by_surface_, &QCheckBox::clicked, this, &PlacePanel::surfaceChosen);
    known_->addRow()->addWidget(known_list_, 1);
    known_->addRow({remove_known_});
    connect(known_list_, &QListWidget::currentRowChanged, this, &PlacePanel::refreshControls);
    connect(remove_known_, &QPushButton::clicked, this, [this] {
      const int picked = known_list_->currentRow();
      const int points = static_cast<int>(stand_.known.points.size());
      if (picked < 0) return;
      // The button goes with the last one; the keyboard had better not end up in a field, where Ctrl+Z means the field.
      if (known_list_->count() == 1) by_surface_->setFocus(Qt::OtherFocusReason);
      if (picked < points) {
        emit pointRemoved(picked);
      } else {
        emit distanceRemoved(picked - points);
      }
    });
    buildPoint();
    buildDistance();
  }

  void buildPoint() {
    point_sigma_mm_->setValue(1);
    pick_->setCheckable(true);
    pick_->setToolTip(tr("The next click on the robot fills in x, y and z"));
    QGridLayout* grid = gridOfFields();
    addField(grid, 0, 0, tr("Cell"), point_cell_);
    addField(grid, 0, 2, tr("±"), point_sigma_mm_);
    const std::array<QString, 3> axes = {tr("x"), tr("y"), tr("z")};
    for (int axis = 0; axis < 3; ++axis) {
      QDoubleSpinBox* field = point_mm_.at(static_cast<std::size_t>(axis));
      addField(grid, 1 + axis, 0, axes.at(static_cast<std::size_t>(axis)), field, 3);
    }
    known_->addRow()->addLayout(grid);
    for (QPushButton* button : {pick_, add_point_}) known_->addRow({button});
    connect(pick_, &QPushButton::toggled, this, &PlacePanel::pickingChanged);
    connect(add_point_, &QPushButton::clicked, this, [this] {
      KnownPoint point;
      point.cell = CellId(static_cast<std::uint32_t>(point_cell_->value()));
      for (std::size_t k = 0; k < point_mm_.size(); ++k) {
        point.x_l[static_cast<Eigen::Index>(k)] = point_mm_.at(k)->value() * kMillimetre;
      }
      point.sigma_m = point_sigma_mm_->value() * kMillimetre;
      emit pointAdded(point);
    });
  }

  void buildDistance() {
    distance_mm_->setSpecialValueText(tr("not measured"));
    letTypingReplaceSpecialText(distance_mm_);
    distance_sigma_mm_->setValue(1);
    QGridLayout* grid = gridOfFields();
    addField(grid, 0, 0, tr("Cell"), from_cell_);
    addField(grid, 0, 2, tr("to"), to_cell_);
    addField(grid, 1, 0, tr("is"), distance_mm_, 3);
    addField(grid, 2, 0, tr("±"), distance_sigma_mm_, 3);
    known_->addRow()->addLayout(grid);
    known_->addRow({add_distance_});
    connect(distance_mm_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &PlacePanel::refreshControls);
    connect(add_distance_, &QPushButton::clicked, this, [this] {
      emit distanceAdded({CellId(static_cast<std::uint32_t>(from_cell_->value())),
                          CellId(static_cast<std::uint32_t>(to_cell_->value())), distance_mm_->value() * kMillimetre,
                          distance_sigma_mm_->value() * kMillimetre});
    });
  }

  void buildPlaces() {
    place_list_->setToolTip(tr("Pointing at a place shows it; Return or a click takes it"));
    place_list_->setMouseTracking(true);
    place_list_->viewport()->installEventFilter(this);
    places_->addRow()->addWidget(place_list_, 1);
    move_->setCheckable(true);
    places_->addRow({move_});
    places_->addRow({look_, remove_place_});
    connect(move_, &QPushButton::toggled, this, &PlacePanel::movingChanged);
    connect(look_, &QPushButton::clicked, this, &PlacePanel::lookWanted);
    connect(place_list_, &QListWidget::itemEntered, this,
            [this](QListWidgetItem* item) { emit placePreviewed(place_list_->row(item)); });
    connect(place_list_, &QListWidget::currentRowChanged, this, &PlacePanel::placePreviewed);
    const auto choose = [this](QListWidgetItem* item) { emit placeChosen(place_list_->row(item)); };
    connect(place_list_, &QListWidget::itemClicked, this, choose);
    connect(place_list_, &QListWidget::itemActivated, this, choose);
    connect(remove_place_, &QPushButton::clicked, this, &PlacePanel::placeRemoved);
  }

  [[nodiscard]] VerifySection* section(PlaceWork work) const { return ofEnum(work, {robot_, joints_, link_, places_}); }

  void showSheet() {
    joint_table_->setSheet(stand_.sheet);
    const int rows = joint_table_->rowCount();
    joint_view_->setVisible(rows > 0 && joint_table_->columnCount() > 0);
    const int shown = std::min(rows, kMaxRowsInList);
    joint_view_->setFixedHeight(joint_view_->horizontalHeader()->sizeHint().height() +
                                shown * joint_view_->verticalHeader()->defaultSectionSize() +
                                joint_view_->horizontalScrollBar()->sizeHint().height() +
                                2 * joint_view_->frameWidth());
  }

  void showKnown() {
    QStringList known;
    for (const KnownPoint& point : stand_.known.points) known << pointText(point);
    for (const KnownDistance& distance : stand_.known.distances) known << distanceText(distance);
    fillChoices(known_list_, known);
    by_surface_->setChecked(stand_.known.by_surface && stand_.has_surface);
    const bool has_link = !stand_.link.isEmpty();
    const bool says_nothing = known.isEmpty() && !by_surface_->isChecked();
    if (!stand_.known_fault.isEmpty()) {
      known_->setSentence({Tone::Bad, stand_.known_fault});
    } else if (has_link && says_nothing) {
      known_->setSentence(
          {Tone::Caution, tr("Nothing says where on the link the patch lies: use the surface, or add a point.")});
    } else if (has_link && !stand_.has_surface) {
      known_->setSentence({Tone::Neutral, tr("Nothing describes the surface of this link; points and distances can say "
                                             "where the patch lies.")});
    } else {
      known_->setSentence({});
    }
  }

  void refreshControls() {
    const bool can = stand_.why_not.isEmpty();
    const bool has_robot = can && stand_.has_robot;
    const bool has_link = has_robot && !stand_.link.isEmpty();
    choose_robot_->setEnabled(can && !isRunning(PlaceWork::Robot));
    choose_robot_->setToolTip(can ? tr("The robot's description; a file can also be dropped onto the window")
                                  : stand_.why_not);
    package_->setVisible(has_robot);
    remove_robot_->setVisible(can && stand_.names_robot);
    enable(choose_joints_, has_robot, tr("A line for each pose, a column for each joint, with its unit"),
           tr("Choose the robot first: its joints have the names of the columns"));
    joints_->setVisible(has_robot);
    patch_->setVisible(has_robot);
    link_->setVisible(has_robot);
    known_->setVisible(has_link);
    places_->setVisible(has_link);
    enable(by_surface_, stand_.has_surface, {}, tr("The robot's description holds no surface of this link"));
    remove_known_->setVisible(known_list_->count() > 0);
    enable(remove_known_, known_list_->currentRow() >= 0, {}, tr("Pick a point or a distance in the list first"));
    enable(add_distance_, distance_mm_->value() > 0, {}, tr("Type the measured distance first"));
    remove_place_->setVisible(stand_.is_placed);
    enable(look_, stand_.is_drawn, tr("The picture shows the cells of the patch with their numbers"),
           tr("The patch is drawn once its place is known"));
    enable(move_, stand_.can_move,
           tr("In the picture the mouse pulls the patch over the link at any time; this is for the keyboard"),
           tr("A patch is moved over the surface of its link, which has to be known and used"));
    if (!has_link && pick_->isChecked()) pick_->setChecked(false);
  }

  Selection* selection_;
  PlaceStand stand_;
  VerifySection* robot_ =
      new VerifySection(tr("Robot"), tr("Which robot wears the skin?"), QStringLiteral("placeRobot"), selection_);
  VerifySection* joints_ = new VerifySection(tr("Joint angles"), tr("How did it stand in each pose?"),
                                             QStringLiteral("placeJoints"), selection_);
  VerifySection* patch_ =
      new VerifySection(tr("Patch"), tr("Which patch is to be placed?"), QStringLiteral("placePatch"), selection_);
  VerifySection* link_ =
      new VerifySection(tr("Link"), tr("Which link saw the same gravity?"), QStringLiteral("placeLink"), selection_);
  VerifySection* known_ = new VerifySection(tr("What is known"), tr("What says where on the link it lies?"),
                                            QStringLiteral("placeKnown"), selection_);
  VerifySection* places_ =
      new VerifySection(tr("Place"), tr("Where on the link can it lie?"), QStringLiteral("placePlaces"), selection_);
  QPushButton* choose_robot_ =
      named(new QPushButton(tr("Choose URDF…")), "placeChooseRobot", tr("Choose the robot's URDF"));
  QPushButton* package_ = named(new QPushButton(tr("Package folder…")), "placePackage",
                                tr("Say in which folder a package of the robot is"));
  QPushButton* remove_robot_ = named(new QPushButton(tr("Remove")), "placeRemoveRobot", tr("Remove the robot"));
  QPushButton* choose_joints_ =
      named(new QPushButton(tr("Choose CSV…")), "placeChooseJoints", tr("Choose a table of joint angles"));
  JointTable* joint_table_ = new JointTable(this);
  JointTableView* joint_view_ =
      named(new JointTableView(joint_table_), "placeJointTable", tr("Joint angles of the poses"));
  QComboBox* pose_ = named(new QComboBox, "placePose", tr("Pose in which the robot is drawn"));
  QComboBox* patch_list_ = named(new QComboBox, "placePatchList", tr("Patch that is placed"));
  QListWidget* links_ = choiceList("placeLinks", tr("Links that the patch may be on"));
  QComboBox* other_link_ = named(new QComboBox, "placeOtherLink", tr("Any link of the robot"));
  QCheckBox* by_surface_ = named(new QCheckBox(tr("Its back lies on the link's surface")), "placeBySurface");
  QListWidget* known_list_ = choiceList("placeKnownList", tr("Known points and distances"));
  QPushButton* remove_known_ =
      named(new QPushButton(tr("Remove")), "placeRemoveKnown", tr("Remove the picked point or distance"));
  QSpinBox* point_cell_ = cellField("placePointCell", tr("Cell at the known point"));
  std::array<QDoubleSpinBox*, 3> point_mm_ = {
      lengthField("placePointX", tr("x of the point in the link's frame"), -kMaxLength_mm),
      lengthField("placePointY", tr("y of the point in the link's frame"), -kMaxLength_mm),
      lengthField("placePointZ", tr("z of the point in the link's frame"), -kMaxLength_mm)};
  QDoubleSpinBox* point_sigma_mm_ = lengthField("placePointSigma", tr("Uncertainty of the point, 1 sigma"), 0.1);
  QPushButton* pick_ = named(new QPushButton(tr("Pick in 3D")), "placePick", tr("Pick the point on the robot"));
  QPushButton* add_point_ = named(new QPushButton(tr("Add point")), "placeAddPoint", tr("Add the known point"));
  QSpinBox* from_cell_ = cellField("placeFromCell", tr("Cell of this patch"));
  QSpinBox* to_cell_ = cellField("placeToCell", tr("Cell of another patch on the same link"));
  QDoubleSpinBox* distance_mm_ = lengthField("placeDistance", tr("Measured distance of the two cells"), 0);
  QDoubleSpinBox* distance_sigma_mm_ =
      lengthField("placeDistanceSigma", tr("Uncertainty of the distance, 1 sigma"), 0.1);
  QPushButton* add_distance_ =
      named(new QPushButton(tr("Add distance")), "placeAddDistance", tr("Add the measured distance"));
  QListWidget* place_list_ = choiceList("placePlaceList", tr("Places that fit, the best first"));
  QPushButton* remove_place_ =
      named(new QPushButton(tr("Take away")), "placeRemovePlace", tr("Take the patch away from its place"));
  QPushButton* move_ =
      named(new QPushButton(tr("Move by hand")), "placeMove", tr("Move the patch over the link by keys"));
  QPushButton* look_ =
      named(new QPushButton(tr("Look closely")), "placeLook", tr("Look closely at the patch on the robot"));

  static constexpr int kMaxRowsInList = 6;
  static constexpr double kMaxLength_mm = 1e5;

  static QDoubleSpinBox* lengthField(const char* object_name, const QString& accessible_name, double least_mm) {
    auto* field = named(new QDoubleSpinBox, object_name, accessible_name);
    field->setRange(least_mm, kMaxLength_mm);
    field->setDecimals(1);
    field->setSuffix(PlacePanel::tr(" mm"));
    field->setGroupSeparatorShown(false);
    field->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    return field;
  }

  static QSpinBox* cellField(const char* object_name, const QString& accessible_name) {
    auto* field = named(new QSpinBox, object_name, accessible_name);
    field->setRange(1, std::numeric_limits<int>::max());
    field->setGroupSeparatorShown(false);
    field->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    return field;
  }

  /// As high as its rows, up to so many; how high they are depends on its width, as long texts are wrapped. Reckoned
  /// here, because asking the list would lay it out again while it is being laid out.
  class ChoiceList : public QListWidget {
   public:
    void fitHeight() {
      constexpr int kBesideText = 4;  // on both sides of a text, in all styles about so much
      const int width = QListWidget::width() - 2 * (frameWidth() + kBesideText);
      int height = 2 * frameWidth();
      for (int row = 0; row < std::min(count(), kMaxRowsInList); ++row) {
        const QRect text = fontMetrics().boundingRect({0, 0, width, 0}, Qt::TextWordWrap, item(row)->text());
        height += text.height() + kBesideText;
      }
      setFixedHeight(height);
    }

   protected:
    void resizeEvent(QResizeEvent* event) override {
      QListWidget::resizeEvent(event);
      if (event->size().width() != event->oldSize().width()) fitHeight();
    }
  };

  static ChoiceList* choiceList(const char* object_name, const QString& accessible_name) {
    auto* list = named(new ChoiceList, object_name, accessible_name);
    list->setWordWrap(true);
    list->setResizeMode(QListView::Adjust);
    list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list->setTabKeyNavigation(false);
    list->hide();
    return list;
  }

  /// Rows stay as they are, with the one that is picked, where the texts are the same.
  static void fillChoices(QListWidget* list, const QStringList& texts) {
    bool same = list->count() == texts.size();
    for (int row = 0; same && row < texts.size(); ++row) same = list->item(row)->text() == texts[row];
    list->setVisible(!texts.isEmpty());
    if (same) return;
    const QSignalBlocker blocker(list);
    const int current = list->currentRow();
    list->clear();
    list->addItems(texts);
    if (current >= 0 && current < texts.size()) list->setCurrentRow(current);
    static_cast<ChoiceList*>(list)->fitHeight();
  }

  static void fillChoices(QComboBox* box, const std::vector<PlaceStand::Choice>& choices, quint32 current) {
    const QSignalBlocker blocker(box);
    bool same = box->count() == static_cast<int>(choices.size());
    for (int k = 0; same && k < box->count(); ++k) {
      const PlaceStand::Choice& choice = choices[static_cast<std::size_t>(k)];
      same = box->itemText(k) == choice.text && box->itemData(k).toUInt() == choice.id;
    }
    if (!same) {
      box->clear();
      for (const PlaceStand::Choice& choice : choices) box->addItem(choice.text, choice.id);
    }
    box->setCurrentIndex(box->findData(current));
  }
};

}  // namespace hexoderm
