// The program's entry.
#include "app/command_line.hpp"

int main(int argc, char** argv) {
    return meltpool::runProgram(argc, argv);
}
