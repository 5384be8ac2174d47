// Smoothing without OpenGL, on pictures made by hand.

#include "widgets/patch/edge_smoothing.h"

#include <gtest/gtest.h>
#include <QColor>
#include <QTransform>
#include <algorithm>
#include <cmath>
#include <random>

namespace hexoderm {
namespace {

constexpr QRgb kDark = qRgb(20, 30, 40);
constexpr QRgb kLight = qRgb(240, 230, 220);

/// Light above a line through the middle, dark below it, as it is drawn without smoothing.
QImage edge(double slope) {
  QImage picture(64, 48, QImage::Format_RGB32);
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) picture.setPixel(x, y, y - 24 < slope * (x - 32) ? kLight : kDark);
  }
  return picture;
}

/// Sum of the squared steps between pixels one below the other.
double squaredSteps(const QImage& picture) {
  double sum = 0;
  for (int y = 1; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      sum += std::pow(qGray(picture.pixel(x, y)) - qGray(picture.pixel(x, y - 1)), 2);
    }
  }
  return sum;
}

int greatestDifference(const QImage& a, const QImage& b) {
  EXPECT_EQ(a.size(), b.size());
  int greatest = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QColor one = a.pixelColor(x, y);
      const QColor other = b.pixelColor(x, y);
      greatest = std::max({greatest, std::abs(one.red() - other.red()), std::abs(one.green() - other.green()),
                           std::abs(one.blue() - other.blue())});
    }
  }
  return greatest;
}

TEST(EdgeSmoothing, SlantedEdgesLoseTheirSteps) {
  for (const double slope : {0.2, 0.5, 1.0, -0.7}) {
    const QImage rough = edge(slope);
    const QImage smooth = smoothEdges(rough);
    EXPECT_LT(squaredSteps(smooth), 0.7 * squaredSteps(rough)) << slope;
    for (int x = 2; x < rough.width() - 2; ++x) {
      for (int y = 2; y < rough.height() - 2; ++y) {
        const double from_edge = std::abs(y - 24 - slope * (x - 32)) / std::hypot(1, slope);
        if (from_edge > 3) {
          EXPECT_EQ(smooth.pixel(x, y), rough.pixel(x, y)) << slope << ": " << x << ", " << y;
        }
        EXPECT_GE(qRed(smooth.pixel(x, y)), qRed(kDark));
        EXPECT_LE(qRed(smooth.pixel(x, y)), qRed(kLight));
      }
    }
  }
}

TEST(EdgeSmoothing, LeavesWhatHasNoEdges) {
  QImage gentle(40, 30, QImage::Format_RGB32);
  std::mt19937 random(1);
  std::uniform_int_distribution<int> noise(0, 3);
  for (int y = 0; y < gentle.height(); ++y) {
    for (int x = 0; x < gentle.width(); ++x) {
      const int gray = 100 + x + noise(random);
      gentle.setPixel(x, y, qRgb(gray, gray, gray));
    }
  }
  EXPECT_EQ(smoothEdges(gentle), gentle);
  // Straight up or across there are no steps to lose, up to the picture's border: no more than a twentieth is mixed.
  for (const QImage& straight : {edge(0), edge(0).transformed(QTransform().rotate(90))}) {
    EXPECT_LE(greatestDifference(smoothEdges(straight), straight), (qRed(kLight) - qRed(kDark)) / 20);
  }
}

TEST(EdgeSmoothing, PrefersNoDirection) {
  for (const double slope : {0.3, 0.8, -0.45}) {
    const QImage picture = edge(slope);
    EXPECT_LE(
        greatestDifference(smoothEdges(picture.mirrored(true, false)), smoothEdges(picture).mirrored(true, false)), 1);
    const QTransform quarter = QTransform().rotate(90);
    EXPECT_LE(greatestDifference(smoothEdges(picture.transformed(quarter)), smoothEdges(picture).transformed(quarter)),
              1);
  }
}

TEST(EdgeSmoothing, KeepsTheDensityAndPicturesTooSmallForEdges) {
  EXPECT_TRUE(smoothEdges(QImage()).isNull());
  for (const QSize& size : {QSize(1, 1), QSize(2, 9), QSize(9, 2), QSize(3, 3)}) {
    QImage small(size, QImage::Format_RGB32);
    small.fill(kDark);
    small.setPixel(0, 0, kLight);
    small.setDevicePixelRatio(1.5);
    EXPECT_EQ(smoothEdges(small).size(), size);
    EXPECT_EQ(smoothEdges(small).devicePixelRatio(), 1.5);
  }
}

}  // namespace
}  // namespace hexoderm
