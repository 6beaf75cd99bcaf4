// Broad phase by trees of fat boxes: who stays inside its fat box costs one comparison, who leaves it one query.
//
// A body's fat box is larger than its bounds by a share of its size, and reaches ahead the way it moves. Pairs of fat
// boxes that overlap are candidates, kept from step to step in order; a step looks whose bounds have left their fat
// box, moves those in the tree, asks the tree for their candidates anew, and filters all candidates by the bounds
// themselves. So the answer never depends on a fat box, nor on what the trees look like.
//
// What can move has one tree, what cannot another, and nobody of the second is asked about unless it changes. Unbounded
// boxes (half-spaces) are in no tree, whose boxes they would make far too large; they are few, and compared with who moved.
// Where more than a share of a tree's leaves changed, it is built afresh rather than edited leaf by leaf; so it is
// when a leaf ended too deep, or queries cost more than those after the last time by what building costs. A step costs
// at most O(n log n), the queries apart, however boxes lie.
#include <algorithm>
#include <bit>

#include "collision/broad/box_tree.h"
#include "collision/broad/broad_phase.h"
#include "collision/broad/fat_boxes.h"
#include "collision/broad/pair_order.h"

namespace carom::collision {
namespace {

/// Part of the leaves that may change one by one; beyond, building afresh costs less.
constexpr std::size_t kAfresh = 2;

class Tree final : public BroadPhase {
 public:
  explicit Tree(Memory* m)
      : moving_(m),
        fixed_(m),
        kind_(m),
        owner_(m),
        changed_(m),
        fat_(m),
        live_(m),
        asked_(m),
        gone_(m),
        shrunk_(m),
        wide_(m),
        leaves_(m),
        known_(m),
        fresh_(m),
        spare_(m),
        order_(m) {}

  void find_pairs(const Colliders& table, std::uint64_t, const BroadSettings&, Array<Pair>& pairs) override {
    work_ = {};
    if (!whole_) clear();
    whole_ = false;  // stays so if an allocation fails half-way: the next call starts afresh
    grow(table.slots());
    fat_.begin_call();
    const bool disabled = take_in(table);
    if (!asked_.empty() || !gone_.empty() || !shrunk_.empty()) {
      settle(table);
      if (2 * asked_.size() > live_.size()) {
        look_at_all();
        filter(table, pairs);
      } else {
        look_around();
        merge(table, pairs);
      }
      work_.asked = asked_.size();
      level(pairs);
      for (const Array<std::uint32_t>* list : {&asked_, &gone_, &shrunk_})
        for (const std::uint32_t slot : *list) changed_[slot] = kStays;
    } else {
      filter(table, pairs);
    }
    if (disabled) std::erase_if(pairs, [&](const Pair& q) { return table.disabled[q.a] | table.disabled[q.b]; });
    whole_ = true;
  }

  void find_near(const Colliders& table, const Aabb& box, Array<std::uint32_t>& found) override {
    const auto take = [&](std::uint32_t slot) {
      if (table.bounds[slot].overlaps(box)) found.push_back(slot);
    };
    moving_.query(box, take), fixed_.query(box, take);
    for (const std::uint32_t slot : wide_) take(slot);
  }

 private:
  enum Kind : std::uint8_t { none, wide, wide_fixed, fixed, moving };
  /// All of a slot's candidates are void; or those whose fat boxes it does not overlap any more.
  enum Change : std::uint8_t { kStays = 0, kShrunk = 1, kVoid = 2 };
  static bool moves(Kind k) { return k == moving || k == wide; }
  static bool in_tree(Kind k) { return k >= fixed; }
  BoxTree& tree(Kind k) { return k == fixed ? fixed_ : moving_; }

  void clear() {
    moving_.clear(), fixed_.clear();
    std::fill(kind_.begin(), kind_.end(), none);
    std::fill(changed_.begin(), changed_.end(), std::uint8_t(0));
    fat_.clear();
    live_.clear(), asked_.clear(), gone_.clear(), shrunk_.clear(), wide_.clear(), known_.clear();
  }

  void grow(std::size_t slots) {
    if (kind_.size() >= slots) return;
    moving_.grow(slots), fixed_.grow(slots);
    for (Array<std::uint32_t>* list : {&live_, &asked_, &gone_, &shrunk_, &wide_, &leaves_}) list->reserve(2 * slots);
    owner_.resize(slots), changed_.resize(slots, 0), fat_.grow(slots);
    kind_.resize(slots, none);  // last: its size says that all have theirs
  }

  static Kind kind_of(const Colliders& table, std::uint32_t slot) {
    const Aabb& box = table.bounds[slot];
    if (is_empty(box)) return none;
    const bool bounded = (box.hi - box.lo).max_entry() < kInfinity;
    if (table.movable[slot]) return bounded ? moving : wide;
    return bounded ? fixed : wide_fixed;
  }

  /// Whose a slot is, whether that moves, and whether anybody notices what it touches.
  static std::uint64_t owner(const Colliders& table, std::uint32_t slot) {
    return 4 * std::uint64_t(table.body[slot]) + 2 * notices(table, slot) + (table.movable[slot] != 0);
  }
  bool noticed(std::uint32_t slot) const { return owner_[slot] & 2; }

  /// Compare the table with what is known of it: who is new, changed, has left its fat box (asked_), is gone (gone_),
  /// or may have a smaller one (shrunk_).
  /// @return whether anybody is disabled
  bool take_in(const Colliders& table) {
    asked_.clear(), gone_.clear(), shrunk_.clear();
    if (!std::equal(table.active.begin(), table.active.end(), live_.begin(), live_.end())) {
      std::size_t i = 0;  // both lists are ascending and walked side by side
      for (const std::uint32_t slot : live_) {
        while (i < table.active.size() && table.active[i] < slot) ++i;
        if (i == table.active.size() || table.active[i] != slot) leave(slot);
      }
      live_.assign(table.active.begin(), table.active.end());
    }
    senses_ = !table.sensor.empty();
    std::uint8_t disabled = 0;
    for (const std::uint32_t slot : live_) {
      disabled |= table.disabled[slot];
      if (owner_[slot] == owner(table, slot) && holds(fat_.of[slot], table.bounds[slot])) continue;
      if (is_empty(table.bounds[slot]))
        leave(slot);
      else
        ask(slot);
    }
    for (std::size_t i = fat_.calls() % FatBoxes::kReview; i < live_.size(); i += FatBoxes::kReview)
      if (kind_[live_[i]] == moving && !changed_[live_[i]] && fat_.bloated(table.bounds[live_[i]], live_[i]))
        shrunk_.push_back(live_[i]), changed_[live_[i]] = kShrunk;
    return disabled;
  }

  void ask(std::uint32_t slot) { asked_.push_back(slot), changed_[slot] = kVoid; }
  void leave(std::uint32_t slot) {
    if (kind_[slot] != none) gone_.push_back(slot), changed_[slot] = kVoid;
  }

  /// Bring fat boxes and trees up to date with who changed.
  void settle(const Colliders& table) {
    std::size_t touched[2] = {0, 0};  // leaves of the fixed and the moving tree that come, go or change
    const auto touch = [&](Kind k) { touched[k == moving] += in_tree(k); };
    for (const std::uint32_t slot : gone_) touch(kind_[slot]);
    for (const std::uint32_t slot : asked_) {
      const Kind now = kind_of(table, slot);
      if (now != kind_[slot]) touch(kind_[slot]);
      touch(now);
    }
    const bool afresh[2] = {kAfresh * touched[0] > fixed_.size(),
                            kAfresh * touched[1] > moving_.size() || moving_.worn()};
    if (afresh[1]) fat_.measure(table, live_);

    bool rewide = false;
    const auto take_out = [&](std::uint32_t slot) {
      const Kind k = kind_[slot];
      rewide |= k == wide || k == wide_fixed;
      if (in_tree(k) && !afresh[k == moving]) tree(k).remove(slot);
      kind_[slot] = none;
    };
    bool deep[2] = {false, false};
    for (const std::uint32_t slot : gone_) take_out(slot), fat_.of[slot] = Aabb();  // which holds nothing
    for (const std::uint32_t slot : asked_) {
      const Kind before = kind_[slot], now = kind_of(table, slot);
      if (before != now) take_out(slot);
      fat_.fatten(table.bounds[slot], slot, now == moving, before == moving && owner_[slot] == owner(table, slot));
      kind_[slot] = now;
      owner_[slot] = owner(table, slot);
      rewide |= !in_tree(now);
      if (in_tree(now) && !afresh[now == moving]) {
        BoxTree& t = tree(now);
        const std::size_t depth = before == now ? t.move(slot, fat_.of[slot]) : t.insert(slot, fat_.of[slot]);
        // Halving leaves would get by with a third of this.
        deep[now == moving] |= depth > 3 * static_cast<std::size_t>(std::bit_width(t.size())) + 8;
      }
    }
    for (const std::uint32_t slot : shrunk_) {
      fat_.shrink(table.bounds[slot], slot);
      if (!afresh[1]) moving_.shrink(slot, fat_.of[slot]);
    }
    for (const Kind k : {fixed, moving})
      if (afresh[k == moving] || deep[k == moving]) rebuild(k);
    if (!rewide) return;
    wide_.clear();
    for (const std::uint32_t slot : live_)
      if (kind_[slot] != none && !in_tree(kind_[slot])) wide_.push_back(slot);
  }

  void rebuild(Kind k) {
    leaves_.clear();
    for (const std::uint32_t slot : live_)
      if (kind_[slot] == k) leaves_.push_back(slot);
    tree(k).build(leaves_, fat_.of);
    ++work_.rebuilds;
  }

  /// The lists change places, so what one has grown to the others get too; and what they are merged and sorted into.
  void level(Array<Pair>& pairs) {
    constexpr std::size_t kFew = 16;  // so that a small world has done so after its first step
    const std::size_t room = std::max({kFew, known_.capacity(), spare_.capacity(), fresh_.capacity()});
    for (Array<Pair>* list : {&known_, &spare_, &fresh_, &pairs}) list->reserve(room);
    order_.reserve(room);
  }

  void add(std::uint32_t a, std::uint32_t b) {
    if (owner_[a] >> 2 != owner_[b] >> 2 && ((owner_[a] | owner_[b]) & 2)) fresh_.push_back({std::min(a, b), std::max(a, b)});
  }

  /// Whether what does not move can be met by one that moves.
  bool meets_fixed(std::uint32_t slot) const { return noticed(slot) || senses_; }

  /// All candidates of who changed; those of all others stay.
  void look_around() {
    fresh_.clear();
    for (const std::uint32_t slot : asked_) {
      const Aabb& box = fat_.of[slot];
      const auto found = [&](std::uint32_t other) {
        // Of two that are both asked for, the one with the smaller number finds the other.
        if (other != slot && !(changed_[other] == kVoid && other < slot)) add(slot, other);
      };
      const bool free = moves(kind_[slot]) && meets_fixed(slot);
      work_.tests += moving_.query(box, found) + wide_.size();
      if (free) work_.tests += fixed_.query(box, found);
      for (const std::uint32_t other : wide_)
        if ((moves(kind_[slot]) || moves(kind_[other])) && box.overlaps(fat_.of[other])) found(other);
    }
    order_.sort(fresh_, kind_.size());
  }

  /// All candidates of all, where most changed.
  void look_at_all() {
    fresh_.clear();
    const auto found = [&](std::uint32_t a, std::uint32_t b) { add(a, b); };
    work_.tests += moving_.each_pair(found);
    // The fewer ask the more.
    const Kind asking = fixed_.size() < moving_.size() ? fixed : moving;
    BoxTree& other = tree(asking == fixed ? moving : fixed);
    if (fixed_.size() > 0)
      for (const std::uint32_t slot : live_)
        if (kind_[slot] == asking && (asking == fixed || meets_fixed(slot))) work_.tests += other.query(fat_.of[slot], [&](std::uint32_t b) { add(slot, b); });
    for (std::size_t i = 0; i < wide_.size(); ++i) {
      const std::uint32_t slot = wide_[i];
      const bool free = moves(kind_[slot]);
      const auto beside = [&](std::uint32_t b) { add(slot, b); };
      work_.tests += moving_.query(fat_.of[slot], beside) + wide_.size() - i;
      if (free) work_.tests += fixed_.query(fat_.of[slot], beside);
      for (std::size_t j = i + 1; j < wide_.size(); ++j)
        if ((free || moves(kind_[wide_[j]])) && fat_.of[slot].overlaps(fat_.of[wide_[j]])) beside(wide_[j]);
    }
    order_.sort(fresh_, kind_.size());
    known_.swap(fresh_);
  }

  /// Candidates whose bounds overlap. Whether two boxes do is a coin toss, so it moves a pointer instead of branching;
  /// and runs of the same first slot are too short to hold its box for them: where they end is another toss.
  void filter(const Colliders& table, Array<Pair>& pairs) {
    pairs.resize(known_.size());
    work_.tests += known_.size();
    const Aabb* const bounds = table.bounds.data();
    Pair* out = pairs.data();
    for (const Pair& p : known_) {
      *out = p;
      out += HeldBox(bounds[p.a]).overlaps(bounds[p.b]);
    }
    pairs.resize(static_cast<std::size_t>(out - pairs.data()));
  }

  /// Candidates of those who did not change, and what is fresh, become what is known, and are filtered on the way.
  void merge(const Colliders& table, Array<Pair>& pairs) {
    spare_.resize(known_.size() + fresh_.size());
    pairs.resize(spare_.size());
    const Aabb* const bounds = table.bounds.data();
    const std::uint8_t* const changed = changed_.data();
    Pair *kept = spare_.data(), *out = pairs.data();
    const auto take = [&](const Pair& p, bool stays) {
      *kept = *out = p;
      kept += stays;
      out += stays & HeldBox(bounds[p.a]).overlaps(bounds[p.b]);
    };
    const auto pass = [&](const Pair& p) {
      const int change = changed[p.a] | changed[p.b];
      take(p, change == kStays || (change == kShrunk && fat_.of[p.a].overlaps(fat_.of[p.b])));
    };
    const Pair* p = known_.data();
    const Pair* const end = p + known_.size();
    for (const Pair& q : fresh_) {
      for (; p < end && *p < q; ++p) pass(*p);
      take(q, true);
    }
    for (; p < end; ++p) pass(*p);
    spare_.resize(static_cast<std::size_t>(kept - spare_.data()));
    pairs.resize(static_cast<std::size_t>(out - pairs.data()));
    work_.tests += spare_.size();
    known_.swap(spare_);
  }

  BoxTree moving_, fixed_;
  Array<Kind> kind_;                            // [slots] as of the last call
  Array<std::uint64_t> owner_;                  // [slots] see owner()
  Array<std::uint8_t> changed_;                 // [slots] in this call, see Change
  FatBoxes fat_;
  Array<std::uint32_t> live_;                   // slots of the table, ascending
  Array<std::uint32_t> asked_, gone_, shrunk_;  // of this call
  Array<std::uint32_t> wide_;                   // slots with an unbounded box
  Array<std::uint32_t> leaves_;                 // of a tree to be built
  Array<Pair> known_;                           // candidates, ascending
  Array<Pair> fresh_, spare_;
  PairOrder order_;
  bool senses_ = false;  // there are sensors, which may be fixed
  bool whole_ = false;  // all of the above are those of the last call
};

}  // namespace

Owned<BroadPhase> make_tree(Memory* memory) { return make_owned<BroadPhase, Tree>(memory, memory); }

}  // namespace carom::collision
