// Instructions of a Cortex-M33 that the emulator rp2350js executes wrongly or does not know. Source: Armv8-M
// Architecture Reference Manual, C2.4.
//   ADC, SBC with flags   it adds the carry to the second operand first, and then overflow and carry are of another sum
//   SMLAL, UMLAL          it adds in floating point, and loses what lies below the upper 53 bits
//   SSUB16, SEL, SMUSDX   it does not have them

const kInBlock = 'an instruction that is corrected stands in an IT block';

/** Signed halves. */
const low = (word) => word << 16 >> 16;
const high = (word) => word >> 16;

/** The flags of a + b + carry that the emulator gets wrong. */
function setFlags(regs, a, b, carry) {
  const sum = a + b + carry | 0;
  regs.C = (a >>> 0) + (b >>> 0) + carry > 0xffffffff;
  regs.V = ((a ^ sum) & (b ^ sum)) < 0;
}

/** The signed bytes that a modified immediate stands for, C1.5, as far as overflow depends on them: its 32 bits. */
function expanded(first, second) {
  const code = (first >>> 10 & 1) << 11 | (second >>> 12 & 7) << 8 | second & 0xff, byte = code & 0xff;
  if (code >>> 10 === 0) return [byte, byte << 16 | byte, byte << 24 | byte << 8, byte * 0x01010101][code >>> 8 & 3] | 0;
  const value = 0x80 | byte & 0x7f, by = code >>> 7;
  return value >>> by | value << 32 - by;
}

/** The second operand that is a shifted register, C2.4. */
function shifted({r, C}, second) {
  const value = r[second & 15] | 0, by = (second >>> 12 & 7) << 2 | second >>> 6 & 3;
  switch (second >>> 4 & 3) {
    case 0: return value << by;
    case 1: return by === 0 ? 0 : value >>> by;
    case 2: return value >> (by === 0 ? 31 : by);
    default: return by === 0 ? (C ? 1 << 31 : 0) | value >>> 1 : value >>> by | value << 32 - by;
  }
}

/** Operands a, b of an addition with carry that sets flags, for SBC with b inverted; undefined for other instructions. */
function additionWithCarry(regs, first, second) {
  const {r} = regs;
  if (first >>> 6 === 0b0100000101) return [r[first & 7], r[first >>> 3 & 7]];
  if (first >>> 6 === 0b0100000110) return [r[first & 7], ~r[first >>> 3 & 7]];
  const kind = first & 0xfbf0;
  if (kind === 0xf150) return [r[first & 15], expanded(first, second)];
  if (kind === 0xf170) return [r[first & 15], ~expanded(first, second)];
  if ((first & 0xfff0) === 0xeb50) return [r[first & 15], shifted(regs, second)];
  if ((first & 0xfff0) === 0xeb70) return [r[first & 15], ~shifted(regs, second)];
  return undefined;
}

/** The product of words, plus the registers of the result, 64 bits. */
function accumulate({r}, second, product) {
  const lower = second >>> 12, upper = second >>> 8 & 15;
  const sum = BigInt.asUintN(64, (BigInt(r[upper]) << 32n | BigInt(r[lower])) + product);
  r[lower] = Number(sum & 0xffffffffn);
  r[upper] = Number(sum >> 32n);
}

/** Executes an instruction that the emulator does not have or adds up wrongly; returns whether it was one. */
function executesItself(regs, first, second) {
  const {r} = regs, n = r[first & 15], m = r[second & 15], d = second >>> 8 & 15, kind = first & 0xfff0;
  if (kind === 0xfad0 && (second & 0xf0f0) === 0xf000) {  // SSUB16
    const lower = low(n) - low(m), upper = high(n) - high(m);
    r[d] = upper << 16 | lower & 0xffff;
    regs.xpsr = (regs.xpsr & ~0xf0000 | (lower >= 0 ? 3 : 0) << 16 | (upper >= 0 ? 12 : 0) << 16) >>> 0;
  } else if (kind === 0xfaa0 && (second & 0xf0f0) === 0xf080) {  // SEL
    const ge = regs.xpsr >>> 16 & 15;
    const mask = [0, 1, 2, 3].reduce((all, byte) => all | (ge >>> byte & 1 ? 0xff << 8 * byte : 0), 0);
    r[d] = n & mask | m & ~mask;
  } else if (kind === 0xfb40 && (second & 0xf0f0) === 0xf010) {  // SMUSDX
    r[d] = low(n) * high(m) - high(n) * low(m);
  } else if (kind === 0xfbc0 && (second & 0xf0) === 0) {  // SMLAL
    accumulate(regs, second, BigInt(n | 0) * BigInt(m | 0));
  } else if (kind === 0xfbe0 && (second & 0xf0) === 0) {  // UMLAL
    accumulate(regs, second, BigInt(n) * BigInt(m));
  } else {
    return false;
  }
  return true;
}

/** Executes an instruction as the chip does, and returns its cycles. `core`: of the emulator, with interrupts masked. */
export function execute(core, chip) {
  const {regs} = core, at = regs.pc, first = chip.readUint16(at);
  // All others begin with other bits.
  const narrow = first >>> 7 === 0x83 || first >>> 6 === 0x105;
  if (!narrow && first < 0xeb50) return core.executeInstruction();
  const second = narrow ? 0 : chip.readUint16(at + 2);
  const operands = additionWithCarry(regs, first, second);
  if (operands) {
    // In an IT block a narrow one sets no flags, and no compiler puts a wide one there.
    const keepsFlags = regs.itState !== 0;
    if (keepsFlags && !narrow) throw new Error(kInBlock);
    const [a, b] = operands, carry = regs.C ? 1 : 0;
    const cycles = core.executeInstruction();
    if (!keepsFlags) setFlags(regs, a | 0, b | 0, carry);
    return cycles;
  }
  if (!executesItself(regs, first, second)) return core.executeInstruction();
  if (regs.itState !== 0) throw new Error(kInBlock);
  regs.pc = at + 4;
  ++core.cycles;
  return 1;
}
