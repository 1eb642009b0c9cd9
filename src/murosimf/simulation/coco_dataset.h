#pragma once

/// @file A set of pictures with what is seen in them, for the training of detectors, in COCO's object detection format.
///
/// A folder with `annotations.json` and the pictures that it names. Each visible object of a picture is one annotation:
/// tight box [left, top, width, height] and area in pixels of its visible part, and its exact mask as a run-length code
/// (counts of pixels that do not and do belong to it, in turn, column by column from the upper left). Beyond COCO's
/// fields an image tells `camera` and `time` [s], an annotation `object`, the simulated object's name.
/// [Lin et al. 2014, "Microsoft COCO"; cocodataset.org, data format]

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "murosimf/algorithms/picture.h"

namespace murosimf {

/// Which object a label of the pictures stands for.
struct LabelledObject {
  std::uint16_t label = 0;
  std::string name, category;  ///< "robots.red.2", "robot"
};

/// The visible part of one label in one picture.
struct VisibleMask {
  int left = 0, top = 0, right = 0, bottom = 0;  ///< outermost pixels [px]
  long area = 0;                                 ///< [px]
  std::vector<long> counts;                      ///< of the run-length code
};
/// Of every label but ground and sky.
std::map<std::uint16_t, VisibleMask> visibleMasks(const Picture& picture);

class CocoDataset {
 public:
  /// @param objects  those that become annotations; other labels are left out
  /// @throws std::runtime_error when the folder cannot be made, or holds a dataset already
  CocoDataset(std::filesystem::path folder, std::vector<LabelledObject> objects);

  /// Writes FOLDER/CAMERA/FRAME.png and remembers what is seen in it. The picture needs labels.
  /// @throws std::runtime_error when the picture cannot be written
  void add(const Picture& picture, const std::string& camera, long frame, double time);
  /// Writes annotations.json, by way of another name, so that it is whole or not there.
  void finish() const;
  std::size_t pictures() const { return images_.size(); }
  std::size_t annotations() const { return annotations_.size(); }

 private:
  int categoryOf(const std::string& name);

  std::filesystem::path folder_;
  std::vector<LabelledObject> objects_;
  std::vector<std::string> categories_;
  nlohmann::ordered_json images_ = nlohmann::ordered_json::array(), annotations_ = nlohmann::ordered_json::array();
};

}  // namespace murosimf
