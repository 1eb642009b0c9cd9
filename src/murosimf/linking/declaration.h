#pragma once

/// @file What a module takes and gives, said in words that can be listed, checked and scheduled.

#include <any>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <vector>

#include "murosimf/world/property.h"
#include "murosimf/world/world.h"

namespace murosimf {

/// How a module touches a property.
enum class Access {
  kNeeds,         ///< a constant that must be there
  kUses,          ///< a constant with a default
  kReads,         ///< a variable whose writer runs before in the same step
  kReadsIfAdded,  ///< the same, but nobody needs to write it: a port for a sensor that a robot may lack
  kReadsLast,     ///< a variable as it stood before this step: the one way to close a loop, visible here
  kAdds,          ///< a variable that this module alone writes
  kAccumulates,   ///< a sum to which several modules add; zero before each evaluation
  kSets,          ///< a variable that somebody outside of the blocks may overwrite between frames, where it is added
};

/// The part of the frame in which a module's pass runs.
enum class Phase {
  kPrescribe,  ///< robots whose motion is given choose their path to the end of the step, before contacts are solved
  kEvaluate,   ///< what an integrator asks for, once or often a step: forces and accelerations in the state of the
               ///< moment
  kAdvance,    ///< robots with dynamics advance under the contacts' forces: integrators
  kSense,      ///< sensors read the state at the end of the frame
};

/// One line of a declaration.
struct DeclaredProperty {
  Access access = Access::kReads;
  std::string_view name, unit, meaning, subset;
  int components = 0;  ///< numbers per object; 0: a value that is no set of numbers (tree, lens)
  Storage storage = Storage::kState;
  bool structural = false;      ///< robots of one batch must have equal values
  std::vector<double> initial;  ///< variables: first value; constants with default: the default
  /// Constants: the numbers of an object's value; false when it is missing or of another type.
  bool (*numbers)(const World&, ObjectId, std::string_view, std::vector<double>&) = nullptr;
  bool (*equal)(const World&, ObjectId, ObjectId, std::string_view) = nullptr;
  bool in_step = false;  ///< the reader's period must be the writer's
  std::any otherwise;    ///< constants with default: the default

  bool isConstant() const { return access == Access::kNeeds || access == Access::kUses; }
  bool isWritten() const { return access == Access::kAdds || access == Access::kAccumulates; }
  bool isRead() const {
    return access == Access::kReads || access == Access::kReadsIfAdded || access == Access::kReadsLast;
  }
  /// Whether both lines speak of the same column of an assembly.
  bool sameColumn(const DeclaredProperty& other) const { return name == other.name && subset == other.subset; }
};

/// Filled by Module::declare(). Pure data: the same words give the table of modules, the schedule and link errors.
class Declaration {
 public:
  /// @param period  time between two steps of the module [s]; 0 where it is only listed
  explicit Declaration(double period = 0) : period_(period) {}

  /// A constant that every object of the subset must have.
  template <class T>
  void needs(const Constant<T>& property, std::string_view of = subset::kSelf) {
    add(property, Access::kNeeds, of);
  }
  /// A constant that counts as `initial` on objects that do not have it.
  template <class T>
  void uses(const Constant<T>& property, const T& initial, std::string_view of = subset::kSelf) {
    DeclaredProperty& line = add(property, Access::kUses, of);
    if constexpr (kIsNumeric<T>) line.initial = numbersOf(initial);
    line.otherwise = initial;
  }
  template <class T>
  void reads(const Variable<T>& property, std::string_view of = subset::kSelf) {
    add(property, Access::kReads, of);
  }
  /// Reads, and must have the writer's period, as whoever looks at how much a value changed over a step.
  template <class T>
  void readsInStep(const Variable<T>& property, std::string_view of = subset::kSelf) {
    add(property, Access::kReads, of).in_step = true;
  }
  template <class T>
  void readsIfAdded(const Variable<T>& property, std::string_view of = subset::kSelf) {
    add(property, Access::kReadsIfAdded, of);
  }
  template <class T>
  void readsLast(const Variable<T>& property, std::string_view of = subset::kSelf) {
    add(property, Access::kReadsLast, of);
  }
  template <class T>
  void adds(const Variable<T>& property, std::string_view of = subset::kSelf) {
    add(property, Access::kAdds, of);
  }
  /// Adds room for `length` values of the property an object: what is on its way. Nobody else sees them.
  template <class T>
  void addsHistory(const Variable<T>& property, int length, std::string_view of = subset::kSelf) {
    DeclaredProperty& line = add(property, Access::kAdds, of);
    line.components *= length;
    line.initial.assign(static_cast<std::size_t>(line.components), 0.0);
  }
  /// The variable must live for a step only (Storage::kStep); whoever reads it runs behind all that add to it.
  template <class T>
  void accumulates(const Variable<T>& property, std::string_view of = subset::kSelf) {
    if (property.storage != Storage::kStep) throw std::logic_error("sums live for a step only");
    add(property, Access::kAccumulates, of);
  }
  /// Reads a sum behind all that add to it; zero where nobody does.
  template <class T>
  void readsSum(const Variable<T>& property, std::string_view of = subset::kSelf) {
    accumulates(property, of);
    reads(property, of);
  }
  /// For interventions: they change what a module added, without being its writer.
  template <class T>
  void sets(const Variable<T>& property, std::string_view of = subset::kSelf) {
    add(property, Access::kSets, of);
  }
  void runsIn(Phase phase) { phase_ = phase; }
  /// Runs in the phase of the module that adds this variable, behind it: poses follow a motion that is prescribed
  /// before contacts are solved, or one that obeys them.
  template <class T>
  void follows(const Variable<T>& property) {
    followed_ = property.name;
  }

  const std::vector<DeclaredProperty>& properties() const { return properties_; }
  double period() const { return period_; }
  Phase phase() const { return phase_; }
  /// Name of the variable that it follows; empty: its phase is fixed.
  std::string_view followed() const { return followed_; }

  template <class T>
  static std::vector<double> numbersOf(const T& value) {
    std::vector<double> numbers(sizeof(T) / sizeof(double));
    __builtin_memcpy(numbers.data(), &value, sizeof(T));
    return numbers;
  }

 private:
  template <class T>
  static bool readNumbers(const World& world, ObjectId id, std::string_view name, std::vector<double>& out) {
    const auto value = world.find(id, Constant<T>{name, {}, {}});
    if (!value) return false;
    if constexpr (kIsNumeric<T>) out = numbersOf(*value);
    return true;
  }
  template <class T>
  static bool areEqual(const World& world, ObjectId a, ObjectId b, std::string_view name) {
    const Constant<T> key{name, {}, {}};
    return world.find(a, key) == world.find(b, key);
  }
  template <class Property>
  DeclaredProperty& add(const Property& p, Access access, std::string_view of, int components) {
    DeclaredProperty& line = properties_.emplace_back();
    line.access = access;
    line.name = p.name, line.unit = p.unit, line.meaning = p.meaning, line.subset = of;
    line.components = components;
    return line;
  }
  template <class T>
  DeclaredProperty& add(const Constant<T>& p, Access access, std::string_view of) {
    DeclaredProperty& line = add(p, access, of, kIsNumeric<T> ? static_cast<int>(sizeof(T) / sizeof(double)) : 0);
    line.structural = !kIsNumeric<T>;
    line.numbers = &readNumbers<T>;
    line.equal = &areEqual<T>;
    return line;
  }
  template <class T>
  DeclaredProperty& add(const Variable<T>& p, Access access, std::string_view of) {
    DeclaredProperty& line = add(p, access, of, Variable<T>::kComponents);
    line.storage = p.storage;
    line.initial = numbersOf(T{});
    return line;
  }

  double period_;
  std::vector<DeclaredProperty> properties_;
  Phase phase_ = Phase::kAdvance;
  std::string_view followed_;
};

}  // namespace murosimf
