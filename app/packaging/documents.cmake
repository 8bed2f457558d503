# Manual page and completion scripts, which the program that was just built prints. The top CMakeLists.txt includes this
# file; the build runs it again as a script with PROGRAM, FOLDER and GZIP.
function(printDocument NAME)
    execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_FILE ${FOLDER}/${NAME} RESULT_VARIABLE failed)
    if(failed)
        message(FATAL_ERROR "${PROGRAM} did not print ${NAME}: ${failed}")
    endif()
endfunction()

if(CMAKE_SCRIPT_MODE_FILE)
    file(MAKE_DIRECTORY ${FOLDER})
    printDocument(meltpool.1 manual)
    printDocument(meltpool.bash completion bash)
    printDocument(_meltpool completion zsh)
    printDocument(meltpool.fish completion fish)
    if(GZIP) # without the time, so that the same page is the same file
        execute_process(COMMAND ${GZIP} -9nf ${FOLDER}/meltpool.1 COMMAND_ERROR_IS_FATAL ANY)
    endif()
    return()
endif()

find_program(GZIP gzip)
set(documents ${PROJECT_BINARY_DIR}/documents)
set(page ${documents}/meltpool.1)
if(GZIP)
    string(APPEND page .gz)
endif()
set(scripts ${documents}/meltpool.bash ${documents}/_meltpool ${documents}/meltpool.fish)
add_custom_command(OUTPUT ${page} ${scripts}
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:meltpool> -DFOLDER=${documents} "-DGZIP=$<$<BOOL:${GZIP}>:${GZIP}>"
        -P ${CMAKE_CURRENT_LIST_FILE}
    DEPENDS meltpool ${CMAKE_CURRENT_LIST_FILE} COMMENT "Printing manual page and completion scripts" VERBATIM)
add_custom_target(meltpool_documents ALL DEPENDS ${page} ${scripts})

install(FILES ${page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${documents}/meltpool.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME meltpool)
set(zshFolder site-functions)
if(EXISTS /etc/debian_version)
    set(zshFolder vendor-completions)
endif()
install(FILES ${documents}/_meltpool DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/${zshFolder})
install(FILES ${documents}/meltpool.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
