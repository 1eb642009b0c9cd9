#pragma once

/// @file Private to the packets: the numbers that each format gives to penalties and set plays.

#include <algorithm>
#include <optional>
#include <span>

#include "murosimf/control/game_controller/packets.h"

namespace murosimf::game_controller {

template <class Word>
struct Code {
  int number;
  Word word;
};

// Of a word that stands twice the first number is sent; both are understood.

inline constexpr Code<Penalty> kHslPenalties[] = {
    {0, Penalty::kNone},           {1, Penalty::kIllegalPosition}, {2, Penalty::kMotionInSet},
    {3, Penalty::kLocalGameStuck}, {4, Penalty::kIncapable},       {5, Penalty::kPickUp},
    {6, Penalty::kBallHolding},    {7, Penalty::kLeavingField},    {8, Penalty::kArmsOrHands},
    {9, Penalty::kPushing},        {10, Penalty::kSentOff},        {11, Penalty::kSubstitute}};

inline constexpr Code<Penalty> kSplPenalties[] = {{0, Penalty::kNone},           {1, Penalty::kBallHolding},
                                                  {2, Penalty::kPushing},        {3, Penalty::kMotionInSet},
                                                  {4, Penalty::kIncapable},      {5, Penalty::kIllegalPosition},
                                                  {6, Penalty::kLeavingField},   {7, Penalty::kPickUp},
                                                  {8, Penalty::kLocalGameStuck}, {9, Penalty::kIllegalPositionInSet},
                                                  {10, Penalty::kPlayerStance},  {14, Penalty::kSubstitute},
                                                  {15, Penalty::kManual}};

inline constexpr Code<Penalty> kHl12Penalties[] = {{0, Penalty::kNone},
                                                   {14, Penalty::kSubstitute},
                                                   {15, Penalty::kManual},
                                                   {30, Penalty::kBallHolding},
                                                   {31, Penalty::kPushing},
                                                   {32, Penalty::kIllegalAttack},
                                                   {33, Penalty::kIllegalDefence},
                                                   {34, Penalty::kPickUp},
                                                   {34, Penalty::kIncapable},
                                                   {35, Penalty::kService}};

inline constexpr Code<SetPlay> kHslSetPlays[] = {
    {0, SetPlay::kNone},    {1, SetPlay::kDirectFreeKick}, {2, SetPlay::kIndirectFreeKick}, {3, SetPlay::kPenaltyKick},
    {4, SetPlay::kThrowIn}, {5, SetPlay::kGoalKick},       {6, SetPlay::kCornerKick}};

// Its "pushing free kick" is a direct one, its kick-in a throw-in.
inline constexpr Code<SetPlay> kSplSetPlays[] = {
    {0, SetPlay::kNone},       {1, SetPlay::kGoalKick}, {2, SetPlay::kDirectFreeKick}, {2, SetPlay::kIndirectFreeKick},
    {3, SetPlay::kCornerKick}, {4, SetPlay::kThrowIn},  {5, SetPlay::kPenaltyKick}};

// States 0 to 3 of its "secondary state" are phases of the game.
inline constexpr Code<SetPlay> kHl12SetPlays[] = {{4, SetPlay::kDirectFreeKick}, {5, SetPlay::kIndirectFreeKick},
                                                  {6, SetPlay::kPenaltyKick},    {7, SetPlay::kCornerKick},
                                                  {8, SetPlay::kGoalKick},       {9, SetPlay::kThrowIn}};

template <class Word>
std::optional<int> codeOf(std::span<const Code<Word>> codes, Word word) {
  const auto found = std::find_if(codes.begin(), codes.end(), [&](const Code<Word>& c) { return c.word == word; });
  return found == codes.end() ? std::nullopt : std::optional(found->number);
}

template <class Word>
std::optional<Word> wordOf(std::span<const Code<Word>> codes, int number) {
  const auto found = std::find_if(codes.begin(), codes.end(), [&](const Code<Word>& c) { return c.number == number; });
  return found == codes.end() ? std::nullopt : std::optional(found->word);
}

}  // namespace murosimf::game_controller
