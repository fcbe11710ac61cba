// Functions of a board that the common start-up code calls; each board defines them.
#pragma once

namespace zstrip::board {

/// Sets up clocks, pins and the console. Called once, after memory is set up and before main.
void start();

/// Sends one character to the board's console; waits until the console has taken it. Fault handlers may call it.
void put_character(char character);

/// Ends the program; status 0 is success. An emulator ends with this exit status; real hardware waits for a reset.
[[noreturn]] void halt(int status);

}  // namespace zstrip::board
