# cmake -D FLIGHTS=folder -D OUT=file.cc -P shipped_flights.cmake: writes the scenarios of a folder to a source file
# that defines the function declared in scenarios/experiments/shipped_flights.h.
file(GLOB flights ${FLIGHTS}/*.yaml)
list(SORT flights)
set(rows "")
foreach(flight ${flights})
  get_filename_component(name ${flight} NAME_WE)
  file(READ ${flight} bytes HEX)
  string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${bytes}")
  string(APPEND rows "      {\"${name}\", \"${bytes}\"},\n")
endforeach()
file(WRITE ${OUT} "#include \"scenarios/experiments/shipped_flights.h\"

namespace touchdown::experiments {

const std::vector<std::pair<std::string_view, std::string_view>>& ShippedFlights() {
  static const std::vector<std::pair<std::string_view, std::string_view>> flights{
${rows}  };
  return flights;
}

}  // namespace touchdown::experiments
")
