#include "scenarios/cli/pad.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "models/error.h"
#include "scenarios/report/pad_sheet.h"
#include "scenarios/runner/scenario.h"
#include "scenarios/util/output_file.h"

namespace touchdown::cli {
namespace {

namespace fs = std::filesystem;

struct PadOptions {
  std::string out;
  std::optional<std::string> pad;
};

report::SheetFormat FormatOf(const fs::path& out) {
  if (out.extension() == ".pdf") return report::SheetFormat::kPdf;
  if (out.extension() == ".svg") return report::SheetFormat::kSvg;
  throw InputError(fmt::format("--out {}: must end in .pdf or .svg", out.string()));
}

int MakePad(const PadOptions& options) {
  const fs::path sheet = options.out;
  const fs::path description = fs::path(sheet).replace_extension(".yaml");
  const report::SheetFormat format = FormatOf(sheet);
  const models::LandingPad pad = options.pad ? runner::LoadPad(*options.pad) : models::LandingPad();
  const bool is_described =
      options.pad && fs::weakly_canonical(*options.pad) == fs::weakly_canonical(fs::absolute(description));
  const std::string content = report::PadSheet(pad, format);
  // A description may have been edited since: only one that says the same is an earlier one.
  const std::string yaml = runner::PadYaml(pad);
  if (!is_described) util::CheckOutputFile(description, yaml);
  util::WriteOutputFile(sheet, content, report::kPadSheetSignature);
  if (!is_described) util::WriteOutputFile(description, yaml, yaml);
  fmt::print("{}: print it at 100 %, and check its ruler; {} describes it\n", sheet.string(), description.string());
  return kPassed;
}

}  // namespace

void AddPad(CLI::App& app, Run& run) {
  const auto options = std::make_shared<PadOptions>();
  CLI::App& command = *app.add_subcommand("pad", "Draw the landing pad to print, to scale, and describe it in YAML");
  command.add_option("--out", options->out, "File for the pad, .pdf or .svg; its description goes beside it, as .yaml")
      ->required()
      ->type_name("FILE");
  command.add_option("--pad", options->pad, "The pad's description (default: the built-in pad, 90 mm on A4)")
      ->type_name("PAD.yaml");
  command.callback([options, &run] { run = [options] { return MakePad(*options); }; });
}

}  // namespace touchdown::cli
