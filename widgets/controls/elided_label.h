#pragma once

#include <QLabel>

namespace hexoderm {

/// A label that never asks for more room, whatever its text: as many lines high as it is told to be, and as narrow as
/// its place. What does not fit ends in dots, and the tool tip has the whole of it. text() is always the whole.
class ElidedLabel : public QLabel {
  Q_OBJECT

 public:
  /// Property of labels whose whole text stands in the tool tip if it is elided.
  static constexpr const char* kElides = "elides";

  explicit ElidedLabel(int lines = 1, QWidget* parent = nullptr);

  [[nodiscard]] bool isElided() const;

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;
  [[nodiscard]] bool hasHeightForWidth() const override { return false; }
  [[nodiscard]] int heightForWidth(int width) const override;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  /// The lines that are shown; the last one elided if there would be more.
  [[nodiscard]] QStringList shownLines() const;
  [[nodiscard]] int linesHeight() const;

  int lines_;
};

}  // namespace hexoderm
