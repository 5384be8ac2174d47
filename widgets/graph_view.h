#pragma once

#include "hexoderm/reconstruction/reconstruction.h"
#include "widgets/palette.h"

#include <QWidget>
#include <memory>

namespace hexoderm {

class Selection;

/// The live graph: the skin as a flat honeycomb, hexagons with IDs, every link in both directions with the colour and
/// line style of its quality, muted links grey and crossed, cuts of closed surfaces drawn, origin starred.
class GraphView : public QWidget {
  Q_OBJECT

 public:
  /// `selection` must outlive the view.
  explicit GraphView(Selection* selection, QWidget* parent = nullptr);
  ~GraphView() override;

  /// Null shows an empty view with a hint.
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction);
  void setTheme(Theme theme);

 public slots:
  void fit();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
