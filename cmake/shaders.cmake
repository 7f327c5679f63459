# caustics_add_shader(TARGET shader TEXT path/to/text.glsl [DEFINES A=1 ...])
# Compiles one shader text for every lane width of CAUSTICS_WIDTHS, embeds the text with its includes
# expanded, and adds a `const caustics::Shader <shader>_shader` to TARGET, with the size of its uniform block
# and the choices of it that the text asks. Paths of texts and their includes start at the current source
# folder or at CAUSTICS_SHADER_ROOT, where this project's own stand: its source folder, or where it is
# installed.
set(CAUSTICS_EXACT_FLAGS -ffp-contract=off -fno-math-errno -fno-fast-math)
set(CAUSTICS_KERNEL_OPTIMISATION $<$<CONFIG:Release>:$<IF:$<BOOL:${CAUSTICS_QUICK_BUILD}>,-O2,-O3>>)
set(CAUSTICS_FLAGS_scalar ${CAUSTICS_KERNEL_OPTIMISATION})
set(CAUSTICS_FLAGS_plain4 ${CAUSTICS_KERNEL_OPTIMISATION})
if(EMSCRIPTEN)
  # Its calls within reach of a handler go through JavaScript, which cannot pass vectors on.
  list(APPEND CAUSTICS_FLAGS_plain4 -fno-exceptions)
endif()
set(CAUSTICS_FLAGS_sse41 ${CAUSTICS_KERNEL_OPTIMISATION} -msse4.1)
set(CAUSTICS_FLAGS_avx2 ${CAUSTICS_KERNEL_OPTIMISATION} -mavx2 -mfma)
set(CAUSTICS_FLAGS_avx512 ${CAUSTICS_KERNEL_OPTIMISATION} -mavx2 -mfma -mavx512f -mavx512dq -mavx512vl
  -mavx512bw -Wno-uninitialized)  # GCC 12 headers
set(CAUSTICS_LANES_scalar 1)
set(CAUSTICS_LANES_plain4 4)
set(CAUSTICS_LANES_sse41 4)
set(CAUSTICS_LANES_avx2 8)
set(CAUSTICS_LANES_avx512 16)
set(CAUSTICS_CMAKE_DIR ${CMAKE_CURRENT_LIST_DIR})

function(caustics_expand_includes file result)
  set(path ${CMAKE_CURRENT_SOURCE_DIR}/${file})
  if(NOT EXISTS ${path})
    set(path ${CAUSTICS_SHADER_ROOT}/${file})
  endif()
  file(READ ${path} content)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
  string(REGEX MATCHALL "#include \"[^\"]+\"" includes "${content}")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "#include \"([^\"]+)\"" "\\1" path "${include}")
    caustics_expand_includes(${path} inner)
    string(REPLACE "${include}" "${inner}" content "${content}")
  endforeach()
  set(${result} "${content}" PARENT_SCOPE)
endfunction()

# The consteval functions that hold C++'s layout against std140's: of the uniform block, and of the structs of
# uniform types (`int`, `vec3`, ...) that it is made of. Conditions (#ifdef) stay as they are.
function(caustics_uniform_checks text result)
  set(checks "")
  string(REGEX REPLACE "//[^\n]*" "" text "${text}")
  string(REPLACE ";" "$" text "${text}")  # a list's separator to CMake
  string(REGEX REPLACE "CHOICE[(]([a-z0-9_]+)[)]" "int \\1$" text "${text}")
  string(REGEX MATCH "UNIFORMS_BEGIN(.*)UNIFORMS_END" block "${text}")
  if(block)
    caustics_layout_check(UniformBlock "${CMAKE_MATCH_1}" checks)
  endif()
  string(REGEX MATCHALL "struct [A-Za-z0-9]+ {[^}]*}" structs "${text}")
  set(varying "Float|Int|Bool|Vec[234]")
  foreach(struct IN LISTS structs)
    string(REGEX MATCH "struct ([A-Za-z0-9]+) {(.*)}" struct "${struct}")
    set(name ${CMAKE_MATCH_1})
    set(members "${CMAKE_MATCH_2}")
    if(members MATCHES "[^A-Za-z0-9](${varying}) [a-z]")
      string(APPEND varying "|${name}")  # nor is a struct of such structs a uniform one
    else()
      caustics_layout_check(${name} "${members}" checks)
    endif()
  endforeach()
  set(${result} "${checks}" PARENT_SCOPE)
endfunction()

# The body of a function that returns the CHOICE members of a text's uniform block which the text asks.
function(caustics_choices text block result)
  set(rows "")
  string(REGEX REPLACE "//[^\n]*" "" text "${text}")
  string(REGEX MATCHALL "CHOICE[(][a-z0-9_]+[)]" choices "${text}")
  foreach(choice IN LISTS choices)
    string(REGEX REPLACE "CHOICE[(](.*)[)]" "\\1" name "${choice}")
    if(text MATCHES "[^A-Za-z0-9_.]u[.]${name}[^A-Za-z0-9_]")
      string(APPEND rows "      {\"${name}\", offsetof(${block}, ${name})},\n")
    endif()
  endforeach()
  set(body "  return {};")
  if(rows)
    set(body "  static constexpr ShaderChoice choices[] = {\n${rows}  };\n  return choices;")
  endif()
  set(${result} "${body}" PARENT_SCOPE)
endfunction()

function(caustics_layout_check type members result)
  string(REGEX REPLACE "([A-Za-z0-9]+) ([a-z0-9_]+)[$]"
    "  check.member(\"\\1\", sizeof(Fragment::\\1), offsetof(Fragment::${type}, \\2))$" members "${members}")
  string(REGEX REPLACE "Fragment::(int|float|i?vec[234]|mat4)\\)" "\\1)" members "${members}")
  string(REPLACE "$" ";" members "${members}")
  set(${result} "${${result}}
consteval bool ${type}_follows_std140() {
  Std140Check check;
${members}
  return check.sound(sizeof(Fragment::${type}));
}
static_assert(${type}_follows_std140(), \"C++ and std140 place a member of ${type} differently\");
" PARENT_SCOPE)
endfunction()

function(caustics_add_shader target shader)
  cmake_parse_arguments(ARG "" "TEXT" "DEFINES" ${ARGN})
  set(SHADER ${shader})
  set(TEXT ${ARG_TEXT})
  caustics_expand_includes(pipeline/shader/constants.glsl constants)
  caustics_expand_includes(pipeline/shader/view.glsl view)
  caustics_expand_includes(pipeline/shader/functions.glsl functions)
  caustics_expand_includes(${TEXT} body)
  set(EXPANDED "")
  foreach(define IN LISTS ARG_DEFINES)
    string(REPLACE "=" " " line ${define})
    string(APPEND EXPANDED "#define ${line}\n")
  endforeach()
  caustics_uniform_checks("${view}${body}" UNIFORM_CHECKS)
  set(UNIFORM_BYTES 0)
  set(block "lanes_scalar::${shader}::Fragment::UniformBlock")
  if(UNIFORM_CHECKS MATCHES "UniformBlock")
    set(UNIFORM_BYTES "sizeof(${block})")
  endif()
  caustics_choices("${body}" "${block}" CHOICES)
  string(APPEND EXPANDED "${constants}\n${view}\n${functions}\n${body}")
  # One string literal may hold 64 KiB in every compiler; adjacent ones are joined.
  string(REPLACE "\n// ---- " ")caustics_shader\"\nR\"caustics_shader(\n// ---- " EXPANDED "${EXPANDED}")
  set(DECLARATIONS "")
  set(VERTEX_KERNELS "")
  set(FRAGMENT_KERNELS "")
  set(directory ${CMAKE_CURRENT_BINARY_DIR}/shaders/${shader})
  foreach(WIDTH IN LISTS CAUSTICS_ALL_WIDTHS)
    if(NOT WIDTH IN_LIST CAUSTICS_WIDTHS)
      list(APPEND VERTEX_KERNELS nullptr)
      list(APPEND FRAGMENT_KERNELS nullptr)
      continue()
    endif()
    set(LANES ${CAUSTICS_LANES_${WIDTH}})
    set(kernel ${directory}/${shader}_${WIDTH}.cpp)
    configure_file(${CAUSTICS_CMAKE_DIR}/kernel.cpp.in ${kernel} @ONLY)
    set_source_files_properties(${kernel} PROPERTIES
      COMPILE_OPTIONS "${CAUSTICS_EXACT_FLAGS};${CAUSTICS_FLAGS_${WIDTH}}"
      COMPILE_DEFINITIONS "${ARG_DEFINES}"
      SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
    target_sources(${target} PRIVATE ${kernel})
    string(APPEND DECLARATIONS "void ${shader}_vertex_${WIDTH}(const VertexBlock&);\n"
                               "void ${shader}_fragment_${WIDTH}(const FragmentBlock&);\n")
    list(APPEND VERTEX_KERNELS ${shader}_vertex_${WIDTH})
    list(APPEND FRAGMENT_KERNELS ${shader}_fragment_${WIDTH})
  endforeach()
  string(REPLACE ";" ", " VERTEX_KERNELS "${VERTEX_KERNELS}")
  string(REPLACE ";" ", " FRAGMENT_KERNELS "${FRAGMENT_KERNELS}")
  configure_file(${CAUSTICS_CMAKE_DIR}/shader.cpp.in ${directory}/${shader}.cpp @ONLY)
  target_sources(${target} PRIVATE ${directory}/${shader}.cpp)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
endfunction()
