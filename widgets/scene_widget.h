#pragma once

#include <QVTKOpenGLNativeWidget.h>

namespace hexoderm {

/// VTK's widget, which draws whenever it is resized; while a layout comes to rest that is several times at once, for
/// pictures that nobody sees. This one draws the size that it has in the end, when Qt paints it.
class SceneWidget : public QVTKOpenGLNativeWidget {
 public:
  using QVTKOpenGLNativeWidget::QVTKOpenGLNativeWidget;

 protected:
  void resizeEvent(QResizeEvent* event) override {
    resizes_ = true;
    QVTKOpenGLNativeWidget::resizeEvent(event);
    resizes_ = false;
    update();
  }
  void paintGL() override {
    if (!resizes_) QVTKOpenGLNativeWidget::paintGL();
  }

 private:
  bool resizes_ = false;
};

}  // namespace hexoderm
