// Pictures with what is seen in them, in COCO's format.

#include "murosimf/simulation/coco_dataset.h"

#include <gtest/gtest.h>

#include <fstream>

namespace murosimf::test {
namespace {

namespace fs = std::filesystem;

Picture pictureOf(const std::vector<std::vector<std::uint16_t>>& rows) {
  Picture picture;
  picture.has_depth = false;
  picture.resize(static_cast<int>(rows.front().size()), static_cast<int>(rows.size()));
  for (int v = 0; v < picture.height; ++v) {
    for (int u = 0; u < picture.width; ++u)
      picture.label[picture.index(u, v)] = rows[static_cast<std::size_t>(v)][static_cast<std::size_t>(u)];
  }
  return picture;
}

/// The mask of a run-length code, as COCO's tools read it.
std::vector<int> decoded(const std::vector<long>& counts) {
  std::vector<int> mask;
  int value = 0;
  for (const long count : counts) {
    mask.insert(mask.end(), static_cast<std::size_t>(count), value);
    value = 1 - value;
  }
  return mask;
}

TEST(VisibleMasks, AreTightAndGiveEveryPixelBack) {
  constexpr std::uint16_t S = kSkyLabel;
  const Picture picture = pictureOf({{S, S, 2, S, S}, {1, 1, 2, 0, 0}, {1, 0, 2, 3, 3}, {0, 0, 0, 0, 3}});
  const auto masks = visibleMasks(picture);
  ASSERT_EQ(masks.size(), 3U);
  for (const auto& [label, mask] : masks) {
    const std::vector<int> all = decoded(mask.counts);
    ASSERT_EQ(all.size(), 20U);
    long area = 0;
    for (int u = 0; u < 5; ++u) {
      for (int v = 0; v < 4; ++v) {
        const bool is_seen = picture.label[picture.index(u, v)] == label;
        area += is_seen ? 1 : 0;
        EXPECT_EQ(all[static_cast<std::size_t>(4 * u + v)], is_seen ? 1 : 0) << label << " at " << u << ' ' << v;
        const bool is_inside = u >= mask.left && u <= mask.right && v >= mask.top && v <= mask.bottom;
        EXPECT_TRUE(is_inside || !is_seen);
      }
    }
    EXPECT_EQ(mask.area, area);
  }
  const VisibleMask& third = masks.at(3);
  EXPECT_EQ(third.left, 3);
  EXPECT_EQ(third.top, 2);
  EXPECT_EQ(third.right, 4);
  EXPECT_EQ(third.bottom, 3);
}

class InAFolder : public testing::Test {
 protected:
  InAFolder() : folder_(fs::path(testing::TempDir()) / "murosimf_coco") { fs::remove_all(folder_); }
  ~InAFolder() override { fs::remove_all(folder_); }
  fs::path folder_;
};

TEST_F(InAFolder, DatasetsNamePicturesCategoriesAndObjects) {
  CocoDataset dataset(folder_, {{1, "ball", "ball"}, {2, "robots.red.1", "robot"}, {3, "robots.blue.1", "robot"}});
  dataset.add(pictureOf({{0, 1, 1}, {9, 3, 0}}), "robots.red.1.camera", 50, 0.05);
  dataset.add(pictureOf({{0, 0, 0}, {0, 0, 2}}), "robots.red.1.camera", 100, 0.1);
  dataset.finish();
  std::ifstream in(folder_ / "annotations.json");
  const nlohmann::json all = nlohmann::json::parse(in);
  EXPECT_EQ(all["images"].size(), 2U);
  EXPECT_TRUE(fs::exists(folder_ / all["images"][1]["file_name"].get<std::string>()));
  ASSERT_EQ(all["annotations"].size(), 3U) << "9 is none of the named objects";
  EXPECT_EQ(all["annotations"][0]["bbox"], (nlohmann::json{1, 0, 2, 1}));
  EXPECT_EQ(all["annotations"][1]["object"], "robots.blue.1");
  EXPECT_EQ(all["annotations"][2]["image_id"], 2);
  EXPECT_EQ(all["categories"].size(), 2U);
  EXPECT_EQ(all["categories"][1]["name"], "robot");
}

TEST_F(InAFolder, DatasetsAreNeverMixed) {
  CocoDataset(folder_, {}).finish();
  EXPECT_THROW(CocoDataset(folder_, {}), std::runtime_error);
}

}  // namespace
}  // namespace murosimf::test
