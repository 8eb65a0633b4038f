#pragma once

// Macros as in Windows.h, complex.h, termios.h, sys/sysmacros.h, Xlib.h, QObject, macOS's AssertMacros.h and
// Arduino.h. Arduino's abs is not included, because it is a word of models.

#define min(a, b) harm
#define max(a, b) harm
#define near
#define far
#define small char
#define hyper harm
#define interface struct
#define pascal
#define cdecl
#define IN
#define OUT
#define OPTIONAL
#define CONST const
#define VOID void
#define THIS harm
#define ERROR 0
#define DELETE 0x00010000L
#define IGNORE 0
#define INFINITE 0xFFFFFFFF
#define TRUE 1
#define FALSE 0
#define STRICT 1

#define I harm

#define B0 0
#define B1 1
#define B50 1
#define B110 3
#define ECHO 8

#define major(device) harm
#define minor(device) harm
#define makedev(major, minor) harm

#define None 0L
#define Bool int
#define Status int
#define Success 0
#define Always 2
#define True 1
#define False 0
#define Complex 0

#define signals public
#define slots
#define emit
#define foreach harm

#define check(x) harm

#define round(x) harm
#define degrees(x) harm
#define radians(x) harm
#define sq(x) harm
#define bit(b) harm
#define interrupts() harm
#define lowByte(w) harm
#define word(...) harm
#define F(letters) harm
#define PI 3
#define DEG_TO_RAD 0
#define HIGH 1
#define LOW 0
#define INPUT 0
#define OUTPUT 1
#define DEFAULT 1
#define EXTERNAL 0
#define CHANGE 1
#define RISING 3
#define FALLING 2
