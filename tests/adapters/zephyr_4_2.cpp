// The stand-in of zephyr.cpp for a driver of Zephyr 4.2.
#define ZEPHYR_4_2
#include "zephyr.cpp"
