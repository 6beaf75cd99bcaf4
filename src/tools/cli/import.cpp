// `carom import`: a mesh as one hull or as several convex parts, and what they are off by; a robot as a snapshot.
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "cli/commands.h"
#include "cli/table.h"
#include "host/system.h"
#include "mesh/parts.h"
#include "mesh/read_mesh.h"
#include "scenefile/scenefile.h"

namespace carom::tools {
namespace {

struct ImportOptions {
  std::string mesh, which, out;
  int parts = 16, vertices = 64;
  double concavity = 0, height = 0;
};

bool is_gltf(const std::string& path) { return mesh_ending(path) == ".gltf" || mesh_ending(path) == ".glb"; }

Mesh read_any_mesh(const ImportOptions& options) {
  if (is_gltf(options.mesh)) return mesh_of_gltf(options.mesh, options.which);
  if (!options.which.empty()) throw Error("--mesh is for glTF files, which have several", "leave it out");
  return read_mesh(options.mesh);
}

void write_result(const ImportOptions& options, const Parts& parts, const Context& context) {
  if (!is_gltf(options.out)) {
    write_parts(options.out, parts.hulls);
    std::printf("wrote %s; see it with: carom run quoits --mesh %s\n", options.out.c_str(), options.out.c_str());
    return;
  }
  Engine engine(context.plugins());
  Stage stage(engine);
  write_parts_scene(options.out, std::filesystem::path(options.mesh).stem().string(), parts.hulls, stage);
  std::printf("wrote %s, a body of these parts; see it with: carom run %s\n", options.out.c_str(), options.out.c_str());
}

bool is_robot(const std::string& path) { return mesh_ending(path) == ".xml" || mesh_ending(path) == ".urdf"; }

/// MuJoCo reads robots, in Python: the snapshot that is written needs neither.
void import_robot(const ImportOptions& options) {
  if (!options.which.empty() || options.height != 0 || options.concavity != 0)
    throw Error("--mesh, --height and --concavity are for meshes, and " + options.mesh + " is a robot",
                "leave them out");
  std::vector<std::string> words{"python3", "-m", "carom.robots"};
  if (!options.out.empty()) words.insert(words.end(), {"-o", options.out});
  words.insert(words.end(), {"--", options.mesh});
  std::fflush(stdout);
  const int status = run_program(words);
  if (status == 0) return;
  throw Error(status == kNoProgram ? "there is no python3, which reads robots"
                                   : "python3 -m carom.robots did not read " + options.mesh + ", and says why above",
              "pip install 'carom[robots]', or mend the model");
}

void run_import(const ImportOptions& options, const Context& context) {
  if (is_robot(options.mesh)) return import_robot(options);
  Mesh mesh = read_any_mesh(options);
  if (options.height < 0) throw Error("--height is out of range", "give metres, more than 0");
  if (options.height > 0) fit_to_height(mesh, options.height);
  std::printf("%s: %zu vertices, %zu faces\n", options.mesh.c_str(), mesh.points.size(), mesh.faces.size());
  PartsWanted wanted;
  wanted.most = static_cast<std::size_t>(std::max(0, options.parts));
  wanted.vertices = static_cast<std::size_t>(std::max(0, options.vertices));
  wanted.concavity = options.concavity;
  wanted.progress = [](const std::string& line) { std::fprintf(stderr, "  %s\n", line.c_str()); };
  const auto begin = std::chrono::steady_clock::now();
  const Parts parts = take_apart(mesh, wanted);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::vector<std::vector<std::string>> rows{{"part", "vertices", "faces", "volume, m^3"}};
  double sum = 0;
  for (std::size_t k = 0; k < parts.hulls.size(); ++k) {
    sum += parts.volumes[k];
    rows.push_back({std::to_string(k + 1), std::to_string(parts.hulls[k].points.size()),
                    std::to_string(parts.hulls[k].faces.size()), format("%.4g", parts.volumes[k])});
  }
  std::printf("%s", table(rows, {false, true, true, true}).c_str());
  std::printf("%zu parts hold %.4g m^3; the mesh %.4g, its one hull %.4g (%.1f s)\n", parts.hulls.size(), sum,
              parts.mesh_volume, parts.hull_volume, seconds);
  std::printf("they stand out of the mesh by at most %.4g m, the mesh out of them by at most %.2g m\n", parts.outside,
              parts.lost);
  if (!options.out.empty()) write_result(options, parts, context);
}

}  // namespace

void add_import_command(CLI::App& app, Context& context) {
  const auto options = std::make_shared<ImportOptions>();
  CLI::App* command = app.add_subcommand(
      "import", "A mesh as one hull or as several convex parts, for colliders; a robot as a snapshot");
  command
      ->add_option(
          "MESH", options->mesh,
          "An OBJ, STL, PLY, glTF or GLB file of a closed mesh; small holes do no harm. A robot of MJCF (.xml) or URDF")
      ->required();
  command
      ->add_option("--mesh", options->which,
                   "Of a glTF file: this mesh alone, by name or index; else all of its scene, as they stand")
      ->type_name("NAME");
  command->add_option("--parts", options->parts, "At most so many, 1 to 256; 1: its hull")
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--concavity", options->concavity,
                   "How far parts may stand out of the mesh, if so many do; 0: a fiftieth of its length")
      ->type_name("M")
      ->capture_default_str();
  command->add_option("--vertices", options->vertices, "Of a part at most, 8 to 2000")
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--height", options->height,
                   "Scale it to so many metres along y, its middle at the origin; 0: leave it")
      ->type_name("M")
      ->capture_default_str();
  command
      ->add_option(
          "-o,--out", options->out,
          "Write the parts: an object each, or one body of a scene file. Of a robot a whole snapshot, and FILE.json, its names")
      ->type_name("FILE.obj|FILE.gltf|FILE.glb|FILE");
  command->footer("Parts cover the mesh: they are hulls of its own faces within boxes that leave no gap.");
  command->callback([options, &context] { run_import(*options, context); });
}

}  // namespace carom::tools
