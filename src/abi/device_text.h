// What a device is given to compile: the text of device/pairs.c, and behind it the support functions of plugins.
#pragma once

#include <string>
#include <string_view>

#include "core/memory.h"

namespace carom::abi {

/// device/pairs.c, as it stands.
extern const char* const kPairsText;

/// A plugin's text with each name of its own changed, so that the texts of several plugins stand in one program.
/// @param number  of the plugin; its function is p<number>_support()
/// @param why     [size] "calls sin()": what a text may not have
/// @return        false if it has that
bool add_plugin_text(std::string_view text, std::uint32_t number, std::pmr::string& program, char* why,
                     std::size_t size);

/// carom_ask(), which asks one of `count` plugins.
void add_ask(std::uint32_t count, std::pmr::string& program);

}  // namespace carom::abi
