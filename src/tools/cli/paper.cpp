// `carom paper`: the 2011 paper's results beside our own, on the terminal, as drawings and as one page.
#include "report/paper.h"

#include <cstdio>
#include <filesystem>

#include "cli/commands.h"
#include "cli/progress.h"
#include "cli/table.h"
#include "host/files.h"

namespace carom::tools {
namespace {

void print(const report::Figure& figure) {
  std::vector<std::vector<std::string>> rows{figure.table.header};
  rows.insert(rows.end(), figure.table.rows.begin(), figure.table.rows.end());
  std::vector<bool> right(figure.table.header.size(), true);
  right[0] = false;
  std::printf("%s\n%s", figure.table.title.c_str(), table(rows, right).c_str());
  for (const std::string& remark : figure.remarks) std::printf("  %s\n", remark.c_str());
  std::printf("\n");
  std::fflush(stdout);
}

void run_paper(const Context& context, const std::string& out, bool quick, const std::string& mesh) {
  std::error_code failed;
  std::filesystem::create_directories(out, failed);
  if (failed) throw Error("cannot make the folder " + out + ": " + failed.message(), "give another one with --out");
  Engine engine(context.plugins());
  ShareOfProgress share(report::broad_phase_runs() + report::size_runs(quick) + report::scene_runs());
  report::PaperRun run{engine, quick, mesh, [&](const std::string& what, double done) {
                         done == 0 ? share.begins(what) : share.goes_on(done);
                       }};
  report::Page page("Carom beside the paper of 2011");
  page.paragraph(
      "Each figure shows what this build measured on this computer in colour, and the paper's own figures dashed "
      "and grey. Written by: carom paper" +
      std::string(quick ? " --quick" : ""));
  for (const auto& measure_figure : {report::broad_phase_shares, report::cost_of_size, report::scene_speeds}) {
    const report::Figure figure = measure_figure(run);
    share.clear();
    print(figure);
    write_file((std::filesystem::path(out) / figure.file_name).string(), figure.drawing);
    page.heading(figure.heading);
    page.drawing(figure.file_name, figure.heading);
    page.table(figure.table);
    for (const std::string& remark : figure.remarks) page.paragraph(remark);
  }
  const auto index = std::filesystem::path(out) / "index.html";
  write_file(index.string(), page.document());
  std::printf("wrote %s and its drawings; open it in a browser\n", index.string().c_str());
}

}  // namespace

void add_paper_command(CLI::App& app, Context& context) {
  struct Options {
    std::string out = "out/paper", mesh;
    bool quick = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("paper", "Measure the 2011 paper's results again, beside its own figures");
  command->add_option("--out", options->out, "Folder for the page and its drawings")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_option("--mesh", options->mesh, "OBJ file of the bunny")->type_name("FILE");
  command->add_flag("--quick", options->quick, "Smaller and shorter runs, under a minute; the curves end early");
  command->callback([options, &context] { run_paper(context, options->out, options->quick, options->mesh); });
}

}  // namespace carom::tools
