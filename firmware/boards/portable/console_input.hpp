// Input from the board's console.
#pragma once

namespace zstrip::board {

/// Takes a character that has arrived, without waiting. Returns false if there is none.
bool take_character(char& character);

}  // namespace zstrip::board
