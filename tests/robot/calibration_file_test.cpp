/// @file Calibrations as OpenCV, ROS and Bouguet's toolbox write them, and what is said of broken ones.

#include "murosimf/robot/calibration_file.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "murosimf/math/random.h"

namespace murosimf {
namespace {

const std::string kOpenCv = R"(%YAML:1.0
---
calibration_time: "Thu 01 Jan 2026"
image_width: 1024
image_height: 768
board_width: 9
flags: 0
fisheye_model: 0
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 8.6899337800000003e+02, 0., 5.2594232299999999e+02, 0.,
       8.6606300099999999e+02, 4.2004252900000000e+02, 0., 0., 1. ]
distortion_coefficients: !!opencv-matrix
   rows: 5
   cols: 1
   dt: d
   data: [ -3.9943099999999998e-01, 1.8892400000000001e-01, 1.53e-04, 5.71e-04, 0. ]
avg_reprojection_error: 2.0e-01
)";

const std::string kRos = R"(image_width: 640
image_height: 480
camera_name: head
camera_matrix:
  rows: 3
  cols: 3
  data: [461.6, 0.5, 361.1, 0, 460.3, 248.1, 0, 0, 1]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [-0.28, 0.07, 0.0002, 1.7e-05, 0]
rectification_matrix:
  rows: 3
  cols: 3
  data: [1, 0, 0, 0, 1, 0, 0, 0, 1]
)";

const std::string kTopic = R"(header:
  frame_id: head
height: 512
width: 512
distortion_model: equidistant
D: [0.0035, 0.0007, -0.002, 0.0002]
K: [190.9, 0.0, 254.9, 0.0, 190.8, 256.8, 0.0, 0.0, 1.0]
binning_x: 0
)";

const std::string kBouguet = R"(% Intrinsic and Extrinsic Camera Parameters
%-- Focal length:
fc = [ 657.462897012567460 ; 657.946733684193280 ];

%-- Principal point:
cc = [ 303.136653554201250 ; 242.569350554444350 ];
alpha_c = 0.000420000000000;   % skew
kc = [ -0.254034681330384 ; 0.121430000000000 ; ...
       -0.000210000000000 ; 0.000020000000000 ; 0.000000000000000 ];
fc_error = [ 0.3 ; 0.4 ];
nx = 640;
ny = 480;
n_ima = 20;
omc_1 = [ 1.654763e+00 ; 1.651920e+00 ; -6.699567e-01 ];
)";

struct Reading {
  std::optional<Calibration> calibration;
  std::vector<std::string> lines;  ///< "LINE: words"
};
Reading read(const std::string& text, const std::string& file = "lens.yaml") {
  Reading out;
  Diagnostics diagnostics;
  out.calibration = readCalibrationText(text, file, diagnostics);
  for (const Diagnostic& d : diagnostics.all()) out.lines.push_back(std::to_string(d.where.line) + ": " + d.message);
  EXPECT_EQ(out.calibration.has_value(), out.lines.empty());
  return out;
}
CameraModel good(const std::string& text, const std::string& file = "lens.yaml") {
  const Reading r = read(text, file);
  EXPECT_TRUE(r.calibration.has_value()) << (r.lines.empty() ? "" : r.lines.front());
  return r.calibration.value_or(Calibration{}).camera;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// The one complaint about the text with a part replaced.
std::string complaint(const std::string& text, const std::string& from, const std::string& to,
                      const std::string& file = "lens.yaml") {
  const Reading r = read(replaced(text, from, to), file);
  EXPECT_EQ(r.lines.size(), 1U) << from << " -> " << to;
  return r.lines.empty() ? "" : r.lines.front();
}
#define EXPECT_SAYS(text, words) EXPECT_NE((text).find(words), std::string::npos) << (text)

TEST(CalibrationFile, ReadsOpenCVsYaml) {
  const CameraModel c = good(kOpenCv);
  EXPECT_EQ(c.width, 1024);
  EXPECT_EQ(c.height, 768);
  EXPECT_EQ(c.fx, 868.993378);
  EXPECT_EQ(c.fy, 866.063001);
  EXPECT_EQ(c.cx, 525.942323);
  EXPECT_EQ(c.cy, 420.042529);
  EXPECT_EQ(c.kind, LensKind::kRational);
  EXPECT_EQ(c.kc, (std::array<double, 12>{-0.399431, 0.188924, 1.53e-4, 5.71e-4}));
}

TEST(CalibrationFile, ReadsFisheyesOfOpenCV) {
  std::string text = replaced(kOpenCv, "fisheye_model: 0", "fisheye_model: 1");
  text = replaced(text, ", 0. ]\navg", " ]\navg");
  EXPECT_EQ(good(replaced(text, "rows: 5", "rows: 4")).kind, LensKind::kFisheye);
  EXPECT_SAYS(complaint(kOpenCv, "fisheye_model: 0", "fisheye_model: 1"),
              "15: distortion_coefficients has 5 numbers, expected 4: k1 k2 k3 k4");
}

TEST(CalibrationFile, ReadsRosCameraInfo) {
  const CameraModel c = good(kRos);
  EXPECT_EQ(c.fx, 461.6);
  EXPECT_EQ(c.skew, 0.5 / 461.6);
  EXPECT_EQ(c.kc[3], 1.7e-5);
  const CameraModel topic = good(kTopic);
  EXPECT_EQ(topic.kind, LensKind::kFisheye);
  EXPECT_EQ(topic.cy, 256.8);
  EXPECT_EQ(topic.kc[3], 0.0002);
  EXPECT_EQ(good(replaced(kTopic, "D: [0.0035, 0.0007, -0.002, 0.0002]", "D:\n- 1\n- 0.1\n- 0\n- 0")).kc[0], 1.0);
  const std::string eight = replaced(replaced(kTopic, "equidistant", "rational_polynomial"),
                                     "[0.0035, 0.0007, -0.002, 0.0002]", "[1, 2, 3, 4, 5, 6, 7, 8]");
  EXPECT_EQ(good(eight).kc, (std::array<double, 12>{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(CalibrationFile, ReadsBouguetsResults) {
  const CameraModel c = good(kBouguet, "Calib_Results.m");
  EXPECT_EQ(c.width, 640);
  EXPECT_EQ(c.height, 480);
  EXPECT_EQ(c.fx, 657.46289701256746);
  EXPECT_EQ(c.cy, 242.56935055444435);
  EXPECT_EQ(c.skew, 0.00042);
  EXPECT_EQ(c.kc, (std::array<double, 12>{-0.254034681330384, 0.12143, -0.00021, 0.00002, 0}));
}

TEST(CalibrationFile, SizeMayBeMissing) {
  std::string text = replaced(replaced(kRos, "image_width: 640\n", ""), "image_height: 480\n", "");
  EXPECT_FALSE(read(text).calibration->has_size);
  EXPECT_TRUE(read(kRos).calibration->has_size);
  EXPECT_SAYS(complaint(kRos, "image_width: 640\n", ""), "1: image_height stands alone");
}

TEST(CalibrationFile, TiltedSensorsAreRefusedAndZeroTiltIsNot) {
  const std::string from = "[0.0035, 0.0007, -0.002, 0.0002]";
  const std::string text = replaced(kTopic, "equidistant", "rational_polynomial");
  EXPECT_EQ(good(replaced(text, from, "[1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 0, 0]")).kc[11], 12.0);
  EXPECT_SAYS(complaint(text, from, "[1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 0.01, 0]"), "6: D has a tilted sensor");
}

TEST(CalibrationFile, MistakesOfYamlAreToldWithTheirLine) {
  EXPECT_SAYS(complaint(kRos, "-0.28,", "-0.28e,"), "12: a number of distortion_coefficients is \"-0.28e\"");
  EXPECT_SAYS(complaint(kRos, "-0.28,", ".nan,"), "12: a number of distortion_coefficients is \".nan\"");
  EXPECT_SAYS(complaint(kRos, "plumb_bob", "plum_bob"),
              "8: distortion_model is \"plum_bob\", expected plumb_bob, rational, rational_polynomial, fisheye, "
              "equidistant (did you mean \"plumb_bob\"?)");
  EXPECT_SAYS(complaint(kRos, "plumb_bob", "equidistant"), "has 5 numbers, expected 4");
  EXPECT_SAYS(complaint(kRos, "cols: 5", "cols: 4"), "10: distortion_coefficients has 5 numbers, expected rows times");
  EXPECT_SAYS(complaint(kRos, "camera_matrix", "camera_matrx"),
              "0: camera_matrix is missing, expected 9 numbers, row by row (did you mean \"camera_matrx\"?)");
  EXPECT_SAYS(complaint(kRos, "0.5, 361.1, 0,", "0.5, 361.1, 3,"),
              "camera_matrix is no such matrix, expected 9: fx s cx");
  EXPECT_SAYS(complaint(kRos, "461.6", "-461.6"), "has the focal lengths -461.6 and 460.3, expected positive ones");
  EXPECT_SAYS(complaint(kRos, "640", "64.5"), "1: image_width is 64.5, expected a whole number from 1 to 8192");
  EXPECT_SAYS(complaint(kTopic, "binning_x: 0", "binning_x: 2"), "8: binning_x is 2, expected 0 or 1");
  EXPECT_SAYS(complaint(kTopic, "D: [", "D: {"), "not YAML");
  EXPECT_SAYS(read("").lines.at(0), "1: holds no table of keys");
  EXPECT_SAYS(read(std::string("a: \0b", 5)).lines.at(0), "zero byte");
  EXPECT_SAYS(read(std::string(100000, '[')).lines.at(0), "not YAML");
}

TEST(CalibrationFile, MistakesOfBouguetsFilesAreToldWithTheirLine) {
  const auto said = [](const std::string& from, const std::string& to) {
    return complaint(kBouguet, from, to, "Calib_Results.m");
  };
  EXPECT_SAYS(said("; 657.946733684193280 ]", "]"), "3: fc is \"657.462897012567460\", expected 2 numbers");
  EXPECT_SAYS(said("\nkc = ", "\nkk = "), "0: kc is missing, expected kc = [ ... ];");
  EXPECT_SAYS(said("nx = 640", "nx = wide"), "11: nx is \"wide\", expected 1 number");
  EXPECT_SAYS(said("ny = 480;", ""), "nx stands alone");
}

TEST(CalibrationFile, FilesThatAreNotThereAreNamed) {
  Diagnostics diagnostics;
  EXPECT_FALSE(readCalibrationFile("/nowhere/lens.yaml", diagnostics));
  EXPECT_EQ(diagnostics.text(), "/nowhere/lens.yaml: error: cannot be read, expected a file of at most 1 MiB\n");
}

TEST(CalibrationFile, MutilatedFilesNeverCrashTheReader) {
  const RandomStream random(3, "calibrations", 0);
  std::uint64_t draw = 0;
  for (const std::string& text : {kOpenCv, kRos, kTopic, kBouguet}) {
    for (int i = 0; i < 1500; ++i) {
      std::string broken = text;
      for (int k = 0; k < 1 + i % 4; ++k) {
        const auto at = static_cast<std::size_t>(random.uniform(draw++, 0, static_cast<double>(broken.size() - 1)));
        const char c = "[]{}:;,=%-!&*'\"#\n 0e."[static_cast<int>(random.uniform(draw++, 0, 21.0))];
        random.uniform(draw++) < 0.3 ? broken.erase(at, 7) : broken.insert(at, 1, c);
        if (broken.size() < 8) break;
      }
      Diagnostics diagnostics;
      const auto read = readCalibrationText(broken, text[0] == '%' && text[1] == ' ' ? "a.m" : "a.yaml", diagnostics);
      EXPECT_EQ(read.has_value(), !diagnostics.hasErrors());
    }
  }
}

}  // namespace
}  // namespace murosimf
