// Cycles of a Cortex-M0+ by the table of its Technical Reference Manual. The emulator counts none for the link
// register of PUSH {..., lr} and the program counter of POP {..., pc}; in the table they are registers of the list, a
// cycle each.
const kPushLink = 0xb5, kPopProgramCounter = 0xbd;  // the upper bytes

/** Executes an instruction and returns its cycles. */
export function execute(core) {
  const upper = core.readUint16(core.PC) >>> 8;
  const cycles = core.executeInstruction();
  if (upper !== kPushLink && upper !== kPopProgramCounter) return cycles;
  ++core.cycles;
  return cycles + 1;
}
