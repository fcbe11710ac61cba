// For builds with LeakSanitizer, which asks this function: what OSMesa keeps of a destroyed context is not our leak.
extern "C" const char* __lsan_default_suppressions();

extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa"; }
