#pragma once

/// @file Scene: what a scenario file says, as plain data. Every value knows the place it was written at.
///
/// A Scene knows no algorithm and no world; the builder turns it into both and then drops it. Values that nobody wrote
/// hold their default and an empty `where` (a measure of the field: the place of the preset's name).
/// Units are SI, angles in rad. W is the field frame: origin at the centre, +x towards the goal that red attacks
/// unless the scenario says otherwise, z up.
/// All values are within the ranges of scene/scenario_keys.h. Not checked here, because only the builder and the
/// linker know: names of modules, of their parameters, of cameras, of surfaces and of properties.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/algorithms/shape.h"
#include "murosimf/control/client/robot_description.h"
#include "murosimf/math/transform.h"
#include "murosimf/math/vec3.h"
#include "murosimf/scene/located.h"

namespace murosimf {

/// A module (or a control program) chosen for one slot of a robot, with its parameters.
struct ModuleChoice {
  std::string slot;             ///< "motion", "actuation", ...; a camera's name; "control"; "modules.<name>"
  Located<std::string> module;  ///< empty: the one that the level of detail brings, with these parameters
  Located<double> period;       ///< [s]; 0: the module's own
  Located<double> phase;        ///< [s] after the start; 0
  std::vector<NamedValue> parameters;
};

struct SimulationSettings {
  Located<double> frame{.001, {}};     ///< length of a frame [s]
  Located<double> duration{60.0, {}};  ///< [s]
  Located<std::uint64_t> seed{1, {}};
  Located<double> pace{0.0, {}};             ///< 0: simulated clock; p > 0: paced, p simulated seconds a second
  Located<double> control_period{.010, {}};  ///< between two steps of the control software [s]: whole frames
  Located<double> control_delay{.010, {}};   ///< from the sensor frame until its commands act [s]: whole frames
  Located<int> threads{0, {}};               ///< 0: all
  Located<int> lanes{0, {}};                 ///< 0: automatic; 1, 4, 8
};

/// Measures are those of client::FieldDescription [m].
struct FieldSettings {
  Located<std::string> preset{"2007", {}};
  Located<double> length, width, goal_width, goal_height, goal_depth, post_radius, line_width, border;
  Located<double> centre_circle_radius, goal_area_length, goal_area_width, penalty_mark_distance;
  Located<double> penalty_area_length, penalty_area_width;
  Located<double> pole_radius, pole_height;
  Located<double> brightness{1.0, {}};  ///< factor on all light
  Located<Colour> carpet;
  Located<std::string> texture;           ///< picture laid on the carpet: a PNG file; empty: none
  Located<double> texture_size{0.0, {}};  ///< edge of the square that it covers again and again [m]; 0: once
  Located<std::string> goal_at_plus_x, goal_at_minus_x;  ///< "yellow", "blue" or "white"
};

struct BallSettings {
  Located<bool> present{true, {}};
  Located<double> radius{.070, {}};          ///< [m]
  Located<double> mass{.205, {}};            ///< [kg]
  Located<double> inertia_factor{.667, {}};  ///< beta: I = beta m r^2
  Located<Vec3<double>> position;            ///< of the ball's lowest point in W [m]
  Located<Colour> colour{{1.0F, .40F, .05F}, {}};
};

/// How two surfaces touch: the constants of algorithms/surface_pair.h. `first` <= `second` in the order of letters.
/// Friction is Coulomb where friction_coefficient > 0 (viscous_friction is 0 then), else viscous.
struct SurfacePairSettings {
  std::string first, second;
  SourceLocation where;                          ///< empty: of the built-in table
  Located<std::string> law{"smooth", {}};        ///< "smooth", "paper" or "hunt_crossley"
  Located<double> stiffness;                     ///< s_c [N/m]
  Located<double> restitution_factor;            ///< s_b [1]: `smooth` and `paper`
  Located<double> blend_speed{.02, {}};          ///< v_0 [m/s]: `smooth`
  Located<double> dissipation{.6, {}};           ///< d [s/m]: `hunt_crossley`
  Located<std::string> friction{"viscous", {}};  ///< "viscous" or "coulomb"
  Located<double> viscous_friction;              ///< s_mu [s/m]
  Located<double> friction_coefficient;          ///< mu [1]
  Located<double> stick_speed{.002, {}};         ///< v_s [m/s]
  Located<double> turning_friction;              ///< s_nu [m s]
  Located<double> rolling_resistance;            ///< c_rr [1]
};

/// A rule of world/contact_rules.h: pairs of objects for which something else holds than for their surfaces.
struct ContactRuleSettings {
  std::string name;
  SourceLocation where;                             ///< of its table
  Located<std::vector<std::string>> between, with;  ///< patterns of the first and the second object of a pair
  Located<std::vector<std::string>> within, self;   ///< one of between, within and self is given
  Located<bool> check{true, {}};
  Located<std::string> points{"manifold", {}};  ///< "manifold" or "one"
  SurfacePairSettings surface;                  ///< values that are given hold
};

struct TeamSettings {
  std::string name;                  ///< "red" or "blue"
  Located<bool> attacks_positive_x;  ///< red: true, blue: false, unless the scenario says otherwise
};

/// When a robot is simulated closely (FocusRule).
struct FocusSettings {
  SourceLocation where;  ///< of its table
  Located<std::string> motion{"multibody_dynamics", {}};
  Located<double> ball{1.0, {}}, robots{1.0, {}}, margin{0.2, {}};  ///< [m]
};

struct RobotSettings {
  std::string team;
  int number = 0;                    ///< jersey number from 1
  SourceLocation where;              ///< of its table
  Located<std::string> file;         ///< as written
  std::filesystem::path file_found;  ///< where that was found
  Located<PlanarPose> pose;          ///< X_WB at the start
  Located<std::string> role;
  Located<std::string> level{"kinematic", {}};
  std::vector<ModuleChoice> modules;  ///< only slots that the scenario names, by slot
  std::vector<ModuleChoice> cameras;  ///< only cameras that the scenario names, by name
  ModuleChoice localisation;          ///< module empty: the level's
  std::optional<FocusSettings> focus;
  ModuleChoice control;                                           ///< module "none": no control software; period
  Located<double> control_delay;                                  ///< [s]; not given: the simulation's, as the period
  std::vector<NamedValue> properties;                             ///< name: object path and property, "trunk.mass"
  std::optional<Located<PlanarPose>> kickoff_own, kickoff_other;  ///< X_WB; absent: the referee's own choice

  std::string path() const { return "robots." + team + "." + std::to_string(number); }
};

/// Something upright that stands in the way.
struct ObstacleSettings {
  std::string name;
  SourceLocation where;                           ///< of its table
  Located<std::string> shape{"cylinder", {}};     ///< "cylinder" or "box"
  Located<double> radius{.1, {}};                 ///< of a cylinder [m]
  Located<double> length{.4, {}}, width{.4, {}};  ///< of a box, along its own x and y [m]
  Located<double> height{.6, {}};                 ///< [m]
  Located<PlanarPose> pose;                       ///< X_WO
  Located<Colour> colour{{.75F, .08F, .06F}, {}};
  Located<double> mass{0.0, {}};  ///< [kg]; 0: it stands fast
  Located<std::string> surface{"plastic", {}};

  std::string path() const { return "obstacles." + name; }
  /// No part of it is farther from its axis [m].
  double reach() const;
};

/// The way of a slalom or of an obstacle run (client::CourseDescription).
struct CourseSettings {
  Located<PlanarPose> pose;         ///< X_WC
  Located<double> length{0.0, {}};  ///< [m]; 0: there is no course
  Located<double> width{0.0, {}};   ///< [m]; 0: no limit
  Located<std::string> first_side{"left", {}};
  Located<int> random_obstacles{0, {}};  ///< on sites that the seed chooses
  Located<int> sites_along{3, {}}, sites_across{3, {}}, most_abreast{2, {}};
};

struct RefereeSettings {
  Located<bool> enabled{true, {}};
  Located<std::string> rules{"match", {}};                     ///< "match", "penalty_kicks", "slalom" or "obstacle_run"
  Located<int> attempts{1, {}};                                ///< of all rules but the match's
  Located<double> time_limit{60.0, {}};                        ///< of an attempt [s]
  Located<double> scatter{0.0, {}}, scatter_heading{0.0, {}};  ///< of the robots' places at its beginning [m], [rad]
  Located<std::string> kickoff_team{"red", {}};
  Located<double> kickoff_wait{10.0, {}};     ///< the other team may play after this even if the ball rests [s]
  Located<double> ball_moved{.05, {}};        ///< ball is in play when moved this far from the mark [m]
  Located<double> pause_after_goal{2.0, {}};  ///< [s]
  Located<double> half_length{0.0, {}};       ///< [s]; 0: one half that lasts as long as the run
};

/// The referee as a game controller of robots' software.
struct GameControllerSettings {
  Located<std::string> role{"none", {}};     ///< "none" or "send"
  Located<std::string> format{"hsl19", {}};  ///< "hsl19", "spl18", "hl15" or "hl12"
  Located<std::string> host{"127.0.0.1", {}};
  Located<int> port{3838, {}};
  Located<bool> broadcast{false, {}};
  Located<std::string> listen{"127.0.0.1", {}};  ///< address on which robots' status is heard
  Located<int> return_port{3939, {}};            ///< 0: any free one
  Located<std::string> allow{"127.0.0.1", {}};   ///< hosts whose robots are heard, blanks between them
  Located<int> red_number{1, {}}, blue_number{2, {}};
};

struct OutputSettings {
  Located<std::string> directory{"out", {}};
  Located<std::string> record{"none", {}};  ///< file of the recorder, relative to directory; "none": off
  Located<std::string> video{"none", {}};   ///< file, relative to directory; "none": no video
  Located<bool> pictures{true, {}};         ///< bird's eye and camera pictures at the end
};

struct Scene {
  std::filesystem::path file;
  SimulationSettings simulation;
  FieldSettings field;
  BallSettings ball;
  std::vector<SurfacePairSettings> surfaces;  ///< built-in table and the scenario's changes, sorted by (first, second)
  std::vector<ContactRuleSettings> contacts;  ///< the later over the earlier
  TeamSettings red{"red", {true, {}}}, blue{"blue", {false, {}}};
  std::vector<RobotSettings> robots;        ///< red before blue, then by number
  std::vector<ObstacleSettings> obstacles;  ///< by name, those on random sites too
  CourseSettings course;
  RefereeSettings referee;
  GameControllerSettings game_controller;
  OutputSettings output;
};

/// Of a robot's control software, its own or that of all [s].
double controlPeriod(const Scene& scene, const RobotSettings& robot);
double controlDelay(const Scene& scene, const RobotSettings& robot);
/// What both teams measure before the game.
client::FieldDescription fieldDescription(const Scene& scene);
/// What a team is told of the course.
client::CourseDescription courseDescription(const Scene& scene, bool attacks_positive_x);
/// The pair of two surfaces in either order, or nullptr.
const SurfacePairSettings* findSurfacePair(const Scene& scene, std::string_view a, std::string_view b);

}  // namespace murosimf
