#include "widgets/patch_view.h"

#include "widgets/part_motion.h"
#include "widgets/patch_scene.h"
#include "widgets/scene_overlay.h"
#include "widgets/selection.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>
#include <QAction>
#include <QActionGroup>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QMenu>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QPainter>
#include <QTimer>
#include <QToolButton>
#include <utility>

namespace hexoderm {
namespace {

/// The trackball without VTK's single-letter commands: keys belong to the window.
class SceneInteractorStyle : public vtkInteractorStyleTrackballCamera {
 public:
  static SceneInteractorStyle* New();
  vtkTypeMacro(SceneInteractorStyle, vtkInteractorStyleTrackballCamera) void OnChar() override {}
  void OnKeyPress() override {}
};
vtkStandardNewMacro(SceneInteractorStyle);

QSurfaceFormat surfaceFormat() {
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);  // multisampling costs a factor of three in software OpenGL
  return format;
}

bool hasOpenGl() {
  QOpenGLContext context;
  context.setFormat(surfaceFormat());
  return context.create() && 10 * context.format().majorVersion() + context.format().minorVersion() >= 32;
}

Rgb toRgb(const QColor& color) { return {color.redF(), color.greenF(), color.blueF()}; }

SceneColors sceneColors(Theme theme) {
  const Colors& colors = Colors::of(theme);
  const bool dark = theme == Theme::Dark;
  // Large faces in a link's full colour would shout: they are calmed towards black.
  const Rgb black{};
  const double calm = dark ? 0.36 : 0.10;
  SceneColors scene;
  scene.background_top = toRgb(colors.scene_top);
  scene.background_bottom = toRgb(colors.scene_bottom);
  for (std::size_t k = 0; k < scene.quality.size(); ++k) {
    scene.quality.at(k) = mixed(toRgb(linkStroke(static_cast<EdgeQuality>(k), theme).color), black, calm);
  }
  scene.neutral = toRgb(colors.muted_link);
  constexpr int kScaleSteps = 32;
  for (int k = 0; k <= kScaleSteps; ++k) {
    scene.scale.push_back(mixed(toRgb(viridis(static_cast<double>(k) / kScaleSteps)), black, 0.5 * calm));
  }
  scene.edge = toRgb(dark ? colors.scene_top : colors.text);
  scene.selection = toRgb(colors.selection);
  scene.light_mark = toRgb(dark ? colors.selection : colors.panel);
  scene.dark_mark = toRgb(dark ? colors.scene_top : colors.text);
  scene.arrow_shaft = toRgb(colors.text_muted);
  scene.arrow_head = toRgb(colors.accent);
  return scene;
}

}  // namespace

struct PatchView::Parts : public QObject {
  Parts(PatchView* owner, Selection* shared) : view(owner), selection(shared) {}

  PatchView* view;
  Selection* selection;
  Theme theme = Theme::Light;
  std::shared_ptr<const Reconstruction> reconstruction;
  CellColoring coloring = CellColoring::LinkQuality;

  vtkNew<vtkGenericOpenGLRenderWindow> window;
  QVTKOpenGLNativeWidget* gl = nullptr;  ///< null without OpenGL
  std::unique_ptr<PatchScene> scene;     ///< likewise
  PartMotion* motion = nullptr;          ///< likewise
  SceneOverlay* overlay = nullptr;
  QFrame* bar = nullptr;
  QTimer at_rest;
  QTimer render_soon;
  QPoint pressed_at;

  void build();
  void buildControls(QGridLayout* layout);
  void buildColoringMenu(QHBoxLayout* row);
  void smoothWhenAtRest();
  void startInteraction() {
    at_rest.stop();
    scene->setSmoothed(false);
  }
  void endInteraction() { at_rest.start(); }
  QToolButton* addButton(QHBoxLayout* row, const QString& text, const QString& tip);
  void updateOverlay();
  void updateSelection();
  /// Several changes in one turn of the event loop make one picture.
  void requestRender();
  void pickAt(const QPoint& position);
  bool eventFilter(QObject* watched, QEvent* event) override;
};

void PatchView::Parts::build() {
  auto* layout = new QGridLayout(view);
  layout->setContentsMargins(0, 0, 0, 0);
  overlay = new SceneOverlay(view);
  if (hasOpenGl()) {
    gl = new QVTKOpenGLNativeWidget(view);
    gl->setFormat(surfaceFormat());
    gl->setRenderWindow(window.Get());
    gl->setAccessibleName(PatchView::tr("Skin patch in 3D"));
    gl->setFocusPolicy(Qt::NoFocus);
    gl->installEventFilter(this);
    vtkNew<SceneInteractorStyle> style;
    window->GetInteractor()->SetInteractorStyle(style);
    scene = std::make_unique<PatchScene>();
    scene->attachTo(window);
    layout->addWidget(gl, 0, 0, 2, 1);
    render_soon.setSingleShot(true);
    connect(&render_soon, &QTimer::timeout, this, [this] { window->Render(); });
    smoothWhenAtRest();
    buildControls(layout);
  }
  layout->addWidget(overlay, 0, 0, 2, 1);
  layout->setRowStretch(1, 1);
  overlay->raise();
  if (bar != nullptr) bar->raise();
  if (gl != nullptr) {
    motion = new PartMotion(view, gl, *scene, [this] { requestRender(); });
    motion->setParent(this);
    connect(motion, &PartMotion::turnRequested, view, &PatchView::turnRequested);
  }
  connect(selection, &Selection::changed, this, [this] { updateSelection(); });
  view->setMinimumHeight(180);
  updateOverlay();
}

QToolButton* PatchView::Parts::addButton(QHBoxLayout* row, const QString& text, const QString& tip) {
  auto* button = new QToolButton(bar);
  button->setText(text);
  button->setToolTip(tip);
  button->setFocusPolicy(Qt::TabFocus);
  row->addWidget(button);
  return button;
}

void PatchView::Parts::buildControls(QGridLayout* layout) {
  bar = new QFrame(view);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(10, 10, 10, 0);
  buildColoringMenu(row);
  row->addStretch(1);
  auto* fit_button = addButton(row, PatchView::tr("Fit"), PatchView::tr("Show the whole skin"));
  auto* front = addButton(row, PatchView::tr("Front"), PatchView::tr("Look at the origin cell's front face"));
  auto* side = addButton(row, PatchView::tr("Side"), PatchView::tr("Look along the origin cell's x axis"));
  auto* top = addButton(row, PatchView::tr("Top"), PatchView::tr("Look along the origin cell's y axis"));
  layout->addWidget(bar, 0, 0);

  connect(fit_button, &QToolButton::clicked, view, &PatchView::fit);
  const auto show = [this](StandardView standard) { return [this, standard] { view->showStandardView(standard); }; };
  connect(front, &QToolButton::clicked, this, show(StandardView::Front));
  connect(side, &QToolButton::clicked, this, show(StandardView::Side));
  connect(top, &QToolButton::clicked, this, show(StandardView::Top));
}

void PatchView::Parts::buildColoringMenu(QHBoxLayout* row) {
  auto* button = addButton(row, {}, PatchView::tr("What the cells' colour shows"));
  button->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(button);
  auto* group = new QActionGroup(menu);
  const auto add = [&](CellColoring value, const QString& name) {
    QAction* action = menu->addAction(name);
    action->setCheckable(true);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, button, value, name] {
      button->setText(PatchView::tr("Colour: %1 ▾").arg(name));
      coloring = value;
      scene->setColoring(value);
      updateOverlay();
      requestRender();
    });
    return action;
  };
  QAction* first = add(CellColoring::LinkQuality, PatchView::tr("link quality"));
  add(CellColoring::Deviation, PatchView::tr("predicted deviation"));
  add(CellColoring::Patch, PatchView::tr("patch"));
  button->setMenu(menu);
  first->trigger();
}

/// While the mouse turns the scene, pictures come without smoothing, which costs half their time.
void PatchView::Parts::smoothWhenAtRest() {
  constexpr int kRest_ms = 150;
  at_rest.setSingleShot(true);
  at_rest.setInterval(kRest_ms);
  connect(&at_rest, &QTimer::timeout, this, [this] {
    scene->setSmoothed(true);
    requestRender();
  });
  vtkInteractorObserver* style = window->GetInteractor()->GetInteractorStyle();
  style->AddObserver(vtkCommand::StartInteractionEvent, this, &Parts::startInteraction);
  style->AddObserver(vtkCommand::EndInteractionEvent, this, &Parts::endInteraction);
}

void PatchView::Parts::updateOverlay() {
  SceneOverlay::Content content;
  if (gl == nullptr) {
    content.hint = PatchView::tr(
        "The 3D view needs OpenGL 3.2, which is not available here. The graph and the tables still work.\n\n"
        "On a remote desktop, software rendering may help: start with LIBGL_ALWAYS_SOFTWARE=1.");
  } else if (!reconstruction || reconstruction->cellCount() == 0) {
    content.hint = PatchView::tr("No skin yet: open a session or start the demo.");
  } else {
    content.gravity = scene->showsGravity();
    content.coloring = coloring;
    content.patches = reconstruction->patches.size();
  }
  overlay->setContent(content);
  if (bar != nullptr) bar->setVisible(content.hint.isEmpty());
}

void PatchView::Parts::updateSelection() {
  if (!scene) return;
  scene->setSelection(selection->cell(), selection->link());
  updateOverlay();
  requestRender();
}

void PatchView::Parts::requestRender() {
  if (gl != nullptr && gl->isVisible()) render_soon.start();
}

void PatchView::Parts::pickAt(const QPoint& position) {
  const double ratio = gl->devicePixelRatioF();
  const auto picked = scene->pick(ratio * position.x(), ratio * (gl->height() - 1 - position.y()));
  if (picked) {
    selection->selectCell(*picked);
  } else {
    selection->clear();
  }
}

bool PatchView::Parts::eventFilter(QObject*, QEvent* event) {
  constexpr int kClickSlack = 3;  // pixels that a hand trembles within a click
  switch (event->type()) {
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
      event->ignore();  // so that it goes on to the window
      return true;
    case QEvent::Show:  // what changed while it was hidden
      requestRender();
      return false;
    case QEvent::MouseButtonPress:
      pressed_at = static_cast<QMouseEvent*>(event)->pos();
      return false;
    case QEvent::MouseButtonRelease: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      if (mouse->button() == Qt::LeftButton && (mouse->pos() - pressed_at).manhattanLength() <= kClickSlack) {
        pickAt(mouse->pos());
      }
      return false;
    }
    default:
      return false;
  }
}

PatchView::PatchView(Selection* selection, QWidget* parent)
    : QWidget(parent), parts_(std::make_unique<Parts>(this, selection)) {
  parts_->build();
  setTheme(Theme::Light);
}

PatchView::~PatchView() {
  delete parts_->motion;
  // The scene gives its OpenGL objects back while the context is still there.
  parts_->scene.reset();
  delete parts_->gl;
}

void PatchView::setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
  parts_->reconstruction = std::move(reconstruction);
  if (parts_->scene) parts_->scene->setReconstruction(parts_->reconstruction);
  parts_->updateSelection();
  parts_->updateOverlay();
  if (parts_->motion) parts_->motion->refresh();
}

void PatchView::setTheme(Theme theme) {
  parts_->theme = theme;
  const SceneColors colors = sceneColors(theme);
  parts_->overlay->setTheme(theme, colors);
  if (parts_->scene) parts_->scene->setColors(colors);
  if (parts_->motion) parts_->motion->setTheme(theme);
  QPalette own = palette();
  own.setColor(QPalette::Window, Colors::of(theme).scene_bottom);
  setPalette(own);
  setAutoFillBackground(true);
  parts_->requestRender();
}

void PatchView::setPose(std::optional<PoseId> pose) {
  if (!parts_->scene) return;
  parts_->scene->setPose(pose);
  parts_->updateOverlay();
  parts_->requestRender();
}

void PatchView::setCurrentUp(const std::optional<Eigen::Vector3d>& up_o) {
  if (!parts_->motion) return;
  const bool was_shown = parts_->scene->showsGravity();
  parts_->motion->setUp(up_o);
  if (parts_->scene->showsGravity() != was_shown) parts_->updateOverlay();
}

void PatchView::setNextUp(const std::optional<Eigen::Vector3d>& up_o) {
  if (parts_->motion) parts_->motion->setNextUp(up_o);
}

void PatchView::setTurnable(bool turnable) {
  if (parts_->motion) parts_->motion->setTurnable(turnable);
}

void PatchView::setAnimated(bool animated) {
  if (parts_->motion) parts_->motion->setAnimated(animated);
}

bool PatchView::isAnimating() const { return parts_->motion && parts_->motion->isAnimating(); }

QImage PatchView::screenshot() {
  if (parts_->gl == nullptr) return grab().toImage();
  // A view that was shown keeps its last picture until it is told to draw; one that never was draws for the first time.
  parts_->scene->setSmoothed(true);
  if (parts_->gl->isValid()) parts_->window->Render();
  QImage image = parts_->gl->grabFramebuffer();
  QPainter painter(&image);
  parts_->overlay->paint(painter, parts_->gl->size());
  parts_->motion->paintCaption(painter, parts_->gl->size());
  return image;
}

void PatchView::fit() {
  if (!parts_->scene) return;
  parts_->scene->fit();
  parts_->requestRender();
}

void PatchView::showStandardView(StandardView view) {
  if (!parts_->scene) return;
  switch (view) {
    case StandardView::Front:
      parts_->scene->showStandardView(PatchScene::View::Front);
      break;
    case StandardView::Side:
      parts_->scene->showStandardView(PatchScene::View::Side);
      break;
    case StandardView::Top:
      parts_->scene->showStandardView(PatchScene::View::Top);
      break;
  }
  parts_->requestRender();
}

}  // namespace hexoderm
