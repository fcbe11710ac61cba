// WebAssembly: the console is a function of the host, and the host calls `run`.
#include "cortex_m/board.hpp"

int main();

extern "C" {
/// Provided by the host: takes one byte of the console's text.
[[clang::import_module("zstrip"), clang::import_name("put_character")]] void host_put_character(int character);

/// Runs the program once and returns its exit status.
[[clang::export_name("run")]] int run() { return main(); }
}

namespace zstrip::board {

void put_character(char character) { host_put_character(static_cast<unsigned char>(character)); }

}  // namespace zstrip::board
