// Presses keys in the program's window, as the person at the desk does.
#pragma once

#include <string>

namespace meltpool::test {

/// Presses and releases a key in the window of that title; `symbol` is X's name of it, such as "F5". Throws
/// RuntimeFault if there is no such window.
void pressKey(const std::string& title, const std::string& symbol);

} // namespace meltpool::test
