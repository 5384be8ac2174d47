// Pictures of the graph that are compared with those in tests/baselines: fixed size and place, no text.

#include "widgets/graph/graph_picture.h"

#include "hexoderm/base/file.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/picture_difference.h"

#include <gtest/gtest.h>

#include <QtWidgets>

#include <cstdlib>

namespace hexoderm {
namespace {

constexpr QSizeF kSize(300, 220);
// A pixel differs if a channel is off by more than this: smoothing may differ between versions of Qt, lines don't.
constexpr int kChannelSlack = 40;
constexpr double kMaxDifferingShare = 0.0003;

/// Everything that the graph draws besides texts: four classes, a muted link inside of a patch and one between patches,
/// an origin, a cell placed by its links, a cut, the tree.
std::shared_ptr<Reconstruction> sample() {
  test::ResultBuilder builder(*sampleTwoPatches());
  builder.patch(31).cells(31, 34);
  for (std::uint32_t id = 31; id <= 34; ++id) builder.link(id, 2, id == 34 ? 31 : id + 1, 3, solvedLink());
  auto result = builder.share();
  result->patches[0].cells[1].cov_t_r = Matrix6d::Identity() * 1e-6;
  result->patches[0].links[1].in_tree = false;
  result->layout = computeFlatLayout(*result->model, result->patches);
  return result;
}

GraphPicture pictureOf(std::shared_ptr<const Reconstruction> reconstruction, Coloring coloring, const GraphStyle& style,
                       const QRectF& legend = {}) {
  const auto scene = std::make_shared<const GraphScene>(std::move(reconstruction));
  const auto paint = std::make_shared<const GraphPaint>(paintOf(*scene, coloring, style.theme));
  GraphCamera camera;
  camera.size = kSize;
  const QRectF& bounds = scene->bounds();
  camera.center = bounds.center();
  camera.scale = 0.94 * std::min(kSize.width() / bounds.width(), kSize.height() / bounds.height());
  return {scene, paint, camera, style, {}, legend};
}

QImage draw(std::shared_ptr<const Reconstruction> reconstruction, Coloring coloring, Theme theme) {
  GraphStyle style;
  style.theme = theme;
  style.has_text = false;
  QImage image(kSize.toSize(), QImage::Format_RGB32);
  QPainter painter(&image);
  pictureOf(std::move(reconstruction), coloring, style).draw(painter);
  return image;
}

double differingShare(const QImage& a, const QImage& b) { return hexoderm::differingShare(a, b, kChannelSlack); }

TEST(GraphPicture, LooksLikeTheBaselines) {
  const struct {
    const char* name;
    Coloring coloring;
    Theme theme;
  } baselines[] = {{"graph_quality_light", Coloring::LinkQuality, Theme::Light},
                   {"graph_quality_dark", Coloring::LinkQuality, Theme::Dark},
                   {"graph_patches", Coloring::Patch, Theme::Light}};
  for (const auto& [name, coloring, theme] : baselines) {
    const QImage picture = draw(sample(), coloring, theme);
    EXPECT_LE(differenceToBaseline(picture, name, kChannelSlack, kMaxDifferingShare), kMaxDifferingShare) << name;
  }
}

/// The negative controls: small changes must be seen.
TEST(GraphPicture, TheBaselineComparisonSeesOneLinkOfAnotherClassAndOneMovedCell) {
  const auto drawn = [](const std::shared_ptr<Reconstruction>& result) {
    return draw(result, Coloring::LinkQuality, Theme::Light);
  };
  const QImage before = drawn(sample());
  EXPECT_LE(differingShare(before, drawn(sample())), 0);
  auto other_class = sample();
  other_class->patches[0].links[0].quality = EdgeQuality::Partially;
  EXPECT_GT(differingShare(before, drawn(other_class)), 1.5 * kMaxDifferingShare);
  auto moved = sample();
  moved->layout.cells.front().center.x() += 0.01;
  EXPECT_GT(differingShare(before, drawn(moved)), 1.5 * kMaxDifferingShare);
}

TEST(GraphPicture, IsWrittenAsShapesOrAsPixels) {
  const QTemporaryDir folder;
  const GraphPicture picture = pictureOf(sampleX17(), Coloring::LinkQuality, {}, QRectF(10, 170, 280, 40));
  const QString svg = QDir(folder.path()).filePath("graph.svg");
  ASSERT_TRUE(picture.save(svg));
  const QByteArray text = QByteArray::fromStdString(readFile(svg.toStdString()));
  EXPECT_TRUE(text.contains("<svg"));
  EXPECT_FALSE(text.contains("<image")) << "shapes can be enlarged";
  EXPECT_GE(text.count("<polygon") + text.count("<path"), 17);
  const QString png = QDir(folder.path()).filePath("graph.png");
  ASSERT_TRUE(picture.save(png));
  EXPECT_EQ(QImage(png).size(), (2 * kSize).toSize());
  EXPECT_FALSE(picture.save(QDir(folder.path()).filePath("no/such/folder.svg")));
}

}  // namespace
}  // namespace hexoderm
