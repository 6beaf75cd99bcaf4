// `carom import`: a mesh as one hull or as several convex parts, and what they are off by.
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "cli/commands.h"
#include "cli/table.h"
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

void run_import(const ImportOptions& options, const Context& context) {
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
  CLI::App* command = app.add_subcommand("import", "A mesh as one hull or as several convex parts, for colliders");
  command
      ->add_option("MESH", options->mesh, "An OBJ, STL, PLY, glTF or GLB file of a closed mesh; small holes do no harm")
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
  command->add_option("--out", options->out, "Write the parts: an object each, or one body of a scene file")
      ->type_name("FILE.obj|FILE.gltf|FILE.glb");
  command->footer("Parts cover the mesh: they are hulls of its own faces within boxes that leave no gap.");
  command->callback([options, &context] { run_import(*options, context); });
}

}  // namespace carom::tools
