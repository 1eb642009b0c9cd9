#include "murosimf/simulation/coco_dataset.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "murosimf/simulation/png_writer.h"

namespace murosimf {

namespace {

constexpr const char* kAnnotations = "annotations.json";

/// Collects runs of labels, pixel by pixel in the order of columns.
class MaskCollector {
 public:
  void see(std::uint16_t label, int u, int v, long place) {
    if (label == kGroundLabel || label == kSkyLabel) {
      last_ = nullptr;
      return;
    }
    if (last_ == nullptr || label != last_label_) begin(label, u, v, place);
    VisibleMask& mask = last_->mask;
    ++mask.counts.back(), ++mask.area;
    mask.left = std::min(mask.left, u), mask.right = std::max(mask.right, u);
    mask.top = std::min(mask.top, v), mask.bottom = std::max(mask.bottom, v);
    last_->end = place + 1;
  }
  std::map<std::uint16_t, VisibleMask> finish(long pixels) {
    std::map<std::uint16_t, VisibleMask> masks;
    for (auto& [label, open] : open_) {
      if (open.end < pixels) open.mask.counts.push_back(pixels - open.end);
      masks.emplace(label, std::move(open.mask));
    }
    return masks;
  }

 private:
  struct Open {
    VisibleMask mask;
    long end = 0;  // behind its last run
  };
  void begin(std::uint16_t label, int u, int v, long place) {
    const auto [found, is_new] = open_.try_emplace(label);
    last_ = &found->second, last_label_ = label;
    if (is_new) last_->mask.left = last_->mask.right = u, last_->mask.top = last_->mask.bottom = v;
    last_->mask.counts.push_back(place - last_->end);
    last_->mask.counts.push_back(0);
  }
  std::map<std::uint16_t, Open> open_;
  Open* last_ = nullptr;
  std::uint16_t last_label_ = 0;
};

}  // namespace

std::map<std::uint16_t, VisibleMask> visibleMasks(const Picture& picture) {
  MaskCollector collector;
  long place = 0;
  for (int u = 0; u < picture.width; ++u) {
    for (int v = 0; v < picture.height; ++v, ++place) collector.see(picture.label[picture.index(u, v)], u, v, place);
  }
  return collector.finish(place);
}

CocoDataset::CocoDataset(std::filesystem::path folder, std::vector<LabelledObject> objects)
    : folder_(std::move(folder)), objects_(std::move(objects)) {
  if (std::filesystem::exists(folder_ / kAnnotations))
    throw std::runtime_error(fmt::format("{}: holds a dataset already, expected a new folder", folder_.string()));
  std::filesystem::create_directories(folder_);
  for (const LabelledObject& object : objects_) categoryOf(object.category);
}

/// From 1, in the order in which they were named.
int CocoDataset::categoryOf(const std::string& name) {
  const auto found = std::find(categories_.begin(), categories_.end(), name);
  const auto number = static_cast<int>(found - categories_.begin()) + 1;
  if (found == categories_.end()) categories_.push_back(name);
  return number;
}

void CocoDataset::add(const Picture& picture, const std::string& camera, long frame, double time) {
  const std::string file = fmt::format("{}/{:08}.png", camera, frame);
  std::filesystem::create_directories(folder_ / camera);
  writePng(folder_ / file, picture);
  const std::size_t image = images_.size() + 1;
  images_.push_back({{"id", image},
                     {"file_name", file},
                     {"width", picture.width},
                     {"height", picture.height},
                     {"camera", camera},
                     {"time", time}});
  for (const auto& [label, mask] : visibleMasks(picture)) {
    const auto object = std::find_if(objects_.begin(), objects_.end(), [&](auto& o) { return o.label == label; });
    if (object == objects_.end()) continue;
    const int width = mask.right - mask.left + 1, height = mask.bottom - mask.top + 1;
    annotations_.push_back({{"id", annotations_.size() + 1},
                            {"image_id", image},
                            {"category_id", categoryOf(object->category)},
                            {"bbox", {mask.left, mask.top, width, height}},
                            {"area", mask.area},
                            {"iscrowd", 0},
                            {"segmentation", {{"size", {picture.height, picture.width}}, {"counts", mask.counts}}},
                            {"object", object->name}});
  }
}

void CocoDataset::finish() const {
  nlohmann::ordered_json categories = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < categories_.size(); ++i)
    categories.push_back({{"id", i + 1}, {"name", categories_[i]}, {"supercategory", "field"}});
  const nlohmann::ordered_json all{{"info", {{"description", "pictures simulated by murosimf"}}},
                                   {"images", images_},
                                   {"annotations", annotations_},
                                   {"categories", categories}};
  const std::filesystem::path file = folder_ / kAnnotations, part = folder_ / (std::string(kAnnotations) + ".part");
  {
    std::ofstream out(part);
    out << all.dump() << '\n';
    if (!out.flush()) throw std::runtime_error(fmt::format("{}: cannot write", part.string()));
  }
  std::filesystem::rename(part, file);
}

}  // namespace murosimf
