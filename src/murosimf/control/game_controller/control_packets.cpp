#include <fmt/format.h>

#include <stdexcept>

#include "murosimf/control/game_controller/byte_order.h"
#include "murosimf/control/game_controller/words_of_formats.h"

namespace murosimf::game_controller {

namespace {

constexpr int kNoTeam = 255;                                     // as kicking team: nobody, or a dropped ball
constexpr std::size_t kHl12Players = 11, kHl12CoachBytes = 254;  // sequence number and text of the coach's message
constexpr int kNoDropIn = 0xFFFF;

struct Layout {
  Format format;
  int version;
  std::size_t bytes;
  const char* league;
  std::span<const Code<Penalty>> penalties;
  Penalty other_penalty;  // sent for one that the format has no number for
  std::span<const Code<SetPlay>> set_plays;
};

const Layout kLayouts[] = {
    {Format::kHsl19, 19, 198, "Humanoid Soccer League", kHslPenalties, Penalty::kPickUp, kHslSetPlays},
    {Format::kSpl18, 18, 118, "Standard Platform League", kSplPenalties, Penalty::kManual, kSplSetPlays},
    {Format::kHl15, 15, 118, "Humanoid League 2025", kSplPenalties, Penalty::kManual, kSplSetPlays},
    {Format::kHl12, 12, 688, "Humanoid League, virtual season", kHl12Penalties, Penalty::kManual, kHl12SetPlays}};

const Layout& layoutOf(Format format) {
  return *std::find_if(std::begin(kLayouts), std::end(kLayouts), [&](const Layout& l) { return l.format == format; });
}

/// Penalties of red-carded robots are red cards where the format has no other word.
int penaltyCode(const Layout& layout, const PlayerState& player) {
  return codeOf(layout.penalties, player.penalty).value_or(*codeOf(layout.penalties, layout.other_penalty));
}

int teamByte(int number) { return number == kNobody ? kNoTeam : number; }
int teamNumber(int byte) { return byte == kNoTeam ? kNobody : byte; }

void writeTeam(LittleEndianWriter& out, const TeamState& team, const Layout& layout) {
  out.u8(team.number);
  out.u8(team.field_colour);
  out.u8(team.keeper_colour);
  out.u8(team.goalkeeper);
  out.u8(team.score);
  out.u8(team.penalty_shots);
  out.u16(team.shots_scored);
  out.u16(team.message_budget);
  for (const PlayerState& player : team.players) {
    out.u8(penaltyCode(layout, player));
    out.u8(player.seconds_left);
    if (layout.format != Format::kHsl19) continue;
    out.u8(player.warnings);
    out.u8(player.yellow_cards);
  }
}

void writeNew(LittleEndianWriter& out, const GameState& game, const Layout& layout) {
  out.u8(layout.version);
  out.u8(game.packet & 0xFF);
  out.u8(game.players_per_team);
  if (layout.format == Format::kHsl19) {
    out.u8(game.competition);
    out.u8(game.stopped ? 1 : 0);
  } else {
    out.u8(game.round);
    out.u8(game.competition);
  }
  out.u8(static_cast<int>(game.phase));
  out.u8(static_cast<int>(game.state));
  out.u8(codeOf(layout.set_plays, game.set_play).value_or(0));
  out.u8(game.first_half ? 1 : 0);
  out.u8(teamByte(game.kicking_team));
  out.i16(game.seconds_remaining);
  out.i16(game.secondary_seconds);
  for (const TeamState& team : game.teams) writeTeam(out, team, layout);
}

void writeHl12Team(LittleEndianWriter& out, const TeamState& team, const Layout& layout) {
  out.u8(team.number);
  out.u8(team.field_colour);
  out.u8(team.score);
  out.u8(team.penalty_shots);
  out.u16(team.shots_scored);
  out.zeros(kHl12CoachBytes + 6);  // the coach is no player of ours
  for (std::size_t i = 0; i < kHl12Players; ++i) {
    const PlayerState& player = team.players[i];
    out.u8(penaltyCode(layout, player));
    out.u8(player.seconds_left);
    out.u8(player.warnings);
    out.u8(player.yellow_cards);
    out.u8(player.red_cards);
    out.u8(team.goalkeeper == static_cast<int>(i) + 1 ? 1 : 0);
  }
}

/// Set plays go before phases: the one byte can tell but one of them.
void writeHl12(LittleEndianWriter& out, const GameState& game, const Layout& layout) {
  const std::optional<int> set_play = codeOf(layout.set_plays, game.set_play);
  out.u16(layout.version);
  out.u8(game.packet & 0xFF);
  out.u8(game.players_per_team);
  out.u8(game.competition);
  out.u8(static_cast<int>(game.state));
  out.u8(game.first_half ? 1 : 0);
  out.u8(teamByte(game.kicking_team));
  out.u8(set_play.value_or(static_cast<int>(game.phase)));
  out.u8(set_play ? teamByte(game.kicking_team) : 0);
  out.zeros(3);
  out.u8(0);
  out.u16(kNoDropIn);
  out.u16(game.seconds_remaining);
  out.u16(game.secondary_seconds);
  for (const TeamState& team : game.teams) writeHl12Team(out, team, layout);
}

/// Thrown and caught here alone.
struct Refused {
  std::string why;
};

template <class Word>
Word decoded(std::span<const Code<Word>> codes, int number, const char* what) {
  const std::optional<Word> word = wordOf(codes, number);
  if (!word) throw Refused{fmt::format("{} is {}, which the format does not have", what, number)};
  return *word;
}

template <class Word>
Word decoded(int number, Word last, const char* what) {
  if (number > static_cast<int>(last))
    throw Refused{fmt::format("{} is {}, expected 0 to {}", what, number, static_cast<int>(last))};
  return static_cast<Word>(number);
}

PlayerState readPlayer(LittleEndianReader& in, const Layout& layout) {
  PlayerState player;
  player.penalty = decoded(layout.penalties, in.u8(), "a player's penalty");
  player.seconds_left = in.u8();
  if (layout.format != Format::kHsl19) return player;
  player.warnings = in.u8();
  player.yellow_cards = in.u8();
  return player;
}

TeamState readTeam(LittleEndianReader& in, const Layout& layout) {
  TeamState team;
  team.number = in.u8();
  team.field_colour = in.u8();
  team.keeper_colour = in.u8();
  team.goalkeeper = in.u8();
  team.score = in.u8();
  team.penalty_shots = in.u8();
  team.shots_scored = static_cast<std::uint16_t>(in.u16());
  team.message_budget = in.u16();
  for (PlayerState& player : team.players) player = readPlayer(in, layout);
  return team;
}

GameState readNew(LittleEndianReader& in, const Layout& layout) {
  GameState game;
  in.skip(1);
  game.packet = in.u8();
  game.players_per_team = in.u8();
  if (layout.format == Format::kHsl19) {
    game.competition = in.u8();
    game.stopped = in.u8() != 0;
  } else {
    game.round = in.u8();
    game.competition = in.u8();
  }
  game.phase = decoded(in.u8(), Phase::kTimeout, "the game's phase");
  game.state = decoded(in.u8(), State::kFinished, "the state");
  game.set_play = decoded(layout.set_plays, in.u8(), "the set play");
  game.first_half = in.u8() != 0;
  game.kicking_team = teamNumber(in.u8());
  game.seconds_remaining = in.i16();
  game.secondary_seconds = in.i16();
  for (TeamState& team : game.teams) team = readTeam(in, layout);
  return game;
}

TeamState readHl12Team(LittleEndianReader& in, const Layout& layout) {
  TeamState team;
  team.number = in.u8();
  team.field_colour = team.keeper_colour = in.u8();
  team.score = in.u8();
  team.penalty_shots = in.u8();
  team.shots_scored = static_cast<std::uint16_t>(in.u16());
  in.skip(kHl12CoachBytes + 6);
  for (std::size_t i = 0; i < kHl12Players; ++i) {
    PlayerState& player = team.players[i];
    player.penalty = decoded(layout.penalties, in.u8(), "a player's penalty");
    player.seconds_left = in.u8();
    player.warnings = in.u8(), player.yellow_cards = in.u8(), player.red_cards = in.u8();
    if (in.u8() != 0) team.goalkeeper = static_cast<int>(i) + 1;
  }
  return team;
}

GameState readHl12(LittleEndianReader& in, const Layout& layout) {
  GameState game;
  in.skip(2);
  game.packet = in.u8();
  game.players_per_team = in.u8();
  game.competition = in.u8();
  game.state = decoded(in.u8(), State::kFinished, "the state");
  game.first_half = in.u8() != 0;
  game.kicking_team = teamNumber(in.u8());
  const int secondary = in.u8(), performing = in.u8();
  if (secondary > static_cast<int>(Phase::kTimeout)) {
    game.set_play = decoded(layout.set_plays, secondary, "the secondary state");
    game.kicking_team = teamNumber(performing);
  } else {
    game.phase = static_cast<Phase>(secondary);
  }
  in.skip(3 + 1 + 2);
  game.seconds_remaining = in.u16();
  game.secondary_seconds = in.u16();
  for (TeamState& team : game.teams) team = readHl12Team(in, layout);
  return game;
}

const Layout& layoutOf(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 6 || std::string(bytes.begin(), bytes.begin() + 4) != "RGme")
    throw Refused{fmt::format("{} bytes that do not begin with RGme", bytes.size())};
  for (const Layout& layout : kLayouts) {
    if (bytes[4] != layout.version) continue;
    if (bytes.size() == layout.bytes) return layout;
    throw Refused{fmt::format("version {} ({}) in {} bytes, expected {}", layout.version, layout.league, bytes.size(),
                              layout.bytes)};
  }
  throw Refused{fmt::format("version {}, expected 12, 15, 18 or 19", bytes[4])};
}

}  // namespace

Bytes encodeControl(const GameState& game, Format format) {
  const Layout& layout = layoutOf(format);
  LittleEndianWriter out;
  out.text("RGme");
  if (format == Format::kHl12) {
    writeHl12(out, game, layout);
  } else {
    writeNew(out, game, layout);
  }
  return out.take();
}

std::optional<DecodedControl> decodeControl(std::span<const std::uint8_t> bytes, std::string& problem) {
  try {
    const Layout& layout = layoutOf(bytes);
    LittleEndianReader in(bytes.subspan(4));
    return DecodedControl{layout.format == Format::kHl12 ? readHl12(in, layout) : readNew(in, layout), layout.format};
  } catch (const Refused& refused) {
    problem = refused.why;
    return std::nullopt;
  }
}

}  // namespace murosimf::game_controller
