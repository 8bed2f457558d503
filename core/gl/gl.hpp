// OpenGL 4.5 core functions and types.
#pragma once

#include <GL/glew.h>

#include <cstddef>
#include <string>
#include <string_view>
