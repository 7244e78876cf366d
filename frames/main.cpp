#include "frames/commands/command_line.h"

int main(int argc, char** argv) { return kerf::run_command_line(argc, argv); }
