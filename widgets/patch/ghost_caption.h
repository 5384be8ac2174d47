#pragma once

#include <QWidget>

namespace hexoderm {

/// "next pose" beside its ghost in the 3D view, how far it is, and a curved arrow that leads there. Lets the mouse
/// through.
class GhostCaption : public QWidget {
  Q_OBJECT

 public:
  explicit GhostCaption(QWidget* parent = nullptr);

  void setShown(bool shown);
  /// "70°"; empty: not said.
  void setAngle(const QString& angle);
  void paint(QPainter& painter, const QSize& area) const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  bool shown_ = false;
  QString angle_;
};

}  // namespace hexoderm
