// A program that calls what its SDK wraps.
extern "C" int printf(const char* format, ...);

int main() { return printf("%d", 3); }
