#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "models/error.h"
#include "scenarios/cli/commands.h"
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

report::SheetFormat SheetFormatOf(const fs::path& out) {
  if (out.extension() == ".pdf") return report::SheetFormat::kPdf;
  if (out.extension() == ".svg") return report::SheetFormat::kSvg;
  throw InputError(fmt::format("--out {}: must end in .pdf or .svg", out.string()));
}

int WritePad(const PadOptions& options) {
  const fs::path sheet = options.out;
  const fs::path description = fs::path(sheet).replace_extension(".yaml");
  const report::SheetFormat format = SheetFormatOf(sheet);
  const models::LandingPad pad = options.pad ? runner::LoadPad(*options.pad) : models::LandingPad();
  const bool is_own_description =
      options.pad && fs::weakly_canonical(*options.pad) == fs::weakly_canonical(fs::absolute(description));
  const std::string content = report::PadSheet(pad, format);
  // The user may have edited the description: replace it only if its content is the same.
  const std::string yaml = runner::PadYaml(pad);
  if (!is_own_description) util::CheckOutputFile(description, yaml);
  util::WriteOutputFile(sheet, content, report::kPadSheetSignature);
  if (!is_own_description) util::WriteOutputFile(description, yaml, yaml);
  fmt::print("{}: print it at 100 % scale and check the ruler; {} is its description\n", sheet.string(),
             description.string());
  return kPassed;
}

}  // namespace

void AddPad(CLI::App& app, Run& run) {
  const auto options = std::make_shared<PadOptions>();
  CLI::App& command =
      *app.add_subcommand("pad", "Write a sheet of the landing pad to print to scale, and its description in YAML");
  command
      .add_option("--out", options->out, "Output file, .pdf or .svg; the description is written next to it as .yaml")
      ->required()
      ->type_name("FILE");
  command
      .add_option("--pad", options->pad, "Pad description (default: the built-in pad with a radius of 90 mm, on A4)")
      ->type_name("PAD.yaml");
  command.callback([options, &run] { run = [options] { return WritePad(*options); }; });
}

}  // namespace touchdown::cli
