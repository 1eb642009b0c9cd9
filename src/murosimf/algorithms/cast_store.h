#pragma once

/// @file From light to bytes: gain, noise, rounding, and the layout of the picture. A part of the ray caster's kernel.

#include "murosimf/algorithms/cast_tile.h"
#include "murosimf/algorithms/pixel_noise.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// A colour's byte: light times gain plus noise, rounded and cut to 0..255. `bytes` are 255 for a light of 1.
template <class S>
inline WordsOf<S> toByte(S light, S gain, S noise_bytes) {
  return toWords(clamp((light * gain + noise_bytes) + S(0.5F), S(0.0F), S(255.0F)));
}

inline constexpr std::uint32_t kColumns[kTileSize] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

/// Sixteen words 0x00bbggrr of one row of a tile, its first pixel being number `pixel` of the picture.
template <class S>
inline void makeWords(const CastJob& job, const TileBuffer& b, int first, std::uint32_t pixel, std::uint32_t* words) {
  const S gain(job.gain), deviation(job.deviation);
  for (int column = 0; column < kTileSize; column += Lanes<S>::kWidth) {
    const int i = first + column;
    S red(0.0F), green(0.0F), blue(0.0F);
    if (job.deviation > 0.0F) {
      const WordsOf<S> counter = (loadWords<S>(kColumns + column) + pixel) * 3U;
      red = deviation * noise<S>(counter, job.key_low, job.key_high);
      green = deviation * noise<S>(counter + 1U, job.key_low, job.key_high);
      blue = deviation * noise<S>(counter + 2U, job.key_low, job.key_high);
    }
    const WordsOf<S> bytes = toByte(load<S>(b.red + i), gain, red) | (toByte(load<S>(b.green + i), gain, green) << 8) |
                             (toByte(load<S>(b.blue + i), gain, blue) << 16);
    storeWords<S>(words + column, bytes);
  }
}

/// Sixteen words 0x00bbggrr to 48 bytes r g b r g b ...
inline void storeColours(const std::uint32_t* words, std::uint8_t* rgb) {
  const __m128i pick = _mm_setr_epi8(0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, -1, -1, -1, -1);
  __m128i part[4];  // 12 bytes each
  for (int k = 0; k < 4; ++k) {
    __builtin_memcpy(&part[k], words + 4 * k, sizeof part[k]);
    part[k] = _mm_shuffle_epi8(part[k], pick);
  }
  const __m128i first = _mm_or_si128(part[0], _mm_slli_si128(part[1], 12));
  const __m128i second = _mm_or_si128(_mm_srli_si128(part[1], 4), _mm_slli_si128(part[2], 8));
  const __m128i third = _mm_or_si128(_mm_srli_si128(part[2], 8), _mm_slli_si128(part[3], 4));
  __builtin_memcpy(rgb, &first, sizeof first);
  __builtin_memcpy(rgb + 16, &second, sizeof second);
  __builtin_memcpy(rgb + 32, &third, sizeof third);
}

/// Sixteen depths and labels of a row of a tile; labels are cut to 0..65535.
template <class S>
inline void storeDepths(const TileBuffer& b, int first, float* depth) {
  for (int column = 0; column < kTileSize; column += Lanes<S>::kWidth)
    store(depth + column, S(1.0F) / load<S>(b.w + first + column));
}
inline void storeLabels(const TileBuffer& b, int first, std::uint16_t* label) {
  for (int column = 0; column < kTileSize; column += 8) {
    __m128 low, high;
    __builtin_memcpy(&low, b.label + first + column, sizeof low);
    __builtin_memcpy(&high, b.label + first + column + 4, sizeof high);
    const __m128i words = _mm_packus_epi32(_mm_cvttps_epi32(low), _mm_cvttps_epi32(high));
    __builtin_memcpy(label + column, &words, sizeof words);
  }
}

/// Sixteen parts: surfaces count from -2 on, a quarter more where they lie in a shadow.
inline void storeParts(const CastJob& job, const TileBuffer& b, int first, std::int32_t* part) {
  for (int column = 0; column < kTileSize; ++column)
    part[column] = job.part_of[static_cast<std::int32_t>(b.surface[first + column] + 2.0F)];
}

/// Where pixels go: depth, label and part may be null.
struct Store {
  std::uint8_t* rgb;
  float* depth;
  std::uint16_t* label;
  std::int32_t* part;
};
inline Store storeAt(const CastJob& job, std::uint32_t pixel) {
  return {job.rgb + 3UL * pixel, job.depth ? job.depth + pixel : nullptr, job.label ? job.label + pixel : nullptr,
          job.part ? job.part + pixel : nullptr};
}

/// Sixteen finished pixels.
struct RowOfTile {
  std::uint8_t rgb[3 * kTileSize];
  float depth[kTileSize];
  std::uint16_t label[kTileSize];
  std::int32_t part[kTileSize];
};

/// Writes row `first / 16` of a tile. `pixel`: number of its first pixel in the picture.
template <class S>
inline void storeRow(const CastJob& job, const TileBuffer& b, int first, std::uint32_t pixel, const Store& to) {
  alignas(64) std::uint32_t words[kTileSize];
  makeWords<S>(job, b, first, pixel, words);
  storeColours(words, to.rgb);
  if (to.depth) storeDepths<S>(b, first, to.depth);
  if (to.label) storeLabels(b, first, to.label);
  if (to.part) storeParts(job, b, first, to.part);
}

/// The colours of a row of a tile, before the sensor.
inline void storeLight(const CastJob& job, const TileBuffer& b, int first, std::uint32_t pixel, int count) {
  const float* colours[3] = {b.red + first, b.green + first, b.blue + first};
  for (int i = 0; i < 3; ++i)
    __builtin_memcpy(job.light[i] + pixel, colours[i], static_cast<unsigned>(count) * sizeof(float));
}

/// Last pass: writes the part of a tile that lies in the job's rows and in the picture.
template <class S>
inline void storeTile(const CastJob& job, const TileBuffer& b, int left, int top) {
  const int count = job.width - left;
  for (int row = 0; row < kTileSize; ++row) {
    const int v = top + row, first = row * kTileSize;
    if (v < job.first_row || v >= job.last_row) continue;
    const auto pixel =
        static_cast<std::uint32_t>(v) * static_cast<std::uint32_t>(job.width) + static_cast<std::uint32_t>(left);
    const Store to = storeAt(job, pixel);
    if (job.light[0]) storeLight(job, b, first, pixel, count < kTileSize ? count : kTileSize);
    if (count >= kTileSize) {
      storeRow<S>(job, b, first, pixel, to);
      continue;
    }
    RowOfTile made;
    storeRow<S>(job, b, first, pixel, {made.rgb, made.depth, made.label, to.part ? made.part : nullptr});
    for (int i = 0; i < 3 * count; ++i) to.rgb[i] = made.rgb[i];
    for (int i = 0; to.depth && i < count; ++i) to.depth[i] = made.depth[i];
    for (int i = 0; to.label && i < count; ++i) to.label[i] = made.label[i];
    for (int i = 0; to.part && i < count; ++i) to.part[i] = made.part[i];
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
