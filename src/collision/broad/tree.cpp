// Broad phase by trees of fat boxes: who stays inside its fat box costs one comparison, who leaves it one query.
//
// A body's fat box is larger than its bounds by a share of its size, and reaches ahead the way it moves. Pairs of fat
// boxes that overlap are candidates, kept from step to step in order; a step looks whose bounds have left their fat
// box, moves those in the tree, asks the tree for their candidates anew, and filters all candidates by the bounds
// themselves. So the result never depends on a fat box, nor on what the trees look like.
//
// What can move has one tree, what cannot another, and nothing of the second is searched unless it changes. Unbounded
// boxes (half-spaces) are in no tree, whose boxes they would make far too large; they are few, and compared with who moved.
// Where more than a share of a tree's leaves changed, it is built afresh rather than edited leaf by leaf; so it is
// when a leaf ended too deep, or queries cost more than those after the last time by what building costs. A step costs
// at most O(n log n), the queries apart, however boxes lie.
#include <algorithm>
#include <array>
#include <atomic>
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
        tests_(m),
        known_(m),
        fresh_(m),
        spare_(m),
        found_(m),
        blocks_(m),
        order_(m) {}

  void find_pairs(const Colliders& table, std::uint64_t, const BroadSettings& settings, Array<Pair>& pairs) override {
    work_ = {};
    jobs_ = settings.jobs;
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
  /// Boxes that one compared in both trees.
  struct Tests {
    std::uint32_t moving, fixed;
  };
  static constexpr std::size_t kAskedAPart = 32, kPairsAPart = 2048;  // some microseconds of a loop
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
    const std::size_t capacity = std::max({kFew, known_.capacity(), spare_.capacity(), fresh_.capacity()});
    for (Array<Pair>* list : {&known_, &spare_, &fresh_, &pairs}) list->reserve(capacity);
    blocks_.reserve(capacity / kPairsAPart + 1), tests_.reserve(kind_.size());
    if (found_.size() < capacity) found_.resize(capacity);
    order_.reserve(capacity);
  }

  /// Whether two may be a pair.
  bool meet(std::uint32_t a, std::uint32_t b) const {
    return owner_[a] >> 2 != owner_[b] >> 2 && ((owner_[a] | owner_[b]) & 2);
  }
  void add(std::uint32_t a, std::uint32_t b) {
    if (meet(a, b)) fresh_.push_back({std::min(a, b), std::max(a, b)});
  }

  /// Whether what does not move can be met by one that moves.
  bool meets_fixed(std::uint32_t slot) const { return noticed(slot) || senses_; }

  /// Pairs that a thread has found, brought to found_ some at a time. Which comes where is left to chance.
  class Basket {
   public:
    Basket(Array<Pair>& found, std::atomic<std::size_t>& count) : found_(found), count_(count) {}
    ~Basket() { empty(); }
    void put(std::uint32_t a, std::uint32_t b) {
      pair_[held_++] = {std::min(a, b), std::max(a, b)};
      if (held_ == pair_.size()) empty();
    }

   private:
    void empty() {
      const std::size_t at = count_.fetch_add(held_, std::memory_order_relaxed);
      if (at + held_ <= found_.size()) std::copy_n(pair_.data(), held_, found_.data() + at);
      held_ = 0;
    }
    Array<Pair>& found_;
    std::atomic<std::size_t>& count_;
    std::array<Pair, 64> pair_;
    std::size_t held_ = 0;
  };

  /// Call found(other) for all that the fat box of one overlaps.   @return boxes compared
  template <class Found>
  Tests search(std::uint32_t slot, const Found& found) const {
    const Aabb& box = fat_.of[slot];
    Tests tests{static_cast<std::uint32_t>(moving_.search(box, found)), 0};
    if (moves(kind_[slot]) && meets_fixed(slot)) tests.fixed = static_cast<std::uint32_t>(fixed_.search(box, found));
    for (const std::uint32_t other : wide_)
      if ((moves(kind_[slot]) || moves(kind_[other])) && box.overlaps(fat_.of[other])) found(other);
    return tests;
  }

  /// All candidates of who changed; those of all others stay.
  void look_around() {
    tests_.resize(asked_.size());
    std::atomic<std::size_t> count{0};
    while (true) {
      count.store(0, std::memory_order_relaxed);
      in_parts(jobs_, asked_.size(), kAskedAPart, [&](std::uint32_t begin, std::uint32_t end) {
        Basket basket(found_, count);
        for (std::uint32_t i = begin; i < end; ++i) {
          const std::uint32_t slot = asked_[i];
          tests_[i] = search(slot, [&](std::uint32_t other) {
            // Of two that are both asked for, the one with the smaller number finds the other.
            if (other != slot && !(changed_[other] == kVoid && other < slot) && meet(slot, other))
              basket.put(slot, other);
          });
        }
      });
      if (count.load(std::memory_order_relaxed) <= found_.size()) break;
      core::grow_to(found_, count.load(std::memory_order_relaxed));  // and once more: all that capacity holds now
    }
    for (std::size_t i = 0; i < asked_.size(); ++i) {
      moving_.count(tests_[i].moving);
      if (tests_[i].fixed > 0) fixed_.count(tests_[i].fixed);
      work_.tests += tests_[i].moving + tests_[i].fixed + wide_.size();
    }
    fresh_.assign(found_.begin(), found_.begin() + static_cast<std::ptrdiff_t>(count.load(std::memory_order_relaxed)));
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
        if (kind_[slot] == asking && (asking == fixed || meets_fixed(slot)))
          work_.tests += other.query(fat_.of[slot], [&](std::uint32_t b) { add(slot, b); });
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

  /// A block of candidates, which one thread has to itself, and what it writes from where it begins: what stays and
  /// what overlaps.
  struct Block {
    std::size_t first, last, fresh, fresh_end;  // of known_, of fresh_
    Pair *kept, *out;                           // one past what is written
    std::size_t begin() const { return first + fresh; }
  };

  /// Candidates and fresh ones in blocks; all in one where no threads share them.
  void cut_into_blocks(const Array<Pair>& fresh) {
    const std::size_t n = known_.size(), part = jobs_ ? kPairsAPart : std::max<std::size_t>(n, 1);
    blocks_.resize(std::max<std::size_t>((n + part - 1) / part, 1));
    std::size_t from = 0;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      const std::size_t first = i * part, last = std::min(first + part, n);
      const auto end = last < n ? std::lower_bound(fresh.begin(), fresh.end(), known_[last]) : fresh.end();
      blocks_[i] = {first, last, from, static_cast<std::size_t>(end - fresh.begin()), nullptr, nullptr};
      from = blocks_[i].fresh_end;
    }
  }

  /// What blocks wrote, one after the other.
  template <Pair* Block::*kEnd>
  void close_ranks(Array<Pair>& pairs) const {
    Pair* to = pairs.data();
    for (const Block& b : blocks_) {
      const Pair* const from = pairs.data() + b.begin();
      to = from == to ? b.*kEnd : std::copy(from, static_cast<const Pair*>(b.*kEnd), to);
    }
    pairs.resize(static_cast<std::size_t>(to - pairs.data()));
  }

  /// Candidates whose bounds overlap. Whether two boxes do is a coin toss, so it moves a pointer instead of branching;
  /// and runs of the same first slot are too short to hold its box for them: where they end is another toss.
  void filter(const Colliders& table, Array<Pair>& pairs) {
    pairs.resize(known_.size());
    work_.tests += known_.size();
    cut_into_blocks({});
    in_parallel(jobs_, blocks_.size(), 1, [&](std::uint32_t i) {
      Block& block = blocks_[i];
      const Aabb* const bounds = table.bounds.data();
      Pair* out = pairs.data() + block.begin();
      for (const Pair *p = known_.data() + block.first, *const end = known_.data() + block.last; p < end; ++p) {
        *out = *p;
        out += HeldBox(bounds[p->a]).overlaps(bounds[p->b]);
      }
      block.out = out;
    });
    close_ranks<&Block::out>(pairs);
  }

  /// Candidates of those who did not change, and what is fresh, become what is known, and are filtered on the way.
  void merge(const Colliders& table, Array<Pair>& pairs) {
    spare_.resize(known_.size() + fresh_.size());
    pairs.resize(spare_.size());
    cut_into_blocks(fresh_);
    in_parallel(jobs_, blocks_.size(), 1, [&](std::uint32_t i) { merge(table, blocks_[i], pairs); });
    close_ranks<&Block::kept>(spare_), close_ranks<&Block::out>(pairs);
    work_.tests += spare_.size();
    known_.swap(spare_);
  }
  void merge(const Colliders& table, Block& block, Array<Pair>& pairs) {
    const Aabb* const bounds = table.bounds.data();
    const std::uint8_t* const changed = changed_.data();
    Pair *kept = spare_.data() + block.begin(), *out = pairs.data() + block.begin();
    const auto take = [&](const Pair& p, bool stays) {
      *kept = *out = p;
      kept += stays;
      out += stays & HeldBox(bounds[p.a]).overlaps(bounds[p.b]);
    };
    const auto pass = [&](const Pair& p) {
      const int change = changed[p.a] | changed[p.b];
      take(p, change == kStays || (change == kShrunk && fat_.of[p.a].overlaps(fat_.of[p.b])));
    };
    const Pair* p = known_.data() + block.first;
    const Pair* const end = known_.data() + block.last;
    for (const Pair *q = fresh_.data() + block.fresh, *const last = fresh_.data() + block.fresh_end; q < last; ++q) {
      for (; p < end && *p < *q; ++p) pass(*p);
      take(*q, true);
    }
    for (; p < end; ++p) pass(*p);
    block.kept = kept, block.out = out;
  }

  BoxTree moving_, fixed_;
  Array<Kind> kind_;             // [slots] as of the last call
  Array<std::uint64_t> owner_;   // [slots] see owner()
  Array<std::uint8_t> changed_;  // [slots] in this call, see Change
  FatBoxes fat_;
  Array<std::uint32_t> live_;                   // slots of the table, ascending
  Array<std::uint32_t> asked_, gone_, shrunk_;  // of this call
  Array<std::uint32_t> wide_;                   // slots with an unbounded box
  Array<std::uint32_t> leaves_;                 // of a tree to be built
  Array<Tests> tests_;                          // by asked_
  Array<Pair> known_;                           // candidates, ascending
  Array<Pair> fresh_, spare_;
  Array<Pair> found_;    // of threads, as they come; all of it there, the first of it in use
  Array<Block> blocks_;  // of known_
  PairOrder order_;
  Jobs* jobs_ = nullptr;
  bool senses_ = false;  // there are sensors, which may be fixed
  bool whole_ = false;   // all of the above are those of the last call
};

}  // namespace

Owned<BroadPhase> make_tree(Memory* memory) { return make_owned<BroadPhase, Tree>(memory, memory); }

}  // namespace carom::collision
