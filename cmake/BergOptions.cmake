# berg_options: the flags of every target of ours; third-party headers are SYSTEM and stay quiet.
add_library(berg_options INTERFACE)
target_include_directories(berg_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(
  berg_options
  INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wsign-conversion
            $<$<NOT:$<BOOL:$<TARGET_PROPERTY:BERG_MAY_NARROW>>>:-Wconversion> -Wold-style-cast
            -Wnon-virtual-dtor -Woverloaded-virtual
            $<$<CXX_COMPILER_ID:GNU>:-Wdouble-promotion> # Clang warns of long double as well
            # Designated initialisers leave members at their defaults on purpose.
            -Wno-missing-field-initializers
            # GCC 12 sees overlaps and overflows in std::string that are not there (its bugs 105329,
            # 105651).
            $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>
            # One result on every machine: no fused multiply-add, no value-changing optimisation.
            -ffp-contract=off)
if(BERGWATCH_UNITY) # these take the other sources of a unit for part of this one; the preset dev keeps them
  target_compile_options(berg_options INTERFACE -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()
if(BERGWATCH_WERROR)
  target_compile_options(berg_options INTERFACE -Werror)
endif()
# What reading at a wrong address is, the address sanitizer knows by itself. Scopes that have ended take a
# quarter of its compiler time: they are watched in what we ship, not in the tests of it.
if(BERGWATCH_SANITIZE)
  target_compile_options(berg_options INTERFACE -fsanitize=${BERGWATCH_SANITIZE}
                                                -fno-sanitize=alignment,null,object-size,pointer-overflow
                                                -fno-omit-frame-pointer -fno-sanitize-recover=all
                                                "$<$<BOOL:$<TARGET_PROPERTY:BERG_IS_TEST>>:-fno-sanitize=undefined;-fno-sanitize-address-use-after-scope>")
  target_link_options(berg_options INTERFACE -fsanitize=${BERGWATCH_SANITIZE})
endif()

# Headers that nearly every file reads, read once: Qt and Eigen take more time than our own code. The
# preset `dev` does without, and so shows an #include that a file forgot.
set(berg_headers_std <algorithm> <array> <cmath> <functional> <map> <memory> <optional> <set> <span>
                     <string> <vector> <Eigen/Core>)
set(berg_headers_widgets
    <QApplication> <QBoxLayout> <QFile> <QFontMetricsF> <QHeaderView> <QKeyEvent> <QLabel> <QLineEdit>
    <QLocale> <QMainWindow> <QMenu> <QMouseEvent> <QPainter> <QPainterPath> <QString> <QTimer>
    <QUndoStack> <QWidget>)

# berg_optimise(target -O2): in place of -O3 in preset release, where the time is spent elsewhere, to be
# compiled sooner.
function(berg_optimise target level)
  target_compile_options(${target} PRIVATE $<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Release>>:${level}>)
endfunction()

# berg_precompile(target <header>...): these before every source of the target.
function(berg_precompile target)
  target_precompile_headers(${target} PRIVATE ${ARGN})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -fpch-preprocess) # for ccache
  endif()
endfunction()

# berg_reuse_precompiled(target FROM other): what was precompiled for `other`, built with the same flags.
function(berg_reuse_precompiled target from other)
  target_precompile_headers(${target} REUSE_FROM ${other})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -fpch-preprocess)
  endif()
endfunction()

# berg_room(sources folder name...): adds folder/name.cpp for each name to the list `sources`, one call for
# each room of a target.
function(berg_room sources folder)
  set(names ${ARGN})
  list(TRANSFORM names PREPEND ${folder}/)
  list(TRANSFORM names APPEND .cpp)
  set(${sources} ${${sources}} ${names} PARENT_SCOPE)
endfunction()

# berg_add_module(plan SOURCES a.cpp b.cpp LINKS base PRIVATE_LINKS PkgConfig::CBC)
# A module of the core: static library berg_<name>, alias berg::<name>. Linking follows the layers
# of ARCHITECTURE.md, so a wrong dependency does not link.
function(berg_add_module name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(berg_${name} STATIC ${arg_SOURCES})
  add_library(berg::${name} ALIAS berg_${name})
  list(TRANSFORM arg_LINKS PREPEND berg::)
  target_link_libraries(berg_${name} PUBLIC berg_options Eigen3::Eigen ${arg_LINKS}
                                     PRIVATE ${arg_PRIVATE_LINKS})
  berg_unity(berg_${name})
endfunction()

# berg_add_resources(target name PREFIX "/x" BASE folder FILES ...): files that become part of the target, without
# their times, so that the same sources give the same bytes.
function(berg_add_resources target name)
  qt_add_resources(${target} ${name} OPTIONS --format-version 1 ${ARGN})
endfunction()
