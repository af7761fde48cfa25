# moc, not told where headers are: it reads a file in 3 ms in place of 300, and what it writes serves as well. It does
# not see the macros of headers, so what takes in or leaves out a slot must be a definition of the target.

# berg_moc(target): for the header beside each source of the target. After berg_unity, since what it writes comes last.
function(berg_moc target)
  get_target_property(sources ${target} SOURCES)
  set(headers)
  foreach(source IN LISTS sources)
    string(REGEX REPLACE "\\.cpp$" ".h" header "${source}")
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${header})
      list(APPEND headers ${header})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES headers)
  list(TRANSFORM headers PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/${target}_moc.cpp)
  add_custom_command(
    OUTPUT ${out}
    COMMAND sh ${PROJECT_SOURCE_DIR}/cmake/moc_all.sh $<TARGET_FILE:Qt6::moc> ${PROJECT_SOURCE_DIR} ${headers} > ${out}
    DEPENDS ${headers} ${PROJECT_SOURCE_DIR}/cmake/moc_all.sh
    VERBATIM)
  target_sources(${target} PRIVATE ${out})
endfunction()

# berg_moc_source(source out target): for a test, which includes `out` itself.
function(berg_moc_source source out target)
  set(definitions "$<TARGET_PROPERTY:${target},COMPILE_DEFINITIONS>")
  add_custom_command(
    OUTPUT ${out}
    COMMAND Qt6::moc -o ${out} "$<$<BOOL:${definitions}>:-D$<JOIN:${definitions},;-D>>"
            ${CMAKE_CURRENT_SOURCE_DIR}/${source}
    DEPENDS ${source}
    COMMAND_EXPAND_LISTS VERBATIM)
endfunction()
