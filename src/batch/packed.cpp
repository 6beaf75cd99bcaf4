// A section is packed as its tag and size, a bit for each of its words of 8 bytes, and the words whose bit is set: those
// that differ. Behind the end of the other's section, and where it has none, its words count as 0.
#include "batch/packed.h"

#include <bit>
#include <cstring>

namespace carom::batch {
namespace {

constexpr std::uint64_t kWord = 8, kBits = 64;

struct PackedSection {
  std::uint32_t tag, unused;
  std::uint64_t size;
};

std::uint64_t words_of(std::uint64_t bytes) { return (bytes + kWord - 1) / kWord; }

std::uint64_t word_at(const std::byte* at) {
  std::uint64_t word;
  std::memcpy(&word, at, kWord);
  return word;
}

/// Writes up to its capacity, and counts on.
class Sink {
 public:
  Sink(std::byte* to, std::uint64_t capacity) : to_(to), capacity_(capacity) {}
  void put(const void* from, std::uint64_t n) {
    if (size_ + n <= capacity_) std::memcpy(to_ + size_, from, n);
    size_ += n;
  }
  std::uint64_t size() const { return size_; }

 private:
  std::byte* to_;
  std::uint64_t capacity_, size_ = 0;
};

}  // namespace

PackingBase::PackingBase(Array<std::byte> bytes) : bytes_(std::move(bytes)), sections_(bytes_.get_allocator()) {
  SectionBytes section;
  for (std::uint64_t at = 0; next_section(bytes_.data(), bytes_.size(), at, section);) sections_.push_back(section);
}

const SectionBytes* PackingBase::find(std::uint32_t tag) const {
  for (const SectionBytes& section : sections_)
    if (section.tag == tag) return &section;
  return nullptr;
}

std::uint64_t PackingBase::pack(const std::byte* bytes, std::uint64_t n, std::byte* to, std::uint64_t capacity) const {
  Sink sink(to, capacity);
  sink.put(&n, kWord);
  SectionBytes section;
  for (std::uint64_t at = 0; next_section(bytes, n, at, section);) {
    const SectionBytes* const base = find(section.tag);
    const std::uint64_t words = words_of(section.size), shared = base ? std::min(words, words_of(base->size)) : 0;
    const PackedSection head{section.tag, 0, section.size};
    sink.put(&head, sizeof head);
    std::uint64_t block[kBits];
    for (std::uint64_t first = 0; first < words; first += kBits) {
      const std::uint64_t many = std::min(kBits, words - first);
      std::uint64_t mask = 0, count = 0;
      for (std::uint64_t k = 0; k < many; ++k) {
        const std::uint64_t i = first + k, now = word_at(section.begin + kWord * i);
        const std::uint64_t was = i < shared ? word_at(base->begin + kWord * i) : 0;
        block[count] = now;
        mask |= std::uint64_t(now != was) << k, count += now != was;
      }
      sink.put(&mask, kWord);
      sink.put(block, kWord * count);
    }
  }
  return sink.size();
}

void PackingBase::unpack(const Array<std::byte>& packed, Array<std::byte>& to) const {
  const std::byte* from = packed.data();
  const std::byte* const end = from + packed.size();
  std::uint64_t n;
  std::memcpy(&n, from, kWord), from += kWord;
  if (to.size() < n) remake(to, n);
  std::uint64_t at = put_header(to.data(), n);
  while (from != end) {
    PackedSection head;
    std::memcpy(&head, from, sizeof head), from += sizeof head;
    const SectionBytes* const base = find(head.tag);
    at += put_section_header(to.data() + at, head.tag, head.size);
    std::byte* const section = to.data() + at;
    const std::uint64_t words = words_of(head.size), shared = base ? std::min(words, words_of(base->size)) : 0;
    if (shared > 0) std::memcpy(section, base->begin, kWord * shared);
    std::memset(section + kWord * shared, 0, kWord * (words - shared));
    for (std::uint64_t first = 0; first < words; first += kBits) {
      std::uint64_t mask = word_at(from);
      from += kWord;
      for (; mask != 0; mask &= mask - 1, from += kWord)
        std::memcpy(section + kWord * (first + static_cast<std::uint64_t>(std::countr_zero(mask))), from, kWord);
    }
    at += kWord * words;
  }
}

}  // namespace carom::batch
