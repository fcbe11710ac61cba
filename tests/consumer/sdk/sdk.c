// An SDK's own printf, and its start.
int main(void);

int __wrap_printf(const char* format, ...) { return format[0]; }
void _start(void) { main(); }
void __aeabi_unwind_cpp_pr0(void) {}
