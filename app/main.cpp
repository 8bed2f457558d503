// The program's entry.
#include "app/commands/command_line.hpp"

int main(int argc, char** argv) {
    return meltpool::runProgram(argc, argv);
}
