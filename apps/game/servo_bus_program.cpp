#include "game/servo_bus_program.h"

#include <fmt/format.h>

#include <charconv>
#include <sstream>
#include <stdexcept>

#include "murosimf/control/servo_bus/servo_bus.h"
#include "murosimf/control/servo_bus/servo_tables.h"

namespace murosimf {

namespace {

using servo_bus::ImuSettings;
using servo_bus::ServoBusSettings;
using servo_bus::ServoSettings;

std::vector<ProgramParameter> parameters() {
  const ServoBusSettings usual;
  const auto number = [](const char* name, double value, const char* meaning, double highest, const char* unit) {
    return ProgramParameter{name, value, meaning, 0, highest, unit};
  };
  return {
      {"protocol", static_cast<double>(usual.protocol), "version of the Dynamixel protocol", 1, 2, "", true},
      {"link", std::string("/tmp/murosimf/{team}.{number}"),
       "path that firmware opens; `{team}`, `{number}` are filled in"},
      {"servos", std::vector<std::string>{},
       "\"ID MODEL JOINT ZERO DIRECTION\" each, zero and direction 0 and 1 unless told; empty: all joints in their "
       "order, from 1"},
      {"model", std::string("MX-64"), "of the servos where `servos` is empty"},
      {"imus", std::vector<std::string>{"241"},
       "\"ID IMU\" each; without IMU the robot's first; of a robot without one: none"},
      number("baud_rate", usual.baud_rate, "that paces the answers; 0: they come at once", 1e7, "1/s"),
      number("return_delay", usual.return_delay, "first value of Return Delay Time", 508e-6, "s"),
      number("supply_voltage", usual.supply_voltage, "what servos tell, and their strength with it", 60, "V"),
      number("temperature", usual.temperature, "what servos tell", 255, "deg C"),
      number("overload_time", usual.overload_time, "that 95 % of the stall torque is borne; 0: for ever", 1e6, "s"),
      {"gains",
       std::string("servo"),
       "whose gains count: the robot file's, or the registers'",
       0,
       0,
       "",
       false,
       {"servo", "commanded"}},
      {"torque_on", usual.torque_on, "servos hold their first position before anybody has switched them on"},
      {"lock_step", usual.lock_step, "a step waits until goals have been written since the last one"},
      number("patience", usual.patience, "that it waits at most; 1 s in 25 s in all", 1, "s"),
  };
}

template <class Number>
Number numberIn(const std::string& word, const std::string& text, const char* what) {
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size())
    throw std::invalid_argument(fmt::format("\"{}\": {} is \"{}\", expected a number", text, what, word));
  return value;
}

std::vector<std::string> wordsOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// "ID MODEL JOINT ZERO DIRECTION".
ServoSettings servoOf(const std::string& text) {
  const std::vector<std::string> words = wordsOf(text);
  if (words.size() < 3 || words.size() > 5)
    throw std::invalid_argument(
        fmt::format("servo \"{}\", expected \"ID MODEL JOINT\", as in \"4 MX-64 elbow_right\", then its zero and its "
                    "direction where they are not 0 and 1",
                    text));
  ServoSettings servo{numberIn<int>(words[0], text, "id"), words[1], words[2]};
  if (words.size() > 3) servo.zero = numberIn<double>(words[3], text, "zero");
  if (words.size() > 4) servo.direction = numberIn<int>(words[4], text, "direction");
  return servo;
}

std::vector<ServoSettings> servosOf(const ProgramValues& values, const client::RobotDescription& robot) {
  std::vector<ServoSettings> servos;
  for (const std::string& text : values.texts("servos")) servos.push_back(servoOf(text));
  if (!servos.empty()) return servos;
  for (const client::JointDescription& joint : robot.joints)
    servos.push_back({static_cast<int>(servos.size()) + 1, values.text("model"), joint.name});
  return servos;
}

std::vector<ImuSettings> imusOf(const ProgramValues& values, const client::RobotDescription& robot) {
  std::vector<ImuSettings> imus;
  if (robot.imus.empty()) return imus;
  for (const std::string& text : values.texts("imus")) {
    const std::vector<std::string> words = wordsOf(text);
    if (words.empty() || words.size() > 2)
      throw std::invalid_argument(fmt::format("board \"{}\", expected \"ID IMU\" or \"ID\"", text));
    imus.push_back({numberIn<int>(words[0], text, "id"), words.size() > 1 ? words[1] : ""});
  }
  return imus;
}

std::string filledIn(std::string text, const std::string& name, const std::string& value) {
  for (std::size_t at = text.find(name); at != text.npos; at = text.find(name, at + value.size()))
    text.replace(at, name.size(), value);
  return text;
}

ServoBusSettings settingsOf(const ProgramValues& values, const client::RobotDescription& robot) {
  ServoBusSettings s;
  s.protocol = static_cast<servo_bus::Protocol>(values.whole("protocol"));
  s.link = filledIn(filledIn(values.text("link"), "{team}", robot.team), "{number}", std::to_string(robot.number));
  s.baud_rate = values.number("baud_rate"), s.return_delay = values.number("return_delay");
  s.supply_voltage = values.number("supply_voltage"), s.temperature = values.number("temperature");
  s.overload_time = values.number("overload_time");
  s.gains = values.text("gains") == "servo" ? servo_bus::Gains::kServo : servo_bus::Gains::kCommanded;
  s.torque_on = values.flag("torque_on"), s.lock_step = values.flag("lock_step");
  s.patience = values.number("patience");
  s.servos = servosOf(values, robot), s.imus = imusOf(values, robot);
  return s;
}

}  // namespace

ControlProgram servoBusProgram() {
  return {parameters(), [](const ProgramValues& values, const client::RobotDescription& robot) {
            return servo_bus::makeServoBus(settingsOf(values, robot));
          }};
}

}  // namespace murosimf
