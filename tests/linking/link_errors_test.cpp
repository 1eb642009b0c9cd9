// Every mistake that linking finds, with the words that a person reads.

#include <gtest/gtest.h>

#include <stdexcept>

#include "linking/toy_world.h"

namespace murosimf::toy {
namespace {

void addsTally(Declaration& d) { d.adds(kTally); }
void readsTallyAddsOther(Declaration& d) { d.reads(kTally), d.adds(kOtherTally); }
void readsOtherAddsTally(Declaration& d) { d.reads(kOtherTally), d.adds(kTally); }
void readsOtherLastAddsTally(Declaration& d) { d.readsLast(kOtherTally), d.adds(kTally); }
void readsTally(Declaration& d) { d.reads(kTally); }
void readsTallyEarly(Declaration& d) { d.runsIn(Phase::kPrescribe), d.reads(kTally), d.adds(kOtherTally); }
void addsScratch(Declaration& d) { d.adds(kScratch), d.adds(kTally); }
void readsScratch(Declaration& d) { d.reads(kScratch), d.adds(kOtherTally); }
void readsScratchLate(Declaration& d) { d.runsIn(Phase::kSense), d.reads(kScratch), d.adds(kOtherTally); }
void readsTallyInStep(Declaration& d) { d.readsInStep(kTally), d.adds(kOtherTally); }
void mayReadTally(Declaration& d) { d.readsIfAdded(kTally), d.adds(kOtherTally); }
void readsTallyAsVector(Declaration& d) { d.reads(Variable<Vector3>{"tally", "1", ""}), d.adds(kOtherTally); }
void needsTally(Declaration& d) { d.needs(Constant<double>{"tally", "1", ""}), d.adds(kOtherTally); }
void usesDampingThree(Declaration& d) { d.uses(kDamping, 3.0, kArms), d.adds(kTally); }

class RefusesToLink final : public RobotModule {
 public:
  void declare(Declaration& d) const override { d.adds(kTally); }

 private:
  void bind(Links&) override { throw std::invalid_argument("the robot has one leg; expected 2"); }
  void stepRobot(const RobotLane&, const StepTime&) const override {}
};
class LinksUndeclared final : public RobotModule {
 public:
  void declare(Declaration& d) const override { d.adds(kTally); }

 private:
  void bind(Links& links) override { links.values(kAngle, kArms); }
  void stepRobot(const RobotLane&, const StepTime&) const override {}
};

/// One robot "a" with two of the modules above.
template <void (*kFirst)(Declaration&), void (*kSecond)(Declaration&)>
struct TwoModules : ToyWorld {
  ObjectId robot = addRobot("a");
  TwoModules() {
    modules.add<Says<kFirst>>("first", "test", "");
    modules.add<Says<kSecond>>("second", "test", "");
    assign(robot, "first", 1);
    assign(robot, "second", 2);
  }
  void setPeriod(std::size_t assignment, double period) {
    assignments[assignment].parameters.emplace("period", WrittenParameter{{{period}, ""}, {"game.toml", 9, 1}});
  }
};

TEST(LinkErrors, AnUnknownModuleIsNamedWithTheKnownOnesAndTheNearest) {
  ToyWorld toy;
  toy.assign(toy.addRobot("robots.red.1"), "pendulum", 12);
  EXPECT_EQ(toy.errors(),
            "game.toml:12:3: error: robots.red.1: unknown module \"pendulum\"; expected one of pendulums, energy_watch "
            "(did you mean \"pendulums\"?)\n");
}

TEST(LinkErrors, AnUnknownPropertyIsNamedWithTheNearest) {
  ToyWorld toy;
  toy.addPendulums("a");
  toy.world.setWritten(toy.world.find("a.arm2"), "lenght", {{0.5}, ""}, {"a.urdf", 33, 0});
  EXPECT_EQ(toy.errors(),
            "a.urdf:33: error: unknown property \"lenght\" of a.arm2: no module declares it (did you mean "
            "\"length\"?)\n");
}

TEST(LinkErrors, AMissingConstantIsNamedWithRobotObjectPropertyAndUnit) {
  ToyWorld toy;
  const ObjectId robot = toy.addPendulums("robots.red.1");
  toy.world.defineSubset(robot, kArms, {toy.world.find("robots.red.1.arm1"), toy.world.add(robot, "tail")});
  EXPECT_EQ(toy.errors(),
            "game.toml:7:3: error: robots.red.1: module pendulums needs property length [m] (l > 0, from the joint to "
            "the bob) of robots.red.1.tail, which has none\n");
}

TEST(LinkErrors, AVariableWithoutAWriterIsNamedWithTheModulesThatWouldWriteIt) {
  ToyWorld toy;
  const ObjectId robot = toy.addRobot("a");
  toy.assign(robot, "energy_watch");
  EXPECT_EQ(toy.errors(),
            "game.toml:7:3: error: a: module energy_watch reads variable rate [rad/s] of arms, which no module writes; "
            "expected pendulums\n");
}

TEST(LinkErrors, AnAttachmentsFaultPointsAtItsRobotsFirstModule) {
  ToyWorld toy;
  const ObjectId robot = toy.addPendulums("a");
  toy.attachments.push_back({"screen", &kEnergyReader, {robot}});
  EXPECT_EQ(toy.errors(),
            "game.toml:7:3: error: a: module screen reads variable energy [J/kg] of self, which no module writes; "
            "expected energy_watch\n");
}

TEST(LinkErrors, AVariableMayBeReadOnlyIfSomebodyWritesItWhereTheReaderSaysSo) {
  TwoModules<mayReadTally, addsTally> with;
  EXPECT_NE(with.link(), nullptr) << with.diagnostics.text();
  ToyWorld without;
  without.modules.add<Says<mayReadTally>>("alone", "test", "");
  without.assign(without.addRobot("a"), "alone");
  EXPECT_NE(without.link(), nullptr) << without.diagnostics.text();
}

TEST(LinkErrors, TwoWritersOfOneVariableAreBothNamedOnce) {
  TwoModules<addsTally, readsOtherLastAddsTally> toy;
  toy.modules.add<Says<readsTallyAddsOther>>("third", "test", "");
  toy.assign(toy.robot, "third");
  EXPECT_EQ(toy.errors(),
            "game.toml:1:3: error: a: variable tally [1] of self is written by 2 modules: first, second; expected "
            "one\n");
}

TEST(LinkErrors, TheSameModuleTwiceIsTwoWriters) {
  ToyWorld toy;
  const ObjectId robot = toy.addPendulums("a");
  toy.assign(robot, "pendulums", 8);
  EXPECT_TRUE(contains(toy.errors(), "angle [rad] of arms is written by 2 modules: pendulums, pendulums"));
}

TEST(LinkErrors, AttachingTheSameTwiceCountsOnce) {
  ToyWorld toy;
  const ObjectId robot = toy.addPendulums("a");
  toy.attachments.push_back({"driver", &kDriver, {robot, robot}});
  EXPECT_NE(toy.link(), nullptr) << toy.diagnostics.text();
}

TEST(LinkErrors, ACycleIsNamedModuleByModule) {
  TwoModules<readsOtherAddsTally, readsTallyAddsOther> toy;
  EXPECT_EQ(toy.errors(),
            "game.toml:1:3: error: a: modules wait for each other: first -> second -> first; one must use "
            "readsLast\n");
}

TEST(LinkErrors, ReadsLastClosesTheLoop) {
  TwoModules<readsOtherLastAddsTally, readsTallyAddsOther> toy;
  EXPECT_NE(toy.link(), nullptr) << toy.diagnostics.text();
}

TEST(LinkErrors, WhoReadsWhatIsWrittenLaterInTheFrameMustUseReadsLast) {
  TwoModules<addsTally, readsTallyEarly> toy;
  EXPECT_EQ(toy.errors(),
            "game.toml:2:3: error: a: module second reads tally, which first writes later in the frame; expected "
            "readsLast\n");
}

TEST(LinkErrors, AnUnusedParameterIsNamedWithTheNearest) {
  ToyWorld toy;
  toy.addPendulums("a");
  toy.assignments[0].parameters.emplace("perod", WrittenParameter{{{0.01}, ""}, {"game.toml", 21, 5}});
  EXPECT_EQ(toy.errors(),
            "game.toml:21:5: error: module pendulums has no parameter \"perod\"; it knows period (did you mean "
            "\"period\"?)\n");
}

TEST(LinkErrors, AParameterOutOfRangeIsNamedWithItsRange) {
  ToyWorld toy;
  toy.addPendulums("a");
  toy.assignments[0].parameters.emplace("period", WrittenParameter{{{-1}, ""}, {"game.toml", 21, 5}});
  EXPECT_EQ(toy.errors(), "game.toml:21:5: error: parameter period of module pendulums is -1 s; expected 0 to 10\n");
}

TEST(LinkErrors, AParameterThatIsNoNumberIsNamed) {
  ToyWorld toy;
  toy.addPendulums("a");
  toy.assignments[0].parameters.emplace("period", WrittenParameter{{{}, "slow"}, {"game.toml", 21, 5}});
  EXPECT_EQ(toy.errors(),
            "game.toml:21:5: error: parameter period of module pendulums is not a number; expected one number in s\n");
}

TEST(LinkErrors, APeriodMustBeAMultipleOfTheFrame) {
  ToyWorld toy;
  toy.addPendulums("a");
  toy.assignments[0].parameters.emplace("period", WrittenParameter{{{0.0105}, ""}, {"game.toml", 21, 5}});
  EXPECT_EQ(toy.errors(),
            "game.toml:7:3: error: period of module pendulums is 0.0105 s; expected a multiple of the frame length, "
            "0.001 s\n");
}

TEST(LinkErrors, AWrittenValueOfAnotherTypeIsNamedWithWhatWasExpected) {
  ToyWorld toy;
  toy.addPendulums("a");
  toy.world.setWritten(toy.world.find("a.arm1"), "length", {{1, 2, 3}, ""}, {"a.urdf", 5, 0});
  toy.world.setWritten(toy.world.find("a"), "kind", {{4}, ""}, {"a.urdf", 6, 0});
  EXPECT_EQ(toy.errors(),
            "a.urdf:5: error: property length of a.arm1 has another type than module pendulums expects: a constant of "
            "1 number [m]\n"
            "a.urdf:6: error: property kind of a has another type than module pendulums expects: a constant that is no "
            "set of numbers\n");
}

TEST(LinkErrors, WhatLivesWithinAStepIsReadInThatStepOnly) {
  const std::string words = "reads variable scratch [1] of self, which lives only while first and what runs with it";
  TwoModules<addsScratch, readsScratch> together;
  EXPECT_NE(together.link(), nullptr) << together.diagnostics.text();
  TwoModules<addsScratch, readsScratchLate> late;
  EXPECT_TRUE(contains(late.errors(), "module second " + words));
  TwoModules<addsScratch, readsScratch> slower;
  slower.setPeriod(1, 0.002);
  EXPECT_TRUE(contains(slower.errors(), "module second " + words));
  TwoModules<addsScratch, readsTally> outside;
  const OutsideAccess reader([](Declaration& d) { d.reads(kScratch); });
  outside.attachments.push_back({"screen", &reader, {outside.robot}});
  EXPECT_TRUE(contains(outside.errors(), "module screen " + words));
}

TEST(LinkErrors, WhoLooksAtAStepMustStepWithItsWriter) {
  TwoModules<addsTally, readsTallyInStep> toy;
  toy.setPeriod(0, 0.01);
  EXPECT_EQ(toy.errors(),
            "game.toml:2:3: error: a: module second reads variable tally [1] of self in step with first, but every "
            "0.001 s instead of 0.01 s; expected equal periods\n");
}

TEST(LinkErrors, OneNameHasOneMeaning) {
  TwoModules<addsTally, readsTallyAsVector> vector;
  EXPECT_TRUE(contains(vector.errors(),
                       "a: property tally is a variable of 3 numbers for module second and a "
                       "variable of 1 number for module first; expected one meaning"));
  TwoModules<addsTally, needsTally> constant;
  EXPECT_TRUE(contains(constant.errors(),
                       "property tally is a constant of 1 number for module second and a variable "
                       "of 1 number for module first"));
  ToyWorld defaults;
  defaults.modules.add<Says<usesDampingThree>>("damper", "test", "");
  defaults.assign(defaults.addPendulums("a"), "damper");
  EXPECT_TRUE(contains(defaults.errors(), "with another default for module pendulums"));
}

TEST(LinkErrors, WhatAModuleRefusesWhenItIsLinkedIsAnErrorLikeTheOthers) {
  ToyWorld toy;
  toy.modules.add<RefusesToLink>("walker", "motion", "");
  toy.assign(toy.addRobot("a"), "walker");
  EXPECT_EQ(toy.errors(), "game.toml:7:3: error: a: module walker: the robot has one leg; expected 2\n");
}

TEST(LinkErrors, AllAreReportedAtOnce) {
  ToyWorld toy;
  const ObjectId a = toy.addPendulums("a"), b = toy.addRobot("b");
  toy.assign(a, "pendulous", 30);
  toy.assign(b, "energy_watch", 31);
  toy.world.setWritten(b, "colour", {{}, "pink"}, {"b.urdf", 3, 0});
  EXPECT_EQ(toy.link(), nullptr);
  EXPECT_EQ(toy.diagnostics.errorCount(), 3) << toy.diagnostics.text();
}

TEST(LinkErrors, WhoMissesAModuleThatCouldNotBeMadeIsNoErrorMore) {
  ToyWorld toy;
  const ObjectId robot = toy.addRobot("a");
  toy.assign(robot, "pendulous");
  toy.assign(robot, "energy_watch");  // reads what pendulums would add
  EXPECT_EQ(toy.link(), nullptr);
  EXPECT_EQ(toy.diagnostics.errorCount(), 1) << toy.diagnostics.text();
}

TEST(LinkErrors, FaultsOfAProgramAreExceptions) {
  ToyWorld toy;
  const ObjectId robot = toy.addPendulums("a");
  const auto linked = toy.link();
  EXPECT_THROW(linked->handle(robot, Variable<Vector3>{"angle", "", ""}, kArms), std::logic_error);
  EXPECT_THROW(toy.modules.add<Pendulums>("pendulums", "motion", "again"), std::invalid_argument);
  EXPECT_THROW(Linker(toy.world, toy.modules, {0.001, 3}), std::invalid_argument);
  EXPECT_THROW(Linker(toy.world, toy.modules, {0, 1}), std::invalid_argument);
  ToyWorld undeclared;
  undeclared.modules.add<LinksUndeclared>("sloppy", "motion", "");
  undeclared.assign(undeclared.addRobot("a"), "sloppy");
  EXPECT_THROW(undeclared.link(), std::logic_error);
}

}  // namespace
}  // namespace murosimf::toy
