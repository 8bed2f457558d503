# licences.txt: the notices of what the program is made of, where the distribution keeps a copyright file of each.
foreach(package libglm-dev libtomlplusplus-dev libcli11-dev nlohmann-json3-dev libstb-dev libimgui-dev libpugixml-dev
    libglfw3-dev libglew-dev libopenxr-dev libopenal-dev zlib1g-dev)
    if(EXISTS /usr/share/doc/${package}/copyright)
        list(APPEND copyrights /usr/share/doc/${package}/copyright)
    endif()
endforeach()
if(copyrights)
    set(notices ${CMAKE_CURRENT_LIST_DIR}/notices.sh)
    add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/licences.txt
        COMMAND ${notices} ${copyrights} > ${PROJECT_BINARY_DIR}/licences.txt
        DEPENDS ${notices} ${copyrights} COMMENT "Collecting licence notices")
    add_custom_target(meltpool_notices DEPENDS ${PROJECT_BINARY_DIR}/licences.txt)
    add_dependencies(meltpool meltpool_notices)
    install(FILES ${PROJECT_BINARY_DIR}/licences.txt DESTINATION ${CMAKE_INSTALL_DOCDIR})
endif()
