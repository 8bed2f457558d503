// The program's window, as the person at the desk sees it and presses keys in it.
#pragma once

#include "core/base/image.hpp"

#include <string>

namespace meltpool::test {

/// Moves the window of that title to the screen's lower right corner, before all others. Covered parts appear only
/// after new frames. Throws RuntimeFault if there is none, as the functions below do.
void showWindow(const std::string& title);
/// Takes a picture of the window of that title.
Image windowPicture(const std::string& title);
/// Presses and releases a key in the window of that title; `symbol` is X's name of it, such as "F5".
void pressKey(const std::string& title, const std::string& symbol);

} // namespace meltpool::test
