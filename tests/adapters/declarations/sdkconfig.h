// menuconfig of ESP-IDF writes this header. The stand-in is a chip whose internal memory has no cache, as an ESP32-S3.
#pragma once
