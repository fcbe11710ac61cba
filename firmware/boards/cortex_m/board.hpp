// Functions of a board that the common start-up code calls; each board defines them.
#pragma once

namespace zstrip::board {

/// Called once, after memory is set up and before main: clocks, pins, and the console.
void start();

/// Sends one character to the board's console; waits until it is taken. Usable from fault handlers.
void put_character(char character);

/// The end of the program: 0 is success. An emulator ends with this exit status, real hardware waits for a reset.
[[noreturn]] void halt(int status);

}  // namespace zstrip::board
