// Ends in a trap: what the processor does with it must reach the console.
int main() { __builtin_trap(); }
