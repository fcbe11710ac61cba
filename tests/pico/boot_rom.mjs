// What the boot ROM does with the flash, by the RP2040 data sheet, 2.8.1; the emulator's package has no ROM.
const kStage = 0x20041f00, kStageBytes = 256, kFlash = 0x10000000, kFlashEnd = 0x18000000;
const kSsi = 0x18000000, kVectorTable = 0x10000100;

/** CRC-32 with the polynomial 04C11DB7, highest bit first, from all ones, not inverted. */
export function crc(bytes) {
  let remainder = 0xffffffff;
  for (const byte of bytes) {
    remainder ^= byte << 24;
    for (let bit = 0; bit < 8; ++bit) remainder = remainder << 1 ^ (remainder & 0x80000000 ? 0x04c11db7 : 0);
  }
  return remainder >>> 0;
}

/** Whether the flash's interface is set up so that a program can be read from it in place (4.10). */
function checkFlashInterface(chip) {
  const read = (offset) => chip.emulator.readUint32(kSsi + offset);
  const control = read(0x00), command = read(0xf4), divider = read(0x14);
  if ((read(0x08) & 1) === 0) return chip.complain('flash: its interface is off');
  if ((control >>> 16 & 31) !== 31 || (control >>> 8 & 3) !== 3 || (control >>> 21 & 3) !== 0 || read(0x04) !== 0)
    chip.complain('flash: the interface does not read one word of 32 bits by one line an access');
  if (command >>> 24 !== 0x03 || (command >>> 8 & 3) !== 2 || (command >>> 2 & 15) !== 24 / 4 ||
      (command >>> 11 & 31) !== 0)
    chip.complain('flash: the command is not 03h with an address of 24 bits');
  // Winbond W25Q16JV: 03h up to 50 MHz; the system's clock will be 125 MHz.
  if (divider % 2 !== 0 || divider === 0 || 125e6 / divider > 50e6) chip.complain('flash: its clock is too fast');
}

/** Runs the second boot stage to its end, where the program in the flash begins. */
export function boot(chip) {
  const {emulator} = chip, {core} = emulator;
  const stage = emulator.flash.slice(0, kStageBytes);
  if (new DataView(stage.buffer).getUint32(kStageBytes - 4, true) !== crc(stage.subarray(0, kStageBytes - 4)))
    return chip.complain('boot: the checksum of the second stage is wrong, the ROM waits for a file by USB');
  emulator.sram.set(stage, kStage - 0x20000000);
  core.SP = kStage;
  core.PC = kStage;
  for (let steps = 0; core.PC < kFlash || core.PC >= kFlashEnd; ++steps) {
    if (steps === 1000) return chip.complain('boot: the second stage does not end');
    chip.step();
  }
  checkFlashInterface(chip);
  if (core.VTOR !== kVectorTable) chip.complain('boot: the vector table is not the program\'s');
}
