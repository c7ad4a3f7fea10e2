# cmake -D TEMPLATE=file -D STYLE=file -D SCRIPT=file -D OUT=file.cc -P embed.cmake: the files as the functions that
# scenarios/report/page_assets.h declares.
function(define name file)
  file(READ ${file} bytes HEX)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${bytes}")
  set(code "${code}\nstd::string_view ${name}() {\n  static constexpr char kBytes[] = {${bytes}};\n  return {kBytes, sizeof(kBytes)};\n}\n" PARENT_SCOPE)
endfunction()

set(code "")
define(PageTemplate ${TEMPLATE})
define(PageStyle ${STYLE})
define(PageScript ${SCRIPT})
file(WRITE ${OUT} "#include \"scenarios/report/page_assets.h\"

namespace touchdown::scenarios {
${code}
}  // namespace touchdown::scenarios
")
