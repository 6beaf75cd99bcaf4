#include "cli/explain.h"

#include <algorithm>

#include "scenes/scene.h"

namespace carom::tools {
namespace {

/// "carom accuracy run", and the command itself, as far as the line was understood.
struct Place {
  const CLI::App* app;
  std::string path;
};

Place place_of(const CLI::App& app) {
  Place place{&app, app.get_name()};
  while (!place.app->get_subcommands().empty()) {
    place.app = place.app->get_subcommands().front();
    place.path += " " + place.app->get_name();
  }
  return place;
}

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands(nullptr)) names.push_back(sub->get_name());
  return names;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// "did you mean 'run'? ", or nothing
std::string meant(const std::string& word, const std::vector<std::string>& names) {
  const std::string near = nearest_name(word, names);
  return near.empty() ? "" : "did you mean '" + near + "'? ";
}

/// "carom help accuracy run": the line that shows what a command takes.
std::string help_line(const std::string& path) {
  const std::size_t blank = path.find(' ');
  return "`carom help" + (blank == std::string::npos ? "" : path.substr(blank)) + "`";
}

/// "carom export SCENE FILE"
std::string usage_of(const Place& place) {
  std::string line = place.path;
  for (const CLI::Option* option : place.app->get_options([](const CLI::Option* o) { return o->get_positional(); }))
    line += option->get_required() ? " " + option->get_name(true) : " [" + option->get_name(true) + "]";
  for (const CLI::Option* option :
       place.app->get_options([](const CLI::Option* o) { return o->get_required() && !o->get_positional(); }))
    line += " " + option->get_name() + " " + option->get_type_name();
  return line;
}

/// What an option takes, in words of the help.
std::string type_of(const CLI::Option* option) {
  const std::string type = option ? option->get_type_name() : "";
  if (type == "FLOAT" || type == "INT" || type == "UINT") return "NUMBER";
  return type.empty() || type == "TEXT" ? "VALUE" : type;
}

/// The option of that name here or further up.
const CLI::Option* option_of(const CLI::App& app, const Place& place, const std::string& name) {
  for (const CLI::App* at : {place.app, &app})
    if (const CLI::Option* option = at->get_option_no_throw(name)) return option;
  return nullptr;
}

Error no_such_command(const Place& place, const std::string& word) {
  const std::vector<std::string> names = commands_of(*place.app);
  const std::vector<Scene>& scenes = all_scenes();
  if (std::any_of(scenes.begin(), scenes.end(), [&](const Scene& s) { return s.name == word; }))
    return Error("'" + word + "' is a scene, not a command of " + place.path, "write: carom run " + word);
  return Error("there is no command '" + place.path + " " + word + "'",
               meant(word, names) + "the commands are: " + listed(names) + "; " + help_line(place.path) +
                   " says what each does");
}

Error no_such_option(const CLI::App& app, const Place& place, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* at : {place.app, &app})
    for (const CLI::Option* option : at->get_options())
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return Error("there is no option " + word + " of " + place.path,
               meant(word.substr(0, word.find('=')), names) + help_line(place.path) + " lists them");
}

Error word_too_many(const CLI::App& app, const Place& place) {
  std::vector<std::string> rest = place.app->remaining();
  if (rest.empty()) rest = app.remaining();
  for (const std::string& word : rest)
    if (word.size() > 1 && word[0] == '-' && !std::isdigit(static_cast<unsigned char>(word[1])))
      return no_such_option(app, place, word);
  if (rest.empty()) return Error("too many words", "write: " + usage_of(place));
  if (!commands_of(*place.app).empty()) return no_such_command(place, rest.front());
  return Error("'" + rest.front() + "' is a word too many", "write: " + usage_of(place));
}

Error command_missing(const CLI::App& app, const Place& place) {
  if (!place.app->remaining().empty() || !app.remaining().empty()) return word_too_many(app, place);
  return Error("no command of " + place.path + " is given", "give one of " + listed(commands_of(*place.app)) + "; " +
                                                                help_line(place.path) +
                                                                " says what each does; a first try: carom run seesaw");
}

/// "--n = abc" -> {"--n", "abc"}
std::pair<std::string, std::string> split(const std::string& text, const std::string& at) {
  const std::size_t place = text.find(at);
  if (place == std::string::npos) return {text, ""};
  return {text.substr(0, place), text.substr(place + at.size())};
}

/// A value that is no number, or none that the option can hold.
Error no_value(const CLI::App& app, const Place& place, const std::string& said) {
  const auto [name, value] = split(said.substr(said.find(": ") + 2), " = ");
  const CLI::Option* option = option_of(app, place, name);
  const std::string unit = type_of(option);
  const bool plain = unit == "VALUE" || unit == "NUMBER";
  return Error(name + " cannot be '" + value + "'",
               "give a number" + (plain ? std::string() : ", " + unit) + ": " + help_line(place.path) + " says which");
}

/// CLI11's own words of a check: "--threads: Value 0 not in range 1 to 256", or what a check of ours says.
Error check_failed(const Place& place, const std::string& said) {
  const auto [name, why] = split(said, ": ");
  const std::string begin = "Value ", middle = " not in range ";
  if (why.rfind(begin, 0) == 0 && why.find(middle) != std::string::npos) {
    const auto [value, range] = split(why.substr(begin.size()), middle);
    return Error(name + " cannot be '" + value + "'", "give a number from " + range);
  }
  const auto [what, remedy] = split(why, "; ");
  return Error(name + ": " + what, remedy.empty() ? help_line(place.path) + " says what it takes" : remedy);
}

}  // namespace

Error explain(const CLI::App& app, const CLI::ParseError& wrong) {
  const Place place = place_of(app);
  const std::string said = wrong.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&wrong)) return word_too_many(app, place);
  if (dynamic_cast<const CLI::RequiredError*>(&wrong)) {
    if (said.find("ubcommand") != std::string::npos) return command_missing(app, place);
    const std::string name = split(said, " ").first;
    return Error(name + " is missing", "write: " + usage_of(place) + "; " + help_line(place.path) + " says what it is");
  }
  if (dynamic_cast<const CLI::ConversionError*>(&wrong)) return no_value(app, place, said);
  if (dynamic_cast<const CLI::ValidationError*>(&wrong)) return check_failed(place, said);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&wrong)) {
    const std::string name = split(said, ":").first;
    const CLI::Option* option = option_of(app, place, name);
    return Error(name + " has no value, or too many",
                 "write: " + name + " " + type_of(option) + "; " + help_line(place.path) + " says what it takes");
  }
  return Error(said, help_line(place.path) + " says what it takes");
}

std::string help_of(const CLI::App& app, const std::vector<std::string>& words) {
  Place place{&app, app.get_name()};
  for (const std::string& word : words) {
    const CLI::App* next = nullptr;
    for (const CLI::App* sub : place.app->get_subcommands(nullptr))
      if (sub->get_name() == word) next = sub;
    if (!next) throw no_such_command(place, word);
    place = {next, place.path + " " + word};
  }
  return place.app->get_formatter()->make_help(place.app, place.path, CLI::AppFormatMode::Normal);
}

}  // namespace carom::tools
