#include "widgets/patch/patch_view.h"

#include "widgets/coloring/coloring.h"
#include "widgets/coloring/scale_ranges.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/controls/selection.h"
#include "widgets/patch/cut_bar.h"
#include "widgets/patch/measure_tool.h"
#include "widgets/patch/opengl_info.h"
#include "widgets/patch/part_motion.h"
#include "widgets/patch/patch_captions.h"
#include "widgets/patch/patch_controls.h"
#include "widgets/patch/patch_legend.h"
#include "widgets/patch/patch_legend_view.h"
#include "widgets/patch/patch_pointing.h"
#include "widgets/patch/patch_words.h"
#include "widgets/patch/scene_widget.h"
#include "widgets/scene/patch_scene.h"
#include "widgets/scene/scene_builder.h"
#include "widgets/style/color_maps.h"
#include "widgets/style/dressed_theme.h"

#include <vtkRenderer.h>
#include <QAction>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QEvent>
#include <QGridLayout>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLocale>
#include <QMenu>
#include <QObject>
#include <QPainter>
#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

namespace hexoderm {

namespace {

/// What is to be explained of a scene that shows cells, in this colouring.
LegendContent legendOf(const PatchScene& scene, Coloring coloring) {
  LegendContent content;
  const SceneContent& shown = *scene.content();
  content.coloring = coloring;
  content.patches = shown.reconstruction->patches.size();
  content.some_links = !shown.signs.links.empty();
  for (const CellSign& sign : shown.signs.cells) {
    content.some_by_links = content.some_by_links || sign.by_links;
    content.some_faulty = content.some_faulty || sign.faulty;
    content.some_doubtful = content.some_doubtful || sign.doubtful;
  }
  content.scale = scene.scale();
  // Where nothing is known, as of a single moment, there is no range to fit, and one would be made up.
  if (content.scale && !content.scale->extremes && !content.scale->is_fixed) {
    content.scale.reset();
    content.some_unknown = true;
  } else if (content.scale) {
    content.some_unknown = content.scale->counts.unknown > 0;
  } else if (coloring == Coloring::LinkQuality) {
    content.some_unknown = std::ranges::any_of(shown.figures.quality, [](const auto& quality) { return !quality; });
  } else if (coloring == Coloring::BodyPart) {
    for (const std::string& name : shown.figures.body_parts) content.body_parts.push_back(QString::fromStdString(name));
    content.some_unknown = std::ranges::any_of(shown.figures.body_part, [](const auto& part) { return !part; });
  }
  return content;
}

/// One kind of readings is there before or after, but not both.
bool comesOrGoes(const CellReadings* before, const CellReadings* after) {
  const auto kinds = [](const CellReadings* readings) {
    return std::pair(readings != nullptr && !readings->acceleration_g.empty(),
                     readings != nullptr && !readings->temperature_c.empty());
  };
  return kinds(before) != kinds(after);
}

struct PatchMenu {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::PatchMenu)
};

}  // namespace

struct PatchView::Parts : public QObject {
  Parts(PatchView* owner, Selection* shared) : view(owner), selection(shared), measure(shared, owner) {}

  PatchView* view;
  DressedTheme dressed{*view};
  Selection* selection;
  MeasureTool measure;
  std::shared_ptr<const Reconstruction> reconstruction;
  QString awaited;
  Coloring coloring = Coloring::LinkQuality;
  PatchOverlays overlays;
  PatchMoment moment;

  const OpenGlInfo opengl = queryOpenGl();
  // Null without OpenGL. The scene gives its OpenGL objects back while the context is still there, and Qt sends a leave
  // event to a canvas that is deleted under the mouse: each goes before those above it.
  std::unique_ptr<SceneWidget> canvas;
  std::unique_ptr<PatchScene> scene;
  std::unique_ptr<PatchClicks> clicks;
  std::unique_ptr<SceneBuilder> builder;
  std::unique_ptr<PartMotion> motion;
  std::unique_ptr<PatchPointing> pointing;
  PatchCaptions* captions = nullptr;
  PatchControls* controls = nullptr;
  PatchLegendView* legend_view = nullptr;
  ScaleRanges own_ranges;
  ScaleRanges* ranges = &own_ranges;
  bool is_marked_elsewhere = false;
  std::vector<std::function<void()>> waiting;  ///< for the picture to be up to date
  int controls_height = 0;

  void build() {
    auto* layout = new QGridLayout(view);
    layout->setContentsMargins(0, 0, 0, 0);
    captions = new PatchCaptions(view);
    if (opengl.usable) buildScene(layout);
    layout->addWidget(captions, 0, 0, 2, 1);
    layout->setRowStretch(1, 1);
    captions->raise();
    legend_view = new PatchLegendView(view);
    connect(legend_view, &PatchLegendView::rangeFixed, this,
            [this](ColorRange range) { ranges->fix(coloring, range); });
    connect(legend_view, &PatchLegendView::rangeReleased, this, [this] { ranges->release(coloring); });
    connectRanges();
    if (scene) {
      connect(legend_view, &PatchLegendView::heightChanged, this, [this](int height) {
        scene->setBottomMargin(qRound(height * canvas->devicePixelRatioF()));
        requestRender();
      });
    }
    if (controls != nullptr) controls->raise();
    if (canvas != nullptr) {
      motion =
          std::make_unique<PartMotion>(view, canvas.get(), controls->turnButton(), *scene, [this] { requestRender(); });
      connect(motion.get(), &PartMotion::turnRequested, view, &PatchView::turnRequested);
      buildPointing();
    }
    connect(selection, &Selection::changed, this, [this] { updateSelection(); });
    connect(selection, &Selection::brushedChanged, this, [this] {
      if (scene) scene->setBrushed(selection->brushed());
      requestRender();
    });
    connect(&measure, &MeasureTool::changed, this, [this] { updateMeasure(); });
    view->setMinimumHeight(180);
    dress();
    updateCaptions();
  }

  void buildScene(QGridLayout* layout) {
    canvas = std::make_unique<SceneWidget>(opengl.software, view);
    canvas->setAccessibleName(PatchView::tr("Skin patch in 3D"));
    scene = std::make_unique<PatchScene>();
    scene->attachTo(canvas->renderWindow());
    clicks = std::make_unique<PatchClicks>(canvas.get(), *scene, [this] { requestRender(); });
    builder = std::make_unique<SceneBuilder>(
        [this](std::shared_ptr<const SceneContent> content) { setContent(std::move(content)); });
    layout->addWidget(canvas.get(), 0, 0, 2, 1);
    controls = new PatchControls(view);
    controls->setRenderer(openGlText(opengl));
    layout->addWidget(controls, 0, 0);
    connectControls();
    updateControls();
  }

  /// After the motion, so that it hears of the mouse also where that turns the part.
  void buildPointing() {
    pointing = std::make_unique<PatchPointing>(view, canvas.get(), *scene, selection, [this] { requestRender(); });
    connect(clicks.get(), &PatchClicks::clicked, pointing.get(), &PatchPointing::pickAt);
    connect(clicks.get(), &PatchClicks::menuWanted, this, &Parts::openMenuAt);
    connect(controls, &PatchControls::coloringChosen, pointing.get(), &PatchPointing::setColoring);
    connect(controls, &PatchControls::heightChanged, pointing.get(), &PatchPointing::setTopMargin);
    // What has the mouse or the keyboard lies above what lets both through.
    controls->raise();
    pointing->raise();
    view->setFocusPolicy(Qt::StrongFocus);
  }

  void connectControls() {
    connect(controls, &PatchControls::coloringChosen, this, [this](Coloring chosen) {
      coloring = chosen;
      is_marked_elsewhere = false;
      scene->setColoring(chosen);
      scene->setFixedRange(ranges->fixed(chosen));
      refresh();
      emit view->coloringChanged(chosen);
    });
    connect(controls, &PatchControls::coloringPicked, view, &PatchView::coloringPicked);
    connect(controls, &PatchControls::itemToggled, this, [this](SceneItem item, bool shown) {
      scene->setShown(item, shown);
      refresh();
    });
    connect(controls, &PatchControls::fitRequested, view, &PatchView::fit);
    connect(controls, &PatchControls::viewRequested, view, &PatchView::showStandardView);
    connect(controls, &PatchControls::heightChanged, captions, &PatchCaptions::setTopMargin);
    connect(controls, &PatchControls::heightChanged, this, [this](int height) {
      controls_height = height;
      updateTopMargin();
      requestRender();
    });
    connect(controls->measureAction(), &QAction::toggled, &measure, &MeasureTool::setActive);
    connect(controls->parallelAction(), &QAction::toggled, this, [this](bool parallel) {
      scene->setParallel(parallel);
      requestRender();
    });
    connect(controls->pictureAction(), &QAction::triggered, view, &PatchView::pictureRequested);
    connectCut();
  }

  void setContent(std::shared_ptr<const SceneContent> content) {
    scene->setContent(std::move(content));
    updateControls();
    refresh();
    // The delivered content may be older than the newest submission.
    if (builder->isBusy()) return;
    for (const std::function<void()>& then : std::exchange(waiting, {})) then();
  }

  void updateControls() {
    const SceneContent* content = scene->content();
    for (const ColoringRow& row : coloringTable()) {
      if (row.patch_title == nullptr) continue;
      const bool known = content == nullptr || hasValues(row.coloring, content->figures, scene->readings());
      controls->setWhyNot(row.coloring, whyNoColoring(row.coloring, known));
    }
    for (const SceneItem item : kSceneItems) controls->setWhyNot(item, whyNotShown(item, scene->availability(item)));
  }

  void updateCaptions() {
    PatchCaptions::Content content;
    std::optional<LegendContent> explained;
    if (canvas == nullptr) {
      content.hint = PatchView::tr(
          "The 3D view needs OpenGL 3.2, which is not available here. The graph and the tables still work.\n\n"
          "On a remote desktop, or with a faulty driver, it may help to let the processor draw: Edit, Preferences, "
          "\"Draw without the graphics card\", then start Hexoderm again.");
    } else if (!reconstruction) {
      content.hint = awaited.isEmpty() ? PatchView::tr("No skin yet: open a session or start the demo.") : awaited;
    } else if (reconstruction->cellCount() == 0) {
      content.hint = PatchView::tr("This skin has no cells.");
    } else if (scene->content() == nullptr) {
      content.hint = PatchView::tr("Preparing the picture of %1 cells…")
                         .arg(QLocale().toString(static_cast<int>(reconstruction->cellCount())));
    } else {
      content.gravity = scene->showsGravity();
      if (scene->showsGhost()) content.next_pose = QString::fromStdString(moment.next_turn);
      explained = legendOf(*scene, coloring);
      content.legend = legendText(*explained);
      content.notes = notesText(scene->notes(), overlays);
      content.message = measure.words();
    }
    captions->setContent(content);
    if (scene) updateTopMargin();
    legend_view->setContent(explained);
    markPicked();
    if (controls != nullptr) controls->setVisible(content.hint.isEmpty());
  }

  /// What is drawn stays below the buttons and the notes.
  void updateTopMargin() {
    const int covered = std::max(controls_height, captions->notesBottom());
    scene->setTopMargin(qRound(covered * canvas->devicePixelRatioF()));
  }

  void connectRanges() {
    connect(ranges, &ScaleRanges::changed, this, [this](Coloring changed) {
      if (changed == coloring) showFixedRange();
    });
  }

  void showFixedRange() {
    if (!scene) return;
    scene->setFixedRange(ranges->fixed(coloring));
    refresh();
  }

  /// The picked cell's value on the scale, unless another one is pointed at.
  void markPicked() {
    if (is_marked_elsewhere) return;
    std::optional<double> value;
    const SceneContent* content = scene ? scene->content() : nullptr;
    const auto cell = selection->cell();
    if (content != nullptr && cell && content->layout.find(*cell) != nullptr && isQuantity(coloring)) {
      value = coloringRow(coloring).of_cell(content->figures, scene->readings(), content->layout.index.at(*cell));
    }
    const auto scale = value ? scene->scale() : std::nullopt;
    legend_view->setMarkedValue(
        value, scale
                   ? PatchView::tr("cell %1: %2").arg(cell->value()).arg(valueWithUnit(*value, scale->range, coloring))
                   : QString());
  }

  void updateSelection() {
    if (!scene) return;
    const auto link = selection->link();
    scene->setPicked(link ? std::optional(link->first.cell) : selection->cell());
    refresh();
  }

  void updateMeasure() {
    if (!scene) return;
    controls->measureAction()->setChecked(measure.isActive());
    pointing->setOnlyCells(measure.isActive());
    scene->setMeasured(measure.first(), measure.second());
    refresh();
  }

  /// Called when the things drawn over the cells have changed.
  void refresh() {
    updateCaptions();
    if (pointing != nullptr) pointing->refresh();
    requestRender();
  }

  /// Several changes in one turn of the event loop make one picture.
  void requestRender() {
    if (canvas == nullptr || !canvas->isVisible()) return;
    canvas->requestRender();
  }

  /// Opens the menu at this place of the canvas: first what can be done with the cell there, if there is one, then what
  /// the buttons over the scene offer too.
  void openMenuAt(const QPoint& position) {
    if (scene->content() == nullptr) return;
    auto* menu = named(new QMenu(view), "patchMenu");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    const auto add = [&](const char* name, const QString& text, const auto& then) {
      QAction* action = menu->addAction(text, this, then);
      action->setObjectName(QLatin1String(name));
      return action;
    };
    if (const auto cell = pointing->cellAt(position)) {
      add("actionPickCell", PatchMenu::tr("&Pick cell %1").arg(cell->value()),
          [this, cell] { selection->selectCell(*cell); });
      add("actionCenterCell", PatchMenu::tr("&Bring cell %1 into the middle").arg(cell->value()),
          [this, cell] { view->centerOn(*cell); });
      menu->addSeparator();
    }
    menu->addAction(controls->fitAction());
    QMenu* look = menu->addMenu(PatchMenu::tr("&Look from"));
    look->setToolTipsVisible(true);
    for (QAction* from : controls->viewActions()) look->addAction(from);
    menu->addActions({controls->parallelAction(), controls->cutAction()});
    menu->addSeparator();
    menu->addMenu(controls->coloringMenu());
    menu->addMenu(controls->showMenu());
    menu->addAction(controls->measureAction());
    menu->addSeparator();
    add("actionCopyPicture", PatchMenu::tr("Copy pict&ure"), [this] {
      view->copyPicture();
    })->setToolTip(PatchMenu::tr("The scene with its legend, to be pasted elsewhere"));
    menu->addAction(controls->pictureAction());
    menu->popup(canvas->mapToGlobal(position));
  }

  void connectCut() {
    const auto cut = [this] {
      const bool is_cut = controls->cutAction()->isChecked();
      scene->setCut(is_cut ? std::optional(controls->cutBar()->share()) : std::nullopt);
      requestRender();
    };
    connect(controls->cutAction(), &QAction::toggled, this, cut);
    connect(controls->cutBar(), &CutBar::shareChanged, this, cut);
    connect(controls->cutBar(), &CutBar::alignRequested, this, [this] {
      scene->alignCut();
      requestRender();
    });
  }

  /// In the colours of the theme.
  void dress() {
    if (!scene) return;
    scene->setColors(sceneColors(themeOf(view->palette())));
    canvas->setBackground(Colors::of(view->palette()).scene_bottom);
    requestRender();
  }
};

PatchView::PatchView(Selection* selection, QWidget* parent)
    : QWidget(parent), parts_(std::make_unique<Parts>(this, selection)) {
  parts_->build();
}

PatchView::~PatchView() = default;

void PatchView::setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
  parts_->reconstruction = std::move(reconstruction);
  parts_->measure.setReconstruction(parts_->reconstruction);
  if (!parts_->scene) {
    parts_->updateCaptions();
  } else if (parts_->reconstruction && parts_->reconstruction->cellCount() > kMaxCellsAtOnce) {
    parts_->builder->submit(parts_->reconstruction);
    parts_->refresh();
  } else {
    parts_->builder->cancel();
    parts_->setContent(makeSceneContent(parts_->reconstruction));
  }
}

void PatchView::setAwaited(const QString& awaited) {
  parts_->awaited = awaited;
  parts_->updateCaptions();
}

void PatchView::setColoring(Coloring coloring) {
  if (parts_->controls != nullptr) parts_->controls->action(coloring)->setChecked(true);
}

Coloring PatchView::coloring() const { return parts_->coloring; }

void PatchView::setScaleRanges(ScaleRanges* ranges) {
  parts_->ranges->disconnect(parts_.get());
  parts_->ranges = ranges;
  parts_->connectRanges();
  parts_->showFixedRange();
}

void PatchView::setMarkedValue(std::optional<double> value, const QString& word) {
  parts_->is_marked_elsewhere = value.has_value();
  if (value) {
    parts_->legend_view->setMarkedValue(value, word);
  } else {
    parts_->markPicked();
  }
}

void PatchView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (parts_->dressed.isChangedBy(*event)) parts_->dress();
}

void PatchView::paintEvent(QPaintEvent* /*event*/) {
  QPainter(this).fillRect(rect(), Colors::of(palette()).scene_bottom);  // seen where there is no OpenGL
}

void PatchView::setOverlays(const PatchOverlays& overlays) {
  if (overlays == parts_->overlays) return;
  parts_->overlays = overlays;
  if (!parts_->scene) return;
  parts_->scene->setOverlays(overlays);
  parts_->updateControls();
  parts_->refresh();
}

const PatchOverlays& PatchView::overlays() const { return parts_->overlays; }

void PatchView::setShiftFactor(std::optional<double> factor) {
  if (parts_->scene) parts_->scene->setShiftFactor(factor);
  parts_->refresh();
}

std::optional<double> PatchView::shiftFactor() const {
  return parts_->scene ? parts_->scene->notes().shift_factor : std::nullopt;
}

vtkCamera* PatchView::camera() const { return parts_->scene ? parts_->scene->renderer()->GetActiveCamera() : nullptr; }

void PatchView::redraw() { parts_->requestRender(); }

void PatchView::setMoment(const PatchMoment& moment) {
  const PatchMoment before = std::exchange(parts_->moment, moment);
  if (!parts_->motion) return;
  const auto captioned = [scene = parts_->scene.get()] {
    return std::pair(scene->showsGravity(), scene->showsGhost());
  };
  const auto captioned_before = captioned();
  parts_->motion->setMoment(moment);
  parts_->pointing->setTold(moment.told_cell);
  const bool other_readings = moment.readings != before.readings;
  if (other_readings && comesOrGoes(before.readings.get(), moment.readings.get())) parts_->updateControls();
  if (moment.pose != before.pose || (other_readings && isReading(parts_->coloring))) {
    parts_->refresh();
  } else if (captioned() != captioned_before || moment.next_turn != before.next_turn) {
    parts_->updateCaptions();
  }
}

const PatchMoment& PatchView::moment() const { return parts_->moment; }

bool PatchView::isUpToDate() const { return !parts_->builder || !parts_->builder->isBusy(); }

void PatchView::setTurnable(bool turnable) {
  if (parts_->motion) parts_->motion->setTurnable(turnable);
}

void PatchView::setAnimated(bool animated) {
  if (!parts_->motion) return;
  parts_->motion->setAnimated(animated);
  parts_->pointing->setAnimated(animated);
}

bool PatchView::isAnimating() const {
  return parts_->motion && (parts_->motion->isAnimating() || parts_->pointing->isGliding());
}

void PatchView::setMetricsShown(bool shown) {
  if (parts_->pointing) parts_->pointing->setMetricsShown(shown);
}

bool PatchView::areMetricsShown() const { return parts_->pointing && parts_->pointing->areMetricsShown(); }

void PatchView::keyPressEvent(QKeyEvent* event) {
  if (!parts_->pointing || !parts_->pointing->onKey(*event)) QWidget::keyPressEvent(event);
}

void PatchView::whenUpToDate(std::function<void()> then) {
  if (isUpToDate()) {
    then();
  } else {
    parts_->waiting.push_back(std::move(then));
  }
}

void PatchView::waitUntilUpToDate() {
  if (!isUpToDate()) parts_->builder->finish();
}

void PatchView::drawNow() {
  if (parts_->canvas != nullptr) parts_->canvas->drawNow();
}

QImage PatchView::screenshot() {
  if (parts_->canvas == nullptr) return grab().toImage();
  drawNow();
  QImage image = parts_->canvas->picture();
  QPainter painter(&image);
  parts_->pointing->paintMarks(painter);
  parts_->captions->paint(painter, parts_->canvas->size());
  parts_->legend_view->paintPicture(painter, parts_->canvas->size());
  return image;
}

void PatchView::fit() {
  if (!parts_->scene) return;
  parts_->pointing->forgetReturn();
  parts_->scene->fit();
  parts_->requestRender();
}

void PatchView::centerOn(CellId cell) {
  if (parts_->scene) parts_->scene->centerOn(cell);
  parts_->requestRender();
}

void PatchView::copyPicture() { QGuiApplication::clipboard()->setImage(screenshot()); }

void PatchView::contextMenuEvent(QContextMenuEvent* event) {
  if (event->reason() == QContextMenuEvent::Mouse || parts_->canvas == nullptr) {
    event->ignore();
  } else {
    parts_->openMenuAt(parts_->canvas->rect().center());
  }
}

void PatchView::keepView() {
  if (parts_->scene) parts_->scene->keepView();
}

void PatchView::returnToKeptView() {
  if (parts_->scene) parts_->scene->returnToKeptView();
  parts_->requestRender();
}

void PatchView::showStandardView(StandardView view) {
  if (!parts_->scene) return;
  parts_->pointing->forgetReturn();
  parts_->scene->showStandardView(view);
  parts_->requestRender();
}

}  // namespace hexoderm
