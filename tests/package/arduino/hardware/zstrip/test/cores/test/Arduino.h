// The part of Arduino's interface that sketches here use: with types of its own for levels, as newer cores have it, or
// with numbers (TEST_OLD_CORE), and the macros that older cores have. Implemented for a board without anything, and by
// tests.
#pragma once

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

// NOLINTBEGIN
#define PI 3.1415926535897932384626433832795
#define EULER 2.718281828459045235360287471352
#define DEG_TO_RAD 0.017453292519943295769236907684886
#define SERIAL 0x0
#define DISPLAY 0x1
#define DEFAULT 1
#define INTERNAL 3
#define EXTERNAL 0
#define abs(x) ((x) > 0 ? (x) : -(x))
#define min(a, b) ((a) < (b) ? (a) : (b))
#define max(a, b) ((a) > (b) ? (a) : (b))
#define round(x) ((x) >= 0 ? (long)((x) + 0.5) : (long)((x)-0.5))
#define constrain(amt, low, high) ((amt) < (low) ? (low) : ((amt) > (high) ? (high) : (amt)))
#define radians(deg) ((deg)*DEG_TO_RAD)
#define sq(x) ((x) * (x))
#define interrupts() sei()
#define noInterrupts() cli()
#define lowByte(w) ((uint8_t)((w)&0xff))
#define highByte(w) ((uint8_t)((w) >> 8))
#define bitRead(value, bit) (((value) >> (bit)) & 0x01)
#define bitSet(value, bit) ((value) |= (1UL << (bit)))
#define bit(b) (1UL << (b))
#define F(text) (text)
#define B0 0
#define B1 1
#define B10 2
#define B11 3

#ifdef TEST_OLD_CORE
#define LOW 0x0
#define HIGH 0x1
#define INPUT 0x0
#define OUTPUT 0x1
#define LSBFIRST 0
#define MSBFIRST 1
typedef uint8_t PinStatus;
typedef uint8_t PinMode;
typedef uint8_t BitOrder;
#else
typedef enum { LOW = 0, HIGH = 1 } PinStatus;
typedef enum { INPUT = 0, OUTPUT = 1 } PinMode;
typedef enum { LSBFIRST = 0, MSBFIRST = 1 } BitOrder;
#endif
typedef bool boolean;
typedef uint8_t byte;
typedef uint16_t word;
typedef uint8_t pin_size_t;
static const uint8_t A0 = 14, A1 = 15, MOSI = 11, SCK = 13;
// NOLINTEND

void pinMode(pin_size_t pin, PinMode mode);
void digitalWrite(pin_size_t pin, PinStatus level);
int analogRead(pin_size_t pin);  ///< 0..1023
void loop1();                    ///< of sketches for two cores
void delay(unsigned long milliseconds);
void delayMicroseconds(unsigned int microseconds);
unsigned long millis();
extern "C" char* itoa(int value, char* text, int base);

class SerialPort {
 public:
  void begin(unsigned long baud);
  size_t println(const char* text);
};
extern SerialPort Serial;

void setup();
void loop();
