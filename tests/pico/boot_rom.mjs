// What the boot ROM does with the flash, by the RP2040 data sheet, 2.8.1; the emulator's package has no ROM.
const kStage = 0x20041f00, kStageBytes = 256, kFlash = 0x10000000, kFlashEnd = 0x18000000;
const kVectorTable = 0x10000100;

/** CRC-32 with the polynomial 04C11DB7, highest bit first, from all ones, not inverted. */
export function crc(bytes) {
  let remainder = 0xffffffff;
  for (const byte of bytes) {
    remainder ^= byte << 24;
    for (let bit = 0; bit < 8; ++bit) remainder = remainder << 1 ^ (remainder & 0x80000000 ? 0x04c11db7 : 0);
  }
  return remainder >>> 0;
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
    if (steps === 100000) return chip.complain('boot: the second stage does not end');
    chip.step();
  }
  chip.checkFlashInterface();
  if (core.VTOR !== kVectorTable) chip.complain('boot: the vector table is not the program\'s');
}
