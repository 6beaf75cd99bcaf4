#include "scenefile/attributes.h"

namespace carom::tools::scenefile {
namespace {

struct Attribute {
  carom_attribute_info info;
  explicit Attribute(std::uint32_t id) : info{} {
    info.struct_size = sizeof info;
    Call call;
    call.done(carom_attribute_get_info(id, &info, call), "asking about an attribute");
  }
};

void set(const Value& given, const Attribute& attribute, carom_world* world, carom_body body) {
  const std::uint32_t n = attribute.info.numbers;
  double value[CAROM_ATTRIBUTE_NUMBERS] = {};
  if (n == 1) {
    value[0] = attribute.info.is_whole ? static_cast<double>(given.bits()) : given.number();
  } else {
    const std::vector<double> numbers = given.numbers(n);
    std::copy(numbers.begin(), numbers.end(), value);
  }
  Call call;
  call.done(carom_body_set_attribute(world, body, attribute.info.attribute, value, call), given.place());
}

}  // namespace

json attributes_of(carom_world* world, carom_body body) {
  json all = json::object();
  for (std::uint32_t id = 0; id < CAROM_ATTRIBUTE_COUNT; ++id) {
    const Attribute attribute(id);
    double value[CAROM_ATTRIBUTE_NUMBERS];
    Call call;
    call.done(carom_body_get_attribute(world, body, id, value, call), "reading a body");
    const std::uint32_t n = attribute.info.numbers;
    if (std::equal(value, value + n, attribute.info.usual)) continue;
    json& entry = all[attribute.info.name];
    if (n > 1)
      entry = std::vector<double>(value, value + n);
    else if (attribute.info.is_whole)
      entry = static_cast<std::uint64_t>(value[0]);
    else
      entry = value[0];
  }
  return all;
}

void read_attributes(const Value& own, carom_world* world, carom_body body) {
  static constexpr std::pair<const char*, std::uint32_t> kOlderNames[] = {
      {"drag", CAROM_ATTRIBUTE_DRAG},
      {"locks", CAROM_ATTRIBUTE_LOCKS},
      {"fieldMask", CAROM_ATTRIBUTE_FORCE_FIELD_MASK}};
  for (const auto& [name, id] : kOlderNames)
    if (const auto given = own.get(name)) set(*given, Attribute(id), world, body);
  const auto given = own.get("attributes");
  if (!given) return;
  std::vector<std::string> names;
  for (std::uint32_t id = 0; id < CAROM_ATTRIBUTE_COUNT; ++id) names.push_back(Attribute(id).info.name);
  for (const auto& [name, value] : given->items()) {
    const auto at = std::find(names.begin(), names.end(), name);
    if (at == names.end()) {
      const std::string near = nearest_name(name, names);
      value.fail("is no attribute that a body has", near.empty() ? "leave it out" : "write \"" + near + "\"?");
    }
    set(value, Attribute(static_cast<std::uint32_t>(at - names.begin())), world, body);
  }
}

}  // namespace carom::tools::scenefile
