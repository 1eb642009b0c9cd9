#include "murosimf/simulation/film.h"

#include <cstdio>

#include "simulation/bouncing_balls.h"

namespace murosimf {
namespace {

FilmSettings smallFilm(const std::filesystem::path& file) {
  FilmSettings settings;
  settings.file = file;
  settings.format.width = 192, settings.format.height = 108;
  return settings;
}

/// The raw pictures of a video, by ffmpeg's own decoder.
std::string decoded(const std::filesystem::path& file) {
  const std::string command = "ffmpeg -loglevel error -i '" + file.string() + "' -f rawvideo -pix_fmt rgb24 -";
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string bytes;
  char buffer[65536];
  for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) bytes.append(buffer, n);
  EXPECT_EQ(pclose(pipe), 0);
  return bytes;
}

TEST(Film, HasAPictureEvery25thOfASecondOfTheWorldAsItIsThen) {
  const test::Folder folder;
  test::BouncingBalls game;
  Film film(*game.simulation, smallFilm(folder / "film.mp4"));
  game.simulation->observe(&film);
  game.run(400);  // 0.4 s: pictures at 0.001, 0.04, 0.08 ... 0.40
  const FilmReport report = film.finish();
  EXPECT_EQ(report.error, "");
  EXPECT_EQ(report.pictures, 11);
  const std::string bytes = decoded(folder / "film.mp4");
  const std::size_t size = 192 * 108 * 3;
  ASSERT_EQ(bytes.size(), 11 * size);
  EXPECT_NE(bytes.substr(0, size), bytes.substr(10 * size, size));  // balls have moved
  // The last picture is the last moment: the same as rendered here, but for the video's losses.
  OverviewSource source(*game.simulation);
  OverviewShot shot = source.emptyShot();
  source.take(shot);
  shot.caption = "T 0.40";
  Overview overview(192, 108, shot.scene.ground);
  const Picture& picture = overview.render(shot);
  double difference = 0;
  for (std::size_t i = 0; i < size; ++i) {
    difference += std::fabs(picture.rgb[i] - double(static_cast<unsigned char>(bytes[10 * size + i])));
  }
  EXPECT_LT(difference / double(size), 6.0);  // grey levels a byte
}

TEST(Film, ChangesNoBitOfTheRun) {
  const test::Folder folder;
  test::BouncingBalls plain, filmed;
  Film film(*filmed.simulation, smallFilm(folder / "film.mp4"));
  filmed.simulation->observe(&film);
  plain.run(300), filmed.run(300);
  EXPECT_EQ(plain.simulation->stateHash(), filmed.simulation->stateHash());
  EXPECT_EQ(film.finish().error, "");
}

TEST(Film, IsRefusedBeforeTheRunWhereItCannotBeMade) {
  const test::Folder folder;
  test::BouncingBalls game;
  FilmSettings settings = smallFilm(folder / "film.mp4");
  settings.format.program = "no_such_ffmpeg";
  const std::string missing = test::errorOf([&] { Film film(*game.simulation, settings); });
  EXPECT_NE(missing.find("film.mp4: cannot film: found no program no_such_ffmpeg"), std::string::npos) << missing;
  EXPECT_FALSE(std::filesystem::exists(folder / "film.mp4"));
  test::writeBytes(folder / "film.mp4", "an earlier film");
  EXPECT_NE(test::errorOf([&] { Film film(*game.simulation, settings); }), "");
  EXPECT_EQ(test::readBytes(folder / "film.mp4"), "an earlier film");
  const std::string nowhere = test::errorOf([&] { Film film(*game.simulation, smallFilm(folder / "no" / "f.mp4")); });
  EXPECT_NE(nowhere.find("f.mp4: cannot write the video: No such file"), std::string::npos) << nowhere;
  settings = smallFilm(folder / "film.mp4");
  settings.format.height = 107;
  const std::string odd = test::errorOf([&] { Film film(*game.simulation, settings); });
  EXPECT_NE(odd.find("must be even"), std::string::npos) << odd;
}

TEST(Film, ThatFailsIsReportedAndTheRunGoesOn) {
  const test::Folder folder;
  test::BouncingBalls game;
  FilmSettings settings = smallFilm(folder / "film.mp4");
  settings.format.program = "false";  // reads nothing, says nothing, ends with 1
  Film film(*game.simulation, settings);
  game.simulation->observe(&film);
  game.run(1000);
  EXPECT_EQ(game.simulation->frame(), 1000);
  const FilmReport report = film.finish();
  EXPECT_NE(report.error.find("false ended with exit status 1"), std::string::npos) << report.error;
}

TEST(Film, TellsTheLastWordsOfItsProgram) {
  const test::Folder folder;
  VideoFormat format;
  format.width = format.height = 64;
  VideoPipe pipe(folder / "film.not_a_video", format);  // ffmpeg knows no such format
  const std::vector<std::uint8_t> picture(64 * 64 * 3);
  for (int i = 0; i < 100 && pipe.write(picture); ++i) {
  }
  const std::string error = pipe.finish();
  EXPECT_NE(error.find("ffmpeg ended with exit status 1: "), std::string::npos) << error;
  EXPECT_NE(error.find("not_a_video"), std::string::npos) << error;
  EXPECT_EQ(pipe.finish(), error);
}

}  // namespace
}  // namespace murosimf
