// Command tables (the names in the comments are those of the data sheets) and timing. Of the read commands, only those
// of the controller's id are included.
#include "panel/dcs_part.hpp"

#include <algorithm>
#include <iterator>

namespace zstrip::sim {
namespace {

using namespace std::chrono_literals;

constexpr DcsCommand kUserCommands[] = {
    {0x00, 0, 0},                              // NOP
    {0x01, 0, 0},                              // SWRESET
    {0x10, 0, 0}, {0x11, 0, 0},                // SLPIN SLPOUT
    {0x12, 0, 0}, {0x13, 0, 0},                // PTLON NORON
    {0x20, 0, 0}, {0x21, 0, 0},                // INVOFF INVON
    {0x26, 1, 1},                              // GAMSET
    {0x28, 0, 0}, {0x29, 0, 0},                // DISPOFF DISPON
    {0x2A, 4, 4}, {0x2B, 4, 4}, {0x2C, 0, 0},  // CASET RASET RAMWR
    {0x30, 4, 4},                              // PTLAR
    {0x33, 6, 6}, {0x37, 2, 2},                // VSCRDEF VSCSAD
    {0x34, 0, 0}, {0x35, 1, 1},                // TEOFF TEON
    {0x36, 1, 1}, {0x3A, 1, 1},                // MADCTL COLMOD
    {0x38, 0, 0}, {0x39, 0, 0},                // IDMOFF IDMON
};

// ST7789V, system function command tables 1 and 2.
constexpr DcsCommand kSt7789Commands[] = {
    {0x3C, 0, 0},                                                // WRMEMC
    {0x44, 2, 2},                                                // STE
    {0x51, 1, 1},   {0x53, 1, 1},   {0x55, 1, 1}, {0x5E, 1, 1},  // WRDISBV WRCTRLD WRCACE WRCABCMB
    {0xB0, 2, 2},   {0xB1, 3, 3},   {0xB2, 5, 5}, {0xB3, 3, 3},  // RAMCTRL RGBCTRL PORCTRL FRCTRL1
    {0xB5, 1, 1},   {0xB7, 1, 1},   {0xB8, 4, 4}, {0xBA, 1, 1},  // PARCTRL GCTRL GTADJ DGMEN
    {0xBB, 1, 1},   {0xBC, 1, 1},   {0xBD, 1, 1},                // VCOMS POWSAVE DLPOFFSAVE
    {0xC0, 1, 1},   {0xC1, 3, 3},   {0xC2, 1, 2}, {0xC3, 1, 1},  // LCMCTRL IDSET VDVVRHEN VRHS
    {0xC4, 1, 1},   {0xC5, 1, 1},   {0xC6, 1, 1}, {0xC7, 1, 1},  // VDVSET VCMOFSET FRCTRL2 CABCCTRL
    {0xC8, 1, 1},   {0xCA, 1, 1},   {0xCC, 1, 1},                // REGSEL1 REGSEL2 PWMFRSEL
    {0xD0, 2, 2},   {0xD2, 1, 1},   {0xDF, 4, 4},                // PWCTRL1 VAPVANEN CMD2EN
    {0xE0, 14, 14}, {0xE1, 14, 14},                              // PVGAMCTRL NVGAMCTRL
    {0xE2, 64, 64}, {0xE3, 64, 64},                              // DGMLUTR DGMLUTB
    {0xE4, 3, 3},   {0xE7, 1, 1},   {0xE8, 1, 2}, {0xE9, 3, 3},  // GATECTRL SPI2EN PWCTRL2 EQCTRL
    {0xEC, 1, 1},   {0xFA, 4, 4},   {0xFC, 1, 1}, {0xFE, 1, 1},  // PROMCTRL PROMEN NVMSET PROMACT
};

// ILI9341, level 2 commands, and the extended registers of its application notes.
constexpr DcsCommand kIli9341Commands[] = {
    {0x2D, 128, 128},                                              // colour set
    {0x3C, 0, 0},                                                  // write memory continue
    {0x44, 2, 2},                                                  // set tear scanline
    {0x51, 1, 1},     {0x53, 1, 1},   {0x55, 1, 1}, {0x5E, 1, 1},  // brightness, control, content adaptive, minimum
    {0xB0, 1, 1},     {0xB1, 2, 2},   {0xB2, 2, 2}, {0xB3, 2, 2},  // RGB interface; frame rate: normal, idle, partial
    {0xB4, 1, 1},     {0xB5, 4, 4},   {0xB6, 3, 4}, {0xB7, 1, 1},  // inversion, porch, display function, entry mode
    {0xB8, 1, 1},     {0xB9, 1, 1},   {0xBA, 1, 1}, {0xBB, 1, 1},  // backlight 1 to 4
    {0xBC, 1, 1},     {0xBE, 1, 1},   {0xBF, 1, 1},                // backlight 5, 7, 8
    {0xC0, 1, 1},     {0xC1, 1, 1},   {0xC5, 2, 2}, {0xC7, 1, 1},  // power 1 and 2, VCOM 1 and 2
    {0xCB, 5, 5},     {0xCF, 3, 3},                                // power A and B
    {0xD0, 2, 2},     {0xD1, 3, 3},                                // NV memory write, protection key
    {0xD9, 1, 1},                                                  // read index; in no data sheet
    {0xE0, 15, 15},   {0xE1, 15, 15},                              // gamma, positive and negative
    {0xE2, 16, 16},   {0xE3, 64, 64},                              // digital gamma 1 and 2
    {0xE8, 3, 3},     {0xE9, 3, 3},   {0xEA, 2, 2}, {0xED, 4, 4},  // driver timing A and B, power-on sequence
    {0xF2, 1, 1},     {0xF6, 3, 3},   {0xF7, 1, 1},                // three gammas, interface, pump ratio
};

// ST7735R and ST7735S, panel function commands.
constexpr DcsCommand kSt7735Commands[] = {
    {0x2D, 128, 128},                                              // RGBSET
    {0xB1, 3, 3},     {0xB2, 3, 3},   {0xB3, 6, 6},                // FRMCTR1 to 3
    {0xB4, 1, 1},     {0xB6, 2, 2},                                // INVCTR DISSET5
    {0xC0, 3, 3},     {0xC1, 1, 1},   {0xC2, 2, 2}, {0xC3, 2, 2},  // PWCTR1 to 4
    {0xC4, 2, 2},     {0xC5, 1, 1},   {0xC7, 1, 1},                // PWCTR5 VMCTR1 VMOFCTR
    {0xD1, 1, 1},     {0xD9, 1, 1},   {0xDE, 1, 1}, {0xDF, 2, 2},  // WRID2 NVFCTR1 to 3
    {0xE0, 16, 16},   {0xE1, 16, 16},                              // GMCTRP1 GMCTRN1
    {0xFC, 1, 1},                                                  // PWCTR6
};

// GC9A01A. The inter register commands of 62h to 98h are in no data sheet; makers of modules give them with so many
// parameters.
constexpr DcsCommand kGc9a01Commands[] = {
    {0x3C, 0, 0},                                                    // write memory continue
    {0x44, 2, 2},                                                    // set tear scanline
    {0x51, 1, 1},         {0x53, 1, 1},                              // brightness, control
    {0x62, 12, 12, true}, {0x63, 12, 12, true}, {0x64, 7, 7, true},  // not described, as all without names here
    {0x66, 10, 10, true}, {0x67, 10, 10, true}, {0x70, 9, 9, true}, {0x74, 7, 7, true}, {0x84, 1, 1, true},
    {0x85, 1, 1, true},   {0x86, 1, 1, true},   {0x87, 1, 1, true}, {0x88, 1, 1, true}, {0x89, 1, 1, true},
    {0x8A, 1, 1, true},   {0x8B, 1, 1, true},   {0x8C, 1, 1, true}, {0x8D, 1, 1, true}, {0x8E, 1, 1, true},
    {0x8F, 1, 1, true},   {0x90, 4, 4, true},   {0x98, 2, 2, true}, {0xA7, 1, 1, true}, {0xAE, 1, 1, true},  // VCORE
    {0xB0, 1, 1},         {0xB5, 4, 4},         {0xB6, 2, 4},  // RGB interface, porch, display function
    {0xBA, 1, 1},                                              // tearing effect
    {0xBC, 1, 1, true},   {0xBD, 1, 1, true},   {0xBE, 1, 1, true}, {0xC1, 1, 1, true}, {0xC3, 1, 1, true},
    {0xC4, 1, 1, true},                                              // power criterion, VREG1 a and b
    {0xC9, 1, 1, true},   {0xCD, 1, 1, true},   {0xDF, 3, 3, true},  // VREG2
    {0xE1, 2, 2, true},   {0xE8, 1, 1, true},   {0xE9, 1, 1, true},  // frame rate, two data lines
    {0xEB, 1, 1, true},   {0xEC, 3, 3, true},   {0xED, 2, 2, true},  // charge pump
    {0xF0, 6, 6, true},   {0xF1, 6, 6, true},   {0xF2, 6, 6, true},  // gamma 1 to 3
    {0xF3, 6, 6, true},                                              // gamma 4
    {0xF6, 1, 1},                                                    // interface
    {0xEF, 0, 0},         {0xFE, 0, 0},         {0xFF, 3, 3, true},  // inter register enable 2 and 1
};
constexpr DcsKey kGc9a01Keys[] = {{0xFE, 0, {}}, {0xEF, 0, {}}};

// ST7796S, command table 2, and the rest of table 1.
constexpr DcsCommand kSt7796Commands[] = {
    {0x3C, 0, 0},                                                                  // WRMEMC
    {0x44, 2, 2},                                                                  // TESLWR
    {0x51, 1, 1},         {0x53, 1, 1},         {0x55, 1, 1},       {0x5E, 1, 1},  // WRDISBV WRCTRLD WRCABC WRCABCMB
    {0xB0, 1, 1, true},   {0xB1, 2, 2, true},   {0xB2, 2, 2, true},                // IFMODE FRMCTR1 FRMCTR2
    {0xB3, 2, 2, true},   {0xB4, 1, 1, true},   {0xB5, 4, 4, true},                // FRMCTR3 DIC BPC
    {0xB6, 3, 3, true},   {0xB7, 1, 1, true},                                      // DFC EM
    {0xC0, 2, 2, true},   {0xC1, 1, 1, true},   {0xC2, 1, 1, true},                // PWR1 PWR2 PWR3
    {0xC5, 1, 1, true},   {0xC6, 1, 1, true},                                      // VCMPCTL VCMOFFSET
    {0xD0, 3, 3, true},                                                            // NVMADW
    {0xE0, 14, 14, true}, {0xE1, 14, 14, true},                                    // PGC NGC
    {0xE2, 64, 64, true}, {0xE3, 64, 64, true},                                    // DGC1 DGC2
    {0xE8, 8, 8, true},                                                            // DOCA
    {0xF0, 1, 1},         {0xFB, 1, 1, true},                                      // CSCON, SPI read control
};
constexpr DcsKey kSt7796Keys[] = {{0xF0, 1, {0xC3}}, {0xF0, 1, {0x96}}};

// ILI9342C. Extended commands need C8h first where the pin EXTC is low, as on modules.
constexpr DcsCommand kIli9342Commands[] = {
    {0x3C, 0, 0},                                                                  // write memory continue
    {0x44, 2, 2},                                                                  // set tear scanline
    {0x51, 1, 1},         {0x53, 1, 1},         {0x55, 1, 1},       {0x5E, 1, 1},  // brightness and its control
    {0xB0, 1, 1, true},   {0xB1, 2, 2, true},   {0xB2, 2, 2, true},                // RGB interface; frame rate
    {0xB3, 2, 2, true},   {0xB4, 1, 1, true},   {0xB5, 4, 4, true},                // inversion, porch
    {0xB6, 3, 4, true},   {0xB7, 1, 1, true},                                      // display function, entry mode
    {0xB8, 1, 1, true},   {0xB9, 1, 1, true},   {0xBA, 1, 1, true},                // backlight 1 to 3
    {0xBB, 1, 1, true},   {0xBC, 1, 1, true},   {0xBE, 1, 1, true},                // backlight 4, 5, 7
    {0xBF, 1, 1, true},                                                            // backlight 8
    {0xC0, 2, 2, true},   {0xC1, 1, 1, true},   {0xC5, 1, 1, true},                // power 1 and 2, VCOM
    {0xC7, 1, 1, true},   {0xC8, 3, 3},                                            // VCOM offset, set EXTC
    {0xD0, 2, 2, true},   {0xD1, 3, 3, true},   {0xD9, 1, 1},  // NV memory write and key; read index
    {0xE0, 15, 15, true}, {0xE1, 15, 15, true},                // gamma
    {0xF6, 3, 3, true},                                        // interface
};
constexpr DcsKey kIli9342Keys[] = {{0xC8, 3, {0xFF, 0x93, 0x42}}};

// ILI9488. Its third format on a serial bus, of 3 bits a pixel, is left out.
constexpr DcsCommand kIli9488Commands[] = {
    {0x3C, 0, 0},                                                    // write memory continue
    {0x44, 2, 2},                                                    // set tear scanline
    {0x51, 1, 1},   {0x53, 1, 1},   {0x55, 1, 1},   {0x5E, 1, 1},    // brightness, control, content adaptive, minimum
    {0xB0, 1, 1},   {0xB1, 2, 2},   {0xB2, 2, 2},   {0xB3, 2, 2},    // interface; frame rate: normal, idle, partial
    {0xB4, 1, 1},   {0xB5, 4, 4},   {0xB6, 3, 3},   {0xB7, 1, 1},    // inversion, porch, display function, entry mode
    {0xB9, 2, 2},   {0xBE, 2, 2},                                    // colour reduction, HS lanes
    {0xC0, 2, 2},   {0xC1, 1, 1},   {0xC2, 1, 1},   {0xC3, 1, 1},    // power 1 to 4
    {0xC4, 1, 1},   {0xC5, 3, 4},   {0xC6, 1, 1},   {0xC8, 1, 1},    // power 5, VCOM, content adaptive 1 and 2
    {0xD0, 3, 3},   {0xD1, 3, 3},                                    // NV memory write, protection key
    {0xE0, 15, 15}, {0xE1, 15, 15}, {0xE2, 16, 16}, {0xE3, 16, 16},  // gamma; digital gamma 1 and 2
    {0xE9, 1, 1},                                                    // set image function
    {0xF2, 9, 9},   {0xF7, 4, 4},   {0xF8, 2, 2},   {0xF9, 1, 1},    // adjust control 2 to 5
    {0xFB, 1, 1},   {0xFC, 2, 2},                                    // SPI read, adjust control 6
};

constexpr DcsCommand kCo5300Commands[] = {
    {0x3C, 0, 0},                                            // write memory continue
    {0x44, 2, 2}, {0x4A, 1, 1}, {0x4F, 1, 1},                // tear scanline, brightness of idle mode, deep standby
    {0x51, 1, 1}, {0x53, 1, 1}, {0x55, 1, 1}, {0x58, 1, 1},  // brightness, control, colours, contrast
    {0x63, 1, 1}, {0xC4, 1, 1}, {0xFE, 1, 1},                // brightness in bright light, SPI mode, command page
};
constexpr DcsCommand kSh8601Commands[] = {
    {0x3C, 0, 0},                                            // write memory continue
    {0x44, 2, 2}, {0x4A, 1, 1}, {0x4F, 1, 1},                // tear scanline, brightness of idle mode, deep standby
    {0x51, 1, 1}, {0x53, 1, 1}, {0x55, 1, 1}, {0x58, 1, 1},  // brightness, control, colours, contrast
    {0x63, 1, 1}, {0xC4, 1, 1},                              // brightness in bright light, SPI mode
};
constexpr DcsCommand kSt77916Commands[] = {
    {0x3C, 0, 0}, {0x44, 2, 2},                // write memory continue, tear scanline
    {0x51, 1, 1}, {0x53, 1, 1}, {0x55, 1, 1},  // brightness, control, content adaptive
};

// RDDID has a dummy clock on a serial bus; RDID1 to RDID3, of 8 bits, have none. ST7735S: the usual answer of these
// parts, because the data sheet leaves it to the maker of the module.
constexpr DcsAnswer kSt7789Answers[] = {
    {0x04, 1, 3, {0x85, 0x85, 0x52}}, {0xDA, 0, 1, {0x85}}, {0xDB, 0, 1, {0x85}}, {0xDC, 0, 1, {0x52}}};
constexpr DcsAnswer kSt7735Answers[] = {
    {0x04, 1, 3, {0x7C, 0x89, 0xF0}}, {0xDA, 0, 1, {0x7C}}, {0xDB, 0, 1, {0x89}}, {0xDC, 0, 1, {0xF0}}};
// RDDID of parts without a programmed id. ID4 is 00h, 93h, 41h after an unused parameter, one byte at a time.
constexpr DcsAnswer kIli9341Answers[] = {
    {0x04, 1, 3, {}}, {0xDA, 0, 1, {}}, {0xDB, 0, 1, {}}, {0xDC, 0, 1, {}}, {0xD3, 0, 3, {0x00, 0x93, 0x41}}};
constexpr DcsAnswer kIli9342Answers[] = {
    {0x04, 1, 3, {}}, {0xDA, 0, 1, {}}, {0xDB, 0, 1, {}}, {0xDC, 0, 1, {}}, {0xD3, 0, 3, {0x00, 0x93, 0x42}}};
constexpr DcsAnswer kIli9488Answers[] = {
    {0x04, 1, 3, {}}, {0xDA, 0, 1, {}}, {0xDB, 0, 1, {}}, {0xDC, 0, 1, {}}, {0xD3, 0, 3, {0x00, 0x94, 0x88}}};
constexpr DcsAnswer kGc9a01Answers[] = {
    {0x04, 1, 3, {0x00, 0x9A, 0x01}}, {0xDA, 0, 1, {0x00}}, {0xDB, 0, 1, {0x9A}}, {0xDC, 0, 1, {0x01}}};
constexpr DcsAnswer kSt7796Answers[] = {{0xD3, 1, 3, {0x00, 0x77, 0x96}}};

}  // namespace

// Timing: serial interface characteristics (write cycle), RESX timing, SWRESET, SLPIN and SLPOUT restrictions; read
// cycle.
const DcsPart kSt7789Part{"ST7789",       240,   320, 66ns, 10us, 5ms, 120ms, 5ms, 120ms, 0x66, true, kSt7789Commands,
                          kSt7789Answers, 150ns, 0};
const DcsPart kIli9341Part{"ILI9341",       240,   320,   100ns, 10us,  5ms,
                           120ms,           5ms,   120ms, 0x66,  false, kIli9341Commands,
                           kIli9341Answers, 150ns, 0xD9};
const DcsPart kSt7735Part{"ST7735",       132,   162, 66ns, 10us, 120ms, 120ms, 5ms, 120ms, 0x06, true, kSt7735Commands,
                          kSt7735Answers, 150ns, 0};
const DcsPart kSt7735Gm11Part{"ST7735_GM11",  128,   160,   66ns, 10us, 120ms,
                              120ms,          5ms,   120ms, 0x06, true, kSt7735Commands,
                              kSt7735Answers, 150ns, 0};
const DcsPart kSt7735Rows132Part{
    "ST7735_ROWS132", 132,   132, 66ns, 10us, 120ms, 120ms, 5ms, 120ms, 0x06, true, kSt7735Commands,
    kSt7735Answers,   150ns, 0};
const DcsPart kGc9a01Part{"GC9A01",       240,   240,   10ns,       10us,  5ms,
                          120ms,          5ms,   120ms, 0x66,       false, kGc9a01Commands,
                          kGc9a01Answers, 150ns, 0,     kGc9a01Keys};
const DcsPart kSt7796Part{"ST7796",       320,   480,   66ns,       10us,  5ms,
                          120ms,          5ms,   120ms, 0x66,       false, kSt7796Commands,
                          kSt7796Answers, 150ns, 0,     kSt7796Keys};
const DcsPart kIli9342Part{"ILI9342",       320,   240,   100ns,       10us,  5ms,
                           120ms,           5ms,   120ms, 0x66,        false, kIli9342Commands,
                           kIli9342Answers, 150ns, 0xD9,  kIli9342Keys};
const DcsPart kIli9488Part{"ILI9488",       320,   480,   50ns, 10us,  5ms,
                           120ms,           5ms,   120ms, 0x66, false, kIli9488Commands,
                           kIli9488Answers, 150ns, 0xFB,  {},   false};

/// Controllers on QSPI have these in common.
constexpr DcsPart qspi_part(const char* name, std::uint16_t columns, std::uint16_t rows,
                            std::span<const DcsCommand> commands) {
  return {.name = name,
          .columns = columns,
          .rows = rows,
          .shortest_cycle = 20ns,
          .shortest_reset = 10us,
          .reset_to_command = 5ms,
          .reset_to_sleep_out = 120ms,
          .sleep_to_command = 5ms,
          .between_sleeps = 120ms,
          .format_after_reset = 0x66,
          .has_12_bits = false,
          .own_commands = commands,
          .answers = {},
          .shortest_read_cycle = 150ns,
          .read_index = 0,
          .has_qspi = true};
}

/// Its pixels give the light, so that brightness is a command. `access`: bits of memory access control that it has.
constexpr DcsPart amoled_part(DcsPart part, std::uint8_t access) {
  part.format_after_reset = 0x77;
  part.has_even_windows = true;
  part.access = access;
  part.brightness_bits = 0x20;
  part.is_lit_by_brightness = true;
  return part;
}

const DcsPart kCo5300Part = amoled_part(qspi_part("CO5300", 480, 502, kCo5300Commands), 0xCC);
const DcsPart kSh8601Part = amoled_part(qspi_part("SH8601", 368, 448, kSh8601Commands), 0x48);
const DcsPart kSt77916Part = qspi_part("ST77916", 360, 360, kSt77916Commands);

const DcsCommand* find_command(const DcsPart& part, std::uint8_t code) {
  for (const std::span<const DcsCommand> table : {std::span<const DcsCommand>(kUserCommands), part.own_commands}) {
    const auto found = std::ranges::find(table, code, &DcsCommand::code);
    if (found != table.end()) return &*found;
  }
  return nullptr;
}

const DcsAnswer* find_answer(const DcsPart& part, std::uint8_t code) {
  const auto found = std::ranges::find(part.answers, code, &DcsAnswer::code);
  return found == part.answers.end() ? nullptr : &*found;
}

}  // namespace zstrip::sim
