# SPDX-License-Identifier: MIT
# The build file of a project that uses an installed OpenRT.
cmake_minimum_required(VERSION 3.25)
project(consumer LANGUAGES C CXX)
find_package(OpenRT 0.1 REQUIRED COMPONENTS OpenRT smart)
add_executable(consumer consumer.c)
target_link_libraries(consumer PRIVATE OpenRT::OpenRT)
add_executable(core_consumer core_consumer.cpp)
target_link_libraries(core_consumer PRIVATE OpenRT::smart)
if(OpenRT_rtut_FOUND)
    add_executable(window_consumer window_consumer.c)
    target_link_libraries(window_consumer PRIVATE OpenRT::rtut)
endif()
