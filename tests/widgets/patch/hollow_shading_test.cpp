#include "widgets/patch/hollow_shading.h"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

namespace hexoderm {
namespace {

constexpr int kSide = 64;
constexpr float kNothing = std::numeric_limits<float>::infinity();

template <class DepthAt>
DepthPicture depthOf(const DepthAt& depth_at) {
  DepthPicture depth{kSide, kSide, {}};
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) depth.depth_m.push_back(depth_at(x, y));
  }
  return depth;
}

QImage plainPicture() {
  QImage picture(kSide, kSide, QImage::Format_RGB32);
  picture.fill(QColor(200, 100, 50));
  return picture;
}

TEST(HollowShading, APlaneStaysAsItIsHoweverItIsTilted) {
  const QImage picture = plainPicture();
  const auto tilted = [](int x, int y) { return 1 + 0.001F * static_cast<float>(x) - 0.002F * static_cast<float>(y); };
  EXPECT_EQ(shadeHollows(picture, depthOf(tilted), 0.01), picture);
}

TEST(HollowShading, WhatLiesLowerIsDarkerBesideAStepAndWhatLiesHigherIsNot) {
  const QImage picture = plainPicture();
  const QImage shaded = shadeHollows(picture, depthOf([](int x, int) { return x < 32 ? 1.0F : 1.01F; }), 0.01);
  EXPECT_LT(qRed(shaded.pixel(33, 32)), 0.9 * 200);
  EXPECT_GT(qRed(shaded.pixel(33, 32)), 0.5 * 200) << "it can still be made out";
  EXPECT_EQ(shaded.pixel(30, 32), picture.pixel(30, 32));
  EXPECT_EQ(shaded.pixel(50, 32), picture.pixel(50, 32)) << "far from the step";
  EXPECT_NEAR(qGreen(shaded.pixel(33, 32)), 0.5 * qRed(shaded.pixel(33, 32)), 2) << "the colour stays";
}

TEST(HollowShading, ADeeperStepIsDarkerUpToALimit) {
  const auto redBeside = [](float step_m) {
    return qRed(shadeHollows(plainPicture(), depthOf([=](int x, int) { return x < 32 ? 1.0F : 1.0F + step_m; }), 0.01)
                    .pixel(33, 32));
  };
  EXPECT_GT(redBeside(0.002F), redBeside(0.005F) + 5);
  EXPECT_GT(redBeside(0.005F), redBeside(0.01F) + 5);
  EXPECT_NEAR(redBeside(0.01F), redBeside(1.0F), 1);
}

TEST(HollowShading, TheEdgeOfThePartAndTheBackgroundStay) {
  const QImage picture = plainPicture();
  EXPECT_EQ(shadeHollows(picture, depthOf([](int x, int) { return x < 32 ? 1.0F : kNothing; }), 0.01), picture);
}

TEST(HollowShading, PicturesOfAnyOtherSizeAreLeftAlone) {
  const QImage picture = plainPicture();
  EXPECT_EQ(shadeHollows(picture, DepthPicture{2, 2, {1, 1, 1, 1}}, 0.01), picture);
  EXPECT_TRUE(shadeHollows(QImage(), DepthPicture(), 0.01).isNull());
}

TEST(HollowShading, DepthsAreThoseOfTheProjection) {
  // Two rows of two, the lower first.
  HollowSight sight;
  sight.near_m = 0.5;
  sight.far_m = 2;
  const auto depthsOf = [](double at_m, const HollowSight& s) {
    return static_cast<float>(s.parallel ? (at_m - s.near_m) / (s.far_m - s.near_m)
                                         : s.far_m * (at_m - s.near_m) / (at_m * (s.far_m - s.near_m)));
  };
  for (const bool parallel : {false, true}) {
    sight.parallel = parallel;
    const DepthPicture depth =
        depthPicture({depthsOf(0.6, sight), depthsOf(0.9, sight), depthsOf(1.5, sight), 1.0F}, QSize(2, 2), sight);
    EXPECT_NEAR(depth.depth_m[0], 1.5, 1e-5);
    EXPECT_EQ(depth.depth_m[1], kNothing);
    EXPECT_NEAR(depth.depth_m[2], 0.6, 1e-5);
    EXPECT_NEAR(depth.depth_m[3], 0.9, 1e-5);
  }
  sight.elsewhere.emplace_back(0, 1, 1, 5);
  const DepthPicture covered = depthPicture({0.1F, 0.1F, 0.1F, 0.1F}, QSize(2, 2), sight);
  EXPECT_EQ(covered.depth_m[2], kNothing);
  EXPECT_NE(covered.depth_m[0], kNothing);
  EXPECT_NE(covered.depth_m[3], kNothing);
}

}  // namespace
}  // namespace hexoderm
