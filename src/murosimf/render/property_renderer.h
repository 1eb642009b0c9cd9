#pragma once

/// @file Renderers are matched to objects by the property they draw [Friedmann, Petersen, von Stryk 2007, 3.4].
///
/// Whoever wants to see a property registers one renderer for it; every object that has the property can then be shown
/// with it, in the window and in pictures, and is switched on and off there. Nothing else has to be told:
///
///     registry.add<BatteryRenderer>({"battery", kCharge, subset::kSelf, "how full it is"});
///
/// A renderer reads the world through constants and handles, between two frames, and writes into a draw list. It
/// changes nothing. One that throws is switched off; its words are kept, and neither the others nor the simulation
/// notice.

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/linking/linked_world.h"
#include "murosimf/linking/linker.h"
#include "murosimf/render/draw_list.h"
#include "murosimf/world/world.h"

namespace murosimf {

/// The moment that is drawn.
struct RenderMoment {
  long frame = 0;   ///< the one that ended last
  double time = 0;  ///< at its end [s]
};

/// Draws one property of one object.
class PropertyRenderer {
 public:
  virtual ~PropertyRenderer() = default;
  /// Adds to the list. The world is at rest.
  virtual void draw(const RenderMoment& now, DrawList& list) = 0;
};

/// What a renderer is made of: the object that has the property, and where to ask about it.
struct RenderedObject {
  const World& world;
  LinkedWorld& linked;
  ObjectId object;
  std::uint32_t label = 0;  ///< of all that belongs to it in label pictures
};

/// One line of the list of renderers.
struct RendererEntry {
  std::string name;      ///< "frames": what people switch
  std::string property;  ///< that the object must have
  std::string subset;    ///< of the object's parts, one of which must have it; `self`: the object
  std::string meaning;   ///< a line for people
  bool shown = false;    ///< at the start
  std::function<std::unique_ptr<PropertyRenderer>(const RenderedObject&)> make;
  /// Variables that nobody might compute if the renderer did not ask for them; may be null.
  const Module* reads = nullptr;
};

class RendererRegistry {
 public:
  void add(RendererEntry entry) { entries_.push_back(std::move(entry)); }
  /// A renderer R(const RenderedObject&).
  template <class R>
  void add(RendererEntry entry) {
    entry.make = [](const RenderedObject& object) { return std::make_unique<R>(object); };
    add(std::move(entry));
  }
  const std::vector<RendererEntry>& entries() const { return entries_; }
  /// What to attach when linking, so that all that is to be drawn is computed.
  std::vector<Attachment> attachments(const std::vector<ObjectId>& assemblies) const;

 private:
  std::vector<RendererEntry> entries_;
};

/// One renderer of one object, with its switch.
struct Rendering {
  int entry = 0;  ///< in the registry
  ObjectId object;
  bool shown = false;
  std::string fault;  ///< what it threw; empty: nothing
  std::unique_ptr<PropertyRenderer> renderer;
};

/// All renderers of all objects of a world.
class Renderings {
 public:
  /// Matches every object with every renderer whose property it has. Labels count objects from 1, in their order.
  Renderings(const RendererRegistry& registry, const World& world, LinkedWorld& linked,
             const std::vector<ObjectId>& objects);

  std::vector<Rendering>& all() { return all_; }
  const std::vector<Rendering>& all() const { return all_; }
  const RendererEntry& entryOf(const Rendering& r) const { return entries_[static_cast<std::size_t>(r.entry)]; }
  const std::vector<RendererEntry>& entries() const { return entries_; }
  /// The object with this label; invalid when there is none.
  ObjectId objectOf(std::uint32_t label) const;
  /// Switches a renderer on or off on one object, or on all (an invalid id).
  void show(std::string_view name, bool shown, ObjectId object = {});
  /// Clears the list and adds all that is shown.
  void draw(const RenderMoment& now, DrawList& list);

 private:
  std::vector<RendererEntry> entries_;
  std::vector<ObjectId> objects_;
  std::vector<Rendering> all_;
};

/// Whether an object, or a member of one of its subsets, has a constant or a variable of this name.
bool hasProperty(const World& world, const LinkedWorld& linked, ObjectId object, std::string_view property,
                 std::string_view subset);

/// Labels of parts: an object's label in the upper 16 bits, the row of its body in the lower ones.
inline constexpr std::uint32_t partId(std::uint32_t label, int row) {
  return label << 16U | static_cast<std::uint32_t>(row);
}
inline constexpr std::uint32_t labelOfPart(std::uint32_t id) { return id >> 16U; }
inline constexpr int rowOfPart(std::uint32_t id) { return static_cast<int>(id & 0xffffU); }

}  // namespace murosimf
