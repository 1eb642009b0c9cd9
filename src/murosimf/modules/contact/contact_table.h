#pragma once

/// @file The terms on which shapes touch, looked up by small numbers: rules and surfaces are read once, at linking.
///
/// Shapes of one kind have the same surface and are in the same sets of the rules. First all kinds are named, then all
/// pairs of them that can meet are agreed upon; a frame only looks up.

#include <cstdint>

#include "murosimf/world/contact_rules.h"
#include "murosimf/world/world.h"

namespace murosimf {

class ContactTable {
 public:
  ContactTable() = default;
  /// Reads surface_table and contact_rules of the root.
  explicit ContactTable(const World& world);

  /// The kind of a shape with this surface on the body at this path.
  int kindOf(const std::string& path, const std::string& surface);
  /// Two kinds of different objects, and of the same robot. All kinds are named.
  /// @throws std::invalid_argument naming both surfaces when they may touch and nothing says how
  void agree(int a, int b);
  void agreeWithin(int a, int b);

  /// Terms that were agreed upon.
  const ContactTerms& between(int a, int b) const { return terms_[number(between_[at(a, b)])]; }
  const ContactTerms& within(int a, int b) const { return terms_[number(within_[at(a, b)])]; }

 private:
  struct Kind {
    std::string path, surface;  // of the first one
    std::vector<char> sets;     // of each rule: whether its `a` and its `b` mean the path
  };
  static std::size_t number(int i) { return static_cast<std::size_t>(i); }
  std::size_t at(int a, int b) const { return number(a) * kinds_.size() + number(b); }
  void agreeOn(std::vector<int>& pairs, int a, int b, bool same_robot);

  SurfaceTable surfaces_;
  std::vector<ContactRule> rules_;
  std::vector<Kind> kinds_;
  std::vector<ContactTerms> terms_;
  std::vector<int> between_, within_;  // of kinds, squares: indices of terms_; -1: not agreed upon
};

}  // namespace murosimf
