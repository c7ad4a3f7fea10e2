# cmake -D TEMPLATE=file -D PAPER_TEMPLATE=file -D SWEEP_TEMPLATE=file -D SECTION_TEMPLATE=file -D STYLE=file
# -D SCRIPT=file -D LICENSE=file -D OUT=file.cc -P embed.cmake
# Writes a C++ file with the functions of scenarios/report/page_assets.h, which return the contents of the input files.
# LICENSE is the license of uPlot, which must be distributed with uPlot.
function(define name bytes)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${bytes}")
  set(code "${code}\nstd::string_view ${name}() {\n  static constexpr char kBytes[] = {${bytes}};\n  return {kBytes, sizeof(kBytes)};\n}\n" PARENT_SCOPE)
endfunction()

file(READ ${TEMPLATE} template HEX)
file(READ ${PAPER_TEMPLATE} paper_template HEX)
file(READ ${SWEEP_TEMPLATE} sweep_template HEX)
file(READ ${SECTION_TEMPLATE} section_template HEX)
file(READ ${STYLE} style HEX)
file(READ ${SCRIPT} script HEX)
file(READ ${LICENSE} license)
string(HEX "/* With uPlot:\n${license}*/\n" license)

set(code "")
define(PageTemplate ${template})
define(PaperPageTemplate ${paper_template})
define(SweepPageTemplate ${sweep_template})
define(SectionTemplate ${section_template})
define(PageStyle ${style})
define(PageScript ${license}${script})
file(WRITE ${OUT} "#include \"scenarios/report/page_assets.h\"

namespace touchdown::report {
${code}
}  // namespace touchdown::report
")
