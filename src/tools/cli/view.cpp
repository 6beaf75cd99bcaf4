// `carom view SCENE`: the page of src/site, served to browsers of this machine, with a scene packed on the spot.
#include <cstdio>
#include <filesystem>
#include <memory>

#include "cli/packed_scene.h"
#include "cli/packed_truth.h"
#include "host/files.h"
#include "host/system.h"
#include "serve/serve.h"

namespace carom::tools {
namespace {

namespace fs = std::filesystem;

struct ViewOptions {
  SceneChoice choice;
  HashedSteps steps{240, 3};
  std::string site;
  std::uint16_t port = 8011;
  bool open = false;
};

/// The built page: --site, or of an installation, or of the checkout in which this program was built.
std::string site_folder(const std::string& given) {
  std::vector<fs::path> places;
  if (!given.empty()) {
    places.emplace_back(given);
  } else {
    const fs::path base = own_base();
    places = {base / "share/carom/site", base / "../../src/site/dist"};  // PREFIX/bin/carom, build/demo/bin/carom
  }
  std::string searched;
  for (const fs::path& place : places) {
    std::error_code failed;
    if (fs::is_regular_file(place / "index.html", failed)) return fs::weakly_canonical(place, failed).string();
    searched += "\n    " + place.lexically_normal().string();
  }
  throw Error("the page is not built: there is no index.html in" + searched,
              "build it as src/site/README.md says: cmake --preset wasm && cmake --build --preset wasm, then "
              "build/demo/bin/carom pack out/scenes && cd src/site && npm ci && npm run build; or name its folder: "
              "--site DIR");
}

/// The folder's own index with one scene in front, which the page then shows first.
std::string index_with(const nlohmann::json& row, const std::string& folder) {
  nlohmann::json index = nlohmann::json::array({row});
  std::error_code failed;
  const std::string own = folder + "/scenes/index.json";
  if (!fs::exists(own, failed)) return index.dump();
  const nlohmann::json others = nlohmann::json::parse(read_file(own, "build the page again"), nullptr, false);
  if (!others.is_array()) throw Error(own + " is damaged", "build the page again: cd src/site && npm run build");
  for (const nlohmann::json& other : others)
    if (other.is_object() && other.value("name", "") != row.value("name", "")) index.push_back(other);
  return index.dump();
}

/// "?scene=pyramid&set=n=12": length of the row (4 bytes, little-endian), row, world, truth.   @throws Error
std::string made_scene(const serve::Question& question, Context& context) {
  SceneChoice choice;
  const auto [from, to] = question.equal_range("set");
  for (auto set = from; set != to; ++set) choice.sets.push_back(set->second);
  const auto scene = question.find("scene");
  if (scene == question.end()) throw Error("no scene is named", "ask for ?scene=NAME&set=PARAMETER=VALUE");
  choice.scene = scene->second;
  if (choice.scene.starts_with("accuracy_")) choice.scene[8] = '/';  // as the page has it
  if (!is_accuracy_scene(choice.scene)) find_scene(choice.scene);    // of the library alone: a page names no files
  PackedScene packed = packed_scene(choice, {240, 1}, context);
  if (!packed.truth.empty()) packed.row["truth"]["bytes"] = packed.truth.size();
  const std::string row = packed.row.dump();
  const std::size_t n = row.size();
  std::string bytes;
  for (int byte = 0; byte < 4; ++byte) bytes += static_cast<char>(n >> (8 * byte) & 255);
  return bytes + row + packed.content + packed.truth;
}

void view(ViewOptions& options, Context& context) {
  serve::Site site;
  const std::string& scene = options.choice.scene;  // a wrong name is told before a missing page is
  if (is_accuracy_scene(scene))
    accuracy_scene(scene);
  else if (!scene.empty() && !is_recording(scene))
    chosen_scene(scene);
  site.folder = site_folder(options.site);
  if (!options.choice.scene.empty()) {
    PackedScene packed = is_recording(options.choice.scene) ? packed_recording(options.choice.scene)
                                                            : packed_scene(options.choice, options.steps, context);
    packed.row["first"] = true;
    site.in_place["/scenes/" + packed.file] = std::move(packed.content);
    if (!packed.truth.empty())
      site.in_place["/scenes/" + packed.row["truth"]["file"].get<std::string>()] = std::move(packed.truth);
    site.in_place["/scenes/index.json"] = index_with(packed.row, site.folder);
  }
  site.make = [&context](const serve::Question& question) { return made_scene(question, context); };
  serve::run(site, options.port, [&](std::uint16_t port) {
    const std::string address = "http://127.0.0.1:" + std::to_string(port) + "/";
    std::printf("%s  (ctrl-C ends it)\n", address.c_str());
    std::fflush(stdout);
    if (options.open && !open_in_browser(address))
      std::fprintf(stderr, "carom: no program is there to open a browser; open the address by hand\n");
  });
}

}  // namespace

void add_view_command(CLI::App& app, Context& context) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command = app.add_subcommand("view", "Serve the page of src/site to a browser on this machine");
  add_scene_options(*command, options->choice, "How long the scene is worth watching; default: the scene's");
  CLI::Option* scene = command->get_option("SCENE");
  scene->required(false);
  scene->description(
      "Which scene comes first: a name, a .gltf or .glb file, a saved world or a recording; others stay in the list");
  command
      ->add_option("--steps", options->steps.most,
                   "Steps whose native hashes stand beside the page's; at most 3 s of computing")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  command->add_option("--site", options->site, "Folder of the built page; default: the installed one, or src/site/dist")
      ->type_name("DIR");
  command->add_option("--port", options->port, "Port on this machine; 0: any that is free")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  command->add_flag("--open", options->open, "Open the address in a browser");
  command->callback([options, &context] { view(*options, context); });
}

}  // namespace carom::tools
